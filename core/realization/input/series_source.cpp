// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/series_source.h"

#include "core/decomposition/component_result.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// Less than this share of the largest value is rounding of the arithmetic.
constexpr double kArithmetic = 1e-11;

/// Without a quiet stretch the noise of a shot is not known, which is not the same as none.
bool hasNoise(const WindowedResponse &response)
{
    return response.noise.size() >= 2;
}

/// Noise of the average: the shots' noise averaged point by point, as the reconstructions are; of
/// the shots whose noise is known.
Eigen::VectorXd averageNoise(const std::vector<WindowedResponse> &responses, double rate_Hz)
{
    Eigen::VectorXd sum;
    Index count = 0;
    for (const WindowedResponse &response : responses) {
        if (!hasNoise(response) || std::abs(response.sampleRate_Hz - rate_Hz) > 1e-9 * rate_Hz)
            continue;
        const Index size
            = sum.size() ? std::min(sum.size(), response.noise.size()) : response.noise.size();
        if (sum.size() == 0)
            sum = Eigen::VectorXd::Zero(size);
        sum = (sum.head(size) + response.noise.head(size)).eval();
        ++count;
    }
    return count ? Eigen::VectorXd(sum / static_cast<double>(count)) : sum;
}

/// Rounding errors of a record, in the unit of its values.
struct Rounding
{
    double sd = 0.0;
    double lastingSd = 0.0; ///< of what averaging does not remove
};

/// Unknown (0), like the noise, without a quiet stretch.
Rounding roundingOf(const WindowedResponse &response)
{
    if (!hasNoise(response))
        return {};
    const double resolution = std::abs(response.resolution / response.valueScale);
    const double arithmetic = kArithmetic * response.window().cwiseAbs().maxCoeff();
    return {std::max(resolution / std::sqrt(12.0), arithmetic),
        std::max(response.roundingSd, arithmetic)};
}

/// Rounding of the average: the shots are rounded independently. Of the same shots as its noise.
Rounding averageRounding(const std::vector<WindowedResponse> &responses)
{
    Rounding squares;
    for (const WindowedResponse &response : responses) {
        const Rounding one = roundingOf(response);
        squares.sd += one.sd * one.sd;
        squares.lastingSd += one.lastingSd * one.lastingSd;
    }
    const auto known = static_cast<double>(std::ranges::count_if(responses, hasNoise));
    const double count = std::max(known, 1.0);
    return {std::sqrt(squares.sd) / count, std::sqrt(squares.lastingSd) / count};
}

/// The shots' levels are averaged with the shots.
double averageOfFactors(const std::vector<WindowedResponse> &responses)
{
    double sum = 0.0;
    for (const WindowedResponse &response : responses)
        sum += response.baselineVarianceFactor;
    return sum / static_cast<double>(responses.size());
}

} // namespace

std::vector<SeriesSource> seriesSources(const std::vector<WindowedResponse> &responses,
    const ComponentResult &components, CombineMethod combine)
{
    std::vector<SeriesSource> list;
    if (combine == CombineMethod::PcaAverage) {
        list.push_back({0, components.average, 0, components.average.size(),
            components.sampleRate_Hz, averageNoise(responses, components.sampleRate_Hz)});
        const Rounding rounding = averageRounding(responses);
        list.back().leastNoiseSd = rounding.sd;
        list.back().roundingSd = rounding.lastingSd;
        list.back().baselineVarianceFactor = averageOfFactors(responses);
        return list;
    }
    for (const WindowedResponse &response : responses) {
        const Rounding rounding = roundingOf(response);
        list.push_back(
            {response.shot, response.values, response.lead, response.length, response.sampleRate_Hz,
                response.noise, rounding.sd, rounding.lastingSd, response.baselineVarianceFactor});
    }
    return list;
}

} // namespace dyncal
