// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/synthesis/sensor_simulator.h"

#include <complex>

namespace dyncal::testing {

/// G(jw) of a simulated sensor, in closed form.
inline std::complex<double> sensorResponse(const SensorSpec &sensor, double frequency_Hz)
{
    const std::complex<double> s(0.0, kTwoPi * frequency_Hz);
    std::complex<double> sum(0.0, 0.0);
    for (const SensorMode &mode : sensor.modes) {
        const double omega0 = kTwoPi * mode.f0_Hz;
        sum += mode.weight * omega0 * omega0
            / (s * s + 2.0 * mode.zeta * omega0 * s + omega0 * omega0);
    }
    if (sensor.realPole_Hz)
        sum /= 1.0 + s / (kTwoPi * *sensor.realPole_Hz);
    if (sensor.acCoupling_s)
        sum *= s / (s + 1.0 / *sensor.acCoupling_s);
    return sensor.sensitivity_V_Pa * sum;
}

} // namespace dyncal::testing
