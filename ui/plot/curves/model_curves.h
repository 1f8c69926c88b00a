// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/sensor_response.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/response_window.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// Data against model. `series` (a position) shows that one alone. Where the model diverges the
/// title says so and its curve ends at the measured range +-50 %.
PlotContent simulationCurves(const ModelInput &input, const SensorModel &model,
    const WindowResult &window, std::optional<std::size_t> series = std::nullopt);

/// Data minus model, every series or one (a position).
PlotContent errorCurves(const ModelInput &input, const SensorModel &model,
    const WindowResult &window, std::optional<std::size_t> series = std::nullopt);

/// Poles and zeros in the z-plane with the unit circle; a marker per class of pole. Those beyond
/// kFarthestInMap are only counted.
PlotContent poleZeroCurves(const SensorModel &model);

/// Magnitude of the response: model as a line, non-parametric values as dots with +- 2u.
PlotContent bodeMagnitudeCurves(const ResponseResult &response);

/// Phase in degrees; where the measured one has another zero than the model's, the legend says so.
PlotContent bodePhaseCurves(const ResponseResult &response);

/// Response of the continuous model to a unit step, from the onset until it has settled, with lines
/// for its overshoot where `response` states one.
PlotContent stepCurves(const SensorModel &model, ResponseTreatment treatment,
    const ResponseResult *response = nullptr);

} // namespace dyncal
