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

} // namespace dyncal
