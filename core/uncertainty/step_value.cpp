// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/step_value.h"

#include "core/model_analysis/shot_lines.h"

#include <array>
#include <utility>

namespace dyncal {
namespace {

struct NamedResult
{
    const char *of;
    const char *unit;
};

/// In the order of StepResult.
constexpr std::array<NamedResult, kStepResults> kNames{
    {{"velocity_m_s", "m/s"}, {"mach", ""}, {"p2_pa", "Pa"}, {"p5_pa", "Pa"}, {"step_pa", "Pa"}}};

} // namespace

ReportedValue stepValue(const StepUncertainty &step, StepResult result, Index shot)
{
    const auto at = static_cast<Index>(result);
    const NamedResult &name = kNames[static_cast<std::size_t>(at)];
    ReportedValue reported{name.of, step.budget.value[at], name.unit};
    if (!step.u(result))
        return reported;
    for (const BudgetLine &line : step.budget.lines) {
        UncertaintyLine part = sourceLine(line, shot);
        part.sensitivity = line.sensitivity[at];
        part.contribution = line.contribution[at];
        reported.lines.push_back(std::move(part));
    }
    combineLines(reported);
    return reported;
}

} // namespace dyncal
