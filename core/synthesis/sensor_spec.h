// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

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

/// 1 - share/(1 + s tau): heat of the shocked gas makes the output sag by its share.
struct HeatSag
{
    double share = 0.0;
    double tau_s = 0.0;
};

/// G(s) = S0 * sum of modes, optionally times 1/(1 + s/w1), s/(s + 1/tau) and the sag by heat. S0
/// is the sensitivity at the onset.
struct SensorSpec
{
    std::string name;
    double sensitivity_V_Pa = 0.0;
    std::vector<SensorMode> modes;
    std::optional<double> realPole_Hz; ///< w1/2pi: third order
    std::optional<double> acCoupling_s; ///< tau
    std::optional<HeatSag> heat = {};
};

} // namespace dyncal
