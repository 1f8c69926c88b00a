// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// p value of what the model leaves of the series having the colour of their pre-trigger noise, by
/// autocorrelations at the lags 1 to 20 (Ljung and Box; docs/method/order.md). `model` is one of
/// `input`. NaN where the model diverges or no series has more than 80 samples.
double residualWhiteness_p(const ModelInput &input, const SensorModel &model);

} // namespace dyncal
