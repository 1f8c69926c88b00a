// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/sensor_poles.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr double kCriticalDistance = 1e-8;

} // namespace

std::vector<std::complex<double>> modePoles(const SensorMode &mode)
{
    const double omega0 = kTwoPi * mode.f0_Hz;
    const double zeta
        = std::abs(mode.zeta - 1.0) < kCriticalDistance ? 1.0 - kCriticalDistance : mode.zeta;
    if (zeta < 1.0) {
        const double imaginary = omega0 * std::sqrt((1.0 - zeta) * (1.0 + zeta));
        return {{-zeta * omega0, imaginary}, {-zeta * omega0, -imaginary}};
    }
    const double fast = omega0 * (zeta + std::sqrt((zeta - 1.0) * (zeta + 1.0)));
    return {{-fast, 0.0}, {-omega0 * omega0 / fast, 0.0}};
}

std::vector<double> sharedRealPoles_per_s(const SensorSpec &sensor)
{
    std::vector<double> poles_per_s;
    if (sensor.realPole_Hz)
        poles_per_s.push_back(kTwoPi * *sensor.realPole_Hz);
    if (sensor.acCoupling_s)
        poles_per_s.push_back(1.0 / *sensor.acCoupling_s);
    if (sensor.heat)
        poles_per_s.push_back(1.0 / sensor.heat->tau_s);
    return poles_per_s;
}

} // namespace dyncal
