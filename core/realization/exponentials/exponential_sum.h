// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// y(t) = c0 + sum c_i e^(s_i t): the form in which all results are kept (docs/method/model.md).
/// Poles come in exact conjugate pairs (upper half first) or real; amplitudes likewise.
struct ExponentialSum
{
    double constant = 0.0; ///< c0
    Eigen::VectorXcd poles_rad_s; ///< s_i
    Eigen::VectorXcd amplitudes; ///< c_i

    /// Value of the k-th derivative at time t (k = 0: the value itself).
    double derivative(double t_s, int k) const;
    double value(double t_s) const { return derivative(t_s, 0); }
};

/// Re and Im of e^(k exponent) for k = 0 .. rows - 1, by one multiplication each; for up to a few
/// hundred rows, where rounding does not yet add up.
Eigen::MatrixX2d powerTable(std::complex<double> exponent, Index rows);

/// Re and Im of e^(k exponent), k = 0 .. count - 1, over any length: products of two tables of
/// direct exponentials, so that rounding does not add up. The magnitude is 1 at k = `origin`:
/// growing exponentials are computed backwards from their last sample.
Eigen::MatrixX2d exponentials(std::complex<double> exponent, Index count, Index origin = 0);

/// Values of a sum at t = k dt, block by block: one exponential per block and mode instead of one
/// per sample.
class ExponentialSampler
{
public:
    static constexpr Index kBlock = 256;

    ExponentialSampler(const ExponentialSum &sum, double dt_s);

    /// Values at k = kBlock * block + (0 .. kBlock - 1).
    Eigen::VectorXd block(Index block) const;

private:
    ExponentialSum m_sum;
    double m_dt_s;
    Eigen::MatrixXd m_powers; ///< per mode Re e^(s j dt), Im e^(s j dt)
};

/// Sorted so that pairs are adjacent with the upper half first, then made exact: conjugates equal,
/// lone values real. Input: eigenvalues of a real matrix in any order. Order: by |arg|, then |z|.
std::vector<std::complex<double>> pairedPoles(const Eigen::VectorXcd &eigenvalues);

/// True where pole i is the upper half of a conjugate pair (then i + 1 is the lower).
bool isUpperOfPair(const std::vector<std::complex<double>> &poles, std::size_t i);

/// Real basis of sum c_i p_i^k for k = 0..count-1: columns |p|^k cos, |p|^k sin for pairs, p^k for
/// real poles (sign kept); the last column is 1 when `withConstant`. Columns are scaled to largest
/// value 1; `scales` receives the divisors.
Eigen::MatrixXd exponentialBasis(const std::vector<std::complex<double>> &poles, Index count,
    bool withConstant, Eigen::VectorXd *scales = nullptr);

/// Least-squares amplitudes of `y_k = c0 + sum c_i p_i^k`, k = 0.. (docs/method/model.md).
struct AmplitudeFit
{
    double constant = 0.0;
    Eigen::VectorXcd amplitudes;
    Eigen::VectorXd fitted;
};
AmplitudeFit fitAmplitudes(
    const Eigen::VectorXd &y, const std::vector<std::complex<double>> &poles, bool withConstant);
/// The same for records in columns, which share poles and length: one decomposition for all.
std::vector<AmplitudeFit> fitAmplitudesTogether(const Eigen::MatrixXd &records,
    const std::vector<std::complex<double>> &poles, bool withConstant);

} // namespace dyncal
