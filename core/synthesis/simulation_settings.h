// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/capture_set.h"
#include "core/synthesis/sensor_spec.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dyncal {

enum class DefectKind {
    Clip,
    Nan,
    Swap,
    NoStep,
    Short,
    Fs50,
    Drift,
    Psi,
    RingVar,
    TubeMode,
    Heat,
    AcCoupling,
    Echo,
    Gain,
    Scatter,
    Attenuation,
    SideDelay,
    Distance,
    Temperature,
    Pressure,
    OtherGas,
    Humidity,
    Rate,
    Scale,
    Levels,
    Front,
    Tilt,
    Clock,
    Bow,
    Autoregressive,
    Flicker
};

/// A fault put into a simulated shot on purpose.
struct Defect
{
    DefectKind kind = DefectKind::Clip;
    Index shot = 0; ///< number from 1; 0 = all shots
    std::optional<double> size = {}; ///< empty = the kind's own (defect_kinds.h)
    std::optional<double> time_s = {}; ///< of kinds that take one, likewise
};

/// All settings of `dyncal simulate`; defaults are documented in docs/simulator.md.
struct SimulationSettings
{
    SensorSpec sensor; ///< what the DUT is
    std::vector<ShotLevel> shots{ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
    double sampleRate_Hz = 100e6;
    double duration_s = 0.02;
    double noise = 0.002; ///< sd as a fraction of each shot's own step, before quantisation
    int bits = 14;
    std::uint64_t seed = 1;
    std::vector<Defect> defects;
};

} // namespace dyncal
