// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// X minimising ||A X - B||; column-pivoted QR, rank-revealing; columns below 1e-14 are dropped.
Eigen::MatrixXcd leastSquares(const Eigen::MatrixXcd &A, const Eigen::MatrixXcd &B);
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd &A, const Eigen::MatrixXd &B);

} // namespace dyncal
