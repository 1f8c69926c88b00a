// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_summary.h"

#include "core/base/number_text.h"
#include "core/results/csv_table.h"

#include <algorithm>
#include <array>
#include <set>

namespace dyncal {
namespace {

constexpr std::array<std::string_view, 3> kFirst{"sensitivity", "f0_hz", "damping_ratio"};
constexpr std::array<Severity, 3> kOfColumns{Severity::Block, Severity::Caution, Severity::Info};

std::vector<std::string> quantitiesOf(const std::vector<SensorStanding> &standings)
{
    std::vector<std::string> quantities(kFirst.begin(), kFirst.end());
    std::set<std::string> others;
    for (const SensorStanding &standing : standings)
        for (const StatedResult &result : standing.record.results)
            others.insert(result.quantity);
    std::ranges::copy_if(others, std::back_inserter(quantities),
        [](const std::string &other) { return std::ranges::find(kFirst, other) == kFirst.end(); });
    return quantities;
}

void addCell(std::string &row, const std::string &text)
{
    row += (row.empty() ? "" : ",") + csvCell(text);
}

std::string headOf(const std::vector<std::string> &quantities)
{
    std::string head;
    addCell(head, "sensor");
    addCell(head, "state");
    for (const std::string &quantity : quantities) {
        addCell(head, quantity);
        addCell(head, "u_expanded_" + quantity);
        addCell(head, "k_" + quantity);
    }
    for (const char *name : {"sensitivity_unit", "blocking", "cautions", "notes", "reason"})
        addCell(head, name);
    return head + '\n';
}

const StatedResult *resultOf(const SensorOutcome &record, std::string_view quantity)
{
    const auto found = std::ranges::find(record.results, quantity, &StatedResult::quantity);
    return found == record.results.end() ? nullptr : &*found;
}

std::string optionalNumber(const std::optional<double> &value)
{
    return value ? numberText(*value) : std::string();
}

void addResultCells(std::string &row, const StatedResult *result)
{
    addCell(row, result ? numberText(result->value) : std::string());
    addCell(row, result ? optionalNumber(result->expanded) : std::string());
    addCell(row, result ? optionalNumber(result->k) : std::string());
}

std::string marksOf(const SensorOutcome &record, Severity severity)
{
    std::string text;
    for (const FindingMark &mark : record.findings)
        if (mark.severity == severity)
            text.append(text.empty() ? "" : " ")
                .append(mark.id)
                .append(mark.shot > 0 ? "@" + std::to_string(mark.shot) : std::string());
    return text;
}

std::string rowOf(const SensorStanding &standing, const std::vector<std::string> &quantities)
{
    std::string row;
    addCell(row, standing.id);
    addCell(row, sensorStateName(standing.record.state));
    for (const std::string &quantity : quantities)
        addResultCells(row, resultOf(standing.record, quantity));
    const StatedResult *sensitivity = resultOf(standing.record, kFirst.front());
    addCell(row, sensitivity ? sensitivity->unit : std::string());
    for (const Severity severity : kOfColumns)
        addCell(row, marksOf(standing.record, severity));
    addCell(row, standing.record.reason);
    return row + '\n';
}

} // namespace

std::string batchSummaryCsv(const std::vector<SensorStanding> &standings)
{
    const std::vector<std::string> quantities = quantitiesOf(standings);
    std::string text = headOf(quantities);
    for (const SensorStanding &standing : standings)
        text += rowOf(standing, quantities);
    return text;
}

} // namespace dyncal
