// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"

#include <complex>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One resonance of a sensor: weight * w0^2 / (s^2 + 2 zeta w0 s + w0^2).
struct SensorMode
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
    double weight = 1.0; ///< weights of a sensor sum to 1
};

/// G(s) = S0 * sum of modes, optionally times 1/(1 + s/w1), optionally times s/(s + 1/tau).
struct SensorSpec
{
    std::string name;
    double sensitivity_V_Pa = 0.0;
    std::vector<SensorMode> modes;
    std::optional<double> realPole_Hz; ///< w1/2pi: third order
    std::optional<double> acCoupling_s; ///< tau
};

/// The presets after the thesis's sensors: piezo, optic1..optic4, in that order
/// (docs/simulator.md).
const std::vector<SensorSpec> &sensorPresets();

/// Fails (Usage) naming the known presets.
Result<SensorSpec> sensorPreset(const std::string &name);

/// Fails (Usage) on a sensor that cannot be simulated: no or too many modes, weights that do not
/// add up to 1, values out of range (docs/simulator.md), real poles that coincide.
Result<void> checkSensor(const SensorSpec &sensor);

/// G(jw) of the truth, for tests: complex response at a frequency.
std::complex<double> sensorResponse(const SensorSpec &sensor, double frequency_Hz);

} // namespace dyncal
