// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/uncertain_complex.h"

#include <cmath>

namespace dyncal {
namespace {

/// V' = J V J^T.
Eigen::Matrix2d propagated(const Eigen::Matrix2d &J, const Eigen::Matrix2d &V)
{
    return J * V * J.transpose();
}

/// What multiplying by `factor` does to (Re, Im).
Eigen::Matrix2d asMatrix(std::complex<double> factor)
{
    return (Eigen::Matrix2d() << factor.real(), -factor.imag(), factor.imag(), factor.real())
        .finished();
}

} // namespace

UncertainPolar toPolar(const UncertainComplex &z)
{
    const double A = std::abs(z.value);
    const double c = z.value.real() / A;
    const double s = z.value.imag() / A;
    const Eigen::Matrix2d J = (Eigen::Matrix2d() << c, s, -s / A, c / A).finished();
    return {A, std::arg(z.value), propagated(J, z.covariance)};
}

UncertainComplex toRectangular(const UncertainPolar &z)
{
    const double A = z.magnitude;
    const double c = std::cos(z.phase_rad);
    const double s = std::sin(z.phase_rad);
    const Eigen::Matrix2d J = (Eigen::Matrix2d() << c, -A * s, s, A * c).finished();
    return {{A * c, A * s}, propagated(J, z.covariance)};
}

UncertainComplex quotient(const UncertainComplex &numerator, const UncertainComplex &denominator)
{
    const std::complex<double> value = numerator.value / denominator.value;
    const Eigen::Matrix2d ofNumerator = asMatrix(1.0 / denominator.value);
    const Eigen::Matrix2d ofDenominator = asMatrix(-value / denominator.value);
    return {value,
        propagated(ofNumerator, numerator.covariance)
            + propagated(ofDenominator, denominator.covariance)};
}

} // namespace dyncal
