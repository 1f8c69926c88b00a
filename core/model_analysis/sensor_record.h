// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/drift.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/response_window.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// One shot's window as the sensor alone would have recorded it: the model's nuisance terms are
/// subtracted, stretches left out are filled by the model (docs/method/nuisance-modes.md).
struct SensorRecord
{
    /// A mode that the step excites: amplitude in the record, and in the pressure relative to the
    /// step, both at the onset.
    struct Driven
    {
        std::complex<double> pole_rad_s;
        std::complex<double> response;
        std::complex<double> pressure;
    };

    /// A drift that `values` are freed of: c (1 - e^(s t)) was added, so that they stay at the
    /// level of the onset.
    struct Slow
    {
        double rate_rad_s = 0.0;
        double response = 0.0; ///< c, in the record
        double pressure = 0.0; ///< of what the sensor sees, relative to the step; 0 where the
                               ///< drift belongs to the sensor's chain
    };

    Eigen::VectorXd values; ///< the window, and what was recorded shortly before it
    Index early = 0; ///< of them, before the detected start
    std::vector<Driven> driven;
    std::vector<Slow> slow;

    /// Response to the step alone, from the transform of `values`: (transform + the modes' part of
    /// the record) over (1 + their part of the pressure). Without such modes it is `transform`. A
    /// slow mode's parts are c s/(jw - s).
    std::complex<double> ofStep(std::complex<double> transform, double frequency_Hz) const;
};

/// `fit` describes the shot by the poles of `model`, one amplitude each; null = no model of it,
/// then nothing is subtracted. `drift`: findDrift() of the same model.
SensorRecord sensorRecord(const WindowedResponse &response, const SensorModel &model,
    const SeriesFit *fit, const DriftResult &drift = {});

} // namespace dyncal
