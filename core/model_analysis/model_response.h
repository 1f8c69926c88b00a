// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <complex>

namespace dyncal {

/// Continuous response of the model at one frequency: G(jw) = c0 + sum c_i jw/(jw - s_i)
/// (docs/method/response.md; impulse: sum c_i/(jw - s_i)).
std::complex<double> modelResponse(
    const SensorModel &model, ResponseTreatment treatment, double frequency_Hz);

} // namespace dyncal
