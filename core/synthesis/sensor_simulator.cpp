// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/sensor_simulator.h"

#include "core/base/number_text.h"
#include "core/synthesis/sensor_poles.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kPoleDistance = 1e-6; ///< relative; closer ones have no usable residues
constexpr double kWeightSum = 1e-9;
constexpr std::size_t kMostModes = 16;

struct Range
{
    double lowest;
    double highest;
    bool contains(double x) const { return x >= lowest && x <= highest; }
};

constexpr Range kFrequency_Hz{1e3, 1e8};
constexpr Range kDamping{1e-4, 10.0};
constexpr Range kSensitivity_V_Pa{1e-9, 1e-2};
constexpr Range kWeight{-10.0, 10.0};
constexpr Range kTimeConstant_s{1e-6, 1e3};
constexpr Range kHeatShare{-0.5, 0.5};

std::string presetNames()
{
    std::string names;
    for (const SensorSpec &preset : sensorPresets())
        names += std::string(names.empty() ? "" : ", ") + preset.name;
    return names;
}

Result<void> outOfRange(
    const char *quantity, const SensorSpec &sensor, double found, const Range &range)
{
    return fail(ErrorKind::Usage,
        Message{
            DYNCAL_TEXT("core", "The simulated sensor '%1' has %2 = %3; it must lie in %4 .. %5."),
            {sensor.name, quantity, numberText(found), numberText(range.lowest),
                numberText(range.highest)}});
}

Result<void> checkModes(const SensorSpec &sensor)
{
    if (sensor.modes.empty() || sensor.modes.size() > kMostModes)
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core", "The simulated sensor '%1' has %2 modes; it needs 1 to %3."),
                {sensor.name, std::to_string(sensor.modes.size()), std::to_string(kMostModes)}});
    double sum = 0.0;
    for (const SensorMode &mode : sensor.modes) {
        if (!kFrequency_Hz.contains(mode.f0_Hz))
            return outOfRange("f0_Hz", sensor, mode.f0_Hz, kFrequency_Hz);
        if (!kDamping.contains(mode.zeta))
            return outOfRange("zeta", sensor, mode.zeta, kDamping);
        if (!kWeight.contains(mode.weight))
            return outOfRange("weight", sensor, mode.weight, kWeight);
        sum += mode.weight;
    }
    if (!(std::abs(sum - 1.0) <= kWeightSum))
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "The weights of the simulated sensor '%1' add up to %2; they must add up to 1."),
                {sensor.name, numberText(sum)}});
    return {};
}

/// Fails if real poles coincide: they have no residues of their own.
Result<void> checkRealPoles(const SensorSpec &sensor)
{
    std::vector<double> shared = sharedRealPoles_per_s(sensor);
    for (const SensorMode &mode : sensor.modes) {
        std::vector<double> all = shared;
        for (const std::complex<double> &pole : modePoles(mode)) {
            if (pole.imag() == 0.0)
                all.push_back(-pole.real());
        }
        std::sort(all.begin(), all.end());
        for (std::size_t i = 1; i < all.size(); ++i) {
            if (all[i] - all[i - 1] < kPoleDistance * all[i])
                return fail(ErrorKind::Usage,
                    Message{
                        DYNCAL_TEXT("core",
                            "Two real poles of the simulated sensor '%1' coincide at %2 Hz; move one of them."),
                        {sensor.name, numberText(all[i] / kTwoPi, 6)}});
        }
    }
    return {};
}

} // namespace

const std::vector<SensorSpec> &sensorPresets()
{
    static const std::vector<SensorSpec> presets{
        {"piezo", 5.0e-6, {{318e3, 0.02, 1.0}}, {}, {}},
        {"optic1", 8.0e-6, {{400e3, 0.7, 1.0}}, {}, {}},
        {"optic2", 5.0e-6, {{3.11e6, 0.03, 1.0}}, {}, {}},
        {"optic3", 5.0e-6, {{2.33e6, 0.02, 1.0}}, {}, {}},
        {"optic4", 8.0e-6, {{2.78e6, 0.02, 1.0}}, 250e3, {}},
    };
    return presets;
}

Result<SensorSpec> sensorPreset(const std::string &name)
{
    for (const SensorSpec &preset : sensorPresets()) {
        if (preset.name == name)
            return preset;
    }
    return fail(ErrorKind::Usage,
        Message{DYNCAL_TEXT("core", "There is no sensor preset '%1'; choose one of %2."),
            {name, presetNames()}});
}

Result<void> checkSensor(const SensorSpec &sensor)
{
    if (!kSensitivity_V_Pa.contains(std::abs(sensor.sensitivity_V_Pa)))
        return outOfRange("sensitivity_V_Pa", sensor, sensor.sensitivity_V_Pa, kSensitivity_V_Pa);
    if (auto checked = checkModes(sensor); !checked)
        return checked;
    if (sensor.realPole_Hz && !kFrequency_Hz.contains(*sensor.realPole_Hz))
        return outOfRange("realPole_Hz", sensor, *sensor.realPole_Hz, kFrequency_Hz);
    if (sensor.acCoupling_s && !kTimeConstant_s.contains(*sensor.acCoupling_s))
        return outOfRange("acCoupling_s", sensor, *sensor.acCoupling_s, kTimeConstant_s);
    if (sensor.heat && !kHeatShare.contains(sensor.heat->share))
        return outOfRange("heat.share", sensor, sensor.heat->share, kHeatShare);
    if (sensor.heat && !kTimeConstant_s.contains(sensor.heat->tau_s))
        return outOfRange("heat.tau_s", sensor, sensor.heat->tau_s, kTimeConstant_s);
    return checkRealPoles(sensor);
}

} // namespace dyncal
