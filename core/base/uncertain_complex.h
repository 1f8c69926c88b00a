// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// A complex value, and the covariance of its real and imaginary part in the square of its unit.
struct UncertainComplex
{
    std::complex<double> value;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of (Re, Im), k = 1
};

/// The same as magnitude (unit of the value) and phase.
struct UncertainPolar
{
    double magnitude = 0.0; ///< not below 0
    double phase_rad = 0.0; ///< toPolar(): -pi to pi
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of (magnitude, phase)
};

// First-order propagation, V' = J V J^T (JCGM 102, 6.2); S. Eichstaedt, V. Wilkens,
// Meas. Sci. Technol. 27 (2016) 055001 has these for spectra. docs/method/dft-covariance.md.

/// The phase of 0 is not determined: its covariance is not a number there.
UncertainPolar toPolar(const UncertainComplex &z);

UncertainComplex toRectangular(const UncertainPolar &z);

/// numerator / denominator, independent of each other, as a record's line is of the response that
/// is divided out of it. Not a number where the denominator is 0.
UncertainComplex quotient(const UncertainComplex &numerator, const UncertainComplex &denominator);

} // namespace dyncal
