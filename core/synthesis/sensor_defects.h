// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/simulation_settings.h"

namespace dyncal {

/// The sensor under test as it is in that shot (from 1): loosely mounted, more or less sensitive,
/// AC coupled, heated, as the settings' defects say.
SensorSpec sensorOfShot(const SimulationSettings &settings, Index shot);

/// The sensor with doubled damping of its first mode, and most of its response passing through a
/// slow, lightly damped resonance of its mount (docs/simulator.md).
SensorSpec looselyMounted(const SensorSpec &sensor);

/// Time in s from 10 to 90 % of the unit step response, each passed for the first time. For sensors
/// that pass checkSensor and reach 90 %; else 0.
double riseTime_s(const SensorSpec &sensor);

} // namespace dyncal
