// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/shot_lines.h"

namespace dyncal {
namespace {

UncertaintyLine lineOf(const BudgetLine &line, const ShotSensitivity &shot)
{
    UncertaintyLine part = sourceLine(line, shot.shot);
    part.contribution = -line.contribution[static_cast<Index>(StepResult::Step)] / *shot.step_Pa;
    part.sensitivity = part.u > 0.0 ? part.contribution / part.u : 0.0;
    return part;
}

} // namespace

UncertaintyLine sourceLine(const BudgetLine &line, Index shot)
{
    UncertaintyLine part;
    part.quantity = line.input.quantity;
    part.value = line.input.value;
    part.u = line.input.u;
    part.distribution = line.input.distribution;
    part.dof = line.input.dof;
    part.correlated = line.input.correlated;
    if (line.input.common)
        return part;
    part.shot = shot;
    return with(OverShots::Own, part);
}

std::vector<UncertaintyLine> shotLines(
    const ShotSensitivity &shot, const StepUncertainty &step, double levelDof)
{
    std::vector<UncertaintyLine> lines{
        with(OverShots::Own, directLine(kLevelRelative, shot.uLevel_relative, levelDof))};
    lines.front().shot = shot.shot;
    for (const BudgetLine &line : step.budget.lines)
        lines.push_back(lineOf(line, shot));
    return lines;
}

} // namespace dyncal
