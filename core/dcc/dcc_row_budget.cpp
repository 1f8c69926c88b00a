// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_row_budget.h"

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_quantity.h"
#include "core/dcc/si_unit.h"
#include "core/results/results_uncertainty_json.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace dyncal {
namespace {

using BudgetOfRow = ReportedValue (*)(const ResponseResult &, const RowUncertainty &, Index);

/// One source over the rows.
struct SourceOverRows
{
    UncertaintyLine line; ///< of the first row that has it
    std::size_t time; ///< how many times a row has it already
    std::vector<std::string> contributions;
};

/// Sources in the order in which they are met.
class SourcesOverRows
{
public:
    explicit SourcesOverRows(std::size_t rows)
        : m_rows(rows)
    {
    }

    void add(const std::vector<UncertaintyLine> &lines, std::size_t row)
    {
        for (auto line = lines.begin(); line != lines.end(); ++line) {
            const auto isSame = [&](const UncertaintyLine &other) {
                return other.quantity == line->quantity && other.shot == line->shot;
            };
            const auto time = std::count_if(lines.begin(), line, isSame);
            contributionsOf(*line, static_cast<std::size_t>(time))[row]
                = dccNumber(line->contribution);
        }
    }
    const std::vector<SourceOverRows> &sources() const { return m_sources; }

private:
    std::vector<std::string> &contributionsOf(const UncertaintyLine &line, std::size_t time)
    {
        for (SourceOverRows &known : m_sources)
            if (known.line.quantity == line.quantity && known.line.shot == line.shot
                && known.time == time)
                return known.contributions;
        m_sources.push_back({line, time, std::vector<std::string>(m_rows, kDccNone)});
        return m_sources.back().contributions;
    }

    std::size_t m_rows;
    std::vector<SourceOverRows> m_sources;
};

DccColumn columnOfSource(const SourceOverRows &source, const std::string &unit)
{
    const UncertaintyLine &line = source.line;
    DccColumn column{line.shot == 0 ? verbatim(line.quantity)
                                    : Message{DYNCAL_TEXT("core", "%1, shot %2"),
                                        {line.quantity, std::to_string(line.shot)}},
        "dyncal_budgetContribution", source.contributions};
    column.units.assign(column.values.size(), unit);
    column.description = verbatim(distributionName(line.distribution));
    return column;
}

/// What the rows of a response are, with u of each: NaN of those without a budget.
struct RowsOfBudget
{
    Message name;
    const char *refType;
    std::string unit;
    const Eigen::VectorXd &u;
    BudgetOfRow budgetOf;
};

void addRows(const DccWords &words, const ResponseResult &response, const RowUncertainty &rows,
    const RowsOfBudget &of, XmlElement &data)
{
    const Index count = std::min(response.frequency_Hz.size(), of.u.size());
    SourcesOverRows sources(static_cast<std::size_t>(count));
    DccColumn frequency{
        {DYNCAL_TEXT("core", "Frequency"), {}}, "basic_tableIndex0 dyncal_frequency"};
    for (Index i = 0; i < count; ++i) {
        frequency.values.push_back(dccNumber(response.frequency_Hz[i]));
        if (std::isfinite(of.u[i]))
            sources.add(of.budgetOf(response, rows, i).lines, static_cast<std::size_t>(i));
    }
    if (sources.sources().empty())
        return;
    frequency.units.assign(frequency.values.size(), "\\hertz");
    XmlElement list = withRefType("dcc:list", of.refType);
    list.add(words.element("dcc:name", {of.name}));
    addDccColumn(words, frequency, list);
    for (const SourceOverRows &source : sources.sources())
        addDccColumn(words, columnOfSource(source, of.unit), list);
    data.add(std::move(list));
}

XmlElement budgetsOf(const DccWords &words, const ResponseResult &response,
    const RowUncertainty &rows, const std::string &unit)
{
    XmlElement data{"dcc:data"};
    if (rows.u_magnitude.size() > kMostBudgetRows) {
        data.add(words.element("dcc:text",
            {Message{
                DYNCAL_TEXT("core",
                    "The budgets of the single frequencies are left out, because there are more than %1."),
                {std::to_string(kMostBudgetRows)}}}));
        return data;
    }
    addRows(words, response, rows,
        {{DYNCAL_TEXT("core", "Magnitude"), {}}, "dyncal_magnitudeBudget", unit, rows.u_magnitude,
            &magnitudeOfRow},
        data);
    addRows(words, response, rows,
        {{DYNCAL_TEXT("core", "Phase"), {}}, "dyncal_phaseBudget", "\\radian", rows.u_phase_rad,
            &phaseOfRow},
        data);
    return data;
}

/// Nothing where nothing was measured, or its unit or the parts of its u are not known.
void addBudgets(const DccSource &source, const char *refType, const Message &name,
    const ResponseResult *response, const RowUncertainty &rows, std::vector<XmlElement> &results)
{
    const auto unit = dsiUnitOf(response ? response->unit : std::string());
    if (!response || !unit || response->u_noiseMagnitude.size() != response->frequency_Hz.size())
        return;
    XmlElement data = budgetsOf(source.words, *response, rows, *unit);
    if (data.children.empty())
        return;
    XmlElement result = dccResult(source.words, name, refType);
    result.add(std::move(data));
    results.push_back(std::move(result));
}

} // namespace

std::vector<XmlElement> dccRowBudgets(const DccSource &source)
{
    std::vector<XmlElement> results;
    if (const UncertaintyReport *report = source.results.uncertainty.get()) {
        const ResponseResult *response = source.results.response.get();
        addBudgets(source, "dyncal_responseBudget",
            {DYNCAL_TEXT("core", "Budgets of the frequency response"), {}}, response, report->rows,
            results);
        addBudgets(source, "dyncal_responseBudgetAtMarks",
            {DYNCAL_TEXT("core", "The same at the limits of the band, its edges and the resonance"),
                {}},
            response ? response->atMarks.get() : nullptr, report->rowsAtMarks, results);
    }
    if (const UncertainResponse *beside = source.comparisonBeside()) {
        addBudgets(source, "dyncal_comparisonBudget",
            {DYNCAL_TEXT(
                 "core", "Budgets of the frequency response against the reference transducer"),
                {}},
            &beside->response, beside->report.rows, results);
        addBudgets(source, "dyncal_comparisonBudgetAtMarks",
            {DYNCAL_TEXT("core", "The same at the limits of the band, its edges and the resonance"),
                {}},
            beside->response.atMarks.get(), beside->report.rowsAtMarks, results);
    }
    return results;
}

} // namespace dyncal
