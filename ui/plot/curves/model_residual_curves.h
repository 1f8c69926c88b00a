// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/decomposition/component_settings.h"
#include "core/model_analysis/sensor_response.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/second_order/second_order_model.h"
#include "core/signal/response_window.h"
#include "ui/plot/values/plot_content.h"

#include <optional>

namespace dyncal {

/// Autocorrelation of what the model leaves of every series, or of one (a position), with the
/// bounds of white noise at the confidence and lags of the settings.
PlotContent modelResidualCurves(const ModelInput &input, const SensorModel &model,
    const WindowResult &window, const ComponentSettings &settings,
    std::optional<std::size_t> series = std::nullopt);

/// Adds the second-order sensor that was fitted beside the model: K/(1 - x^2 + 2 j zeta x), in the
/// unit of the response.
void addSecondOrder(PlotContent &magnitude, const SensorModel &model, const SecondOrderModel &fit,
    const ResponseResult &response);

} // namespace dyncal
