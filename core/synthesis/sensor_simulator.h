// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/synthesis/sensor_spec.h"

#include <complex>
#include <string>
#include <vector>

namespace dyncal {

/// The presets after the thesis's sensors: piezo, optic1..optic4, in that order
/// (docs/simulator.md).
const std::vector<SensorSpec> &sensorPresets();

/// Fails (Usage) naming the known presets.
Result<SensorSpec> sensorPreset(const std::string &name);

/// Fails (Usage) on a sensor that cannot be simulated: no or too many modes, weights that do not
/// add up to 1, values out of range (docs/simulator.md), real poles that coincide.
Result<void> checkSensor(const SensorSpec &sensor);

} // namespace dyncal
