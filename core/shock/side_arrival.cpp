// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/side_arrival.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

constexpr double kFallbackSpan_s = 0.5e-3;
constexpr double kLevelBegin = 0.25; ///< fractions of the span from start to reflection-free time
constexpr double kLevelEnd = 0.75;
constexpr double kCrossing = 0.5; ///< fraction of the step that counts as the arrival

/// Median of the finite physical values of samples [begin, end), cut to the record.
std::optional<double> medianLevel(const Channel &channel, Index begin, Index end)
{
    begin = std::clamp<Index>(begin, 0, channel.samples.size());
    end = std::clamp<Index>(end, begin, channel.samples.size());
    const Eigen::VectorXd values = physicalValues(channel, begin, end - begin);
    std::vector<double> finite;
    finite.reserve(static_cast<std::size_t>(values.size()));
    std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
        [](double value) { return std::isfinite(value); });
    if (finite.empty())
        return std::nullopt;
    const auto middle = finite.begin() + static_cast<Index>(finite.size() / 2);
    std::nth_element(finite.begin(), middle, finite.end());
    return *middle;
}

constexpr double kLeastHeightToNoise = 10.0; ///< else a spike may pass for the reflected shock
constexpr double kBehindBegin = 0.05; ///< of the way back from the wall
constexpr double kBehindEnd = 0.25;
constexpr double kLeastLevelSamples = 20.0;
constexpr double kRiseBegin = 0.1;
constexpr double kRiseEnd = 0.9;

/// u of the 50 % crossing: noise over the slope between 40 % and 60 %, the position within a
/// sample, and 1 % of a sample for the interpolation.
double crossingUncertainty_s(const Channel &channel, const SideArrival &arrival, Index from)
{
    const double height = arrival.behind - arrival.before;
    const double sample_s = 1.0 / channel.sampleRate_Hz;
    const auto below = crossingTime_s(channel, arrival.before + 0.4 * height, from);
    const auto above = crossingTime_s(channel, arrival.before + 0.6 * height, from);
    const double span_s = below && above ? std::max(*above - *below, 0.0) : 0.0;
    // A front shorter than a sample looks like a ramp of one sample, wherever in it the crossing
    // lies. From two samples on the interpolation finds the crossing.
    const double grid_s
        = std::clamp(2.0 * sample_s - span_s / 0.2, 0.0, sample_s) / std::sqrt(12.0);
    return std::hypot(arrival.noiseSd * span_s / (0.2 * std::abs(height)), grid_s)
        + 0.01 * sample_s;
}

} // namespace

std::optional<double> medianBetween(const Channel &channel, double begin_s, double end_s)
{
    const auto sampleAt = [&](double time_s) {
        return static_cast<Index>(std::clamp((time_s - channel.t0_s) * channel.sampleRate_Hz, 0.0,
            static_cast<double>(channel.samples.size())));
    };
    return medianLevel(channel, sampleAt(begin_s), sampleAt(end_s));
}

std::optional<ReturnPassage> returnPassage(
    const Channel &channel, const SideArrival &arrival, double wall_s)
{
    const double height = arrival.behind - arrival.before;
    const auto from
        = static_cast<Index>(std::max(0.0, (wall_s - channel.t0_s) * channel.sampleRate_Hz));
    if (from >= channel.samples.size() || std::abs(height) < kLeastHeightToNoise * arrival.noiseSd)
        return std::nullopt;
    const auto first_s = crossingTime_s(channel, arrival.behind + kCrossing * height, from);
    if (!first_s)
        return std::nullopt;
    const double way_s = *first_s - wall_s;
    const auto level
        = medianBetween(channel, *first_s + kBehindBegin * way_s, *first_s + kBehindEnd * way_s);
    // The reflected step is never the smaller one: less is no reflected shock.
    if (!level || (*level - arrival.behind) / height < 0.9)
        return std::nullopt;
    SideArrival second = arrival;
    second.before = arrival.behind;
    second.behind = *level;
    const double half = arrival.behind + kCrossing * (*level - arrival.behind);
    const auto time_s = crossingTime_s(channel, half, from);
    if (!time_s)
        return std::nullopt;
    return ReturnPassage{*time_s, crossingUncertainty_s(channel, second, from)};
}

double levelBehindReturn(
    const Channel &channel, const ReturnPassage &back, double wall_s, double end_s)
{
    const double way_s = back.time_s - wall_s;
    const double begin_s = back.time_s + kBehindBegin * way_s;
    const double last_s = std::min(back.time_s + kBehindEnd * way_s, end_s);
    if (!((last_s - begin_s) * channel.sampleRate_Hz >= kLeastLevelSamples)
        || last_s > channel.t0_s + channel.duration_s())
        return kUnknown;
    return medianBetween(channel, begin_s, last_s).value_or(kUnknown);
}

std::optional<SideArrival> sideArrival(const Channel &channel, const DetectedStart &start,
    const std::optional<double> &reflectionFree_s)
{
    const double untilReflection_s
        = reflectionFree_s ? *reflectionFree_s - start.time_s : kFallbackSpan_s;
    const double span_s = untilReflection_s > 0.0 ? untilReflection_s : kFallbackSpan_s;
    const double spanInRecord
        = std::min(span_s * channel.sampleRate_Hz, static_cast<double>(channel.samples.size()));
    const Index begin = start.sample + static_cast<Index>(kLevelBegin * spanInRecord);
    const Index end = start.sample + static_cast<Index>(kLevelEnd * spanInRecord) + 1;
    const auto level = medianLevel(channel, begin, end);
    if (!level)
        return std::nullopt;
    SideArrival arrival;
    arrival.before = start.baseline;
    arrival.behind = *level;
    arrival.noiseSd = start.noiseSd;
    const Index from = std::max<Index>(start.sample - 1, 0);
    const auto crossing = [&](double share) {
        return crossingTime_s(
            channel, arrival.before + share * (arrival.behind - arrival.before), from);
    };
    const auto time_s = crossing(kCrossing);
    if (!time_s)
        return std::nullopt;
    arrival.time_s = *time_s;
    arrival.rise_s = std::max(
        crossing(kRiseEnd).value_or(*time_s) - crossing(kRiseBegin).value_or(*time_s), 0.0);
    arrival.u_time_s = crossingUncertainty_s(channel, arrival, from);
    return arrival;
}

} // namespace dyncal
