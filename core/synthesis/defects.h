// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/synthesis/simulation_settings.h"
#include "core/synthesis/step_response.h"

#include <cstdint>
#include <string>

namespace dyncal {

/// Reads "clip" or "clip@2"; fails (Usage) naming the known kinds.
Result<Defect> parseDefect(const std::string &text);

inline constexpr double kDriftPerSecond = 20.0; ///< of the step: 2 % per millisecond

/// Whether shot `shot` (from 1) is to have the defect. Without a shot number a defect concerns all
/// shots; RingVar, which makes one shot unlike the others, then concerns the middle one.
bool hasDefect(const SimulationSettings &settings, DefectKind kind, Index shot);

/// Fails (Usage) on a defect of a shot that is not simulated.
Result<void> checkDefects(const SimulationSettings &settings);

/// The sensor with doubled damping of its first mode, and most of its response passing through a
/// slow, lightly damped resonance of its mount (docs/simulator.md).
SensorSpec looselyMounted(const SensorSpec &sensor);

/// A mode of the gas that the reflected shock excites.
struct TubeModeOfShot
{
    double amplitude = 0.0; ///< of the pressure, relative to the step
    Oscillation oscillation; ///< from the step on
};

/// Frequency proportional to the sound speed of region 5; damping, phase and amplitude as drawn
/// for that shot (docs/simulator.md).
TubeModeOfShot drawTubeMode(std::uint64_t seed, Index shot, double a5_m_s);

/// Volts as floating point numbers, three of them invalid from `time_s` on.
void spoilWithInvalidSamples(Channel &channel, double time_s);

/// Values in psi under the unit "bar", as when somebody typed the wrong unit.
void mislabelAsBar(Channel &channel, double sensitivity_V_Pa);

/// Exchanges the roles of the DUT and the driven-side channel.
void swapRoles(Shot &shot);

} // namespace dyncal
