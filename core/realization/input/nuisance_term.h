// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace dyncal {

/// What one mode that is not the sensor's adds to one record: Re(amplitude e^(pole t)), t from the
/// detected start. Every record has its own pole and amplitude (docs/method/nuisance-modes.md).
struct NuisanceTerm
{
    std::size_t mode = 0; ///< place in the recipe's list
    bool startsWithStep = true; ///< driven by the step (tube), or there before it (anything else)
    std::complex<double> pole_rad_s; ///< upper half of the pair
    std::complex<double> amplitude;

    double frequency_Hz() const { return std::abs(pole_rad_s) / (2.0 * std::numbers::pi); }
    double dampingRatio() const { return -pole_rad_s.real() / std::abs(pole_rad_s); }
    double value(double t_s) const { return (amplitude * std::exp(pole_rad_s * t_s)).real(); }
};

} // namespace dyncal
