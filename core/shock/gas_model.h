// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/shock/shock_relations.h"
#include "core/shock/shock_settings.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// One kind of vibration of the molecules, as harmonic oscillators in equilibrium.
struct Vibration
{
    double theta_K = 0.0; ///< h nu / k
    double share = 1.0; ///< oscillators per molecule of the gas
};

/// Heat capacity of an ideal gas over temperature: rigid rotator and harmonic oscillators.
struct HeatCapacity
{
    double rigidCp_R = 3.5; ///< cp/R without vibration
    std::vector<Vibration> vibrations;
};

inline constexpr double kLowestHeatCapacity_K = 200.0; ///< range in which the model is valid
inline constexpr double kHighestHeatCapacity_K = 1500.0;

double cpOverR(const HeatCapacity &gas, double temperature_K); ///< cp/R
double enthalpyOverR_K(const HeatCapacity &gas, double temperature_K); ///< h/R, 0 at 0 K
double gammaAt(const HeatCapacity &gas, double temperature_K); ///< cp/(cp - R)

/// A gas as the relations need it, with what is known of its constants.
struct GasModel
{
    std::string name; ///< word of the recipe
    Gas constants; ///< at the state of the section
    std::optional<HeatCapacity> heatCapacity; ///< where cp(T) is asked for
    double u_gamma = 0.0; ///< usual standard uncertainties, used where no budget states them
    double u_molarMass_kg_mol = 0.0;
    const char *source = ""; ///< of the constants
};

/// `GasModel::source` of constants that a recipe states.
inline constexpr std::string_view kTypedConstants = "typed";

/// What the program knows of a gas that a recipe may name.
struct NamedGas
{
    const char *name;
    double gamma;
    double molarMass_kg_mol;
    double u_gamma;
    double u_molarMass_kg_mol;
    HeatCapacity heatCapacity;
    const char *source;
};

/// air (thesis, table 4.1), n2, he, ar, co2. "humid-air" and "custom" have no constants of their
/// own.
const std::vector<NamedGas> &knownGases();

/// State of a section's gas before the shot. Humidity and CO2 count for moist air only.
struct SectionState
{
    double pressure_Pa = 0.0;
    double temperature_K = 0.0;
    double relativeHumidity = 0.0;
    double carbonDioxide = 0.0;
};

/// The model that the settings ask for. Constant heat capacity: the typed gamma and molar mass.
/// "humid-air": gamma by Cramer and the molar mass that gives Cramer's speed of sound with it.
/// Variable: vibrational equilibrium, valid 200..1500 K. Fails (Usage) on an unknown name or on
/// variable heat capacity of a gas without one; (DataBlocked, SHK-009) outside Cramer's range.
Result<GasModel> gasModel(const GasSettings &settings, const SectionState &state);

} // namespace dyncal
