// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/shock/shock_relations.h"
#include "core/synthesis/recorded_conditions.h"
#include "core/synthesis/simulation_settings.h"

#include <vector>

namespace dyncal {

/// What really happens in one simulated shot; times on the record's axis.
struct ShotScene
{
    Gas gas; ///< true, in the driven section
    ShockStates states; ///< of the shock as it reaches the end wall
    double attenuation_per_m = 0.0; ///< a of W(x) = W (1 + a x), x m from the end wall
    double pressureBehindShockAtSide_Pa = 0.0; ///< absolute
    double distance_m = 0.0; ///< true, side sensor to end wall
    double driverPressure_Pa = 0.0; ///< absolute, in steps of 100 Pa
    double plateau_s = 0.0;
    double burst_s = 0.0;
    double sideArrival_s = 0.0;
    double wallArrival_s = 0.0;
    double reflectionAtSide_s = 0.0;

    double step_Pa() const { return states.reflected.pressure_Pa - states.driven.pressure_Pa; }
};

/// One scene per shot of the settings, drawn from their seed (distributions: docs/simulator.md).
Result<std::vector<ShotScene>> drawScenes(const SimulationSettings &settings);

} // namespace dyncal
