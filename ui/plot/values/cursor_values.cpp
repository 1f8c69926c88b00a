// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/cursor_values.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

std::optional<Index> sampleNear(const CurveSamples &samples, double x)
{
    const Index from = samples.firstFrom(x);
    const Index begin = std::max<Index>(from - 2, 0);
    const DrawnPoints around = samples.samples(begin, std::min(from + 2, samples.size()));
    if (around.x.empty())
        return std::nullopt;
    const auto nearest = std::ranges::min_element(
        around.x, {}, [x](double sample) { return std::abs(sample - x); });
    const double interval = around.x.size() > 1 ? around.x[1] - around.x[0] : 0.0;
    const bool isOutside = x < around.x.front() || x > around.x.back();
    if (isOutside && std::abs(*nearest - x) > interval / 2.0)
        return std::nullopt;
    return begin + (nearest - around.x.begin());
}

std::optional<double> valueNear(const CurveSamples &samples, double x)
{
    const std::optional<Index> at = sampleNear(samples, x);
    if (!at)
        return std::nullopt;
    const double y = samples.samples(*at, *at + 1).y.front();
    return std::isfinite(y) ? std::optional(y) : std::nullopt;
}

} // namespace dyncal
