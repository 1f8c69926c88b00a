// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

namespace dyncal::testing {

inline constexpr double kSigmas = 5.0; ///< of statistical bounds

/// A short record at a tenth of the usual rate: enough for everything but speed.
inline SimulationSettings smallSettings(const char *preset = "optic3")
{
    SimulationSettings settings;
    settings.sensor = sensorPreset(preset).value();
    settings.sampleRate_Hz = 20e6;
    settings.duration_s = 0.006;
    return settings;
}

inline SimulatedCapture simulated(const SimulationSettings &settings)
{
    return simulateShots(settings).value();
}

} // namespace dyncal::testing
