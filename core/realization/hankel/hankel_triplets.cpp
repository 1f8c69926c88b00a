// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_triplets.h"

#include "core/base/parallel.h"
#include "core/base/svd.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dyncal {
namespace {

bool isSymmetric(const std::vector<HankelOperator> &blocks)
{
    return blocks.size() == 1 && blocks.front().isSymmetric();
}

std::unique_ptr<SymmetricOperator> productOf(const std::vector<HankelOperator> &blocks)
{
    if (isSymmetric(blocks))
        return std::make_unique<SymmetricHankel>(blocks.front());
    return std::make_unique<HankelGram>(blocks);
}

Index columnsOf(const std::vector<HankelOperator> &blocks)
{
    return std::accumulate(blocks.begin(), blocks.end(), Index(0),
        [](Index sum, const HankelOperator &block) { return sum + block.columns(); });
}

/// [H_1 H_2 ...]^T x.
Eigen::VectorXd transposedTimes(
    const std::vector<HankelOperator> &blocks, const Eigen::Ref<const Eigen::VectorXd> &x)
{
    Eigen::VectorXd result(columnsOf(blocks));
    Index at = 0;
    for (const HankelOperator &block : blocks) {
        result.segment(at, block.columns()) = block.transposedTimes(x);
        at += block.columns();
    }
    return result;
}

} // namespace

HankelTriplets::HankelTriplets(const std::vector<HankelOperator> &blocks)
    : m_blocks(blocks)
    , m_product(productOf(blocks))
    , m_lanczos(*m_product)
{
}

Result<SingularTriplets> HankelTriplets::leading(
    Index count, Right right, const JobControl &control)
{
    if (!m_lanczos.iterate(count, control))
        return fail(ErrorKind::Cancelled, {});
    EigenPairs pairs = m_lanczos.leading(count);
    if (isSymmetric(m_blocks))
        return fromEigenvalues(std::move(pairs), right);
    return fromSquares(std::move(pairs), right, control);
}

SingularTriplets HankelTriplets::fromEigenvalues(EigenPairs pairs, Right right) const
{
    SingularTriplets triplets;
    triplets.singularValues = pairs.values.cwiseAbs();
    if (right == Right::Wanted)
        triplets.right = pairs.vectors * pairs.values.cwiseSign().asDiagonal();
    triplets.left = std::move(pairs.vectors);
    triplets.converged = pairs.converged;
    return triplets;
}

Result<SingularTriplets> HankelTriplets::fromSquares(
    EigenPairs pairs, Right right, const JobControl &control) const
{
    const Index count = pairs.values.size();
    std::vector<Eigen::VectorXd> images(static_cast<std::size_t>(count)); // H^T u
    Eigen::VectorXd values(count);
    forEachPart(count, m_product->size() > 2000, [&](Index k) {
        if (control.stopRequested())
            return;
        Eigen::VectorXd image = transposedTimes(m_blocks, pairs.vectors.col(k));
        values[k] = image.norm(); // the eigenvalue's root has half the digits
        if (right == Right::Wanted)
            images[static_cast<std::size_t>(k)] = std::move(image);
    });
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    std::vector<Index> order(
        static_cast<std::size_t>(count)); // at rounding level the order may change
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(
        order.begin(), order.end(), [&](Index a, Index b) { return values[a] > values[b]; });

    SingularTriplets triplets;
    triplets.singularValues = values(order);
    triplets.left = std::is_sorted(order.begin(), order.end())
        ? std::move(pairs.vectors)
        : Eigen::MatrixXd(pairs.vectors(Eigen::all, order));
    triplets.converged = pairs.converged;
    if (right == Right::Wanted) {
        triplets.right.resize(images.front().size(), count);
        for (Index k = 0; k < count; ++k) {
            const double sigma = triplets.singularValues[k];
            triplets.right.col(k)
                = images[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])]
                / (sigma > 0.0 ? sigma : 1.0);
        }
    }
    return triplets;
}

Eigen::MatrixXd denseHankel(const std::vector<HankelOperator> &blocks)
{
    Eigen::MatrixXd matrix(blocks.front().rows(), columnsOf(blocks));
    Index column = 0;
    for (const HankelOperator &block : blocks) {
        matrix.middleCols(column, block.columns()) = block.dense();
        column += block.columns();
    }
    return matrix;
}

double largestSingularValue(const std::vector<HankelOperator> &blocks, const JobControl &control)
{
    if (BlockLanczos::mostPairs(blocks.front().rows()) < 1)
        return leftSvd(denseHankel(blocks)).singularValues[0];
    // The error of a value is at most its residual, and about its square if other values are far
    // away.
    constexpr double kResidual = 0.01;
    const auto product = productOf(blocks);
    BlockLanczos lanczos(*product, kResidual);
    if (!lanczos.iterate(1, {control.stop, {}}))
        return 0.0;
    const double value = std::abs(lanczos.leading(1).values[0]);
    return isSymmetric(blocks) ? value : std::sqrt(value);
}

} // namespace dyncal
