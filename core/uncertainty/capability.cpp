// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/capability.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

bool isFor(const CapabilityEntry &entry, const std::string &of, double frequency_Hz)
{
    const bool isOverFrequency = of == "magnitude" || of == "phase_rad";
    return entry.of == of
        && (!isOverFrequency
            || (frequency_Hz >= entry.from_Hz && (!entry.to_Hz || frequency_Hz <= *entry.to_Hz)));
}

/// Q is 1/(2 damping): what the laboratory can of the one it can of the other, relative to both.
double leastOfReciprocal(
    const std::vector<CapabilityEntry> &cmc, const char *other, const ReportedValue &reported)
{
    const double value = 0.5 / reported.value;
    return leastExpanded(cmc, other, value) * std::abs(reported.value / value);
}

double leastOf(const std::vector<CapabilityEntry> &cmc, const ReportedValue &reported)
{
    const double own = leastExpanded(cmc, reported.of, reported.value);
    if (reported.of == "q")
        return std::max(own, leastOfReciprocal(cmc, "damping_ratio", reported));
    if (reported.of == "damping_ratio")
        return std::max(own, leastOfReciprocal(cmc, "q", reported));
    return own;
}

void holdValue(const std::vector<CapabilityEntry> &cmc, ReportedValue &reported)
{
    reported.leastExpanded = leastOf(cmc, reported);
    if (reported.u)
        combineLines(reported);
}

bool isHeld(const ReportedValue &reported)
{
    return !reported.lines.empty() && reported.lines.back().quantity == kCapability;
}

void raise(double least, double &u)
{
    if (std::isfinite(u))
        u = std::max(u, least / kUsualFactor);
}

/// The model's curve is stated beside the measured rows.
void holdModelRow(Index row, double leastMagnitude, RowUncertainty &rows)
{
    raise(leastMagnitude, rows.u_modelMagnitude[row]);
    raise(rows.leastExpandedPhase_rad[row], rows.u_modelPhase_rad[row]);
}

/// What a report of rows says of one quantity.
struct RowColumns
{
    Eigen::VectorXd &u, &dof, &k;
};

void take(const ReportedValue &reported, Index row, const RowColumns &columns)
{
    columns.u[row] = *reported.u;
    columns.dof[row] = reported.dof;
    columns.k[row] = reported.k;
}

void holdRow(Index row, const ResponseResult &response, RowUncertainty &rows)
{
    if (std::isfinite(rows.u_magnitude[row]))
        take(magnitudeOfRow(response, rows, row), row,
            {rows.u_magnitude, rows.dof_magnitude, rows.k_magnitude});
    if (std::isfinite(rows.u_phase_rad[row]))
        take(
            phaseOfRow(response, rows, row), row, {rows.u_phase_rad, rows.dof_phase, rows.k_phase});
}

/// The value that a relative CMC is of.
double magnitudeAt(const ResponseResult &response, Index row)
{
    const bool isStated = row < response.magnitude.size() && std::isfinite(response.magnitude[row]);
    return isStated ? response.magnitude[row] : response.modelMagnitude[row];
}

void holdRows(
    const std::vector<CapabilityEntry> &cmc, const ResponseResult &response, RowUncertainty &rows)
{
    const Index count = rows.u_phase_rad.size();
    rows.leastExpanded_relative.resize(count);
    rows.leastExpandedPhase_rad.resize(count);
    for (Index row = 0; row < count; ++row) {
        const double f_Hz = response.frequency_Hz[row], S = magnitudeAt(response, row);
        rows.leastExpanded_relative[row] = leastExpanded(cmc, "magnitude", S, f_Hz) / S;
        rows.leastExpandedPhase_rad[row] = leastExpanded(cmc, "phase_rad", 1.0, f_Hz);
        holdRow(row, response, rows);
        if (row < response.modelMagnitude.size())
            holdModelRow(
                row, leastExpanded(cmc, "magnitude", response.modelMagnitude[row], f_Hz), rows);
    }
}

/// Frequencies of a response whose magnitude is stated outside the scope.
void addOutside(const std::vector<CapabilityEntry> &cmc, const ResponseResult &response,
    const RowUncertainty &rows, std::vector<double> &outside_Hz)
{
    for (Index row = 0; row < rows.u_magnitude.size(); ++row)
        if (std::isfinite(rows.u_magnitude[row]) && std::isfinite(response.magnitude[row])
            && isOutsideScope(cmc, response.frequency_Hz[row]))
            outside_Hz.push_back(response.frequency_Hz[row]);
}

void judgeScope(const std::vector<CapabilityEntry> &cmc, const ResponseResult &response,
    UncertaintyReport &report)
{
    std::vector<double> outside_Hz;
    addOutside(cmc, response, report.rows, outside_Hz);
    if (response.atMarks)
        addOutside(cmc, *response.atMarks, report.rowsAtMarks, outside_Hz);
    if (outside_Hz.empty())
        return;
    const auto [lowest, highest] = std::ranges::minmax(outside_Hz);
    report.findings.push_back({.id = "CER-007",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1 values of S(f), from %2 to %3, lie outside the frequencies that the laboratory states a capability (CMC) for; the certificate marks them as outside the scope."),
            {std::to_string(outside_Hz.size()), numberWithUnit(lowest, "Hz", 4),
                numberWithUnit(highest, "Hz", 4)}}});
}

} // namespace

bool isOutsideScope(const std::vector<CapabilityEntry> &cmc, double frequency_Hz)
{
    const auto isOfRows = [](const CapabilityEntry &entry) { return entry.of == "magnitude"; };
    return std::ranges::any_of(cmc, isOfRows)
        && std::ranges::none_of(cmc,
            [&](const CapabilityEntry &entry) { return isFor(entry, "magnitude", frequency_Hz); });
}

double leastExpanded(const std::vector<CapabilityEntry> &cmc, const std::string &of, double value,
    double frequency_Hz)
{
    double least = 0.0;
    for (const CapabilityEntry &entry : cmc) {
        const bool isRelative = entry.isRelative && of != "phase_rad";
        if (isFor(entry, of, frequency_Hz))
            least = std::max(least, entry.expanded * (isRelative ? std::abs(value) : 1.0));
    }
    return least;
}

void holdToCapability(const std::vector<CapabilityEntry> &cmc, const ResponseResult &response,
    UncertaintyReport &report)
{
    if (cmc.empty())
        return;
    if (report.sensitivity)
        holdValue(cmc, *report.sensitivity);
    if (report.sensitivity && isHeld(*report.sensitivity)) // no input makes U smaller then
        std::erase_if(report.findings, [](const Finding &one) { return one.id == "UNC-002"; });
    for (auto *values : {&report.perLevel, &report.ofShots, &report.ofModel})
        for (ReportedValue &one : *values)
            holdValue(cmc, one);
    holdRows(cmc, response, report.rows);
    if (response.atMarks)
        holdRows(cmc, *response.atMarks, report.rowsAtMarks);
    judgeScope(cmc, response, report);
}

} // namespace dyncal
