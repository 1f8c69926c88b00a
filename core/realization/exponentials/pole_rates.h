// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <complex>
#include <vector>

namespace dyncal {

/// s = ln(z) / dt; finite for z = 0 too.
std::complex<double> rateOf(std::complex<double> z, double dt_s);

/// z = e^(s dt) of every rate; the s of a negative real z gives that real z back.
std::vector<std::complex<double>> discretePoles(
    const std::vector<std::complex<double>> &rates_rad_s, double dt_s);

} // namespace dyncal
