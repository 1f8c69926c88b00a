// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/per_shot.h"
#include "core/shock/counter_fit.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

inline constexpr const char *kConstantHeatCapacity = "constant";
inline constexpr const char *kVariableHeatCapacity = "variable";
/// Substances that only the program itself chooses: what the capture says (gas_choice.h), and air
/// of a humidity at any pressure and temperature.
inline constexpr const char *kAutoGas = "auto";
inline constexpr const char *kMoistAir = "moist-air";
inline constexpr double kUsualCarbonDioxide = 4e-4; ///< mole fraction in air

/// A gas: constants, which serve with a constant heat capacity, and what substance it is.
struct GasSettings
{
    double gamma = 1.402; ///< thesis table 4.1
    double molarMass_kg_mol = 0.028966; ///< thesis table 4.1
    std::string substance = "air"; ///< or "auto", "humid-air", "n2", "he", "ar", "co2", "custom"
    std::string heatCapacity = kConstantHeatCapacity; ///< or variable: cp(T) of the substance
    bool operator==(const GasSettings &) const = default;
};

/// What the capture says of the gas, else moist air.
inline GasSettings recordedGas()
{
    GasSettings gas;
    gas.substance = kAutoGas;
    return gas;
}

/// A sensor that marks the passing of the shock before it reaches the end wall.
struct ArrivalSensor
{
    std::string channel; ///< channel name or role name
    double distanceToEndWall_m = 0.0;
    double u_distance_m = 0.0;
    std::optional<double> arrival_s
        = std::nullopt; ///< typed for all shots, record axis; else found in the record
    double u_arrival_s = 0.0;
    std::optional<double> delay_s = std::nullopt; ///< of the sensor's 50 % crossing; taken off
    double u_delay_s = 0.0;
    /// Typed shot by shot (one entry per shot of the set, or none at all); empty = found.
    std::vector<std::optional<double>> shotArrival_s = {};
    bool operator==(const ArrivalSensor &) const = default;
};

/// Recipe section "shock". Empty values are taken from the capture (environment, tube) if it has
/// them.
struct ShockSettings
{
    bool enabled = true;
    std::optional<double> p1_Pa;
    std::optional<double> T1_K;
    std::optional<double> T4_K;
    GasSettings drivenGas = recordedGas();
    GasSettings driverGas = recordedGas();
    std::optional<double> relativeHumidity;
    PerShot velocity_m_s; ///< typed: wins over a measured one
    PerShot step_Pa; ///< typed pressure step: wins over a computed one
    std::vector<ArrivalSensor> arrivalSensors;
    std::optional<double> driverLength_m;
    std::optional<double> drivenLength_m;
    std::optional<double> innerDiameter_m;
    std::string dutPosition = "end-wall"; ///< or "side-wall"
    double frontDuration_s = 0.0;
    double u_frontDuration_s = 0.0;
    std::string stateFrom = "velocity"; ///< or "p2", "p4": which pressure the state follows from
    std::optional<double> p2_Pa = std::nullopt; ///< absolute; for "p2"
    std::optional<double> p4_Pa = std::nullopt; ///< absolute; for "p4", and to compare with
    double carbonDioxide = kUsualCarbonDioxide; ///< mole fraction in humid air
    std::vector<CounterReading> counters = {}; ///< win over arrival sensors
    std::string attenuation = "auto"; ///< or "none", "linear"
    Interval attenuation_per_m = kUsualAttenuation_per_m; ///< what is known of it for "auto"
    bool useDutArrival = true; ///< a DUT in the end wall marks the arrival there
    std::optional<double> dutDistance_m = std::nullopt; ///< of a DUT in the side wall
    std::optional<double> dutDiameter_m = std::nullopt; ///< of its diaphragm
    std::optional<double> tubeLength_m = std::nullopt; ///< over all; else the sum of the sections
    double wallSoundSpeed_m_s = 5130.0; ///< thesis, eq 5.1
    double plateauGuard_s = 0.0; ///< taken off the usable plateau
    double largestMach = 5.0; ///< of a shock in this tube; beyond, something is wrong (SHK-019)
    double largestDriverPressure_Pa = 5e7; ///< that this tube can hold, absolute

    bool operator==(const ShockSettings &) const = default;
};

} // namespace dyncal
