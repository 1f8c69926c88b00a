// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/second_order_truth.h"

#include <cmath>
#include <numbers>

namespace dyncal {

double SecondOrderTruth::step(double t_s) const
{
    if (t_s <= 0.0)
        return 0.0;
    const double decay = 2.0 * std::numbers::pi * f0_Hz * zeta;
    const double root = std::sqrt(1.0 - zeta * zeta);
    const double angle = 2.0 * std::numbers::pi * f0_Hz * root * t_s;
    return 1.0 - std::exp(-decay * t_s) * (std::cos(angle) + zeta / root * std::sin(angle));
}

std::complex<double> SecondOrderTruth::response(double frequency_Hz) const
{
    const double r = frequency_Hz / f0_Hz;
    return 1.0 / std::complex<double>(1.0 - r * r, 2.0 * zeta * r);
}

std::complex<double> SecondOrderTruth::pole_rad_s() const
{
    const double w0_rad_s = 2.0 * std::numbers::pi * f0_Hz;
    return {-zeta * w0_rad_s, std::sqrt(1.0 - zeta * zeta) * w0_rad_s};
}

Eigen::VectorXd SecondOrderTruth::sampled(double rate_Hz, Index count, double first) const
{
    return Eigen::VectorXd::NullaryExpr(
        count, [&](Index k) { return step((static_cast<double>(k) + first) / rate_Hz); });
}

} // namespace dyncal
