// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/shot_uncertainty.h"

#include "core/base/propagation.h"
#include "core/shock/shock_uncertainty.h"

#include <cmath>

namespace dyncal {

void addUncertainty(const SeriesFit &fit, const ShockConditions &conditions, ShotSensitivity &shot)
{
    constexpr double kCoverage = 0.95;
    const auto u_step_Pa = conditions.uncertainty && !conditions.stepTyped
        ? conditions.uncertainty->u(StepResult::Step)
        : std::nullopt;
    if (!u_step_Pa || !std::isfinite(fit.u_level()) || fit.level() == 0.0)
        return;
    const double ofStep = *u_step_Pa / *conditions.step_Pa;
    const double ofLevel = fit.u_level() / fit.level();
    const double relative = std::hypot(ofStep, ofLevel);
    const double dof = conditions.uncertainty->budget.dof[static_cast<Index>(StepResult::Step)]
        * std::pow(relative / ofStep, 4.0);
    shot.u_sensitivity = std::abs(*shot.sensitivity) * relative;
    shot.k_sensitivity = coverageFactor(dof, kCoverage);
}

} // namespace dyncal
