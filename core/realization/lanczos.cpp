// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/lanczos.h"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>

namespace dyncal {
namespace {

/// Thrown inside Spectra, which has no way to stop; caught below and never seen outside.
struct Stopped
{
};

Eigen::VectorXd timesItsTranspose(
    const std::vector<HankelOperator> &blocks, const Eigen::Ref<const Eigen::VectorXd> &x)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(x.size());
    for (const HankelOperator &block : blocks)
        sum += block.times(block.transposedTimes(x));
    return sum;
}

/// What Spectra wants of an operator.
class GramProduct
{
public:
    using Scalar = double;

    GramProduct(const std::vector<HankelOperator> &blocks, const JobControl &control)
        : m_blocks(blocks)
        , m_control(control)
    {
    }

    Index rows() const { return m_blocks.front().rows(); }
    Index cols() const { return rows(); }
    void perform_op(const double *in, double *out) const
    {
        if (m_control.stopRequested())
            throw Stopped();
        const Eigen::Map<const Eigen::VectorXd> x(in, rows());
        Eigen::Map<Eigen::VectorXd>(out, rows()) = timesItsTranspose(m_blocks, x);
    }

private:
    const std::vector<HankelOperator> &m_blocks;
    const JobControl &m_control;
};

Eigen::VectorXd transposedTimes(
    const std::vector<HankelOperator> &blocks, const Eigen::Ref<const Eigen::VectorXd> &x)
{
    Index total = 0;
    for (const HankelOperator &block : blocks)
        total += block.columns();
    Eigen::VectorXd result(total);
    Index at = 0;
    for (const HankelOperator &block : blocks) {
        result.segment(at, block.columns()) = block.transposedTimes(x);
        at += block.columns();
    }
    return result;
}

} // namespace

Result<SingularTriplets> leadingTriplets(
    const std::vector<HankelOperator> &blocks, Index count, const JobControl &control)
{
    const Index rows = blocks.front().rows();
    const GramProduct product(blocks, control);
    const Index basis = std::min(rows, 2 * count + 20);
    const Index wanted = std::min(count, basis - 1);
    constexpr int kRestarts = 300;
    constexpr double kResidual = 1e-10;
    constexpr Index kFewest = 8; ///< enough to judge an order by
    try {
        Spectra::SymEigsSolver<GramProduct> solver(
            const_cast<GramProduct &>(product), wanted, basis); // takes a reference, does not write
        solver.init();
        const Index found = solver.compute(
            Spectra::SortRule::LargestMagn, kRestarts, kResidual, Spectra::SortRule::LargestMagn);
        if (found < std::min<Index>(wanted, kFewest)) {
            return fail(ErrorKind::Internal,
                Message{DYNCAL_TEXT("core",
                            "Hankel decomposition: %1 of %2 singular values converged; shorten the "
                            "model input or ask for fewer."),
                    {std::to_string(found), std::to_string(wanted)}});
        }
        SingularTriplets triplets;
        triplets.left = solver.eigenvectors(found);
        triplets.singularValues.resize(found);
        Eigen::MatrixXd right;
        for (Index k = 0; k < found; ++k) {
            const Eigen::VectorXd v = transposedTimes(blocks, triplets.left.col(k));
            if (k == 0)
                right.resize(v.size(), found);
            const double sigma = v.norm(); // more accurate than the square root of the eigenvalue
            triplets.singularValues[k] = sigma;
            right.col(k) = sigma > 0.0 ? Eigen::VectorXd(v / sigma) : v;
        }
        triplets.right = std::move(right);
        return triplets;
    } catch (const Stopped &) {
        return fail(ErrorKind::Cancelled, {});
    }
}

double largestSingularValue(const std::vector<HankelOperator> &blocks)
{
    // Spectra refuses a zero matrix: records without any noise have one.
    const Eigen::VectorXd probe = Eigen::VectorXd::Ones(blocks.front().rows());
    if (timesItsTranspose(blocks, probe).norm() == 0.0)
        return 0.0;
    const auto triplets = leadingTriplets(blocks, 1, {});
    return triplets ? triplets->singularValues[0] : 0.0;
}

} // namespace dyncal
