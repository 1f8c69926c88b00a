// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_reported.h"

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_quantity.h"
#include "core/dcc/si_unit.h"
#include "core/monte_carlo/chain_monte_carlo.h"
#include "core/results/reported_by_key.h"
#include "core/uncertainty/step_value.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Texts = std::vector<std::string>;

DccColumn keyColumn()
{
    return {{DYNCAL_TEXT("core", "Key in results.json"), {}}, "dyncal_reportedName"};
}

void addNumber(double value, DccColumn &column)
{
    column.values.push_back(dccNumber(value));
    column.units.emplace_back("\\one");
}

/// Values of one unit.
struct ReportedColumns
{
    std::string unit;
    DccColumn keys = keyColumn();
    DccColumn values{{DYNCAL_TEXT("core", "Value"), {}}, "dyncal_reportedValue"};
    DccColumn factors{{DYNCAL_TEXT("core", "k"), {}}, "dyncal_coverageFactor"};
    DccColumn dofs{
        {DYNCAL_TEXT("core", "Effective degrees of freedom"), {}}, "dyncal_degreesOfFreedom"};

    void add(const std::string &key, const ReportedValue &value)
    {
        keys.words.push_back(verbatim(key));
        values.values.push_back(dccNumber(value.value));
        values.units.push_back(unit);
        values.standard.push_back(dccNumber(*value.u));
        addNumber(value.k, factors);
        addNumber(value.dof, dofs);
    }
    XmlElement list(const DccWords &words) const
    {
        XmlElement list{"dcc:list"};
        for (const DccColumn *column : {&keys, &values, &factors, &dofs})
            addDccColumn(words, *column, list);
        return list;
    }
};

/// The same of the trials.
struct DrawnColumns
{
    std::string unit;
    DccColumn keys = keyColumn();
    DccColumn agree{{DYNCAL_TEXT("core", "Both propagations agree: 1, or 0"), {}},
        "dyncal_monteCarloValidated"};
    Texts values = {}, u = {}, low = {}, high = {};

    void add(const DrawnValue &one)
    {
        keys.words.push_back(verbatim(one.of));
        addNumber(one.gum.validated ? 1.0 : 0.0, agree);
        values.push_back(dccNumber(one.value));
        u.push_back(dccNumber(one.drawn.u));
        low.push_back(dccNumber(one.drawn.low));
        high.push_back(dccNumber(one.drawn.high));
    }
    XmlElement quantity(const DccWords &words, double coverage) const
    {
        XmlElement quantity = withRefType("dcc:quantity", "dyncal_reportedValue");
        quantity.add(words.element("dcc:name", {Message{DYNCAL_TEXT("core", "Value"), {}}}));
        XmlElement &list = quantity.add({"si:realListXMLList"});
        list.add({"si:valueXMLList", {}, dccList(values)});
        list.add({"si:unitXMLList", {}, unit});
        XmlElement &interval = list.add({"si:measurementUncertaintyUnivariateXMLList"})
                                   .add({"si:coverageIntervalMUXMLList"});
        interval.add({"si:valueStandardMUXMLList", {}, dccList(u)});
        interval.add({"si:intervalMinXMLList", {}, dccList(low)});
        interval.add({"si:intervalMaxXMLList", {}, dccList(high)});
        interval.add({"si:coverageProbabilityXMLList", {}, dccNumber(coverage)});
        return quantity;
    }
    XmlElement list(const DccWords &words, double coverage) const
    {
        XmlElement list = withRefType("dcc:list", "dyncal_monteCarloValues");
        addDccColumn(words, keys, list);
        list.add(quantity(words, coverage));
        addDccColumn(words, agree, list);
        return list;
    }
};

/// The columns of a unit, in the order in which the units are met; null where it is not known.
template <typename Columns>
Columns *columnsOfUnit(const std::string &printed, std::vector<Columns> &all)
{
    const std::optional<std::string> unit = dsiUnitOf(printed);
    if (!unit)
        return nullptr;
    const auto known = std::ranges::find(all, *unit, &Columns::unit);
    if (known != all.end())
        return &*known;
    return &all.emplace_back(Columns{*unit});
}

} // namespace

std::vector<std::pair<std::string, ReportedValue>> dccValues(const CalibrationResults &results)
{
    std::vector<std::pair<std::string, ReportedValue>> all;
    for (const auto &[key, value] : reportedByKey(results))
        all.emplace_back(key, *value);
    for (std::size_t i = 0; results.shock && i < results.shock->shots.size(); ++i) {
        const ShockConditions &shock = results.shock->shots[i];
        for (const StepResult result : {StepResult::Velocity, StepResult::Step}) {
            if (!shock.uncertainty)
                continue;
            ReportedValue value = stepValue(*shock.uncertainty, result, shock.shot);
            std::string key = "shock" + placeOf(i) + "." + value.of;
            all.emplace_back(std::move(key), std::move(value));
        }
    }
    return all;
}

std::vector<XmlElement> dccReportedValues(const DccSource &source)
{
    std::vector<ReportedColumns> lists;
    for (const auto &[key, value] : dccValues(source.results))
        if (value.u && std::isfinite(value.value))
            if (ReportedColumns *columns = columnsOfUnit(value.unit, lists))
                columns->add(key, value);
    if (lists.empty())
        return {};
    XmlElement result = dccResult(source.words,
        {DYNCAL_TEXT("core", "Reported values, not rounded"), {}}, "dyncal_reportedValues");
    XmlElement &data = result.add({"dcc:data"});
    for (const ReportedColumns &columns : lists)
        data.add(columns.list(source.words));
    return {std::move(result)};
}

std::vector<XmlElement> dccDrawnValues(const DccSource &source)
{
    const auto &drawn = source.results.chainMonteCarlo;
    if (!drawn || drawn->trials <= 0)
        return {};
    std::vector<DrawnColumns> lists;
    for (const DrawnValue &one : drawn->values)
        if (DrawnColumns *columns = columnsOfUnit(one.unit, lists))
            columns->add(one);
    if (lists.empty())
        return {};
    XmlElement result = dccResult(source.words,
        {DYNCAL_TEXT("core", "Values by Monte Carlo, with their intervals"), {}},
        "dyncal_monteCarlo");
    XmlElement &data = result.add({"dcc:data"});
    for (const DrawnColumns &columns : lists)
        data.add(columns.list(source.words, drawn->coverage));
    return {std::move(result)};
}

} // namespace dyncal
