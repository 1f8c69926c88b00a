// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

namespace dyncal {

/// X = U diag(s) V^T, thin: U rows x k, V columns x k, k = min(rows, columns), s descending.
struct ThinSvd
{
    Eigen::MatrixXd left;
    Eigen::VectorXd singularValues;
    Eigen::MatrixXd right;
};

/// All dense SVD code lives behind these functions, in one translation unit: Eigen's template costs
/// a minute of compile time.
ThinSvd thinSvd(const Eigen::MatrixXd &matrix);

/// The same without V. Much less work for a wide X: only R of X^T = Q R is decomposed.
struct LeftSvd
{
    Eigen::MatrixXd left;
    Eigen::VectorXd singularValues;
};
LeftSvd leftSvd(const Eigen::MatrixXd &matrix);

} // namespace dyncal
