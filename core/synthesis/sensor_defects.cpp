// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/sensor_defects.h"

#include "core/base/portable_random.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/step_response.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr double kMountFrequencyRatio = 1.0 / 25.0;
constexpr double kMountDamping = 1e-4;
constexpr double kMountWeight = 0.9;
constexpr Index kScatterStream = 5; ///< after those of scene, channels and tube mode

/// What the sensitivity of that shot is multiplied by.
double gainOfShot(const SimulationSettings &settings, Index shot)
{
    double gain = defectSize(settings, DefectKind::Gain, shot, 1.0);
    if (const auto scatter = defectOf(settings, DefectKind::Scatter, shot))
        gain *= 1.0
            + *scatter->size * RandomStream(settings.seed, shot, kScatterStream).nextNormal();
    return gain;
}

/// First time at which the response passes `level`: looked for in steps, then halved; 0 if never.
double firstPassing_s(const StepResponse &response, double level, double step_s)
{
    constexpr int kMostSteps = 100000;
    constexpr int kHalvings = 60;
    int steps = 1;
    while (steps < kMostSteps && response.at(steps * step_s) < level)
        ++steps;
    if (steps == kMostSteps)
        return 0.0;
    double low_s = (steps - 1) * step_s;
    double high_s = steps * step_s;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle_s = 0.5 * (low_s + high_s);
        (response.at(middle_s) < level ? low_s : high_s) = middle_s;
    }
    return high_s;
}

} // namespace

SensorSpec sensorOfShot(const SimulationSettings &settings, Index shot)
{
    SensorSpec sensor = hasDefect(settings, DefectKind::RingVar, shot)
        ? looselyMounted(settings.sensor)
        : settings.sensor;
    sensor.sensitivity_V_Pa *= gainOfShot(settings, shot);
    if (const auto ac = defectOf(settings, DefectKind::AcCoupling, shot))
        sensor.acCoupling_s = ac->size;
    const auto heat = defectOf(settings, DefectKind::Heat, shot);
    if (heat && *heat->size != 0.0)
        sensor.heat = HeatSag{*heat->size, *heat->time_s};
    return sensor;
}

SensorSpec looselyMounted(const SensorSpec &sensor)
{
    SensorSpec loose = sensor;
    for (SensorMode &mode : loose.modes)
        mode.weight *= 1.0 - kMountWeight;
    SensorMode &first = loose.modes.front();
    loose.modes.push_back({first.f0_Hz * kMountFrequencyRatio, kMountDamping, kMountWeight});
    loose.modes.front().zeta *= 2.0;
    return loose;
}

double riseTime_s(const SensorSpec &sensor)
{
    constexpr double kStepsPerPeriod = 200.0;
    double fastest_Hz = sensor.realPole_Hz.value_or(0.0);
    for (const SensorMode &mode : sensor.modes)
        fastest_Hz = std::max(fastest_Hz, mode.f0_Hz);
    const StepResponse response(sensor);
    const double step_s = 1.0 / (kStepsPerPeriod * fastest_Hz);
    const double high_s = firstPassing_s(response, 0.9, step_s);
    return high_s > 0.0 ? high_s - firstPassing_s(response, 0.1, step_s) : 0.0;
}

} // namespace dyncal
