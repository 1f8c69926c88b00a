// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponential_regression.h"

#include "core/realization/exponential_sum.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
constexpr Index kBlock = 128; ///< rows: powers within stay accurate, products stay in the cache

/// d y / d parameter = t^order Re(factor p^k).
struct Column
{
    Complex factor;
    std::size_t mode;
    std::size_t order; ///< 1 for parameters of the pole, 0 for those of the gain
};

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

/// Sums of k^a e^(exponent k) over the samples of all ranges.
std::array<Complex, 3> powerSumsOver(Complex exponent, const std::vector<SampleRange> &ranges)
{
    std::array<Complex, 3> total{};
    for (const SampleRange &range : ranges) {
        const auto b = static_cast<double>(range.begin);
        const auto [s0, s1, s2] = powerSums(std::exp(exponent), range.size());
        const Complex begin = std::exp(exponent * b);
        total[0] += begin * s0;
        total[1] += begin * (s1 + b * s0);
        total[2] += begin * (s2 + 2.0 * b * s1 + b * b * s0);
    }
    return total;
}

/// Sum over k of the product of two columns: Re(a) Re(b) = (Re(a b) + Re(a conj b)) / 2.
class GramTable
{
public:
    GramTable(const std::vector<RegressionMode> &modes, const std::vector<SampleRange> &ranges)
        : m_modes(modes.size())
        , m_sums(m_modes * m_modes)
    {
        for (std::size_t a = 0; a < m_modes; ++a) {
            for (std::size_t b = 0; b <= a; ++b)
                m_sums[a * m_modes + b]
                    = {powerSumsOver(modes[a].exponent + modes[b].exponent, ranges),
                        powerSumsOver(modes[a].exponent + std::conj(modes[b].exponent), ranges)};
        }
    }

    double product(const Column &a, const Column &b, double dt) const
    {
        if (b.mode > a.mode)
            return product(b, a, dt);
        const Pair &sums = m_sums[a.mode * m_modes + b.mode];
        const std::size_t order = a.order + b.order;
        const Complex both = a.factor * b.factor * sums.straight[order]
            + a.factor * std::conj(b.factor) * sums.conjugate[order];
        return 0.5 * both.real() * (order == 0 ? 1.0 : order == 1 ? dt : dt * dt);
    }

private:
    struct Pair
    {
        std::array<Complex, 3> straight;
        std::array<Complex, 3> conjugate;
    };

    std::size_t m_modes;
    std::vector<Pair> m_sums;
};

/// Powers of the modes within a block (rows 0 .. kBlock-1) and at the blocks' beginnings.
struct Powers
{
    Eigen::MatrixXd within; ///< per mode Re p^j, Im p^j
    Eigen::MatrixXcd begins; ///< mode x block: p^(kBlock b)
};

Powers powersOf(const std::vector<RegressionMode> &modes, Index blocks)
{
    const Index count = std::ssize(modes);
    Powers powers{Eigen::MatrixXd(kBlock, 2 * count), Eigen::MatrixXcd(count, blocks)};
    for (Index m = 0; m < count; ++m) {
        const Complex exponent = modes[static_cast<std::size_t>(m)].exponent;
        powers.within.middleCols(2 * m, 2) = powerTable(exponent, kBlock);
        // Not multiplied on from block to block: errors would add up over a long record.
        for (Index b = 0; b < blocks; ++b)
            powers.begins(m, b) = std::exp(exponent * static_cast<double>(b * kBlock));
    }
    return powers;
}

/// Model of all blocks as columns.
Eigen::MatrixXd modelOf(const std::vector<RegressionMode> &modes, const Powers &powers)
{
    Eigen::MatrixXd gains(powers.within.cols(), powers.begins.cols());
    for (Index m = 0; m < powers.begins.rows(); ++m) {
        const Complex gain = modes[static_cast<std::size_t>(m)].gain;
        for (Index b = 0; b < gains.cols(); ++b) {
            const Complex here = gain * powers.begins(m, b);
            gains(2 * m, b) = here.real();
            gains(2 * m + 1, b) = -here.imag();
        }
    }
    return powers.within * gains;
}

/// Sums over k of r_k p^k and of r_k k p^k, per mode.
Eigen::MatrixX2cd momentsOf(const Eigen::MatrixXd &residual, const Powers &powers)
{
    Eigen::MatrixXd weighted = powers.within;
    for (Index j = 0; j < kBlock; ++j)
        weighted.row(j) *= static_cast<double>(j);
    const Eigen::MatrixXd plain = powers.within.transpose() * residual;
    const Eigen::MatrixXd ramped = weighted.transpose() * residual;
    Eigen::MatrixX2cd moments = Eigen::MatrixX2cd::Zero(powers.begins.rows(), 2);
    for (Index b = 0; b < residual.cols(); ++b) {
        const double before = static_cast<double>(b * kBlock);
        for (Index m = 0; m < moments.rows(); ++m) {
            const Complex zeroth(plain(2 * m, b), plain(2 * m + 1, b));
            const Complex first(ramped(2 * m, b), ramped(2 * m + 1, b));
            moments(m, 0) += powers.begins(m, b) * zeroth;
            moments(m, 1) += powers.begins(m, b) * (before * zeroth + first);
        }
    }
    return moments;
}

} // namespace

std::array<Complex, 3> powerSums(Complex q, Index count)
{
    // Sums over 0 .. n-1 and q^n, for the leading bits of count taken one after the other.
    Complex s0 = 0.0;
    Complex s1 = 0.0;
    Complex s2 = 0.0;
    Complex power = 1.0;
    double n = 0.0;
    const auto bits = static_cast<std::uint64_t>(count);
    for (auto bit = static_cast<int>(std::bit_width(bits)) - 1; bit >= 0; --bit) {
        s2 += power * (s2 + 2.0 * n * s1 + n * n * s0);
        s1 += power * (s1 + n * s0);
        s0 += power * s0;
        power *= power;
        n *= 2.0;
        if ((bits >> bit) & 1U) {
            s0 += power;
            s1 += n * power;
            s2 += n * n * power;
            power *= q;
            n += 1.0;
        }
    }
    return {s0, s1, s2};
}

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
    const Powers powers = powersOf(modes, m_columns.cols());
    Eigen::MatrixXd residual = m_columns - modelOf(modes, powers);
    Index free = 0;
    for (const SampleRange &range : m_used) {
        residual.reshaped().segment(free, range.begin - free).setZero();
        free = range.end;
    }
    residual.reshaped().tail(residual.size() - free).setZero();
    const Eigen::MatrixX2cd moments = momentsOf(residual, powers);
    const GramTable gram(modes, m_used);

    const std::vector<Column> columns = columnsOf(modes);
    const Index count = std::ssize(columns);
    RegressionEquations sum{
        Eigen::MatrixXd(count, count), Eigen::VectorXd(count), residual.squaredNorm()};
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
