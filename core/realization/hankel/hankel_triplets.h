// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/realization/hankel/hankel_operator.h"
#include "core/realization/hankel/lanczos.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace dyncal {

/// Leading singular triplets of [H_1 H_2 ...].
struct SingularTriplets
{
    Eigen::VectorXd singularValues; ///< largest first
    Eigen::MatrixXd left; ///< r x k
    Eigen::MatrixXd right; ///< s x k, s summed over the blocks; empty unless asked for
    Index converged = 0; ///< the first so many are exact to rounding; the rest err by 1 % at most
};

/// Singular triplets by block Lanczos: of one symmetric block as the eigenpairs of the matrix
/// itself, otherwise as those of sum H_i H_i^T, where values below about 1e-8 of the first are
/// rounding. Later calls continue from the result of earlier ones.
class HankelTriplets
{
public:
    enum class Right { Wanted, NotWanted };

    /// Refers to `blocks`.
    explicit HankelTriplets(const std::vector<HankelOperator> &blocks);

    /// The `count` leading ones, count <= BlockLanczos::mostPairs(r). Fails (Cancelled) on request.
    Result<SingularTriplets> leading(Index count, Right right, const JobControl &control);

private:
    SingularTriplets fromEigenvalues(EigenPairs pairs, Right right) const;
    Result<SingularTriplets> fromSquares(
        EigenPairs pairs, Right right, const JobControl &control) const;

    const std::vector<HankelOperator> &m_blocks;
    std::unique_ptr<SymmetricOperator> m_product;
    BlockLanczos m_lanczos;
};

/// [H_1 H_2 ...] written out.
Eigen::MatrixXd denseHankel(const std::vector<HankelOperator> &blocks);

/// The largest singular value alone, to 1 % or better (usually 0.01 %); meaningless after a stop.
double largestSingularValue(
    const std::vector<HankelOperator> &blocks, const JobControl &control = {});

} // namespace dyncal
