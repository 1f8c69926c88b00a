// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/recipe.h"
#include "core/realization/sensor_model.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// What is known of the shock before any model: from the starts that were detected in the records.
struct ExpectedShock
{
    ShockConditionsSet conditions; ///< empty where the settings make no sense, or none are wanted
    Findings findings; ///< CAP-010
};

/// By the starts of the DUTs, detected or typed (window.start), which a sensor's delay makes late:
/// for the plateau's end, and so that the records are read once. Never fails: what is wrong with
/// the settings is said by shockStage().
Result<ExpectedShock> expectedShock(
    const CaptureSet &set, const RecordStarts &starts, const Recipe &recipe);

/// When each sensor felt the shock: the model's onset where there is one, else the detected start,
/// which its own delay makes late.
std::vector<DutArrival> dutArrivals(const WindowResult &window, const SensorModel &model);

/// Velocity, states, step, uncertainty and tube of every shot, and which peaks of the spectra move
/// with the gas (SPC-005). Reads nothing from the records: that is in `expected`.
Result<ShockConditionsSet> shockStage(const CaptureSet &set, const ShockConditionsSet &expected,
    const WindowResult &window, const SpectrumResult &spectrum, const SensorModel &model,
    const Recipe &recipe);

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

/// Prominent peaks of the first shot's spectrum that every other shot shows, where it would lie if
/// it were the gas's or the sensor's or between, tested against the sound speed of region 5.
/// `shock` needs states of at least two shots; otherwise nothing is followed.
std::vector<FollowedPeak> followPeaks(
    const SpectrumResult &spectrum, const WindowResult &window, const ShockConditionsSet &shock);

} // namespace dyncal
