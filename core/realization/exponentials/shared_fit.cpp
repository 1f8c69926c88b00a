// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/shared_fit.h"

#include "core/base/index.h"
#include "core/base/least_squares.h"

namespace dyncal {
namespace {

constexpr Index kStretch = 128; ///< samples over which powers are multiplied up

/// Re p^k and Im p^k: products within a stretch, one exponential at its beginning.
void fillPowers(std::complex<double> p, Eigen::Ref<Eigen::MatrixXd> columns)
{
    const std::complex<double> stretch = std::pow(p, static_cast<int>(kStretch));
    std::complex<double> begin = 1.0;
    for (Index first = 0; first < columns.rows(); first += kStretch, begin *= stretch) {
        std::complex<double> power = begin;
        const Index end = std::min(first + kStretch, columns.rows());
        for (Index k = first; k < end; ++k, power *= p) {
            columns(k, 0) = power.real();
            if (columns.cols() > 1)
                columns(k, 1) = -power.imag();
        }
    }
}

/// Columns scaled to norm 1; `norms` receives the divisors.
Eigen::MatrixXd scaledBasis(Index samples, const std::vector<std::complex<double>> &poles,
    bool withConstant, Eigen::VectorXd &norms)
{
    const Index count = static_cast<Index>(poles.size());
    Eigen::MatrixXd basis(samples, count + (withConstant ? 1 : 0));
    for (Index i = 0; i < count; ++i) {
        const Index width = isUpperOfPair(poles, static_cast<std::size_t>(i)) ? 2 : 1;
        fillPowers(poles[static_cast<std::size_t>(i)], basis.middleCols(i, width));
        i += width - 1;
    }
    if (withConstant)
        basis.rightCols(1).setOnes();
    norms = basis.colwise().norm();
    norms = (norms.array() > 0.0).select(norms, 1.0);
    basis.array().rowwise() /= norms.transpose().array();
    return basis;
}

} // namespace

std::vector<AmplitudeFit> fitSharedPoles(const Eigen::MatrixXd &records,
    const std::vector<std::complex<double>> &poles, bool withConstant)
{
    Eigen::VectorXd norms;
    const Eigen::MatrixXd basis = scaledBasis(records.rows(), poles, withConstant, norms);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(basis.cols(), basis.cols());
    if (basis.cols() > 0) // Eigen's products take the address of the first element
        gram.selfadjointView<Eigen::Lower>().rankUpdate(basis.transpose());
    gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
    Eigen::MatrixXd scaled = basis.transpose() * records;
    if (scaled.rows() > 0) // without poles and constant nothing is fitted
        scaled = leastSquares(gram, scaled);
    const Eigen::MatrixXd fitted = basis * scaled;

    std::vector<AmplitudeFit> fits(static_cast<std::size_t>(records.cols()));
    const Index count = static_cast<Index>(poles.size());
    for (std::size_t r = 0; r < fits.size(); ++r) {
        const Eigen::VectorXd x
            = (scaled.col(static_cast<Index>(r)).array() / norms.array()).matrix();
        fits[r].fitted = fitted.col(static_cast<Index>(r));
        fits[r].constant = withConstant ? x[count] : 0.0;
        fits[r].amplitudes.resize(count);
        for (Index i = 0; i < count; ++i) {
            if (isUpperOfPair(poles, static_cast<std::size_t>(i))) {
                // a Re p^k - b Im p^k = 2 Re(c p^k) with c = (a + j b) / 2
                fits[r].amplitudes[i] = {x[i] / 2.0, x[i + 1] / 2.0};
                fits[r].amplitudes[i + 1] = std::conj(fits[r].amplitudes[i]);
                ++i;
            } else {
                fits[r].amplitudes[i] = x[i];
            }
        }
    }
    return fits;
}

} // namespace dyncal
