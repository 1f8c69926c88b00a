// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/plateau_drift.h"

#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kMeans = 32;
constexpr Index kFewestPerMean = 10;

bool driftsBehind(const WindowedResponse &response, double from_s)
{
    constexpr double kSigmas = 6.0;
    constexpr double kLeast = 1e-3; // of the level
    const auto first = static_cast<Index>(std::ceil(from_s * response.sampleRate_Hz));
    const Index each = (response.length - first) / kMeans;
    if (first < 0 || each < kFewestPerMean)
        return false;
    const auto behind = response.window().tail(response.length - first);
    const LineFit line = fitLine(meansOf(behind, each).head(kMeans));
    const double sd = std::max(line.sd, fitLine(meansOf(response.noise, each)).sd);
    const double change = std::abs(line.slope) * static_cast<double>(kMeans);
    return std::abs(line.slope) > kSigmas * uOfSlope(sd, kMeans)
        && change > kLeast * std::abs(line.mean);
}

} // namespace

bool levelsDriftBehind(const std::vector<WindowedResponse> &responses, double from_s)
{
    const auto drifting = std::ranges::count_if(responses,
        [&](const WindowedResponse &response) { return driftsBehind(response, from_s); });
    return 2 * drifting > std::ssize(responses);
}

} // namespace dyncal
