// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/realization/hankel_operator.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// Leading singular triplets of [H_1 H_2 ...].
struct SingularTriplets
{
    Eigen::VectorXd singularValues;
    Eigen::MatrixXd left; ///< r x k
    Eigen::MatrixXd right; ///< s x k, s summed over the blocks
};

/// The `count` leading triplets by implicitly restarted Lanczos on x -> sum H_i H_i^T x (Spectra),
/// residuals below 1e-10. Values below about 1e-8 of the first are noise of the squaring. The start
/// vector is fixed, so results repeat. Fails (Cancelled) on request, (Internal) without
/// convergence.
Result<SingularTriplets> leadingTriplets(
    const std::vector<HankelOperator> &blocks, Index count, const JobControl &control);

/// Largest singular value alone; 0 if it does not converge.
double largestSingularValue(const std::vector<HankelOperator> &blocks);

} // namespace dyncal
