// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/uncertain_value.h"
#include "core/model_analysis/shot_sensitivity.h"
#include "core/shock/shock_uncertainty.h"

#include <limits>
#include <vector>

namespace dyncal {

/// The source of a line of a step's budget (evaluateStep()), without what it does to a value: of
/// `shot` where other shots do not share its error, else of all.
UncertaintyLine sourceLine(const BudgetLine &line, Index shot);

/// What makes the sensitivity of one shot uncertain, relative to it: the noise of its level, of
/// `levelDof` degrees of freedom, and every input of its step, which acts the other way round for
/// a larger step makes it smaller. Inputs that all shots have in common are OverShots::Shared, the
/// others its own. Needs `shot.step_Pa`.
std::vector<UncertaintyLine> shotLines(const ShotSensitivity &shot, const StepUncertainty &step,
    double levelDof = std::numeric_limits<double>::infinity());

} // namespace dyncal
