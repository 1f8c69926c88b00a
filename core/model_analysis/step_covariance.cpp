// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/step_covariance.h"

#include "core/base/constants.h"
#include "core/signal/dft_covariance.h"
#include "core/signal/spectral_sums.h"

#include <cmath>

namespace dyncal {
namespace {

/// What the errors of the samples have to do with the level that continues the record.
struct LevelMoments
{
    double variance = 0.0; ///< of the level
    Eigen::VectorXcd withSum; ///< E[error of F, error of the level], at each frequency
};

LevelMoments levelMoments(const Eigen::Ref<const Eigen::VectorXd> &variance,
    const TransformEnd &end, const Eigen::VectorXd &turns)
{
    if (end.averaged == 0)
        return {0.0, Eigen::VectorXcd::Zero(turns.size())};
    const double m = static_cast<double>(end.averaged);
    const auto last = variance.segment(end.samples - end.averaged, end.averaged);
    Eigen::VectorXcd withSum = spectralSums(last, turns) / m;
    for (Index k = 0; k < turns.size(); ++k)
        withSum[k] *= turned(turns[k], static_cast<double>(end.samples - end.averaged));
    return {last.sum() / (m * m), std::move(withSum)};
}

} // namespace

std::vector<UncertainComplex> stepTransformsWithCovariance(
    const Eigen::Ref<const Eigen::VectorXd> &y, const Eigen::Ref<const Eigen::VectorXd> &variance,
    double rate_Hz, const TransformEnd &end, double onset_s,
    const Eigen::Ref<const Eigen::VectorXd> &frequency_Hz)
{
    using Complex = std::complex<double>;
    const Eigen::VectorXd turns = frequency_Hz / rate_Hz;
    const Eigen::VectorXcd F = spectralSums(y.head(end.samples), turns);
    const Eigen::VectorXcd squares = spectralSums(variance.head(end.samples), 2.0 * turns);
    const double power = variance.head(end.samples).sum();
    const LevelMoments level = levelMoments(variance, end, turns);
    std::vector<UncertainComplex> lines;
    for (Index k = 0; k < turns.size(); ++k) {
        const double w = kTwoPi * frequency_Hz[k];
        // S = a F + b level, because the bracket jwT/(1 - q) takes the factor of F off.
        const Complex a = Complex(0.0, w / rate_Hz) * std::polar(1.0, w * onset_s);
        const Complex last = turned(turns[k], static_cast<double>(end.samples));
        const Complex b = a * last / (1.0 - turned(turns[k], 1.0));
        const ComplexMoments moments{std::norm(a) * power + std::norm(b) * level.variance
                + 2.0 * (a * std::conj(b) * level.withSum[k]).real(),
            a * a * squares[k] + b * b * level.variance + 2.0 * a * b * level.withSum[k]};
        lines.push_back({a * F[k] + b * end.level, covarianceOf(moments)});
    }
    return lines;
}

} // namespace dyncal
