// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/simulation_settings.h"

#include <optional>
#include <span>
#include <string>

namespace dyncal {

/// A number that may be typed behind a kind, in the unit that docs/simulator.md states.
struct DefectNumber
{
    double standard = 0.0; ///< where none is typed
    double lowest = 0.0;
    double highest = 0.0;
};

/// Whom a defect without a shot number concerns.
enum class DefectScope {
    AllShots,
    MiddleShot, ///< it makes one shot unlike the others
    Capture ///< what is noted once; a shot number makes no sense
};

/// One row of the table of kinds.
struct DefectDescription
{
    DefectKind kind;
    const char *name; ///< as typed
    const char *meaning; ///< a few words for `--defect help`
    std::optional<DefectNumber> size = {};
    std::optional<DefectNumber> time_s = {};
    DefectScope scope = DefectScope::AllShots;
};

/// All kinds, in the order in which they are named to people.
std::span<const DefectDescription> defectDescriptions();

const DefectDescription &describedDefect(DefectKind kind);

/// "clip, nan, swap, ..."
std::string defectNames();

} // namespace dyncal
