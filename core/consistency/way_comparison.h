// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/contradiction.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/message.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

inline constexpr double kPowerMargin = 1.2816; ///< 90 % point of the normal distribution

enum class Compared {
    Velocity,
    Arrival,
    Mach,
    P2Rise, ///< p2 - p1 at a side sensor
    P5Rise, ///< p5 - p1 there
    P4,
    Step,
    Sensitivity,
    Shots,
    Levels
};

enum class Way {
    Typed,
    Counters,
    Arrivals,
    ThisArrival,
    OtherArrivals,
    SoundSpeed, ///< velocity over the speed of sound
    StepRatio, ///< reflected over incident step at a side sensor
    VelocityRatio, ///< incident over reflected velocity between a side sensor and the wall
    SideSensor,
    Computed,
    Recorded,
    Card,
    Calibration,
    OneShot,
    OtherShots,
    Names,
    Steps
};

const char *comparedName(Compared of); ///< "velocity", "mach": words of results.json
const char *wayName(Way way); ///< "arrivals", "ratio of steps"

/// Two independent ways to one quantity (docs/method/checks.md).
struct WayComparison
{
    Compared of = Compared::Mach;
    Way a = Way::Computed;
    Way b = Way::Computed;
    Index shot = 0; ///< from 1; 0 = of all shots
    std::string channel = {}; ///< where it was seen, if that is one place
    double value_a = kUnknown;
    double value_b = kUnknown;
    double u = kUnknown; ///< standard uncertainty of the difference, common errors removed
    std::string unit = {};
    std::optional<Message> missing = std::nullopt; ///< why the comparison could not be made
    bool isInOrder = true; ///< of the levels, which have no numbers

    bool isMade() const { return !missing.has_value(); }
    double difference() const { return value_a - value_b; }
    double e_n() const { return difference() / (2.0 * u); } ///< at k = 2 (ISO 13528)
    bool agrees() const;
    /// The fault that is found in nine of ten cases, in `unit`.
    double smallestDetectable() const { return (kContradiction + kPowerMargin) * u; }
};

/// What all ways of a calibration say of each other.
struct ConsistencyResult
{
    std::vector<WayComparison> checks;
    Findings findings;
};

} // namespace dyncal
