// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"

#include <complex>
#include <functional>

namespace dyncal {

/// A model as characteristicValues() needs it, poles, level and amplitudes alone; the amplitude of
/// every pole s (rad/s) is `factor(s)` times as large, the level stays.
SensorModel withAmplitudes(const SensorModel &model,
    const std::function<std::complex<double>(std::complex<double> s_rad_s)> &factor);

/// The sensor that a record of level 1 + `mounting` is of where the mounting takes part in the
/// level and not in what rings (docs/method/uncertainty.md): relative to the sensor's own level all
/// amplitudes are 1/(1 + mounting) times as large.
SensorModel withMounting(const SensorModel &model, double mounting);

} // namespace dyncal
