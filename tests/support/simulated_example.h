// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

#include <memory>

namespace dyncal::testing {

/// Three simulated shots of the optical sensor, as they would be read from a file.
inline std::shared_ptr<const CaptureSet> simulatedExample(
    double sampleRate_Hz, double duration_s = SimulationSettings().duration_s)
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.sampleRate_Hz = sampleRate_Hz;
    settings.duration_s = duration_s;
    settings.noise = 0.01;
    settings.seed = 3;
    auto set = std::make_shared<CaptureSet>(simulateShots(settings).value().set);
    set->inputs = {{"example", "example", "0123", "simulated"}};
    return set;
}

} // namespace dyncal::testing
