// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/svd.h"

#include "core/base/index.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace dyncal {
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

} // namespace dyncal
