// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/gum_validation.h"

#include "core/base/input_draws.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// The input that is more than half of u^2, or none.
std::string dominantOf(const std::vector<UncertaintyLine> &lines, double u)
{
    for (const UncertaintyLine &line : lines)
        if (2.0 * line.contribution * line.contribution > u * u)
            return line.quantity;
    return {};
}

} // namespace

GumValidation validateGum(
    double value, double u, double dof, double coverage, const DrawnQuantity &drawn)
{
    GumValidation gum;
    gum.u = u;
    gum.k = coverageFactor(dof, coverage);
    gum.low = value - gum.k * u;
    gum.high = value + gum.k * u;
    gum.d_low = std::abs(gum.low - drawn.low);
    gum.d_high = std::abs(gum.high - drawn.high);
    if (!(u > 0.0))
        return gum;
    gum.tolerance = numericalTolerance(u, 1);
    gum.validated
        = gum.d_low <= gum.tolerance && gum.d_high <= gum.tolerance && sizeOfGum(gum, drawn) == 0;
    return gum;
}

GumValidation validateGum(
    const ReportedValue &reported, double coverage, const DrawnQuantity &drawn)
{
    std::vector<UncertaintyLine> lines = reported.lines;
    std::erase_if(lines, [](const UncertaintyLine &line) { return line.quantity == kCapability; });
    const CombinedUncertainty all = combined(lines);
    GumValidation gum = validateGum(reported.value, all.u, all.dof, coverage, drawn);
    gum.largest = dominantOf(lines, all.u);
    return gum;
}

double leastDofOf(const std::vector<UncertaintyLine> &lines)
{
    double least = std::numeric_limits<double>::infinity();
    for (const UncertaintyLine &line : lines)
        if (line.contribution != 0.0 && line.dof > 0.0)
            least = std::min(least, line.dof);
    return least;
}

int sizeOfGum(const GumValidation &gum, const DrawnQuantity &drawn)
{
    if (gum.expanded() * (1.0 + kExpandedDiffers) < drawn.leastExpanded)
        return -1;
    return gum.expanded() > drawn.mostExpanded * (1.0 + kExpandedDiffers) ? 1 : 0;
}

} // namespace dyncal
