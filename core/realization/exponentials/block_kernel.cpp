// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/block_kernel.h"

#include "core/base/lanes.h"

namespace dyncal {
namespace {

constexpr Index kRows = BlockKernel::kRows;

struct Block
{
    const double *columns; ///< powers, or their rows
    Index count; ///< columns, or places of a row
    const double *record;
    double *out;
    Index outStride;
};

template <int B>
DYNCAL_INLINE void subtractTile(const Block &block, const double *gains)
{
    for (Index i = 0; i < kRows; i += kLanes) {
        Lanes model[B] = {};
        for (Index c = 0; c < block.count; ++c) {
            const Lanes power = *lanes(block.columns + c * kRows + i);
            for (int b = 0; b < B; ++b)
                model[b] += power * gains[c + b * block.count];
        }
        for (int b = 0; b < B; ++b)
            *lanes(block.out + b * kRows + i) = *lanes(block.record + b * kRows + i) - model[b];
    }
}

/// `Chains` sums a place: of every row, or of even and of odd rows.
template <int B, int Chains>
DYNCAL_INLINE void projectTile(const Block &block)
{
    for (Index place = 0; place < block.count; place += kLanes) {
        Lanes sums[B][Chains] = {};
        for (Index j = 0; j < kRows; j += Chains) {
            for (int k = 0; k < Chains; ++k) {
                const Lanes row = *lanes(block.columns + (j + k) * block.count + place);
                for (int b = 0; b < B; ++b)
                    sums[b][k] += row * block.record[b * kRows + j + k];
            }
        }
        for (int b = 0; b < B; ++b) {
            Lanes sum = sums[b][0];
            if constexpr (Chains == 2)
                sum += sums[b][1];
            *lanes(block.out + b * block.outStride + place) = sum;
        }
    }
}

DYNCAL_INLINE void subtractBlocks(const Block &block, const double *gains, Index blocks)
{
    if (blocks == BlockKernel::kBlocks) {
        subtractTile<BlockKernel::kBlocks>(block, gains);
        return;
    }
    Block one = block;
    for (Index b = 0; b < blocks; ++b) {
        subtractTile<1>(one, gains + b * block.count);
        one.record += kRows;
        one.out += kRows;
    }
}

DYNCAL_INLINE void projectBlocks(const Block &block, bool inTwoChains, Index blocks)
{
    if (blocks == BlockKernel::kBlocks && inTwoChains) {
        projectTile<BlockKernel::kBlocks, 2>(block);
        return;
    }
    if (blocks == BlockKernel::kBlocks) {
        projectTile<BlockKernel::kBlocks, 1>(block);
        return;
    }
    Block one = block;
    for (Index b = 0; b < blocks; ++b) {
        projectTile<1, 1>(one);
        one.record += kRows;
        one.out += block.outStride;
    }
}

DYNCAL_INLINE void addSquaresOf(const double *values, Index count, double *fourSums)
{
    Lanes sums = *lanes(fourSums);
    for (Index i = 0; i < count; i += kLanes) {
        const Lanes value = *lanes(values + i);
        sums += value * value;
    }
    *lanes(fourSums) = sums;
}

void subtractAnywhere(const Block &block, const double *gains, Index blocks)
{
    subtractBlocks(block, gains, blocks);
}

DYNCAL_AVX2 void subtractAvx2(const Block &block, const double *gains, Index blocks)
{
    subtractBlocks(block, gains, blocks);
}

void projectAnywhere(const Block &block, bool inTwoChains, Index blocks)
{
    projectBlocks(block, inTwoChains, blocks);
}

DYNCAL_AVX2 void projectAvx2(const Block &block, bool inTwoChains, Index blocks)
{
    projectBlocks(block, inTwoChains, blocks);
}

void addSquaresAnywhere(const double *values, Index count, double *fourSums)
{
    addSquaresOf(values, count, fourSums);
}

DYNCAL_AVX2 void addSquaresAvx2(const double *values, Index count, double *fourSums)
{
    addSquaresOf(values, count, fourSums);
}

/// Rows of columns and of columns times j, one row after the other, zeros up to whole lanes.
Eigen::MatrixXd rowsOf(const Eigen::MatrixXd &columns)
{
    const Index count = columns.cols();
    const Index places = (2 * count + kLanes - 1) / kLanes * kLanes;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(places, kRows);
    for (Index j = 0; j < kRows; ++j) {
        rows.col(j).head(count) = columns.row(j);
        rows.col(j).segment(count, count) = columns.row(j) * static_cast<double>(j);
    }
    return rows;
}

} // namespace

BlockKernel::BlockKernel(const Eigen::MatrixXd &powers, Index lastColumns)
    : m_powers(powers)
    , m_rows(rowsOf(powers.leftCols(powers.cols() - lastColumns)))
    , m_lastRows(rowsOf(powers.rightCols(lastColumns)))
    , m_last(lastColumns)
{
}

void BlockKernel::subtract(const double *y, const Eigen::MatrixXd &gains, double *residual) const
{
    const auto run = hasAvx2() ? subtractAvx2 : subtractAnywhere;
    run({m_powers.data(), m_powers.cols(), y, residual, 0}, gains.data(), gains.cols());
}

void BlockKernel::project(const double *residual, Eigen::MatrixXd &sums) const
{
    const auto run = hasAvx2() ? projectAvx2 : projectAnywhere;
    const Index count = m_powers.cols();
    const Index first = count - m_last;
    Eigen::MatrixXd most(m_rows.rows(), sums.cols());
    Eigen::MatrixXd last(m_lastRows.rows(), sums.cols());
    run({m_rows.data(), m_rows.rows(), residual, most.data(), most.rows()}, false, sums.cols());
    run({m_lastRows.data(), m_lastRows.rows(), residual, last.data(), last.rows()}, true,
        sums.cols());
    sums.topRows(first) = most.topRows(first);
    sums.middleRows(first, m_last) = last.topRows(m_last);
    sums.middleRows(count, first) = most.middleRows(first, first);
    sums.bottomRows(m_last) = last.middleRows(m_last, m_last);
}

void addSquares(const double *values, Index count, double *fourSums)
{
    (hasAvx2() ? addSquaresAvx2 : addSquaresAnywhere)(values, count, fourSums);
}

} // namespace dyncal
