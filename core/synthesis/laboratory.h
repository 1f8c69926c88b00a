// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/simulation_settings.h"

#include <string>

namespace dyncal {

inline constexpr double kPressureRange_V = 5.0; ///< of the side and driver channels' converters

/// The other sensors; their sensitivity is known, so their channels are in pascal.
const SensorSpec &sideSensor();
const SensorSpec &driverSensor();

/// A capture without shots: tube, sensors and instruments as a laboratory would describe them.
CaptureSet laboratorySet(const SimulationSettings &settings);

/// What the laboratory wrote down of shot `shot` (from 1), defects of the notes included.
Environment recordedEnvironment(const SimulationSettings &settings, Index shot, double p4_Pa);

/// "Low", "Medium", "High".
std::string levelLabel(ShotLevel level);

/// Name, role, sensor and unit of the channel at `position` (0 DUT, 1 driven side, 2 driver); the
/// latter two get the polynomial that gives pascal.
void labelChannel(Channel &channel, std::size_t position, const SensorSpec &sensor);

} // namespace dyncal
