// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/least_squares.h"

#include <Eigen/QR>

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

Eigen::MatrixXcd leastSquares(const Eigen::MatrixXcd &A, const Eigen::MatrixXcd &B)
{
    return solve(A, B);
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd &A, const Eigen::MatrixXd &B)
{
    return solve(A, B);
}

} // namespace dyncal
