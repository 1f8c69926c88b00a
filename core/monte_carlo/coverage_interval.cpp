// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/coverage_interval.h"

#include "core/base/distributions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

double quantileOf(const std::vector<double> &sorted, double p)
{
    const auto last = static_cast<double>(sorted.size() - 1);
    const double position = std::clamp(p * (last + 1.0) - 0.5, 0.0, last);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double share = position - static_cast<double>(below);
    return sorted[below] * (1.0 - share) + sorted[above] * share;
}

/// Of all intervals between order statistics that hold round(coverage n) trials (JCGM 101, 7.7.4).
void addShortest(const std::vector<double> &sorted, double coverage, DrawnQuantity &drawn)
{
    const auto n = std::ssize(sorted);
    const auto held = std::min<Index>(n - 1, std::llround(coverage * static_cast<double>(n)));
    Index best = 0;
    const auto width = [&](Index from) {
        return sorted[static_cast<std::size_t>(from + held)]
            - sorted[static_cast<std::size_t>(from)];
    };
    for (Index from = 1; from + held < n; ++from)
        if (width(from) < width(best))
            best = from;
    drawn.shortestLow = sorted[static_cast<std::size_t>(best)];
    drawn.shortestHigh = sorted[static_cast<std::size_t>(best + held)];
}

/// The number of trials below a quantile is binomial: its ranks at +-1.96 standard deviations, or
/// more where there are many comparisons.
void addExpanded(const Eigen::VectorXd &values, double reported, double coverage, Index comparisons,
    DrawnQuantity &drawn)
{
    const double twoSided = normalQuantile(1.0 - 0.025 / static_cast<double>(comparisons));
    std::vector<double> distance(values.begin(), values.end());
    for (double &one : distance)
        one = std::abs(one - reported);
    std::ranges::sort(distance);
    const double reach
        = twoSided * std::sqrt(coverage * (1.0 - coverage) / static_cast<double>(values.size()));
    drawn.expanded = quantileOf(distance, coverage);
    drawn.leastExpanded = quantileOf(distance, std::max(0.0, coverage - reach));
    drawn.mostExpanded = quantileOf(distance, std::min(1.0, coverage + reach));
}

} // namespace

DrawnQuantity drawnQuantity(
    const Eigen::VectorXd &values, double reported, double coverage, Index comparisons)
{
    DrawnQuantity drawn;
    drawn.trials = values.size();
    drawn.undefined = drawn.trials - values.array().isFinite().count();
    if (drawn.undefined > 0 || drawn.trials < 2)
        return drawn;
    drawn.mean = values.mean();
    drawn.u = std::sqrt(
        (values.array() - drawn.mean).square().sum() / static_cast<double>(drawn.trials - 1));
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    drawn.low = quantileOf(sorted, 0.5 * (1.0 - coverage));
    drawn.high = quantileOf(sorted, 0.5 * (1.0 + coverage));
    addShortest(sorted, coverage, drawn);
    addExpanded(values, reported, coverage, comparisons, drawn);
    return drawn;
}

void leaveOutMoments(double leastDof, DrawnQuantity &drawn)
{
    drawn.leastDof = leastDof;
    if (!(leastDof > 2.0))
        drawn.u = kUnknown;
    if (!(leastDof > 1.0))
        drawn.mean = kUnknown;
}

} // namespace dyncal
