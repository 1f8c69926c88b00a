// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

namespace dyncal {

/// x(k+1) = A x(k) + B u(k), y(k) = C x(k) + D u(k), sampled every `sampleInterval_s` (eq 3.23).
struct StateSpaceModel
{
    Eigen::MatrixXd A; ///< n x n
    Eigen::MatrixXd B; ///< n x 1
    Eigen::MatrixXd C; ///< 1 x n
    Eigen::MatrixXd D; ///< 1 x 1
    double sampleInterval_s = 0.0;

    Index order() const { return A.rows(); }
};

} // namespace dyncal
