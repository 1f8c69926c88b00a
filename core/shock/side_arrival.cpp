// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/side_arrival.h"

#include "core/signal/start_detection.h"

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

} // namespace

std::optional<double> sideArrival_s(
    const Channel &channel, const std::optional<double> &reflectionFree_s)
{
    if (!(channel.sampleRate_Hz > 0.0))
        return std::nullopt;
    const auto start = detectStart(channel);
    if (!start)
        return std::nullopt;
    const double untilReflection_s
        = reflectionFree_s ? *reflectionFree_s - start->time_s : kFallbackSpan_s;
    const double span_s = untilReflection_s > 0.0 ? untilReflection_s : kFallbackSpan_s;
    const double spanInRecord
        = std::min(span_s * channel.sampleRate_Hz, static_cast<double>(channel.samples.size()));
    const Index begin = start->sample + static_cast<Index>(kLevelBegin * spanInRecord);
    const Index end = start->sample + static_cast<Index>(kLevelEnd * spanInRecord) + 1;
    const auto level = medianLevel(channel, begin, end);
    if (!level)
        return std::nullopt;
    return crossingTime_s(channel, start->baseline + kCrossing * (*level - start->baseline),
        std::max<Index>(start->sample - 1, 0));
}

} // namespace dyncal
