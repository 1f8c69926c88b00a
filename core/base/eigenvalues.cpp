// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace dyncal {

SymmetricEigen symmetricEigen(const Eigen::MatrixXd &matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd &matrix)
{
    return matrix.eigenvalues();
}

} // namespace dyncal
