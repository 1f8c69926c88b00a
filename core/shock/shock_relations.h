// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

namespace dyncal {

inline constexpr double kGasConstant_J_molK = 8.314462618; ///< CODATA 2018
inline constexpr double kLowestTemperature_K = 200.0; ///< of a section before the shot
inline constexpr double kHighestTemperature_K = 400.0;

/// Ideal gas of constant heat capacity.
struct Gas
{
    double gamma = 1.402;
    double molarMass_kg_mol = 0.028966;
};

/// Speed of sound a = sqrt(gamma R T / M) (thesis 3.1). T > 0.
double soundSpeed_m_s(const Gas &gas, double temperature_K);

/// State of a gas at rest or moving along the tube.
struct GasState
{
    double pressure_Pa = 0.0;
    double temperature_K = 0.0;
    double density_kg_m3 = 0.0;
    double soundSpeed_m_s = 0.0;
    double velocity_m_s = 0.0;
};

/// A gas at rest; density from p M / (R T). T > 0.
GasState gasAtRest(const Gas &gas, double pressure_Pa, double temperature_K);

/// Everything that follows from a shock of velocity W into gas at rest (p1, T1) with a rigid end
/// wall: regions 1, 2, 5 and the reflected shock (thesis 3.1-3.9).
struct ShockStates
{
    double velocity_m_s = 0.0;
    double mach = 0.0;
    GasState driven; ///< region 1
    GasState shocked; ///< region 2
    GasState reflected; ///< region 5
    double reflectedVelocity_m_s = 0.0;
    double reflectedMach = 0.0;
};

/// Fails (DataBlocked, SHK-001) if M <= 1, (SHK-004) if T1 is outside 200..400 K, and on p1 <= 0;
/// (Usage) on an impossible gas: gamma outside (1, 2], molar mass outside 0.001..0.4 kg/mol.
/// Relative error of the results below 1e-12 down to M - 1 = 1e-6.
Result<ShockStates> shockStates(const Gas &gas, double p1_Pa, double T1_K, double velocity_m_s);

/// Time from the shock's reflection until the disturbance from the contact surface is back at the
/// end wall, for a driven section of the given length > 0 (docs/method/shock.md).
double plateauTime_s(const ShockStates &states, double drivenLength_m);

/// Driver pressure that makes this shock with an ideal diaphragm (eq 3.10). Fails where no pressure
/// makes it (DataBlocked), on T4 outside 200..400 K (SHK-004) and on an impossible driver gas
/// (Usage).
Result<double> driverPressure_Pa(
    const ShockStates &states, const Gas &driven, const Gas &driver, double T4_K);

/// Mach number of the shock with pressure ratio p2/p1 (eq 3.1 inverted). Fails (DataBlocked,
/// SHK-001) on a ratio that is not above 1.
Result<double> machOfPressureRatio(const Gas &gas, double ratio);

/// Velocity of the shock that a driver at p4, T4 makes in gas at p1, T1: eq 3.10 solved for p2/p1,
/// then eq 3.1. Fails (DataBlocked) where p4 does not exceed p1 and as driverPressure_Pa().
Result<double> velocityOfDriverPressure_m_s(
    const Gas &driven, double p1_Pa, double T1_K, const Gas &driver, double p4_Pa, double T4_K);

/// Region 3: driver gas behind the contact surface, expanded from (p4, T4) to p3 = p2 without a
/// shock; u3 = u2. `p4_Pa` at least p2.
GasState expandedDriver(const ShockStates &states, const Gas &driver, double p4_Pa, double T4_K);

} // namespace dyncal
