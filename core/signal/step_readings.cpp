// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/step_readings.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kLowOfRise = 0.1, kHighOfRise = 0.9;
constexpr double kLargestNoise = 0.1;
constexpr double kSettleBand = 0.05;
constexpr double kLargestFineNoise = kSettleBand / 4.0;

/// Where the line through two neighbours has the value `level`, in samples.
double interpolated(const Eigen::Ref<const Eigen::VectorXd> &y, Index i, double level)
{
    return static_cast<double>(i) + (level - y[i]) / (y[i + 1] - y[i]);
}

/// First upward crossing of `level` between samples `from` and `end` - 1.
std::optional<double> firstCrossing(
    const Eigen::Ref<const Eigen::VectorXd> &y, Index from, Index end, double level)
{
    for (Index i = from; i + 1 < end; ++i) {
        if (y[i] < level && y[i + 1] >= level)
            return interpolated(y, i, level);
    }
    return std::nullopt;
}

std::optional<double> riseOf(const Eigen::Ref<const Eigen::VectorXd> &y, Index lead, Index end)
{
    const auto low = riseCrossing(y, lead, end, kLowOfRise);
    const auto high = riseCrossing(y, lead, end, kHighOfRise);
    if (!low || !high)
        return std::nullopt;
    return *high - *low;
}

/// Maximum of the window from a parabola through the largest sample and its neighbours.
double peakOf(const Eigen::Ref<const Eigen::VectorXd> &y, Index lead, Index length)
{
    Index at = 0;
    const double largest = y.segment(lead, length).maxCoeff(&at);
    if (at == 0 || at == length - 1)
        return largest;
    const double before = y[lead + at - 1], behind = y[lead + at + 1];
    const double bend = before - 2.0 * largest + behind;
    return bend < 0.0 ? largest - (behind - before) * (behind - before) / (8.0 * bend) : largest;
}

std::optional<double> settlingOf(
    const Eigen::Ref<const Eigen::VectorXd> &y, Index lead, Index length)
{
    Index i = lead + length - 1;
    while (i >= lead && std::abs(y[i] - 1.0) <= kSettleBand)
        --i;
    if (i == lead + length - 1 || i < lead)
        return std::nullopt; // not settled at the end, or never outside
    const double edge = y[i] > 1.0 ? 1.0 + kSettleBand : 1.0 - kSettleBand;
    return interpolated(y, i, edge) - static_cast<double>(lead);
}

} // namespace

std::optional<double> riseCrossing(
    const Eigen::Ref<const Eigen::VectorXd> &response, Index lead, Index end, double level)
{
    // In noise the detected start may lie above 10 %; then the crossing is before it.
    Index from = lead;
    while (from > 0 && response[from] >= kLowOfRise)
        --from;
    return firstCrossing(response, from, end, level);
}

StepReadings readStep(
    const Eigen::Ref<const Eigen::VectorXd> &response, Index lead, Index length, double noiseSd)
{
    StepReadings result;
    if (!(noiseSd <= kLargestNoise) || length < 2)
        return result;
    result.rise_samples = riseOf(response, lead, lead + length);
    if (noiseSd > kLargestFineNoise)
        return result;
    result.overshoot = std::max(peakOf(response, lead, length) - 1.0, 0.0);
    result.settling_samples = settlingOf(response, lead, length);
    return result;
}

} // namespace dyncal
