// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/interpolated_samples.h"

#include <cmath>
#include <numeric>

namespace dyncal {
namespace {

constexpr Index kLeastChanges = 24;
constexpr double kRounding = 1e-9; ///< of the range, of the arithmetic
constexpr double kLeastContrast = 4.0; ///< of the changes at their places to those between

/// Whether what changes at every `spacing`-th place is far more than what changes between.
bool standsOut(const Eigen::VectorXd &changes, Index first, Index spacing)
{
    double at = 0.0, between = 0.0;
    for (Index i = 0; i < changes.size(); ++i)
        ((i - first) % spacing == 0 ? at : between) += changes[i] * changes[i];
    const double shareOfBetween = static_cast<double>(spacing - 1);
    return at * shareOfBetween >= kLeastContrast * kLeastContrast * between;
}

/// The greatest n of which all distances between places with a change are multiples; 1 where these
/// are too few to say.
Index spacingOf(const Eigen::VectorXd &changes, double tolerance)
{
    Index spacing = 0, first = -1, count = 0;
    for (Index i = 0; i < changes.size() && spacing != 1; ++i) {
        if (!(std::abs(changes[i]) > tolerance))
            continue;
        ++count;
        if (first < 0)
            first = i;
        else
            spacing = std::gcd(spacing, i - first);
    }
    const bool isDense = count >= kLeastChanges && 2 * count * spacing >= changes.size();
    return isDense && spacing > 1 && standsOut(changes, first, spacing) ? spacing : 1;
}

} // namespace

std::optional<InterpolatedSamples> interpolatedSamples(
    const Eigen::Ref<const Eigen::VectorXd> &values, double resolution)
{
    if (values.size() < 3)
        return std::nullopt;
    const double rounding = kRounding * (values.maxCoeff() - values.minCoeff());
    const Index count = values.size() - 1;
    const Eigen::VectorXd steps = values.tail(count) - values.head(count);
    if (const Index factor = spacingOf(steps, rounding); factor > 1)
        return InterpolatedSamples{factor, true};
    const Eigen::VectorXd bends = steps.tail(count - 1) - steps.head(count - 1);
    // Each point is at most half a step off its line, so the bend at most two.
    if (const Index factor = spacingOf(bends, 2.0 * resolution + rounding); factor > 1)
        return InterpolatedSamples{factor, false};
    return std::nullopt;
}

} // namespace dyncal
