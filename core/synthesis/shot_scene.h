// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/shock/shock_relations.h"
#include "core/synthesis/simulation_settings.h"

#include <vector>

namespace dyncal {

/// What a laboratory would have written down about the simulated tube and day.
struct RecordedConditions
{
    static constexpr double driverLength_m = 0.97; ///< thesis, appendix A
    static constexpr double drivenLength_m = 0.97;
    static constexpr double innerDiameter_m = 0.10;
    static constexpr double distance_m = 0.80; ///< side sensor to end wall
    static constexpr double u_distance_m = 0.2e-3;
    static constexpr double p1_Pa = 101100.0; ///< thesis, table 4.1
    static constexpr double u_p1_Pa = 30.0;
    static constexpr double T1_K = 294.15;
    static constexpr double u_T1_K = 0.3;
    static constexpr double T4_K = 295.35;
    static constexpr Gas gas{}; ///< in both sections
};

/// What really happens in one simulated shot; times on the record's axis.
struct ShotScene
{
    ShockStates states;
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
