// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>
#include <numbers>

namespace dyncal::testing {

/// |2 J1(x)/x| with x = pi f d/W: the factor by which a diaphragm of diameter d in the side wall,
/// swept by the shock, reduces a frequency.
inline double sideWallAveraging(double frequency_Hz, double diameter_m, double velocity_m_s)
{
    const double x = std::numbers::pi * frequency_Hz * diameter_m / velocity_m_s;
    return x < 1e-6 ? 1.0 : std::abs(2.0 * std::cyl_bessel_j(1.0, x) / x);
}

} // namespace dyncal::testing
