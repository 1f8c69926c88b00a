// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

namespace dyncal {

/// Products of a few columns of powers with a record cut into blocks; they take most of the time of
/// a fit of exponentials. Up to kBlocks blocks a call, small enough for the first cache.
///
/// Sums run in the order of Eigen's matrix product of two columns per mode, to the last bit: rows
/// one after the other. Exception: the last of an odd number of modes, in calls of kBlocks blocks,
/// has separate sums of even and odd rows.
class BlockKernel
{
public:
    static constexpr Index kRows = 128;
    static constexpr Index kBlocks = 4;

    /// `powers`: kRows rows, one or two columns per mode. The last `lastColumns` columns belong to
    /// the last of an odd number of modes.
    BlockKernel(const Eigen::MatrixXd &powers, Index lastColumns);

    /// residual = y - powers * gains; gains: columns x blocks.
    void subtract(const double *y, const Eigen::MatrixXd &gains, double *residual) const;

    /// Per block (column): sum over j of powers(j, c) r_j for every c, then of j powers(j, c) r_j.
    void project(const double *residual, Eigen::MatrixXd &sums) const;

private:
    Eigen::MatrixXd m_powers;
    Eigen::MatrixXd m_rows; ///< transposed, plain and times j, filled up to whole lanes
    Eigen::MatrixXd m_lastRows; ///< the same of the last columns
    Index m_last;
};

/// Adds the squares of `count` values (a multiple of 4) to four sums: of places 0, 4, 8 ..., of
/// 1, 5, 9 ... and so on.
void addSquares(const double *values, Index count, double *fourSums);

} // namespace dyncal
