// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/pole_mapping.h"

#include <cmath>
#include <numbers>

namespace dyncal {

std::complex<double> continuousPole(std::complex<double> z, double dt_s)
{
    // A pole at 0 is a pure delay: infinitely fast, kept finite so that it can be listed.
    constexpr double kTiny = 1e-300;
    return std::log(std::abs(z) > kTiny ? z : std::complex<double>(kTiny)) / dt_s;
}

std::vector<std::complex<double>> discretePoles(
    const std::vector<std::complex<double>> &poles_rad_s, double dt_s)
{
    std::vector<std::complex<double>> poles;
    for (const std::complex<double> &s : poles_rad_s) {
        const std::complex<double> z = std::exp(s * dt_s);
        // The s of a negative real z lies on the Nyquist line and has no partner there.
        const bool onNyquistLine = std::abs(std::abs(s.imag()) * dt_s - std::numbers::pi) < 1e-12;
        poles.push_back(onNyquistLine ? std::complex<double>(z.real()) : z);
    }
    return poles;
}

} // namespace dyncal
