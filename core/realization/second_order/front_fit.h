// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/realization/second_order/second_order_fit.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// The beginning of a record, where a front shows.
struct EarlyRecord
{
    Eigen::VectorXd y;
    double first_s = 0.0; ///< time of y[0] after the detected start
    double rate_Hz = 0.0;
    double weight = 1.0; ///< 1 / sd of the whitened noise
    Eigen::VectorXd whitening = {}; ///< coefficients of whitened(); empty = white
};

/// Weighted sum of squares of `residual`, whitened.
double whitenedSquares(const EarlyRecord &record, const Eigen::VectorXd &residual);

/// A second-order sensor behind a front, as the beginning of the records shows both.
struct FrontFit
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
    double duration_s = 0.0;
    double u_duration_s = 0.0; ///< 0 where it was given
    double cost = 0.0; ///< sum of whitenedSquares()
    Index parameters = 0; ///< of all: w0, zeta, duration where free, and per record K and onset
};

/// Nonlinear least squares of K softStep(w0, zeta, T, t - onset) to all records, K and onset of
/// each its own: T is `start_s`, or free from there on. Empty where it does not converge.
std::optional<FrontFit> fitFront(const std::vector<EarlyRecord> &records,
    const SecondOrderStart &start, double start_s, bool isFree, const JobControl &control = {});

} // namespace dyncal
