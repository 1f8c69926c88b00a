// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/exponential_regression.h"

#include "core/realization/exponentials/block_kernel.h"
#include "core/realization/exponentials/exponential_gram.h"
#include "core/realization/exponentials/exponential_sum.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
constexpr Index kBlock = BlockKernel::kRows; ///< powers within a block stay accurate

using Column = ExponentialColumn; ///< d y / d parameter

std::vector<Column> columnsOf(const std::vector<RegressionMode> &modes)
{
    const Complex i(0.0, 1.0);
    std::vector<Column> columns;
    for (std::size_t m = 0; m < modes.size(); ++m) {
        if (modes[m].isFixed)
            continue;
        columns.push_back({modes[m].gain, m, 1});
        if (modes[m].isPair)
            columns.push_back({i * modes[m].gain, m, 1});
    }
    for (std::size_t m = 0; m < modes.size(); ++m) {
        columns.push_back({1.0, m, 0});
        if (modes[m].isPair)
            columns.push_back({i, m, 0});
    }
    return columns;
}

/// Powers of the modes within a block (rows 0 .. kBlock-1) and at the blocks' beginnings.
struct Powers
{
    Eigen::MatrixXd within; ///< per mode Re p^j, and of a pair Im p^j
    Eigen::MatrixXcd begins; ///< mode x block: p^(kBlock b)
};

Index columnsOf(const RegressionMode &mode)
{
    return mode.isPair ? 2 : 1;
}

Powers powersOf(const std::vector<RegressionMode> &modes, Index blocks)
{
    const Index count = std::ssize(modes);
    Index columns = 0;
    for (const RegressionMode &mode : modes)
        columns += columnsOf(mode);
    Powers powers{Eigen::MatrixXd(kBlock, columns), Eigen::MatrixXcd(count, blocks)};
    Index column = 0;
    for (Index m = 0; m < count; ++m) {
        const RegressionMode &mode = modes[static_cast<std::size_t>(m)];
        powers.within.middleCols(column, columnsOf(mode))
            = powerTable(mode.exponent, kBlock).leftCols(columnsOf(mode));
        column += columnsOf(mode);
        // Not by multiplication from block to block: errors would add up over a long record.
        for (Index b = 0; b < blocks; ++b)
            powers.begins(m, b) = std::exp(mode.exponent * static_cast<double>(b * kBlock));
    }
    return powers;
}

/// Gains of the columns of powers in some blocks.
Eigen::MatrixXd gainsOf(
    const std::vector<RegressionMode> &modes, const Powers &powers, Index begin, Index blocks)
{
    Eigen::MatrixXd gains(powers.within.cols(), blocks);
    Index column = 0;
    for (Index m = 0; m < powers.begins.rows(); ++m) {
        const RegressionMode &mode = modes[static_cast<std::size_t>(m)];
        for (Index b = 0; b < blocks; ++b) {
            const Complex here = mode.gain * powers.begins(m, begin + b);
            gains(column, b) = here.real();
            if (mode.isPair)
                gains(column + 1, b) = -here.imag();
        }
        column += columnsOf(mode);
    }
    return gains;
}

/// Adds the sums over k of r_k p^k and of r_k k p^k, per mode, of some blocks.
void addMoments(const std::vector<RegressionMode> &modes, const Powers &powers,
    const Eigen::MatrixXd &sums, Index begin, Eigen::MatrixX2cd &moments)
{
    const Index columns = powers.within.cols();
    for (Index b = 0; b < sums.cols(); ++b) {
        const double before = static_cast<double>((begin + b) * kBlock);
        Index c = 0;
        for (Index m = 0; m < moments.rows(); ++m) {
            const RegressionMode &mode = modes[static_cast<std::size_t>(m)];
            const Complex zeroth(sums(c, b), mode.isPair ? sums(c + 1, b) : 0.0);
            const Complex first(sums(columns + c, b), mode.isPair ? sums(columns + c + 1, b) : 0.0);
            moments(m, 0) += powers.begins(m, begin + b) * zeroth;
            moments(m, 1) += powers.begins(m, begin + b) * (before * zeroth + first);
            c += columnsOf(mode);
        }
    }
}

/// Zero where a sample takes no part; `values` begin with sample `begin`.
void clearUnused(
    const std::vector<SampleRange> &used, Index begin, Eigen::Ref<Eigen::VectorXd> values)
{
    const Index end = begin + values.size();
    Index free = begin;
    for (const SampleRange &range : used) {
        const Index next = std::clamp(range.begin, free, end);
        values.segment(free - begin, next - free).setZero();
        free = std::clamp(range.end, next, end);
    }
    values.tail(end - free).setZero();
}

} // namespace

ExponentialRegression::ExponentialRegression(
    const Eigen::VectorXd &y, const std::vector<SampleRange> &used)
    : m_columns(Eigen::MatrixXd::Zero(kBlock, (y.size() + kBlock - 1) / kBlock))
    , m_used(used)
{
    if (m_used.empty())
        m_used.push_back({0, y.size()});
    m_columns.reshaped().head(y.size()) = y;
}

Index ExponentialRegression::count() const
{
    Index count = 0;
    for (const SampleRange &range : m_used)
        count += range.size();
    return count;
}

RegressionEquations ExponentialRegression::equations(
    const std::vector<RegressionMode> &modes, double dt) const
{
    const Index blocks = m_columns.cols();
    const Powers powers = powersOf(modes, blocks);
    const BlockKernel kernel(
        powers.within, modes.size() % 2 == 1 ? columnsOf(modes.back()) : Index(0));
    Eigen::MatrixX2cd moments = Eigen::MatrixX2cd::Zero(std::ssize(modes), 2);
    std::array<double, 4> squares{};
    for (Index begin = 0; begin < blocks; begin += BlockKernel::kBlocks) {
        const Index count = std::min(BlockKernel::kBlocks, blocks - begin);
        Eigen::VectorXd residual(count * kBlock);
        kernel.subtract(
            m_columns.col(begin).data(), gainsOf(modes, powers, begin, count), residual.data());
        clearUnused(m_used, begin * kBlock, residual);
        addSquares(residual.data(), residual.size(), squares.data());
        Eigen::MatrixXd sums(2 * powers.within.cols(), count);
        kernel.project(residual.data(), sums);
        addMoments(modes, powers, sums, begin, moments);
    }
    std::vector<Complex> exponents;
    for (const RegressionMode &mode : modes)
        exponents.push_back(mode.exponent);
    const ExponentialGram gram(exponents, m_used);

    const std::vector<Column> columns = columnsOf(modes);
    const Index count = std::ssize(columns);
    RegressionEquations sum{Eigen::MatrixXd(count, count), Eigen::VectorXd(count),
        (squares[0] + squares[2]) + (squares[1] + squares[3])};
    for (Index a = 0; a < count; ++a) {
        const Column &column = columns[static_cast<std::size_t>(a)];
        const Complex moment
            = moments(static_cast<Index>(column.mode), static_cast<Index>(column.order));
        sum.gradient[a] = (column.factor * moment).real() * (column.order == 0 ? 1.0 : dt);
        for (Index b = 0; b <= a; ++b) {
            sum.matrix(a, b) = gram.product(column, columns[static_cast<std::size_t>(b)], dt);
            sum.matrix(b, a) = sum.matrix(a, b);
        }
    }
    return sum;
}

} // namespace dyncal
