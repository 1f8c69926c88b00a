// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/gas_model.h"

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

const NamedGas *knownGas(const std::string &name)
{
    const auto &gases = knownGases();
    const auto found = std::find_if(
        gases.begin(), gases.end(), [&](const NamedGas &gas) { return name == gas.name; });
    return found != gases.end() ? &*found : nullptr;
}

Result<GasModel> humidAir(const SectionState &state)
{
    const auto air = moistAir(
        state.pressure_Pa, state.temperature_K, state.relativeHumidity, state.carbonDioxide);
    if (!air)
        return tl::unexpected(air.error());
    GasModel model{"humid-air", {}, {}, 5e-4, 0.0, "Cramer 1993"};
    // The mass that makes the ideal gas's speed of sound the real one.
    model.constants = {air->gamma,
        air->gamma * kGasConstant_J_molK * state.temperature_K
            / (air->soundSpeed_m_s * air->soundSpeed_m_s)};
    return model;
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
    if (settings.substance == "humid-air" && !variable)
        return humidAir(state);
    if (variable && known == nullptr)
        return tl::unexpected(noHeatCapacity(settings.substance).error());
    if (known == nullptr && settings.substance != "custom")
        return tl::unexpected(unknownGas(settings.substance).error());
    GasModel model{
        settings.substance, {settings.gamma, settings.molarMass_kg_mol}, {}, 5e-4, 1e-5, "typed"};
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
