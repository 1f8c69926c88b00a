// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// X = V diag(t) V^T of a symmetric matrix, t ascending.
struct SymmetricEigen
{
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// In a translation unit of its own, apart from the SVD: Eigen's templates compile slowly.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd &matrix);

/// Eigenvalues of a real square matrix.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd &matrix);

} // namespace dyncal
