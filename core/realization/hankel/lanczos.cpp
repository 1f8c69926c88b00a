// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/lanczos.h"

#include "core/base/eigenvalues.h"
#include "core/base/portable_random.h"
#include "core/base/tall_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace dyncal {
namespace {

/// With two, a double eigenvalue is found with both its vectors and each of two threads has a
/// product, for hardly more products than with one.
constexpr Index kBlock = 2;
constexpr double kRoundingOfProducts = 1e-14; ///< of A's products, relative to the largest
/// If a subtraction leaves less than this of a vector, rounding shows, and it is repeated.
constexpr double kMuchRemoved = 0.05;

/// Fixed numbers without any structure that a record could have.
void fillRandom(Eigen::Ref<Eigen::VectorXd> x, Index stream)
{
    RandomStream random(20260101, 0, stream);
    for (double &value : x)
        value = random.nextUniform() - 0.5;
}

/// Predicts when to check convergence again: a check costs as much as some products, and residuals
/// shrink at a steady rate.
class Convergence
{
public:
    explicit Convergence(Index firstLook)
        : m_nextLook(firstLook)
    {
    }
    void add(Index products, double excess)
    {
        const double logarithm = std::log(excess);
        if (m_products > 0 && logarithm < m_logarithm) {
            const double rate
                = (m_logarithm - logarithm) / static_cast<double>(products - m_products);
            m_nextLook = products
                + std::max<Index>(8, static_cast<Index>(std::min(logarithm / rate, 1e6)));
        }
        m_products = products;
        m_logarithm = logarithm;
    }
    Index nextLook() const { return m_nextLook; }

private:
    Index m_products = 0;
    double m_logarithm = 0.0;
    Index m_nextLook;
};

} // namespace

BlockLanczos::BlockLanczos(SymmetricOperator &A, double tolerance)
    : m_A(A)
    , m_tolerance(tolerance)
{
    eigen_assert(mostPairs(A.size()) > 0);
    Eigen::MatrixXd start(A.size(), kBlock);
    for (Index j = 0; j < kBlock; ++j)
        fillRandom(start.col(j), j);
    reserve(kBlock);
    appendOrthonormal(start);
}

Index BlockLanczos::mostPairs(Index size)
{
    return std::max<Index>(size / 2 - 5 * kBlock, 0);
}

/// Basis vectors before a restart. A larger basis saves few products and costs more in
/// orthogonalisation.
Index BlockLanczos::capacity(Index count) const
{
    return std::min(m_A.size() - kBlock, count + count / 2 + 40);
}

void BlockLanczos::reserve(Index columns)
{
    if (m_Q.cols() < columns)
        m_Q.conservativeResize(m_A.size(), columns);
}

Eigen::MatrixXd BlockLanczos::removeBasis(Eigen::Ref<Eigen::MatrixXd> W, Index columns) const
{
    Eigen::MatrixXd C = innerProducts(m_Q.leftCols(columns), W);
    subtractProducts(m_Q.leftCols(columns), C, W);
    return C;
}

/// Subtracts from W = A * next what the recurrence predicts: the coupled part of the basis, and
/// `next` itself, whose coefficients are returned.
Eigen::MatrixXd BlockLanczos::removeCoupled(Eigen::Ref<Eigen::MatrixXd> W) const
{
    const Index coupled = m_restarted ? m_dimension : std::min(m_dimension, kBlock);
    subtractProducts(m_Q.middleCols(m_dimension - coupled, coupled),
        m_coupling.rightCols(coupled).transpose(), W);
    const auto next = m_Q.middleCols(m_dimension, kBlock);
    Eigen::MatrixXd corner = innerProducts(next, W);
    subtractProducts(next, corner, W);
    return corner;
}

/// Adds the next block to the basis; the part of A times it that is orthogonal to the basis becomes
/// the following block. The terms of the recurrence are subtracted first, so that the pass over the
/// whole basis removes rounding only: a single pass that removed more would lose orthogonality step
/// by step.
void BlockLanczos::grow()
{
    const Index d = m_dimension + kBlock;
    Eigen::MatrixXd W(m_A.size(), kBlock);
    m_A.apply(m_Q.middleCols(m_dimension, kBlock), W);
    m_products += kBlock;
    const Eigen::ArrayXd before = W.colwise().norm();
    m_scale = std::max(m_scale, before.maxCoeff());

    Eigen::MatrixXd corner = removeCoupled(W);
    corner += removeBasis(W, d).bottomRows(kBlock);
    const Eigen::ArrayXd after = W.colwise().norm();
    if ((after < kMuchRemoved * before).any())
        removeBasis(W, d);
    extendProjection(corner);
    m_restarted = false;
    appendOrthonormal(W);
}

void BlockLanczos::extendProjection(const Eigen::MatrixXd &corner)
{
    const Index old = m_dimension;
    m_dimension += kBlock;
    m_T.conservativeResize(m_dimension, m_dimension);
    m_T.topRightCorner(old, kBlock) = m_coupling.transpose();
    m_T.bottomLeftCorner(kBlock, old) = m_coupling;
    m_T.bottomRightCorner(kBlock, kBlock) = 0.5 * (corner + corner.transpose());
}

/// W = next * R with W orthogonal to the basis: `next` is stored after the basis, R couples it to
/// the last block; earlier blocks have no coupling.
void BlockLanczos::appendOrthonormal(Eigen::MatrixXd &W)
{
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(kBlock, kBlock);
    for (Index j = 0; j < kBlock; ++j) {
        const Index known = m_dimension + j;
        const double before = W.col(j).norm();
        for (Index i = 0; i < j; ++i) {
            R(i, j) = m_Q.col(m_dimension + i).dot(W.col(j));
            W.col(j) -= R(i, j) * m_Q.col(m_dimension + i);
        }
        const double norm = W.col(j).norm();
        if (norm > kRoundingOfProducts * m_scale) {
            R(j, j) = norm;
        } else { // the subspace is exhausted: any other direction, uncoupled
            fillRandom(W.col(j), kBlock + m_products + j);
            removeBasis(W.col(j), known);
        }
        W.col(j).normalize();
        if (norm < kMuchRemoved * before || norm < 1e-6 * m_scale) {
            removeBasis(W.col(j), known);
            W.col(j).normalize();
        }
        m_Q.col(known) = W.col(j);
    }
    m_coupling.setZero(kBlock, m_dimension);
    if (m_dimension > 0)
        m_coupling.rightCols(kBlock) = R;
}

void BlockLanczos::decompose()
{
    const SymmetricEigen eigen = symmetricEigen(m_T);
    std::vector<Index> order(static_cast<std::size_t>(m_dimension));
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
        [&](Index a, Index b) { return std::abs(eigen.values[a]) > std::abs(eigen.values[b]); });
    m_values = eigen.values(order);
    m_rotation = eigen.vectors(Eigen::all, order);
    m_residuals = (m_coupling * m_rotation).colwise().norm();
}

Index BlockLanczos::convergedAmong(Index count) const
{
    for (Index k = 0; k < count; ++k) {
        if (excess(k) > 1.0)
            return k;
    }
    return count;
}

/// Residual of a pair over what is allowed.
double BlockLanczos::excess(Index pair) const
{
    return m_residuals[pair]
        / std::max({m_tolerance * std::abs(m_values[pair]), kRoundingOfProducts * m_scale,
            std::numeric_limits<double>::min()});
}

double BlockLanczos::largestExcess(Index count) const
{
    double largest = 0.0;
    for (Index k = 0; k < count; ++k)
        largest = std::max(largest, excess(k));
    return largest;
}

/// The leading Ritz vectors become the basis; the next block is kept.
void BlockLanczos::restart(Index keep)
{
    rotateColumns(m_Q.leftCols(m_dimension), m_rotation.leftCols(keep));
    m_Q.middleCols(keep, kBlock) = m_Q.middleCols(m_dimension, kBlock).eval();
    m_coupling = (m_coupling * m_rotation.leftCols(keep)).eval();
    m_T = m_values.head(keep).asDiagonal();
    m_dimension = keep;
    m_restarted = true;
}

bool BlockLanczos::iterate(Index count, const JobControl &control)
{
    const Index full = capacity(count);
    const Index keep = count + (full - count) / 3;
    const Index limit = m_products + 100 * count + 1000;
    reserve(full + kBlock);
    Convergence convergence(m_products + 3 * count + 20);
    while (m_products < limit) {
        if (control.stopRequested())
            return false;
        control.report(
            1.0 - std::exp(-static_cast<double>(m_products) / static_cast<double>(4 * count + 60)));
        grow();
        const bool isFull = m_dimension + kBlock > full;
        if (!isFull && m_products < convergence.nextLook())
            continue;
        decompose();
        if (convergedAmong(count) == count)
            break;
        convergence.add(m_products, largestExcess(count));
        if (isFull)
            restart(keep);
    }
    return true;
}

EigenPairs BlockLanczos::leading(Index count)
{
    decompose();
    return {m_values.head(count),
        combineColumns(m_Q.leftCols(m_dimension), m_rotation.leftCols(count)),
        convergedAmong(count)};
}

} // namespace dyncal
