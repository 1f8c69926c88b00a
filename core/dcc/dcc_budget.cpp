// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_budget.h"

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_quantity.h"
#include "core/dcc/si_unit.h"
#include "core/monte_carlo/chain_monte_carlo.h"

#include <algorithm>
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
    for (const DccColumn &column : {columns.sources, columns.shots, columns.uncertainties,
             columns.contributions, columns.shares, columns.dofs, columns.distributions})
        for (XmlElement &quantity : dccColumn(source.words, column))
            list.add(std::move(quantity));
    data.add(std::move(list));
}

void addLevels(const DccSource &source, const std::string &begin, const std::string &end,
    const std::vector<ReportedValue> &values, XmlElement &data)
{
    for (std::size_t i = 0; i < values.size(); ++i)
        addBudget(source,
            std::string(begin).append("[").append(std::to_string(i)).append("]").append(end),
            values[i], data);
}

void addResult(const DccSource &source, const char *refType, const Message &name, XmlElement data,
    std::vector<XmlElement> &results)
{
    if (data.children.empty())
        return;
    XmlElement result = withRefType("dcc:result", refType);
    result.add(source.words.element("dcc:name", {name}));
    result.add(std::move(data));
    results.push_back(std::move(result));
}

/// Values with the interval of the trials; those whose unit is known.
XmlElement drawnValues(
    const DccSource &source, const ChainMonteCarlo &drawn, const DccColumn &names)
{
    std::vector<std::string> values, units, u, low, high;
    for (const DrawnValue &one : drawn.values) {
        values.push_back(dccNumber(one.value));
        units.push_back(dsiUnitOf(one.unit).value_or("\\one"));
        u.push_back(dccNumber(one.drawn.u));
        low.push_back(dccNumber(one.drawn.low));
        high.push_back(dccNumber(one.drawn.high));
    }
    XmlElement quantity = withRefType("dcc:quantity", "dyncal_reportedValue");
    quantity.add(source.words.element("dcc:name", {Message{DYNCAL_TEXT("core", "Value"), {}}}));
    XmlElement &list = quantity.add({"si:realListXMLList"});
    list.add({"si:valueXMLList", {}, dccList(values)});
    list.add({"si:unitXMLList", {}, dccList(units, true)});
    XmlElement &interval = list.add({"si:measurementUncertaintyUnivariateXMLList"})
                               .add({"si:coverageIntervalMUXMLList"});
    interval.add({"si:valueStandardMUXMLList", {}, dccList(u)});
    interval.add({"si:intervalMinXMLList", {}, dccList(low)});
    interval.add({"si:intervalMaxXMLList", {}, dccList(high)});
    interval.add({"si:coverageProbabilityXMLList", {}, dccNumber(drawn.coverage)});
    XmlElement whole = withRefType("dcc:list", "dyncal_monteCarloValues");
    for (XmlElement &column : dccColumn(source.words, names))
        whole.add(std::move(column));
    whole.add(std::move(quantity));
    return whole;
}

void addDrawn(const DccSource &source, std::vector<XmlElement> &results)
{
    const auto &drawn = source.results.chainMonteCarlo;
    const bool isKnown = drawn && drawn->trials > 0 && !drawn->values.empty()
        && std::ranges::all_of(
            drawn->values, [](const DrawnValue &one) { return dsiUnitOf(one.unit).has_value(); });
    if (!isKnown)
        return;
    DccColumn names{{DYNCAL_TEXT("core", "Key in results.json"), {}}, "dyncal_reportedName"};
    DccColumn agree{{DYNCAL_TEXT("core", "Both propagations agree: 1, or 0"), {}},
        "dyncal_monteCarloValidated"};
    for (const DrawnValue &one : drawn->values) {
        names.words.push_back(verbatim(one.of));
        agree.values.push_back(one.gum.validated ? "1" : "0");
        agree.units.push_back("\\one");
    }
    XmlElement list = drawnValues(source, *drawn, names);
    for (XmlElement &quantity : dccColumn(source.words, agree))
        list.add(std::move(quantity));
    addResult(source, "dyncal_monteCarlo",
        {DYNCAL_TEXT("core", "Values by Monte Carlo, with their intervals"), {}},
        {"dcc:data", {}, {}, {std::move(list)}}, results);
}

} // namespace

std::vector<XmlElement> dccBudgets(const DccSource &source)
{
    std::vector<XmlElement> results;
    if (const UncertaintyReport *report = source.results.uncertainty.get()) {
        XmlElement data{"dcc:data"};
        if (report->sensitivity)
            addBudget(source, "sensitivity", *report->sensitivity, data);
        addLevels(source, "sensitivity.per_level", "", report->perLevel, data);
        addLevels(source, "shots", ".sensitivity", report->ofShots, data);
        for (const ReportedValue &one : report->ofModel)
            addBudget(source, one.of, one, data);
        addResult(source, "dyncal_uncertaintyBudget",
            {DYNCAL_TEXT("core", "Budget of the uncertainty"), {}}, std::move(data), results);
    }
    addDrawn(source, results);
    return results;
}

} // namespace dyncal
