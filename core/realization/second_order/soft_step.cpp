// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/soft_step.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

using Complex = std::complex<double>;

/// Both poles; zeta is kept away from 1, where they meet.
struct Poles
{
    Complex first;
    Complex second;
};

Poles polesOf(double omega_rad_s, double zeta)
{
    constexpr double kApart = 1e-9;
    if (std::abs(zeta - 1.0) < kApart)
        zeta = zeta < 1.0 ? 1.0 - kApart : 1.0 + kApart;
    const Complex root = std::sqrt(Complex(zeta * zeta - 1.0));
    return {omega_rad_s * (-zeta + root), omega_rad_s * (-zeta - root)};
}

double sharp(const Poles &s, double t_s)
{
    if (t_s <= 0.0)
        return 0.0;
    return 1.0
        + ((s.second * std::exp(s.first * t_s) - s.first * std::exp(s.second * t_s))
            / (s.first - s.second))
              .real();
}

/// Integral of sharp() from 0 on.
double area(const Poles &s, double t_s)
{
    if (t_s <= 0.0)
        return 0.0;
    const auto part
        = [t_s](Complex own, Complex other) { return other / own * (std::exp(own * t_s) - 1.0); };
    return t_s
        + ((part(s.first, s.second) - part(s.second, s.first)) / (s.first - s.second)).real();
}

} // namespace

double softStep(double omega_rad_s, double zeta, double duration_s, double t_s)
{
    constexpr double kSharp = 1e-4; // of the period over 2 pi: below it the areas cancel
    const Poles poles = polesOf(omega_rad_s, zeta);
    if (omega_rad_s * duration_s < kSharp)
        return sharp(poles, t_s);
    const double half_s = 0.5 * duration_s;
    return (area(poles, t_s + half_s) - area(poles, t_s - half_s)) / duration_s;
}

} // namespace dyncal
