// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/second_order/second_order_model.h"

#include <optional>

namespace dyncal {

/// Fits the second-order sensor for comparison with the model, starting from the model's main
/// resonance (or slowest real poles) and its shots' plateaus and onsets. Empty where the fit does
/// not converge, and for treatments whose series are no step responses with a plateau.
std::optional<SecondOrderModel> fitSecondOrderBeside(
    const ModelInput &input, const SensorModel &model, const JobControl &control);

} // namespace dyncal
