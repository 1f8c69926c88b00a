// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/simulation_checks.h"

#include "core/base/number_text.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/sensor_defects.h"
#include "core/synthesis/sensor_simulator.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr double kMostSamples = 1e8; ///< per channel
constexpr double kMostSamplesInAll = 1e9;
constexpr double kChannels = 3.0;
constexpr Index kMostShots = 100;

Result<void> checkRange(const char *name, double value, double lowest, double highest)
{
    if (value >= lowest && value <= highest)
        return {};
    return fail(ErrorKind::Usage,
        Message{
            DYNCAL_TEXT("core", "The simulation is asked for %1 = %2; it must lie in %3 .. %4."),
            {name, numberText(value), numberText(lowest), numberText(highest)}});
}

Result<void> checkShots(const std::vector<ShotLevel> &shots)
{
    if (auto checked = checkRange("number of shots", static_cast<double>(shots.size()), 1.0,
            static_cast<double>(kMostShots));
        !checked)
        return checked;
    if (std::find(shots.begin(), shots.end(), ShotLevel::None) != shots.end())
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core", "A shot to simulate has no level; choose low, medium or high."),
                {}});
    return {};
}

Result<void> checkSize(const SimulationSettings &settings)
{
    const double samples = settings.sampleRate_Hz * settings.duration_s;
    if (auto checked = checkRange("samples per channel", samples, 1.0, kMostSamples); !checked)
        return checked;
    return checkRange("samples in all",
        samples * kChannels * static_cast<double>(settings.shots.size()), 1.0, kMostSamplesInAll);
}

/// Above the Nyquist frequency the ringing would appear at another frequency than the stated truth.
Result<void> checkResolved(const SimulationSettings &settings)
{
    for (const SensorMode &mode : settings.sensor.modes) {
        if (2.0 * mode.f0_Hz >= settings.sampleRate_Hz)
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The simulated sensor '%1' rings at %2, which a sample rate of %3 cannot show; it needs more than %4."),
                    {settings.sensor.name, numberWithUnit(mode.f0_Hz, "Hz"),
                        numberWithUnit(settings.sampleRate_Hz, "Hz"),
                        numberWithUnit(2.0 * mode.f0_Hz, "Hz")}});
    }
    return {};
}

/// Time constants and gains of defects must suit the sensor, whatever its mount does to its modes.
Result<void> checkSensorsOfShots(const SimulationSettings &settings)
{
    for (Index shot = 1; shot <= std::ssize(settings.shots); ++shot) {
        SensorSpec sensor = sensorOfShot(settings, shot);
        sensor.modes = settings.sensor.modes;
        if (auto checked = checkSensor(sensor); !checked)
            return checked;
    }
    return {};
}

} // namespace

Result<void> checkSimulation(const SimulationSettings &settings)
{
    if (auto checked = checkShots(settings.shots); !checked)
        return checked;
    if (auto checked = checkRange("sample_rate_hz", settings.sampleRate_Hz, 1e5, 1e9); !checked)
        return checked;
    if (auto checked = checkRange("duration_s", settings.duration_s, 0.003, 1.0); !checked)
        return checked;
    if (auto checked = checkRange("noise", settings.noise, 0.0, 1.0); !checked)
        return checked;
    if (auto checked = checkRange("bits", settings.bits, 8, 28); !checked)
        return checked;
    if (auto checked = checkSize(settings); !checked)
        return checked;
    if (auto checked = checkSensor(settings.sensor); !checked)
        return checked;
    if (auto checked = checkResolved(settings); !checked)
        return checked;
    if (auto checked = checkDefects(settings); !checked)
        return checked;
    return checkSensorsOfShots(settings);
}

} // namespace dyncal
