// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

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

/// Real block-diagonal realisation of D + sum r_i / (z - p_i); conjugates stand side
/// by side, lone poles are real.
StateSpaceModel modalStateSpace(const std::vector<std::complex<double>> &poles,
    const Eigen::VectorXcd &residues, double feedthrough, double sampleInterval_s);

/// D, CB, CAB, ...: `count` values (thesis appendix D calls this dimpulse).
Eigen::VectorXd impulseResponse(const StateSpaceModel &model, Index count);

/// Finite zeros of C (zI - A)^-1 B + D; those further out than 1e6 are numerical infinities.
std::vector<std::complex<double>> transmissionZeros(const StateSpaceModel &model);

} // namespace dyncal
