// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/synthesis/simulation_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Reads KIND[=SIZE[:TIME]][@SHOT], e.g. "clip", "clip@2", "heat=0.05:1e-4@2". Fails (Usage) naming
/// the known kinds, or the range of a number.
Result<Defect> parseDefect(const std::string &text);

/// The defect of that kind in shot `shot` (from 1), its numbers filled in; the last one counts
/// where several are asked for. Without a shot number a defect concerns all shots, or the middle
/// one where the kind makes one shot unlike the others.
std::optional<Defect> defectOf(const SimulationSettings &settings, DefectKind kind, Index shot);

inline bool hasDefect(const SimulationSettings &settings, DefectKind kind, Index shot)
{
    return defectOf(settings, kind, shot).has_value();
}

/// The size of that defect in that shot, or `otherwise` without one.
double defectSize(
    const SimulationSettings &settings, DefectKind kind, Index shot, double otherwise);

/// The levels as they are noted: those of the settings unless DefectKind::Levels exchanges some.
std::vector<ShotLevel> notedLevels(const SimulationSettings &settings);

/// Fails (Usage) on a defect of a shot that is not simulated, of a size out of range, or that these
/// shots cannot show.
Result<void> checkDefects(const SimulationSettings &settings);

} // namespace dyncal
