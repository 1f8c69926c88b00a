// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <complex>
#include <vector>

namespace dyncal {

/// s = ln(z) / dt; finite for z = 0 too.
std::complex<double> continuousPole(std::complex<double> z, double dt_s);

/// z = e^(s dt) of every continuous pole; the s of a negative real z gives exactly that z.
std::vector<std::complex<double>> discretePoles(
    const std::vector<std::complex<double>> &poles_rad_s, double dt_s);

} // namespace dyncal
