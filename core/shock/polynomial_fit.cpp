// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/polynomial_fit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace dyncal {

Polynomial fitPolynomial(const Eigen::VectorXd &x, const Eigen::VectorXd &y,
    const Eigen::VectorXd &weight, Index parameters, const std::optional<CoefficientPrior> &prior)
{
    const Index count = x.size();
    const Index rows = count + (prior ? 1 : 0);
    Eigen::MatrixXd powers = Eigen::MatrixXd::Zero(rows, parameters);
    Eigen::VectorXd seen(rows), root(rows);
    powers.col(0).head(count).setOnes();
    for (Index k = 1; k < parameters; ++k)
        powers.col(k).head(count) = powers.col(k - 1).head(count).cwiseProduct(x);
    seen.head(count) = y;
    root.head(count) = weight.cwiseSqrt();
    if (prior) {
        powers(count, parameters - 1) = 1.0;
        seen[count] = prior->value;
        root[count] = std::sqrt(prior->weight);
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(root.asDiagonal() * powers);
    Polynomial fit;
    fit.coefficients = qr.solve(root.cwiseProduct(seen));
    const Eigen::VectorXd residual = seen - powers * fit.coefficients;
    fit.residual = residual.head(count);
    fit.squares = root.cwiseProduct(residual).squaredNorm();
    const Eigen::MatrixXd triangle = qr.matrixQR().topRows(parameters);
    const Eigen::MatrixXd inverse = triangle.triangularView<Eigen::Upper>().solve(
        Eigen::MatrixXd::Identity(parameters, parameters));
    fit.covariance = inverse * inverse.transpose();
    fit.gain = fit.covariance * powers.topRows(count).transpose() * weight.asDiagonal();
    return fit;
}

Index distinctPlaces(Eigen::VectorXd x)
{
    std::sort(x.begin(), x.end());
    return std::unique(x.begin(), x.end()) - x.begin();
}

} // namespace dyncal
