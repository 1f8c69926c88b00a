// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_relations.h"
#include "core/synthesis/simulation_settings.h"
#include "core/synthesis/step_response.h"

#include <cstdint>

namespace dyncal {

/// The driven gas as it really is: dry air as noted, mixed with nitrogen (DefectKind::OtherGas) and
/// water vapour (DefectKind::Humidity) by mole fractions of ideal gases. p1 in Pa, T1 in K, the
/// true ones; the noted air itself without these defects.
Gas drivenGasOf(const SimulationSettings &settings, Index shot, double p1_Pa, double T1_K);

/// A mode of the gas that the reflected shock excites.
struct TubeModeOfShot
{
    double amplitude = 0.0; ///< of the pressure, relative to the step
    Oscillation oscillation; ///< from the step on
};

/// Frequency proportional to the sound speed of region 5; damping, phase and amplitude as drawn
/// for that shot (docs/simulator.md).
TubeModeOfShot drawTubeMode(std::uint64_t seed, Index shot, double a5_m_s);

/// Time in s until a shock of W(x) = W (1 + a x), x m from the end wall, has come from `distance_m`
/// to the wall: the integral of dx/W = distance/W ln(1 + a distance)/(a distance). `velocity_m_s`
/// is W, above 0; |a distance| below 0.1; distance/W exactly without attenuation.
double travelTime_s(double velocity_m_s, double attenuation_per_m, double distance_m);

} // namespace dyncal
