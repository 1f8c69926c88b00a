// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/refinement/refinement.h"

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// A pole as frequency and damping ratio, with uncertainties from the covariance of the fit.
struct PoleFigures
{
    double frequency_Hz = 0.0; ///< |s|/2pi
    double u_frequency_Hz = 0.0;
    double dampingRatio = 0.0; ///< -Re s/|s|
    double u_dampingRatio = 0.0; ///< 0 for a real pole, whose damping ratio is 1 by definition
};

/// Figures of s from the covariance of its real and imaginary part, first-order propagation
/// (GUM 5.1). s != 0.
PoleFigures pairFigures(std::complex<double> s_rad_s, const Eigen::Matrix2d &covariance);

/// Figures of pole `i` of the fit (of a pair either half).
PoleFigures poleFigures(const Refinement &refinement, Index i);

/// Student's factor of a two-sided 95 % interval.
double coverageFactor95(double dof);

} // namespace dyncal
