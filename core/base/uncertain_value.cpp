// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/uncertain_value.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {

std::vector<VariancePart> partsOf(const std::vector<UncertaintyLine> &lines)
{
    std::vector<VariancePart> parts;
    parts.reserve(lines.size());
    for (const UncertaintyLine &line : lines)
        parts.push_back({line.quantity, line.contribution, line.dof, line.shot, line.correlated});
    return parts;
}

bool areCorrelated(const std::vector<UncertaintyLine> &lines)
{
    return std::ranges::any_of(
        lines, [](const UncertaintyLine &line) { return !line.correlated.empty(); });
}

CombinedUncertainty combined(const std::vector<UncertaintyLine> &lines)
{
    if (areCorrelated(lines))
        return combinedParts(partsOf(lines));
    double variance = 0.0;
    double fourth = 0.0;
    for (const UncertaintyLine &line : lines) {
        variance += line.contribution * line.contribution;
        if (std::isfinite(line.dof) && line.dof > 0.0)
            fourth += std::pow(line.contribution, 4) / line.dof;
    }
    CombinedUncertainty result{std::sqrt(variance)};
    if (fourth > 0.0)
        result.dof = variance * variance / fourth;
    return result;
}

UncertaintyLine directLine(std::string quantity, double u, double dof, Distribution distribution)
{
    UncertaintyLine line;
    line.quantity = std::move(quantity);
    line.u = u;
    line.dof = dof;
    line.distribution = distribution;
    line.contribution = u;
    return line;
}

UncertaintyLine with(OverShots overShots, UncertaintyLine line)
{
    line.overShots = overShots;
    return line;
}

std::vector<UncertaintyLine> scaled(std::vector<UncertaintyLine> lines, double factor)
{
    for (UncertaintyLine &line : lines) {
        line.sensitivity *= factor;
        line.contribution *= factor;
    }
    return lines;
}

} // namespace dyncal
