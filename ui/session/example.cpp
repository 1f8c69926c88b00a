// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/example.h"

#include "core/base/content_hash.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

namespace dyncal {

namespace {

/// Stands for the file's hash: the hash of the recordings' own hashes, in order.
std::string combinedHash(const CaptureSet &set)
{
    std::string all;
    for (const Shot &shot : set.shots)
        for (const Channel &channel : shot.channels)
            all += sha256OfSamples(channel.samples);
    return sha256Hex(std::string_view(all));
}

} // namespace

Result<CaptureSet> exampleCaptures(const JobControl &control, double duration_s)
{
    SimulationSettings settings;
    Result<SensorSpec> sensor = sensorPreset("optic3");
    if (!sensor)
        return tl::unexpected(sensor.error());
    settings.sensor = std::move(*sensor);
    settings.duration_s = duration_s;
    Result<SimulatedCapture> simulated = simulateShots(settings, control);
    if (!simulated)
        return tl::unexpected(simulated.error());
    CaptureSet set = std::move(simulated->set);
    set.inputs = {{kExamplePath, "example optic3", combinedHash(set), "simulated"}};
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        set.shots[i].input = 0;
        set.shots[i].inFile = static_cast<Index>(i) + 1;
    }
    return set;
}

} // namespace dyncal
