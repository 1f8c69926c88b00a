// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/way_words.h"

namespace dyncal {

Message comparedText(Compared of)
{
    switch (of) {
    case Compared::Velocity:
        return {DYNCAL_TEXT("core", "Velocity"), {}};
    case Compared::Arrival:
        return {DYNCAL_TEXT("core", "Travel time"), {}};
    case Compared::Mach:
        return {DYNCAL_TEXT("core", "Mach number"), {}};
    case Compared::P2Rise:
        return {DYNCAL_TEXT("core", "p2 − p1"), {}};
    case Compared::P5Rise:
        return {DYNCAL_TEXT("core", "p5 − p1"), {}};
    case Compared::P4:
        return {DYNCAL_TEXT("core", "Driver pressure"), {}};
    case Compared::Step:
        return {DYNCAL_TEXT("core", "Pressure step"), {}};
    case Compared::Sensitivity:
        return {DYNCAL_TEXT("core", "Sensitivity"), {}};
    case Compared::Shots:
        return {DYNCAL_TEXT("core", "Sensitivity, shot against shots"), {}};
    case Compared::Levels:
        return {DYNCAL_TEXT("core", "Order of the levels"), {}};
    }
    return {};
}

Message wayText(Way way)
{
    switch (way) {
    case Way::Typed:
        return {DYNCAL_TEXT("core", "typed"), {}};
    case Way::Counters:
        return {DYNCAL_TEXT("core", "counters"), {}};
    case Way::Arrivals:
        return {DYNCAL_TEXT("core", "arrivals"), {}};
    case Way::ThisArrival:
        return {DYNCAL_TEXT("core", "this arrival"), {}};
    case Way::OtherArrivals:
        return {DYNCAL_TEXT("core", "other arrivals"), {}};
    case Way::SoundSpeed:
        return {DYNCAL_TEXT("core", "velocity over speed of sound"), {}};
    case Way::StepRatio:
        return {DYNCAL_TEXT("core", "ratio of the steps"), {}};
    case Way::VelocityRatio:
        return {DYNCAL_TEXT("core", "ratio of the velocities"), {}};
    case Way::SideSensor:
        return {DYNCAL_TEXT("core", "side sensor"), {}};
    case Way::Computed:
        return {DYNCAL_TEXT("core", "computed"), {}};
    case Way::Recorded:
        return {DYNCAL_TEXT("core", "recorded"), {}};
    case Way::Card:
        return {DYNCAL_TEXT("core", "sensor card"), {}};
    case Way::Calibration:
        return {DYNCAL_TEXT("core", "this calibration"), {}};
    case Way::OneShot:
        return {DYNCAL_TEXT("core", "this shot"), {}};
    case Way::OtherShots:
        return {DYNCAL_TEXT("core", "other shots"), {}};
    case Way::Names:
        return {DYNCAL_TEXT("core", "names"), {}};
    case Way::Steps:
        return {DYNCAL_TEXT("core", "steps"), {}};
    }
    return {};
}

} // namespace dyncal
