// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/dft_covariance.h"

#include "core/base/index.h"
#include "core/signal/spectral_sums.h"

namespace dyncal {

Eigen::Matrix2d covarianceOf(const ComplexMoments &moments)
{
    const double re = 0.5 * (moments.power + moments.square.real());
    const double im = 0.5 * (moments.power - moments.square.real());
    const double both = 0.5 * moments.square.imag();
    return (Eigen::Matrix2d() << re, both, both, im).finished();
}

std::vector<UncertainComplex> dftWithCovariance(const Eigen::Ref<const Eigen::VectorXd> &y,
    const Eigen::Ref<const Eigen::VectorXd> &variance, double rate_Hz,
    const Eigen::Ref<const Eigen::VectorXd> &frequency_Hz)
{
    const Eigen::VectorXd turns = frequency_Hz / rate_Hz;
    const Eigen::VectorXcd values = spectralSums(y, turns);
    const Eigen::VectorXcd squares = spectralSums(variance, 2.0 * turns);
    const double power = variance.sum();
    std::vector<UncertainComplex> lines;
    for (Index k = 0; k < turns.size(); ++k)
        lines.push_back({values[k], covarianceOf({power, squares[k]})});
    return lines;
}

Eigen::MatrixXd dftCovariance(const Eigen::Ref<const Eigen::VectorXd> &variance, double rate_Hz,
    const Eigen::Ref<const Eigen::VectorXd> &frequency_Hz)
{
    const Index count = frequency_Hz.size();
    const Eigen::VectorXd turns = frequency_Hz / rate_Hz;
    Eigen::MatrixXd covariance(2 * count, 2 * count);
    for (Index a = 0; a < count; ++a) {
        const Eigen::VectorXcd above = spectralSums(variance, turns.array() + turns[a]);
        const Eigen::VectorXcd below = spectralSums(variance, turns[a] - turns.array());
        covariance.row(a) << 0.5 * (below + above).real().transpose(),
            0.5 * (above - below).imag().transpose();
        covariance.row(count + a) << 0.5 * (above + below).imag().transpose(),
            0.5 * (below - above).real().transpose();
    }
    return covariance;
}

} // namespace dyncal
