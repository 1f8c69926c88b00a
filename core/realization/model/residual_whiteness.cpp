// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/residual_whiteness.h"

#include "core/base/constants.h"
#include "core/base/distributions.h"
#include "core/decomposition/residual_analysis.h"
#include "core/realization/input/whitening.h"

#include <optional>
#include <vector>

namespace dyncal {
namespace {

constexpr Index kWhitenessLags = 20;

/// Autocorrelation at lags 1 .. of a record, with its variance under white noise (Ljung and Box).
struct Correlogram
{
    Eigen::ArrayXd values;
    Eigen::ArrayXd variances;
};

std::optional<Correlogram> correlogramOf(const Eigen::VectorXd &record)
{
    const auto n = static_cast<double>(record.size());
    if (record.size() <= 4 * kWhitenessLags)
        return std::nullopt;
    const Eigen::VectorXd covariance
        = autocovariance((record.array() - record.mean()).matrix(), kWhitenessLags);
    if (!(covariance[0] > 0.0))
        return std::nullopt;
    const Eigen::ArrayXd lags
        = Eigen::ArrayXd::LinSpaced(kWhitenessLags, 1.0, static_cast<double>(kWhitenessLags));
    return Correlogram{
        covariance.tail(kWhitenessLags).array() / covariance[0], (n - lags) / (n * (n + 2.0))};
}

} // namespace

// Residual and noise are both made white by the noise's model before they are compared.
double residualWhiteness_p(const ModelInput &input, const SensorModel &model)
{
    std::vector<NoiseCovariance> noise;
    for (const ModelSeries &series : input.series)
        noise.push_back(noiseCovariance(series.noise, kLargestNoiseModel));
    const auto noiseModels = chooseAutoregressiveModels(noise, kLargestNoiseModel);
    double statistic = 0.0;
    Index lags = 0;
    for (std::size_t r = 0; r < model.series.size() && !model.diverges; ++r) {
        const Eigen::VectorXd &a = noiseModels[r].coefficients;
        const auto left = correlogramOf(whitened(model.series[r].error, a));
        if (!left)
            continue;
        const Eigen::VectorXd &before = input.series[r].noise;
        const auto quiet = before.size() > a.size() ? correlogramOf(whitened(before, a))
                                                    : std::optional<Correlogram>();
        const Eigen::ArrayXd difference
            = quiet ? Eigen::ArrayXd(left->values - quiet->values) : left->values;
        const Eigen::ArrayXd variance
            = quiet ? Eigen::ArrayXd(left->variances + quiet->variances) : left->variances;
        statistic += (difference.square() / variance).sum();
        lags += kWhitenessLags;
    }
    return lags > 0 ? chiSquareSurvival(statistic, static_cast<double>(lags)) : kUnknown;
}

} // namespace dyncal
