// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/more_shots.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// The lines of n shots stand as those of `made` with the same sum of squares and the same sum of
/// c^4 / dof, which is all that u and its effective degrees of freedom rest on.
void rescale(double made, double shots, UncertaintyLine &line)
{
    if (line.overShots == OverShots::Shared)
        return;
    const double factor = std::sqrt(made / shots);
    line.sensitivity *= factor;
    line.contribution *= factor;
    line.dof = line.overShots == OverShots::Own ? line.dof * shots / made : line.dof + shots - made;
}

bool hasScatterWithoutDof(const ReportedValue &reported)
{
    return std::ranges::any_of(reported.lines, [](const UncertaintyLine &line) {
        return line.overShots == OverShots::Scatter && !(line.dof > 0.0);
    });
}

} // namespace

ReportedValue withShots(ReportedValue reported, Index made, Index shots)
{
    if (!reported.u || made < 1 || shots < 1)
        return reported;
    for (UncertaintyLine &line : reported.lines)
        rescale(static_cast<double>(made), static_cast<double>(shots), line);
    if (!hasScatterWithoutDof(reported)) {
        combineLines(reported);
        return reported;
    }
    reported.u.reset();
    reported.dof = reported.k = kUnknown;
    return reported;
}

ReportedValue withEndlessShots(ReportedValue reported)
{
    if (!reported.u)
        return reported;
    std::erase_if(reported.lines,
        [](const UncertaintyLine &line) { return line.overShots != OverShots::Shared; });
    combineLines(reported);
    return reported;
}

std::vector<ReportedValue> forShots(const ReportedValue &reported, Index made, Index most)
{
    std::vector<ReportedValue> values;
    for (Index shots = 1; reported.u && shots <= most; ++shots)
        values.push_back(withShots(reported, made, shots));
    return values;
}

} // namespace dyncal
