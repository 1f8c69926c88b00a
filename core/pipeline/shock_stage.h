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

/// When each sensor felt the shock: the model's onset where there is one, else the detected start,
/// which its own delay makes late.
std::vector<DutArrival> dutArrivals(const WindowResult &window, const SensorModel &model);

/// Velocity, states, step, uncertainty and tube of every shot, and which peaks of the spectra move
/// with the gas (SPC-005).
Result<ShockConditionsSet> shockStage(const CaptureSet &set, const WindowResult &window,
    const SpectrumResult &spectrum, const SensorModel &model, const Recipe &recipe,
    const JobControl &control = {});

/// Prominent peaks of the first shot's spectrum that every other shot shows, where it would lie if
/// it were the gas's or the sensor's or between, tested against the sound speed of region 5.
/// `shock` needs states of at least two shots; otherwise nothing is followed.
std::vector<FollowedPeak> followPeaks(
    const SpectrumResult &spectrum, const WindowResult &window, const ShockConditionsSet &shock);

} // namespace dyncal
