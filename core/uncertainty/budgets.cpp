// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/budgets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr double kDegrees = 360.0 / kTwoPi; ///< of a radian

Index shotsOfLevel(const ResponseResult &response, ShotLevel level)
{
    return static_cast<Index>(std::ranges::count(response.shots, level, &ShotSensitivity::level));
}

void addLevels(
    const UncertaintyReport &report, const ResponseResult &response, std::vector<Budget> &budgets)
{
    const auto &levels = response.summary.perLevel;
    for (std::size_t i = 0; i < std::min(levels.size(), report.perLevel.size()); ++i)
        budgets.push_back({BudgetOf::Level, levels[i].level, kUnknown,
            shotsOfLevel(response, levels[i].level), report.perLevel[i]});
}

void addModelValues(const UncertaintyReport &report, Index shots, std::vector<Budget> &budgets)
{
    for (const ReportedValue &one : report.ofModel)
        budgets.push_back({BudgetOf::Model, ShotLevel::None, kUnknown, shots, one});
}

/// Where all that makes its u is known; `known` is that u, or not a number.
template <typename Make>
ReportedValue rowValue(const ReportedValue &bare, double known, const Make &make)
{
    if (std::isfinite(known))
        return make();
    ReportedValue reported = bare;
    reported.missing = {DYNCAL_TEXT("core", "a part of it is not known"), {}};
    return reported;
}

Budget magnitudeBudget(
    const UncertaintyReport &report, const ResponseResult &response, Index row, Index shots)
{
    const ReportedValue bare{
        "magnitude", response.magnitude[row], response.unit == "1" ? "" : response.unit};
    return {BudgetOf::Magnitude, ShotLevel::None, response.frequency_Hz[row], shots,
        rowValue(bare, report.rows.u_magnitude[row],
            [&] { return magnitudeOfRow(response, report.rows, row); })};
}

/// All lines of a phase are in its own unit.
ReportedValue inDegrees(ReportedValue reported)
{
    for (UncertaintyLine &line : reported.lines) {
        line.u *= kDegrees;
        line.contribution *= kDegrees;
    }
    reported.leastExpanded *= kDegrees;
    reported.of = "phase";
    reported.value *= kDegrees;
    reported.unit = "\xC2\xB0";
    combineLines(reported);
    return reported;
}

Budget phaseBudget(
    const UncertaintyReport &report, const ResponseResult &response, Index row, Index shots)
{
    const ReportedValue bare{"phase", kDegrees * response.phase_rad[row], "\xC2\xB0"};
    return {BudgetOf::Phase, ShotLevel::None, response.frequency_Hz[row], shots,
        rowValue(bare, report.rows.u_phase_rad[row],
            [&] { return inDegrees(phaseOfRow(response, report.rows, row)); })};
}

bool isInBand(const ResponseResult &response, Index row)
{
    constexpr double kRoundingOfEdge = 1e-9; // the last row lies on it
    const double f_Hz = response.frequency_Hz[row];
    return std::isfinite(response.magnitude[row])
        && f_Hz >= (1.0 - kRoundingOfEdge) * response.fLow_Hz
        && f_Hz <= (1.0 + kRoundingOfEdge) * response.fHigh_Hz;
}

/// All magnitudes, then all phases.
void addRows(const UncertaintyReport &report, const ResponseResult &response, Index shots,
    std::vector<Budget> &budgets)
{
    const Index count = std::min(report.rows.u_magnitude.size(), response.magnitude.size());
    for (const auto make : {magnitudeBudget, phaseBudget})
        for (Index row = 0; row < count; ++row)
            if (isInBand(response, row))
                budgets.push_back(make(report, response, row, shots));
}

} // namespace

std::vector<Budget> allBudgets(const UncertaintyReport &report, const ResponseResult &response)
{
    std::vector<Budget> budgets;
    const auto shots = static_cast<Index>(response.shots.size());
    if (report.sensitivity)
        budgets.push_back(
            {BudgetOf::Sensitivity, ShotLevel::None, kUnknown, shots, *report.sensitivity});
    addLevels(report, response, budgets);
    addModelValues(report, shots, budgets);
    addRows(report, response, shots, budgets);
    return budgets;
}

} // namespace dyncal
