// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/pole_rates.h"

#include <cmath>
#include <numbers>

namespace dyncal {

std::complex<double> rateOf(std::complex<double> z, double dt_s)
{
    // A pole at 0 is a pure delay: infinitely fast, kept finite so that it can be listed.
    constexpr double kTiny = 1e-300;
    return std::log(std::abs(z) > kTiny ? z : std::complex<double>(kTiny)) / dt_s;
}

std::vector<std::complex<double>> discretePoles(
    const std::vector<std::complex<double>> &rates, double dt_s)
{
    std::vector<std::complex<double>> poles;
    for (const std::complex<double> &s : rates) {
        const std::complex<double> z = std::exp(s * dt_s);
        // The s of a negative real z lies on the Nyquist line and has no partner there.
        const bool onNyquistLine = std::abs(std::abs(s.imag()) * dt_s - std::numbers::pi) < 1e-12;
        poles.push_back(onNyquistLine ? std::complex<double>(z.real()) : z);
    }
    return poles;
}

} // namespace dyncal
