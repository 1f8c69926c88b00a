// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/shot_sensitivity.h"
#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

// Levels and sensitivities of the shots of a model. Internal to core/model_analysis.

/// The fit of a shot, or of the average; null without one.
const SeriesFit *fitOfShot(const SensorModel &model, Index shot);

bool shareOneUnit(const std::vector<WindowedResponse> &responses);

/// c0 of one shot. The fit of an average gives the mean; each shot's c0 is in proportion to its
/// step.
double plateauOf(const SeriesFit &fit, const WindowedResponse &response,
    const std::vector<WindowedResponse> &responses);

/// The level of the step itself, at the onset, likewise.
double levelOf(const SeriesFit &fit, const WindowedResponse &response,
    const std::vector<WindowedResponse> &responses);

/// Whether every series has a level that may be divided by (u up to 10 %); also where its u is
/// unknown.
bool isLevelKnown(const SensorModel &model);

/// The shots' sensitivities, one by one and together.
struct ShotSensitivities
{
    std::vector<ShotSensitivity> shots;
    SensitivitySummary summary; ///< empty where the shots differ in unit
    Findings findings; ///< CAP-023, RSP-002
};

ShotSensitivities describeShots(const std::vector<WindowedResponse> &responses,
    const SensorModel &model, const ShockConditionsSet &shock);

} // namespace dyncal
