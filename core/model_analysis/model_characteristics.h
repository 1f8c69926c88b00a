// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/step_characteristics.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <optional>

namespace dyncal {

/// Half width of the range about the level in which a step response has settled.
inline constexpr double kSettledRange = 0.05;

/// Closed: of the continuous model, so that neither rate nor window limits them
/// (docs/method/response.md). Empty for a free decay and where a pole does not decay.
StepCharacteristics stepCharacteristics(const SensorModel &model, ResponseTreatment treatment);

/// Time of the last passage into 1 +- `settled`, from the onset; empty where there is none, and as
/// stepCharacteristics().
std::optional<double> settlingTime_s(
    const SensorModel &model, ResponseTreatment treatment, double settled);

} // namespace dyncal
