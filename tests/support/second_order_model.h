// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"

#include <cmath>
#include <numbers>

namespace dyncal::testing {

/// Model of w0^2/(s^2 + 2 zeta w0 s + w0^2), written down, not identified: for tests of what is
/// derived from a model.
inline SensorModel secondOrderModel(double f0_Hz, double zeta, double gain = 1.0)
{
    const double w0 = 2.0 * std::numbers::pi * f0_Hz;
    const std::complex<double> s = w0 * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
    SensorModel model;
    model.order = 2;
    model.plateauGain = gain;
    model.amplitudes.resize(2);
    const std::complex<double> c = gain * std::conj(s) / (s - std::conj(s)); // y(0) = y'(0) = 0
    model.amplitudes << c, std::conj(c);
    for (const std::complex<double> &half : {s, std::conj(s)}) {
        Pole pole;
        pole.s_rad_s = half;
        pole.z = std::exp(half / (100.0 * f0_Hz));
        pole.poleClass = PoleClass::Sensor;
        pole.frequency_Hz = f0_Hz;
        pole.dampingRatio = zeta;
        model.poles.push_back(pole);
    }
    return model;
}

} // namespace dyncal::testing
