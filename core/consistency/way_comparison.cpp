// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/way_comparison.h"

#include <array>
#include <cmath>

namespace dyncal {

const char *comparedName(Compared of)
{
    constexpr std::array kNames{"velocity", "arrival", "mach", "p2 rise", "p5 rise", "p4", "step",
        "sensitivity", "shots", "levels"};
    return kNames[static_cast<std::size_t>(of)];
}

const char *wayName(Way way)
{
    constexpr std::array kNames{"typed", "counters", "arrivals", "this arrival", "other arrivals",
        "velocity over speed of sound", "ratio of steps", "ratio of velocities", "side sensor",
        "computed", "recorded", "sensor card", "this calibration", "one shot", "other shots",
        "names", "steps"};
    return kNames[static_cast<std::size_t>(way)];
}

bool WayComparison::agrees() const
{
    if (!isMade())
        return true;
    return of == Compared::Levels ? isInOrder : std::abs(difference()) <= kContradiction * u;
}

} // namespace dyncal
