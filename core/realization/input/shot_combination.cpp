// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/shot_combination.h"

#include "core/base/distributions.h"
#include "core/realization/input/whitening.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kFewestNoise = 50;
constexpr double kSignificance = 0.01;

bool canCombine(const ModelInput &input)
{
    return input.series.size() > 1
        && std::all_of(input.series.begin(), input.series.end(), [&](const ModelSeries &series) {
               return series.noise.size() >= kFewestNoise && series.noiseSd > 0.0
                   && series.y.size() == input.series.front().y.size();
           });
}

const ModelSeries &clearest(const ModelInput &input)
{
    return *std::max_element(
        input.series.begin(), input.series.end(), [](const ModelSeries &a, const ModelSeries &b) {
            return a.y.norm() / a.noiseSd < b.y.norm() / b.noiseSd;
        });
}

/// Height of every shot relative to the clearest one, corrected for that one's noise, which would
/// make the ratio too low.
std::vector<double> heights(const ModelInput &input)
{
    const ModelSeries &reference = clearest(input);
    const double noise = static_cast<double>(reference.y.size()) * std::pow(reference.noiseSd, 2);
    const double energy = reference.y.squaredNorm() - noise;
    std::vector<double> list;
    for (const ModelSeries &series : input.series)
        list.push_back(&series == &reference ? 1.0 : series.y.dot(reference.y) / energy);
    return list;
}

ModelSeries weightedMean(const ModelInput &input, const std::vector<double> &height)
{
    Index noiseLength = input.series.front().noise.size();
    for (const ModelSeries &series : input.series)
        noiseLength = std::min(noiseLength, series.noise.size());
    ModelSeries mean;
    mean.y = Eigen::VectorXd::Zero(input.series.front().y.size());
    mean.noise = Eigen::VectorXd::Zero(noiseLength);
    double weights = 0.0;
    for (std::size_t i = 0; i < height.size(); ++i) {
        const ModelSeries &series = input.series[i];
        const double weight = std::pow(height[i] / series.noiseSd, 2);
        mean.y += weight / height[i] * series.y;
        mean.noise += weight / height[i] * series.noise.head(noiseLength);
        weights += weight;
    }
    mean.y /= weights;
    mean.noise /= weights;
    mean.noiseSd = std::sqrt(noiseCovariance(mean.noise, 0).values[0]);
    return mean;
}

bool sharesShape(
    const ModelInput &input, const std::vector<double> &height, const ModelSeries &mean)
{
    const Eigen::VectorXd filter = chooseAutoregressiveModels(
        {noiseCovariance(mean.noise, kLargestNoiseModel)}, kLargestNoiseModel)
                                       .front()
                                       .coefficients;
    double squares = 0.0;
    double noiseCount = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < height.size(); ++i) {
        const ModelSeries &series = input.series[i];
        const Eigen::VectorXd noise = whitened(series.noise, filter) / height[i];
        const Eigen::VectorXd difference = whitened(series.y / height[i] - mean.y, filter);
        squares
            += difference.squaredNorm() / (noise.squaredNorm() / static_cast<double>(noise.size()));
        noiseCount += static_cast<double>(noise.size());
        count += static_cast<double>(difference.size());
    }
    // The combination takes the degrees of freedom of one shot. Both variances are estimated from
    // hundreds of values, so that the logarithm of their ratio is normal.
    const double dof = count * (1.0 - 1.0 / static_cast<double>(height.size()));
    const double spread = std::sqrt(2.0 / dof + 2.0 / noiseCount);
    return std::log(squares / dof) <= normalQuantile(1.0 - kSignificance) * spread;
}

} // namespace

std::optional<ModelSeries> combineShots(const ModelInput &input)
{
    if (!canCombine(input))
        return std::nullopt;
    const std::vector<double> height = heights(input);
    if (std::any_of(
            height.begin(), height.end(), [](double h) { return !std::isfinite(h) || h == 0.0; }))
        return std::nullopt;
    ModelSeries mean = weightedMean(input, height);
    if (!sharesShape(input, height, mean))
        return std::nullopt;
    return mean;
}

} // namespace dyncal
