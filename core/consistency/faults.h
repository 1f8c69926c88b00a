// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/consistency/shot_ways.h"

#include <functional>
#include <string>
#include <vector>

namespace dyncal {

/// A fault as something to take back from one shot's point.
struct Fault
{
    FindingCause cause;
    double usual; ///< size that is not surprising, in its own unit
    double largest; ///< beyond, it is not believed
    bool perShot; ///< another size in every shot
    /// Takes back a fault of that size; false where there can be none of it. A shot without what
    /// the fault acts on (that sensor, arrivals, something typed, moist air) stays as it is.
    std::function<bool(const ShotEvidence &, double, CheckPoint &)> takeBack;
};

/// Everything that may be wrong in a calibration with these side sensors: what was typed, rate, gas
/// (molar mass alone, or a share of a known gas), temperature, humidity, p1, both scales,
/// attenuation, delays, and the distance of every sensor, which a shot may have missed.
std::vector<Fault> possibleFaults(const std::vector<std::string> &sensors);

} // namespace dyncal
