// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// The sensor w0^2/(s^2 + 2 zeta w0 s + w0^2), 0 < zeta < 1, written out in closed form: nothing of
/// it is computed by the method that it is the truth for.
struct SecondOrderTruth
{
    double f0_Hz = 0.0;
    double zeta = 0.0;

    double step(double t_s) const; ///< response to a unit step at 0
    std::complex<double> response(double frequency_Hz) const;
    std::complex<double> pole_rad_s() const; ///< the upper of the two

    /// step((k + first) / rate), k = 0 .. count - 1.
    Eigen::VectorXd sampled(double rate_Hz, Index count, double first) const;
};

} // namespace dyncal
