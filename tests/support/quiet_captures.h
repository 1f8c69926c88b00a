// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/step_response.h"

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Records without any noise, as a script that checks the program against theory writes them.
namespace dyncal::testing {

/// How the values of a closed form get into a record.
struct QuietRecord
{
    double sampleRate_Hz = 10e6;
    Index before = 5000; ///< samples before the step
    Index after = 5000;
    double resolution = 0.0; ///< values are rounded to multiples of it; 0 = full double precision
    double offset = 0.0; ///< level before the step
    std::vector<double> steps = {0.3, 0.6, 0.9}; ///< one shot each
};

/// The exact step response of the sensor (gain 1), each shot arriving at a fraction of a sample of
/// its own; floating point numbers without anything about a converter.
inline std::shared_ptr<const CaptureSet> quietCapture(
    const SensorSpec &sensor, const QuietRecord &record)
{
    SensorSpec unit = sensor;
    unit.sensitivity_V_Pa = 1.0;
    const StepResponse response(unit);
    auto set = std::make_shared<CaptureSet>();
    set->inputs = {{"quiet", "quiet", "0123", "simulated"}};
    for (std::size_t i = 0; i < record.steps.size(); ++i) {
        std::vector<double> values(
            static_cast<std::size_t>(record.before + record.after), record.offset);
        const double first = std::fmod(0.37 * static_cast<double>(i + 1), 1.0);
        response.addTo(std::span(values).subspan(static_cast<std::size_t>(record.before)),
            first / record.sampleRate_Hz, record.sampleRate_Hz, record.steps[i]);
        if (record.resolution > 0.0) {
            for (double &value : values)
                value = std::nearbyint(value / record.resolution) * record.resolution;
        }
        Channel channel;
        channel.name = "DUT";
        channel.role = ChannelRole::Dut;
        channel.sampleRate_Hz = record.sampleRate_Hz;
        channel.samples = RawSamples(std::move(values));
        Shot shot;
        shot.label = std::to_string(i + 1);
        shot.channels = {std::move(channel)};
        set->shots.push_back(std::move(shot));
    }
    return set;
}

} // namespace dyncal::testing
