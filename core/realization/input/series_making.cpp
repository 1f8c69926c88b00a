// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/series_making.h"

#include "core/realization/input/whitening.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

double standardDeviation(const Eigen::VectorXd &values)
{
    if (values.size() < 2)
        return 0.0;
    const double mean = values.mean();
    return std::sqrt(
        (values.array() - mean).square().sum() / static_cast<double>(values.size() - 1));
}

Eigen::VectorXd filteredNoise(const SeriesSource &source, const AntiAliasFilter &filter)
{
    const Index half = filter.halfLength();
    const Index count = outputCount(filter, half, source.noise.size() - 1);
    return count >= 8 ? decimate(source.noise, filter, half, count) : Eigen::VectorXd();
}

/// u of the mean of a noise record, from its spectral density at frequency 0 over its length.
double uncertaintyOfMean(const NoiseCovariance &noise)
{
    if (noise.count == 0)
        return 0.0;
    const AutoregressiveModel model
        = chooseAutoregressiveModels({noise}, kLargestNoiseModelOrder).front();
    return std::sqrt(model.innovationVariance / static_cast<double>(noise.count))
        / std::abs(1.0 + model.coefficients.sum());
}

/// Adds to the noise the rounding errors of a response of `samples` samples, which the record
/// before the start does not show: a new error at each sample while the response moves, the same
/// error for long where it rests (docs/method/order.md).
NoiseCovariance withRounding(
    const NoiseCovariance &noise, double leastSd, double lastingSd, Index samples)
{
    constexpr double kShareAlike = 0.1; // share of the response with the same error
    NoiseCovariance result = noise;
    if (noise.count == 0)
        return result;
    const double length = kShareAlike * static_cast<double>(samples);
    for (Index lag = 0; lag < result.values.size(); ++lag)
        result.values[lag] = lastingSd * lastingSd * std::exp(-static_cast<double>(lag) / length);
    result.values[0] += std::max(noise.values[0], leastSd * leastSd);
    return result;
}

} // namespace

ModelSeries makeSeries(
    const SeriesSource &source, const AntiAliasFilter &filter, Index first, Index samples)
{
    ModelSeries series;
    series.shot = source.shot;
    series.filter = filter;
    series.y = decimate(source.values, filter, first, samples);
    series.first_s = static_cast<double>(first - source.lead) / source.rate_Hz;
    series.noise = filteredNoise(source, filter);
    series.fullRateNoiseSd = std::max(standardDeviation(source.noise), source.leastNoiseSd);
    series.fullRateNoise = noiseCovariance(source.noise, kLargestNoiseModelOrder);
    series.roundingSd = source.roundingSd;
    series.u_baseline = std::hypot(
        std::sqrt(source.baselineVarianceFactor) * uncertaintyOfMean(series.fullRateNoise),
        series.roundingSd);
    series.noiseSd = std::hypot(series.noise.size() ? standardDeviation(series.noise)
                                                    : series.fullRateNoiseSd * filter.taps.norm(),
        series.roundingSd);
    const Index last = first
        + static_cast<Index>(std::floor(static_cast<double>(samples - 1) * filter.factor + 1e-9));
    series.fullRate = source.values.segment(source.lead, last - source.lead + 1);
    series.fullRate_Hz = source.rate_Hz;
    if (roundingCounts(series))
        series.fullRateNoise = withRounding(
            series.fullRateNoise, source.leastNoiseSd, source.roundingSd, series.fullRate.size());
    return series;
}

} // namespace dyncal
