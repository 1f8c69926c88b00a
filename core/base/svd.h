// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// X = U diag(s) V^T, thin: U rows x k, V columns x k, k = min(rows, columns), s descending.
struct ThinSvd
{
    Eigen::MatrixXd left;
    Eigen::VectorXd singularValues;
    Eigen::MatrixXd right;
};

/// All dense SVD and eigenvalue code lives behind these functions, in one translation unit: each
/// of the Eigen templates costs up to a minute of compile time.
ThinSvd thinSvd(const Eigen::MatrixXd &matrix);

/// The same without V, which is much less work for a wide X: of X^T = Q R only R is decomposed.
struct LeftSvd
{
    Eigen::MatrixXd left;
    Eigen::VectorXd singularValues;
};
LeftSvd leftSvd(const Eigen::MatrixXd &matrix);

/// X = V diag(t) V^T of a symmetric matrix, t ascending.
struct SymmetricEigen
{
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};
SymmetricEigen symmetricEigen(const Eigen::MatrixXd &matrix);

/// Eigenvalues of a real square matrix.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd &matrix);

/// X minimising ||A X - B||; column-pivoted QR, rank-revealing; columns below 1e-14 are dropped.
Eigen::MatrixXcd leastSquares(const Eigen::MatrixXcd &A, const Eigen::MatrixXcd &B);
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd &A, const Eigen::MatrixXd &B);

} // namespace dyncal
