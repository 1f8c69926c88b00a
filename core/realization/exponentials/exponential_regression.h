// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// One mode of the model at one moment of the fit: Re(gain p^k) with p = e^exponent, the upper half
/// of a conjugate pair or real (then exponent and gain are real). A constant is a fixed exponent 0.
struct RegressionMode
{
    std::complex<double> exponent; ///< s dt
    std::complex<double> gain; ///< at k = 0
    bool isPair = false;
    bool isFixed = false; ///< its pole is no parameter
};

/// Normal equations of y_k = sum over modes of Re(gain p^k) for s and the gains, t = k dt.
/// Parameters, in this order: per mode that is not fixed Re s (and Im s of a pair), then per mode
/// Re gain (and Im gain of a pair).
struct RegressionEquations
{
    Eigen::MatrixXd matrix; ///< J^T J
    Eigen::VectorXd gradient; ///< J^T r
    double cost = 0.0; ///< r^T r
};

/// A record cut into columns, so that model and gradient are matrix products. J^T J comes from
/// powerSums, in a time that hardly grows with the record.
class ExponentialRegression
{
public:
    /// Only the samples of `used` (in order, not touching) take part; all if it is empty.
    explicit ExponentialRegression(
        const Eigen::VectorXd &y, const std::vector<SampleRange> &used = {});

    RegressionEquations equations(const std::vector<RegressionMode> &modes, double dt) const;

    /// Samples that take part.
    Index count() const;

private:
    Eigen::MatrixXd m_columns; ///< y, kBlock rows, the last column filled with zeros
    std::vector<SampleRange> m_used;
};

} // namespace dyncal
