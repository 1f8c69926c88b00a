// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// Largest order of a model of the noise in a record; its autocovariance is kept for as many lags.
inline constexpr Index kLargestNoiseModelOrder = 20;

/// Autocovariance of a noise record about its mean, lag 0 first: sum of products over `count`.
struct NoiseCovariance
{
    Eigen::VectorXd values;
    Index count = 0; ///< values of the record
};

/// Lags 0 to `lags` at most, fewer where the record has fewer values.
NoiseCovariance noiseCovariance(const Eigen::Ref<const Eigen::VectorXd> &noise, Index lags);

/// Highest order tried for the noise of a model input (docs/method/order.md).
inline constexpr Index kLargestNoiseModel = 8;

/// Noise e_k = x_k + a_1 x_(k-1) + ... + a_p x_(k-p) with white e; no coefficients: x is white.
struct AutoregressiveModel
{
    Eigen::VectorXd coefficients; ///< a_1 .. a_p
    double innovationVariance = 0.0; ///< of e

    Index order() const { return coefficients.size(); }
};

/// Yule-Walker by Levinson's recursion: always stable. 0 <= order < covariance.values.size().
AutoregressiveModel autoregressiveModel(const NoiseCovariance &covariance, Index order);

/// One model for each record, all of the order 0 .. `largest` with the smallest sum over the
/// records of BIC(p) = n ln(innovation variance) + p ln n (docs/method/order.md). Orders that would
/// leave a record fewer than ten values per coefficient are not tried. Order 0 where a record is
/// too short or does not vary.
std::vector<AutoregressiveModel> chooseAutoregressiveModels(
    const std::vector<NoiseCovariance> &records, Index largest);

/// x filtered by 1 + sum a_i z^-i; the first a.size() values, which would need samples before the
/// record, are left out. Poles of a sum of exponentials survive a FIR filter.
Eigen::VectorXd whitened(const Eigen::Ref<const Eigen::VectorXd> &x, const Eigen::VectorXd &a);

} // namespace dyncal
