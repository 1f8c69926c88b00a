// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/pole_uncertainty.h"

#include "core/base/constants.h"
#include "core/base/distributions.h"

#include <cmath>

namespace dyncal {

PoleFigures pairFigures(std::complex<double> s, const Eigen::Matrix2d &covariance)
{
    const double w = std::abs(s);
    const Eigen::Vector2d frequency(s.real() / w, s.imag() / w);
    const Eigen::Vector2d damping(
        -s.imag() * s.imag() / (w * w * w), s.real() * s.imag() / (w * w * w));
    return {w / kTwoPi, std::sqrt(frequency.dot(covariance * frequency)) / kTwoPi, -s.real() / w,
        std::sqrt(damping.dot(covariance * damping))};
}

PoleFigures poleFigures(const Refinement &refinement, Index i)
{
    const auto &poles = refinement.poles_rad_s;
    if (poles[static_cast<std::size_t>(i)].imag() < 0.0)
        --i; // the pair's parameters stand at its upper half
    const std::complex<double> s = poles[static_cast<std::size_t>(i)];
    const Eigen::MatrixXd &covariance = refinement.covariance;
    if (s.imag() != 0.0)
        return pairFigures(s, covariance.block<2, 2>(i, i));
    const double w = std::abs(s);
    return {w / kTwoPi, std::sqrt(covariance(i, i)) / kTwoPi, -s.real() / w, 0.0};
}

double coverageFactor95(double dof)
{
    return studentQuantile(0.975, dof);
}

} // namespace dyncal
