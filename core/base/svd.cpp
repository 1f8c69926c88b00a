// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/svd.h"

#include "core/base/index.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace dyncal {
namespace {

template <typename Matrix>
Matrix solve(const Matrix &A, const Matrix &B)
{
    Eigen::ColPivHouseholderQR<Matrix> qr(A);
    qr.setThreshold(1e-14);
    return qr.solve(B);
}

} // namespace

ThinSvd thinSvd(const Eigen::MatrixXd &matrix)
{
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
    return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

LeftSvd leftSvd(const Eigen::MatrixXd &matrix)
{
    const Index rows = matrix.rows();
    Eigen::MatrixXd small = matrix;
    if (matrix.cols() > rows) {
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix.transpose());
        small = Eigen::MatrixXd(qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>())
                    .transpose();
    }
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(small, Eigen::ComputeThinU);
    return {svd.matrixU(), svd.singularValues()};
}

SymmetricEigen symmetricEigen(const Eigen::MatrixXd &matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd &matrix)
{
    return matrix.eigenvalues();
}

Eigen::MatrixXcd leastSquares(const Eigen::MatrixXcd &A, const Eigen::MatrixXcd &B)
{
    return solve(A, B);
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd &A, const Eigen::MatrixXd &B)
{
    return solve(A, B);
}

} // namespace dyncal
