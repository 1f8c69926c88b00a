// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/front.h"

#include <cmath>

namespace dyncal {

bool isFrontStated(const FrontDuration &front)
{
    return front.duration_s > 0.0 || front.u_s > 0.0;
}

std::complex<double> frontFactor(double duration_s, std::complex<double> s)
{
    constexpr double kSmall = 1e-3; // the next term of the series is z^4/120
    const std::complex<double> z = 0.5 * duration_s * s;
    return std::abs(z) < kSmall ? 1.0 + z * z / 6.0 : std::sinh(z) / z;
}

ExponentialSum asIfSharp(ExponentialSum behindFront, double duration_s)
{
    for (Index i = 0; i < behindFront.amplitudes.size(); ++i)
        behindFront.amplitudes[i] /= frontFactor(duration_s, behindFront.poles_rad_s[i]);
    return behindFront;
}

} // namespace dyncal
