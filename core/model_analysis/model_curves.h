// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <Eigen/Core>

namespace dyncal {

/// One curve of the response over frequency; phase unwrapped from 0 at f -> 0, lag negative.
struct ResponseCurve
{
    Eigen::VectorXd frequency_Hz;
    Eigen::VectorXd magnitude;
    Eigen::VectorXd phase_rad;
};

/// Bode curve of the model on `count` log-spaced frequencies.
ResponseCurve modelCurve(const SensorModel &model, ResponseTreatment treatment, double from_Hz,
    double to_Hz, Index count);

} // namespace dyncal
