// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/reference/comparison_settings.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

#include <memory>

namespace dyncal::testing {

/// What the reference of referenceCapture() is.
inline ReferenceModel referenceTruth()
{
    const SensorSpec spec = sensorPreset("optic1").value();
    const SensorMode &mode = spec.modes.front();
    return {spec.sensitivity_V_Pa, 0.003 * spec.sensitivity_V_Pa, mode.f0_Hz, 0.001 * mode.f0_Hz,
        mode.zeta, 0.002};
}

/// Three simulated shots of the optical sensor, with the well-damped one as a reference transducer
/// that the same step reached at the same moment.
inline std::shared_ptr<CaptureSet> referenceCapture(double sampleRate_Hz = 2e7)
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.sampleRate_Hz = sampleRate_Hz;
    settings.noise = 0.01;
    settings.seed = 3;
    auto set = std::make_shared<CaptureSet>(simulateShots(settings).value().set);
    settings.sensor = sensorPreset("optic1").value();
    settings.noise = 0.002;
    const CaptureSet other = simulateShots(settings).value().set;
    for (std::size_t i = 0; i < set->shots.size(); ++i) {
        Channel channel = *other.shots[i].channelWithRole(ChannelRole::Dut);
        channel.name = "Reference";
        channel.role = ChannelRole::Reference;
        set->shots[i].channels.push_back(std::move(channel));
    }
    set->inputs = {{"example", "example", "0123", "simulated"}};
    return set;
}

/// A comparison with it, by its model.
inline ComparisonSettings referenceComparison()
{
    ComparisonSettings settings;
    settings.enabled = true;
    settings.model = referenceTruth();
    settings.u_delay_s = 1e-9;
    return settings;
}

} // namespace dyncal::testing
