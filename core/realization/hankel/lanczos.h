// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"

#include <Eigen/Core>

namespace dyncal {

/// A symmetric matrix known by its products only.
class SymmetricOperator
{
public:
    virtual ~SymmetricOperator() = default;
    virtual Index size() const = 0;
    /// Y = A X, column by column; Y has the size of X.
    virtual void apply(const Eigen::Ref<const Eigen::MatrixXd> &X, Eigen::Ref<Eigen::MatrixXd> Y)
        = 0;
};

/// Leading eigenpairs, largest magnitude first.
struct EigenPairs
{
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors; ///< orthonormal columns
    Index converged = 0; ///< the first so many have a residual below the tolerance
};

/// Block Lanczos with full reorthogonalisation and thick restarts (Wu and Simon 2000) for the
/// eigenvalues of largest magnitude. The start block is fixed and sums have a fixed order, so that
/// results repeat, with one thread or two. If the subspace is exhausted (low rank) it continues
/// with a fresh random direction. docs/method/hankel.md.
class BlockLanczos
{
public:
    /// `A` is referred to. A pair counts as converged at ||A v - t v|| <= tolerance |t|, or at the
    /// rounding of A's products.
    explicit BlockLanczos(SymmetricOperator &A, double tolerance = 1e-8);

    /// Largest number of pairs a matrix of this size can be asked for.
    static Index mostPairs(Index size);

    /// Iterates until the `count` leading pairs have converged, or for at most 100 count + 1000
    /// products; continues from the result of an earlier call. False when asked to stop.
    bool iterate(Index count, const JobControl &control);

    /// The `count` leading pairs after the last iterate(), which must have asked for at least as
    /// many.
    EigenPairs leading(Index count);

    Index products() const { return m_products; } ///< A x so far

private:
    void grow();
    void extendProjection(const Eigen::MatrixXd &corner);
    void appendOrthonormal(Eigen::MatrixXd &W);
    Eigen::MatrixXd removeBasis(Eigen::Ref<Eigen::MatrixXd> W, Index columns) const;
    Eigen::MatrixXd removeCoupled(Eigen::Ref<Eigen::MatrixXd> W) const;
    void decompose();
    void restart(Index keep);
    Index convergedAmong(Index count) const;
    double excess(Index pair) const;
    double largestExcess(Index count) const;
    Index capacity(Index count) const;
    void reserve(Index columns);

    SymmetricOperator &m_A;
    double m_tolerance;
    Eigen::MatrixXd m_Q; ///< basis, then the next block
    Eigen::MatrixXd m_T; ///< projected matrix: Q^T A Q
    Eigen::MatrixXd m_coupling; ///< A Q = Q T + next * coupling
    Index m_dimension = 0; ///< columns of the basis
    bool m_restarted = false; ///< the next block couples to the whole basis, not to its last block
    double m_scale = 0.0; ///< largest norm of A q so far: the scale of rounding
    Index m_products = 0;
    Eigen::VectorXd m_values; ///< of T, largest magnitude first
    Eigen::MatrixXd m_rotation; ///< eigenvectors of T
    Eigen::VectorXd m_residuals;
};

} // namespace dyncal
