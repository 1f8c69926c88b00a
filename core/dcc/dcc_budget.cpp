// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_budget.h"

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_quantity.h"
#include "core/dcc/dcc_reported.h"
#include "core/dcc/si_unit.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

/// What the name of a source ends with says its unit; the longest first.
constexpr std::array kUnitsOfSources{std::pair{"_per_m", "\\metre\\tothe{-1}"},
    std::pair{"_kg_mol", "\\kilogram\\mole\\tothe{-1}"},
    std::pair{"_m_s", "\\metre\\second\\tothe{-1}"}, std::pair{"_relative", "\\one"},
    std::pair{"_humidity", "\\one"}, std::pair{"_fraction", "\\one"}, std::pair{"_pa", "\\pascal"},
    std::pair{"_hz", "\\hertz"}, std::pair{"_rad", "\\radian"}, std::pair{"_k", "\\kelvin"},
    std::pair{"_s", "\\second"}, std::pair{"_m", "\\metre"}, std::pair{"gamma", "\\one"}};

/// NaN stands where nobody has said what the unit is.
std::optional<std::string> unitOfSource(const UncertaintyLine &line, const std::string &ofValue)
{
    const std::string_view name
        = std::string_view(line.quantity).substr(0, line.quantity.find('['));
    for (const auto &[ending, unit] : kUnitsOfSources)
        if (name.ends_with(ending))
            return unit;
    return line.sensitivity == 1.0 ? std::optional(ofValue) : std::nullopt;
}

/// The columns of one budget.
struct BudgetColumns
{
    DccColumn sources{{DYNCAL_TEXT("core", "Source"), {}}, "dyncal_budgetSource"};
    DccColumn shots{
        {DYNCAL_TEXT("core", "Shot, 0 where it is of all"), {}}, "dyncal_budgetSourceShot"};
    DccColumn uncertainties{
        {DYNCAL_TEXT("core", "Standard uncertainty"), {}}, "dyncal_budgetUncertainty"};
    DccColumn coefficients{
        {DYNCAL_TEXT("core", "Sensitivity coefficient"), {}}, "dyncal_budgetCoefficient"};
    DccColumn contributions{{DYNCAL_TEXT("core", "Contribution"), {}}, "dyncal_budgetContribution"};
    DccColumn shares{{DYNCAL_TEXT("core", "Share of the variance"), {}}, "dyncal_budgetShare"};
    DccColumn dofs{{DYNCAL_TEXT("core", "Degrees of freedom"), {}}, "dyncal_degreesOfFreedom"};
    DccColumn distributions{{DYNCAL_TEXT("core", "Distribution"), {}}, "dyncal_budgetDistribution"};

    static void put(DccColumn &column, double value, const std::string &unit)
    {
        column.values.push_back(dccNumber(value));
        column.units.push_back(unit);
    }
    void add(const UncertaintyLine &line, const ReportedValue &reported, const std::string &unit)
    {
        const auto own = unitOfSource(line, unit);
        sources.words.push_back(verbatim(line.quantity));
        put(shots, static_cast<double>(line.shot), "\\one");
        put(uncertainties, own ? line.u : kUnknown, own.value_or("\\one"));
        put(coefficients, own ? line.sensitivity : kUnknown,
            own ? quotientOfUnits(unit, *own) : "\\one");
        put(contributions, line.contribution, unit);
        put(shares, reported.sharePercent(line), "\\percent");
        put(dofs, line.dof, "\\one");
        distributions.words.push_back(verbatim(distributionName(line.distribution)));
    }
};

void addBudget(
    const DccSource &source, const std::string &of, const ReportedValue &reported, XmlElement &data)
{
    const auto unit = dsiUnitOf(reported.unit);
    if (!unit || !reported.u || reported.lines.empty())
        return;
    BudgetColumns columns;
    for (const UncertaintyLine &line : reported.lines)
        columns.add(line, reported, *unit);
    XmlElement list = withRefType("dcc:list", "dyncal_uncertaintyBudget");
    list.add(source.words.element("dcc:name", {verbatim(of)}));
    for (const DccColumn *column :
        {&columns.sources, &columns.shots, &columns.uncertainties, &columns.coefficients,
            &columns.contributions, &columns.shares, &columns.dofs, &columns.distributions})
        addDccColumn(source.words, *column, list);
    data.add(std::move(list));
}

} // namespace

std::vector<XmlElement> dccBudgets(const DccSource &source)
{
    XmlElement data{"dcc:data"};
    for (const auto &[key, value] : dccValues(source.results))
        addBudget(source, key, value, data);
    if (data.children.empty())
        return {};
    XmlElement result = dccResult(source.words,
        {DYNCAL_TEXT("core", "Budget of the uncertainty"), {}}, "dyncal_uncertaintyBudget");
    result.add(std::move(data));
    return {std::move(result)};
}

} // namespace dyncal
