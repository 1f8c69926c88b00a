// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/channel_recorder.h"
#include "core/synthesis/gas_defects.h"
#include "core/synthesis/shot_scene.h"
#include "core/synthesis/simulation_settings.h"

#include <cmath>
#include <optional>
#include <vector>

namespace dyncal {

/// A copy of the step that comes later.
struct EchoOfStep
{
    double share = 0.0;
    double delay_s = 0.0;
};

/// All that is needed to record one shot.
struct ShotPlan
{
    Index number = 0; ///< from 1
    ShotLevel level = ShotLevel::None; ///< as noted
    ShotScene scene;
    SensorSpec dut;
    RecordAxis axis;
    double noise_V = 0.0;
    NoiseKind noise;
    double driftPerSecond_V = 0.0;
    double overshoot = 0.0; ///< of the DUT's step response, relative
    bool burst = true;
    std::optional<TubeModeOfShot> tubeMode;
    std::optional<EchoOfStep> echo;
    std::optional<Front> front; ///< of the step at the DUT and of its echo
    double sideDelay_s = 0.0; ///< of the side sensor, besides its own response
    double bow_codes = 0.0; ///< of the DUT's converter

    double plateau_V() const { return std::abs(dut.sensitivity_V_Pa) * scene.step_Pa(); }
};

/// The plan of shot `shot` (from 1), for settings that pass checkSimulation.
ShotPlan planShot(const SimulationSettings &settings, const ShotScene &scene, Index shot);

/// The smallest range of the 1-2-5 series that fits the DUT in all shots, as an operator would
/// choose it.
double commonRange_V(const std::vector<ShotPlan> &plans);

/// The range of DefectKind::Clip: half of the overshoot is cut off, or the step itself.
double clippedRange_V(const ShotPlan &plan);

} // namespace dyncal
