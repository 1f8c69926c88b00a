// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// What is known of the last coefficient beforehand: it counts as one more observation.
struct CoefficientPrior
{
    double value = 0.0;
    double weight = 0.0; ///< 1/u^2
};

/// Polynomial through y over x by weighted least squares.
struct Polynomial
{
    Eigen::VectorXd coefficients; ///< ascending
    Eigen::MatrixXd covariance; ///< for weights that are inverse variances
    Eigen::VectorXd residual; ///< of y
    double squares = 0.0; ///< weighted sum of the residuals' squares, the prior's included
    Eigen::MatrixXd gain; ///< coefficients by y: how much each observation moves each of them
};

/// `weight` of each y, all above 0; `parameters` coefficients, no more than there are observations
/// (the prior is one).
Polynomial fitPolynomial(const Eigen::VectorXd &x, const Eigen::VectorXd &y,
    const Eigen::VectorXd &weight, Index parameters,
    const std::optional<CoefficientPrior> &prior = std::nullopt);

/// Number of different places: two values at one place say nothing about the shape along the tube.
Index distinctPlaces(Eigen::VectorXd x);

} // namespace dyncal
