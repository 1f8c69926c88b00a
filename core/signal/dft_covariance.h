// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/uncertain_complex.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// Second moments of the error e of a complex value: E|e|^2 and E e^2. With them
/// var Re = (power + Re square)/2, var Im = (power - Re square)/2, cov(Re, Im) = Im square/2, and a
/// factor a makes them |a|^2 power and a^2 square.
struct ComplexMoments
{
    double power = 0.0;
    std::complex<double> square;
};

/// The covariance of (Re, Im) with these moments.
Eigen::Matrix2d covarianceOf(const ComplexMoments &moments);

/// F(f) = sum y_n e^(-2 pi j f n / rate) at each frequency, and the covariance of its parts from
/// independent errors of the samples with the variances `variance` (as many as y, unit of y
/// squared, not below 0). Exact: with C(f) = sum var_n e^(-2 pi j f n / rate),
/// var Re F = [C(0) + Re C(2f)]/2, var Im F = [C(0) - Re C(2f)]/2, cov(Re F, Im F) = Im C(2f)/2
/// (S. Eichstaedt, V. Wilkens, Meas. Sci. Technol. 27 (2016) 055001, for all bins at once).
/// 0 < rate_Hz; |f| N / rate below 2^51. One value for each frequency.
/// docs/method/dft-covariance.md.
std::vector<UncertainComplex> dftWithCovariance(const Eigen::Ref<const Eigen::VectorXd> &y,
    const Eigen::Ref<const Eigen::VectorXd> &variance, double rate_Hz,
    const Eigen::Ref<const Eigen::VectorXd> &frequency_Hz);

/// Covariance of all (Re F(f_1), Re F(f_2) ..., Im F(f_1), Im F(f_2) ...) from the same errors:
/// with C at sums and differences of two frequencies a and b, cov(Re, Re) = Re [C(a-b) + C(a+b)]/2,
/// cov(Im, Im) = Re [C(a-b) - C(a+b)]/2, cov(Re F(a), Im F(b)) = Im [C(a+b) - C(a-b)]/2. Takes as
/// many sums over the record as there are pairs, twice.
Eigen::MatrixXd dftCovariance(const Eigen::Ref<const Eigen::VectorXd> &variance, double rate_Hz,
    const Eigen::Ref<const Eigen::VectorXd> &frequency_Hz);

} // namespace dyncal
