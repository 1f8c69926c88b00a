// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/project/recipe.h"
#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/shock_velocity.h"
#include "core/signal/record_starts.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"

#include <vector>

namespace dyncal {

/// What is known of the shock before any model: from the starts that were detected in the records.
struct ExpectedShock
{
    ShockConditionsSet conditions; ///< empty where the settings make no sense, or none are wanted
    Findings findings; ///< CAP-010
};

/// From the starts of the DUTs, detected or typed (window.start), which are late by the sensor's
/// delay. Gives the plateau's end to the window, and has the records read only once. Never fails:
/// what is wrong with the settings is said by shockStage().
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

} // namespace dyncal
