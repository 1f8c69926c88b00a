// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/reported_value.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr double kCoverageOfReported = 0.95;

void setCombined(ReportedValue &reported)
{
    const CombinedUncertainty all = combined(reported.lines);
    reported.u = all.u;
    reported.dof = all.dof;
    reported.k = coverageFactor(all.dof, kCoverageOfReported);
}

/// U that the value has with a u of this size, from the same degrees of freedom.
double expandedWith(double u, const ReportedValue &before)
{
    const double dof = before.dof * std::pow(u / *before.u, 4);
    return u * statedFactor(coverageFactor(dof, kCoverageOfReported));
}

/// The least u whose U is not below `leastExpanded`; k falls as it grows.
double uOfCapability(const ReportedValue &before)
{
    double low = *before.u, high = before.leastExpanded / kUsualFactor;
    if (std::isinf(before.dof) || !(low > 0.0))
        return high;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (expandedWith(middle, before) < before.leastExpanded ? low : high) = middle;
    }
    return high;
}

} // namespace

double statedFactor(double k)
{
    return k > kUsualFactor ? k : kUsualFactor;
}

std::optional<double> ReportedValue::expanded() const
{
    return u ? std::optional(factor() * *u) : std::nullopt;
}

double ReportedValue::sharePercent(const UncertaintyLine &line) const
{
    if (!u || !(*u > 0.0))
        return 0.0;
    if (line.correlated.empty())
        return 100.0 * std::pow(line.contribution / *u, 2);
    const auto at = static_cast<std::size_t>(&line - lines.data());
    return 100.0 * varianceShares(partsOf(lines))[at] / (*u * *u);
}

void combineLines(ReportedValue &reported)
{
    std::erase_if(
        reported.lines, [](const UncertaintyLine &line) { return line.quantity == kCapability; });
    setCombined(reported);
    if (!(*reported.expanded() < reported.leastExpanded))
        return;
    const double u = uOfCapability(reported);
    reported.lines.push_back(
        directLine(kCapability, std::sqrt((u - *reported.u) * (u + *reported.u))));
    reported.lines.back().value = 0.0;
    setCombined(reported);
    reported.k = statedFactor(reported.k); // k u is the CMC, whoever multiplies
}

} // namespace dyncal
