// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/step_value.h"

#include <array>

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

UncertaintyLine lineOf(const BudgetLine &line, Index result, Index shot)
{
    UncertaintyLine part;
    part.quantity = line.input.quantity;
    part.value = line.input.value;
    part.u = line.input.u;
    part.distribution = line.input.distribution;
    part.dof = line.input.dof;
    part.correlated = line.input.correlated;
    part.sensitivity = line.sensitivity[result];
    part.contribution = line.contribution[result];
    if (line.input.common)
        return part;
    part.shot = shot;
    return with(OverShots::Own, part);
}

} // namespace

ReportedValue stepValue(const StepUncertainty &step, StepResult result, Index shot)
{
    const auto at = static_cast<Index>(result);
    const NamedResult &name = kNames[static_cast<std::size_t>(at)];
    ReportedValue reported{name.of, step.budget.value[at], name.unit};
    if (!step.u(result))
        return reported;
    for (const BudgetLine &line : step.budget.lines)
        reported.lines.push_back(lineOf(line, at, shot));
    combineLines(reported);
    return reported;
}

} // namespace dyncal
