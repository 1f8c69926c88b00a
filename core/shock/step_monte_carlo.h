// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/shock_uncertainty.h"
#include "core/shock/uncertainty_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Monte Carlo of one shot's step, or why there is none (in English).
struct ShotMonteCarlo
{
    Index shot = 0;
    std::optional<StepMonteCarlo> outcome;
    std::string missing;
};

struct StepMonteCarloSet
{
    std::vector<ShotMonteCarlo> shots; ///< those whose step has an uncertainty
    Findings findings; ///< SHK-012

    const ShotMonteCarlo *ofShot(Index shot) const;
};

/// Draws the step of every shot that has an uncertainty. Fails (Usage) on settings that make no
/// sense, and when stopped.
Result<StepMonteCarloSet> stepMonteCarlo(const ShockConditionsSet &shock,
    const UncertaintySettings &settings, const JobControl &control = {});

} // namespace dyncal
