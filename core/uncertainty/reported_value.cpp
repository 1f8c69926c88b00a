// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/reported_value.h"

#include <cmath>

namespace dyncal {

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
    return u && *u > 0.0 ? 100.0 * std::pow(line.contribution / *u, 2) : 0.0;
}

void combineLines(ReportedValue &reported)
{
    constexpr double kCoverage = 0.95;
    const CombinedUncertainty all = combined(reported.lines);
    reported.u = all.u;
    reported.dof = all.dof;
    reported.k = coverageFactor(all.dof, kCoverage);
}

} // namespace dyncal
