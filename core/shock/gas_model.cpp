// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/gas_model.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/shock/moist_air.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kSecondRadiation_cmK = 1.438776877; ///< h c / k
/// Wave numbers: N2 and O2 from Huber and Herzberg (1979), CO2 from Shimanouchi (1972), as in the
/// NIST Chemistry WebBook.
constexpr double kNitrogen_K = 2358.57 * kSecondRadiation_cmK;
constexpr double kOxygen_K = 1580.193 * kSecondRadiation_cmK;
constexpr double kDioxideStretch_K = 1333.0 * kSecondRadiation_cmK;
constexpr double kDioxideBend_K = 667.0 * kSecondRadiation_cmK;
constexpr double kDioxideAntisymmetric_K = 2349.0 * kSecondRadiation_cmK;
constexpr double kDryNitrogen = 0.78084; ///< mole fractions of dry air, the rest as argon
constexpr double kDryOxygen = 0.20946;

HeatCapacity dryAir()
{
    const double argon = 1.0 - kDryNitrogen - kDryOxygen;
    return {3.5 - argon, {{kNitrogen_K, kDryNitrogen}, {kOxygen_K, kDryOxygen}}};
}

std::vector<NamedGas> makeGases()
{
    const HeatCapacity monatomic{2.5, {}};
    const HeatCapacity nitrogen{3.5, {{kNitrogen_K, 1.0}}};
    const HeatCapacity dioxide{
        3.5, {{kDioxideStretch_K, 1.0}, {kDioxideBend_K, 2.0}, {kDioxideAntisymmetric_K, 1.0}}};
    const char *weights = "kinetic theory; IUPAC standard atomic weights";
    return {{"air", 1.402, 0.028966, 5e-4, 1e-5, dryAir(), "thesis, table 4.1"},
        {"n2", 7.0 / 5.0, 0.028014, 5e-4, 1e-6, nitrogen, weights},
        {"he", 5.0 / 3.0, 0.0040026, 5e-4, 1e-6, monatomic, weights},
        {"ar", 5.0 / 3.0, 0.039948, 5e-4, 1e-6, monatomic, weights},
        {"co2", gammaAt(dioxide, 293.15), 0.044009, 5e-4, 1e-6, dioxide,
            "harmonic oscillators at 293.15 K; IUPAC standard atomic weights"}};
}

/// Moist air as an ideal mixture.
MoistAir idealMoistAir(double temperature_K, double waterFraction)
{
    constexpr double kWater_kg_mol = 0.018015;
    constexpr double kDryAir_kg_mol = 0.028966;
    // Wave numbers of water: Shimanouchi (1972), as in the NIST Chemistry WebBook.
    static const HeatCapacity water{4.0,
        {{1595.0 * kSecondRadiation_cmK, 1.0}, {3657.0 * kSecondRadiation_cmK, 1.0},
            {3756.0 * kSecondRadiation_cmK, 1.0}}};
    static const HeatCapacity dry = dryAir();
    const double cp = (1.0 - waterFraction) * cpOverR(dry, temperature_K)
        + waterFraction * cpOverR(water, temperature_K);
    const double mass = (1.0 - waterFraction) * kDryAir_kg_mol + waterFraction * kWater_kg_mol;
    const double gamma = cp / (cp - 1.0);
    return {std::sqrt(gamma * kGasConstant_J_molK * temperature_K / mass), gamma, waterFraction};
}

/// Moist air at any state of the driven section: Cramer's inside his range; outside, his values at
/// the nearest state inside, moved on by the ideal mixture of dry air and water. The real gas
/// differs from the ideal one by about 0.03 % of the speed of sound per 100 kPa.
Result<MoistAir> anyMoistAir(const SectionState &state)
{
    constexpr double kMostWater = 0.06; // Cramer's range
    const double T_K = std::clamp(state.temperature_K, kCelsiusZero_K, kCelsiusZero_K + 30.0);
    const double p_Pa = std::clamp(state.pressure_Pa, 75e3, 102e3);
    const double humidity = std::clamp(state.relativeHumidity, 0.0, 1.0);
    const double water
        = std::min(waterFraction(state.pressure_Pa, state.temperature_K, humidity), 0.5);
    const double saturated = waterFraction(p_Pa, T_K, 1.0);
    const double inside = std::min({water / saturated, 1.0, kMostWater / saturated});
    const auto known = moistAir(p_Pa, T_K, inside, std::clamp(state.carbonDioxide, 0.0, 0.01));
    if (!known)
        return tl::unexpected(known.error());
    const MoistAir from = idealMoistAir(T_K, known->waterFraction);
    const MoistAir to = idealMoistAir(state.temperature_K, water);
    return MoistAir{known->soundSpeed_m_s * to.soundSpeed_m_s / from.soundSpeed_m_s,
        known->gamma + to.gamma - from.gamma, water};
}

const NamedGas *knownGas(const std::string &name)
{
    const auto &gases = knownGases();
    const auto found = std::find_if(
        gases.begin(), gases.end(), [&](const NamedGas &gas) { return name == gas.name; });
    return found != gases.end() ? &*found : nullptr;
}

GasModel humidAirOf(const SectionState &state, const MoistAir &air)
{
    GasModel model{"humid-air", {}, {}, 5e-4, 0.0, "Cramer 1993"};
    // The mass that makes the ideal gas's speed of sound the real one.
    model.constants = {air.gamma,
        air.gamma * kGasConstant_J_molK * state.temperature_K
            / (air.soundSpeed_m_s * air.soundSpeed_m_s)};
    return model;
}

Result<GasModel> humidAir(const SectionState &state, bool anywhere)
{
    const auto air = anywhere ? anyMoistAir(state)
                              : moistAir(state.pressure_Pa, state.temperature_K,
                                  state.relativeHumidity, state.carbonDioxide);
    if (!air)
        return tl::unexpected(air.error());
    return humidAirOf(state, *air);
}

Result<void> noHeatCapacity(const std::string &name)
{
    return fail(ErrorKind::Usage,
        Message{
            DYNCAL_TEXT("core",
                "The gas '%1' has no heat capacity over temperature; choose air, n2, he, ar or co2, or a constant heat capacity."),
            {name}});
}

Result<void> unknownGas(const std::string &name)
{
    return fail(ErrorKind::Usage,
        Message{
            DYNCAL_TEXT("core",
                "The gas '%1' is not known; it must be air, humid-air, n2, he, ar, co2 or custom."),
            {name}});
}

} // namespace

double cpOverR(const HeatCapacity &gas, double temperature_K)
{
    double cp = gas.rigidCp_R;
    for (const Vibration &vibration : gas.vibrations) {
        const double half = 0.5 * vibration.theta_K / temperature_K;
        const double term = half / std::sinh(half);
        cp += vibration.share * term * term;
    }
    return cp;
}

double enthalpyOverR_K(const HeatCapacity &gas, double temperature_K)
{
    double h = gas.rigidCp_R * temperature_K;
    for (const Vibration &vibration : gas.vibrations)
        h += vibration.share * vibration.theta_K / std::expm1(vibration.theta_K / temperature_K);
    return h;
}

double gammaAt(const HeatCapacity &gas, double temperature_K)
{
    const double cp = cpOverR(gas, temperature_K);
    return cp / (cp - 1.0);
}

const std::vector<NamedGas> &knownGases()
{
    static const std::vector<NamedGas> gases = makeGases();
    return gases;
}

Result<GasModel> gasModel(const GasSettings &settings, const SectionState &state)
{
    const bool variable = settings.heatCapacity == kVariableHeatCapacity;
    const NamedGas *known = knownGas(settings.substance);
    const bool anywhere = settings.substance == kMoistAir;
    if ((anywhere || settings.substance == "humid-air") && !variable)
        return humidAir(state, anywhere);
    if (variable && known == nullptr)
        return tl::unexpected(noHeatCapacity(settings.substance).error());
    if (known == nullptr && settings.substance != "custom")
        return tl::unexpected(unknownGas(settings.substance).error());
    GasModel model{settings.substance, {settings.gamma, settings.molarMass_kg_mol}, {}, 5e-4, 1e-5,
        kTypedConstants.data()};
    if (known != nullptr) {
        model.u_gamma = known->u_gamma;
        model.u_molarMass_kg_mol = known->u_molarMass_kg_mol;
        if (settings.gamma == known->gamma && settings.molarMass_kg_mol == known->molarMass_kg_mol)
            model.source = known->source;
    }
    if (variable) {
        model.heatCapacity = known->heatCapacity;
        model.constants.gamma = gammaAt(known->heatCapacity, state.temperature_K);
        model.source = "harmonic oscillators in equilibrium, valid 200 K to 1500 K";
    }
    return model;
}

} // namespace dyncal
