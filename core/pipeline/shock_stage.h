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

/// What is known of the shock before any model, from the starts detected in the records.
struct ExpectedShock
{
    ShockConditionsSet conditions; ///< empty if the settings are invalid or the shock is disabled
    Findings findings; ///< CAP-010
};

/// From the starts of the DUTs, detected or typed (window.start), which are late by the sensor's
/// delay. The window uses the plateau's end, and the records are read here only. Never fails:
/// shockStage() reports invalid settings.
Result<ExpectedShock> expectedShock(
    const CaptureSet &set, const RecordStarts &starts, const Recipe &recipe);

/// When each sensor felt the shock: the model's onset, else the detected start, which is late by
/// the sensor's delay.
std::vector<DutArrival> dutArrivals(const WindowResult &window, const SensorModel &model);

/// Velocity, states, step, uncertainty and tube of every shot, and which peaks of the spectra move
/// with the gas (SPC-005). Reads nothing from the records: that is in `expected`.
Result<ShockConditionsSet> shockStage(const CaptureSet &set, const ShockConditionsSet &expected,
    const WindowResult &window, const SpectrumResult &spectrum, const SensorModel &model,
    const Recipe &recipe);

} // namespace dyncal
