// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_relations.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr double kHighestGamma = 2.0;
constexpr double kLightestGas_kg_mol = 0.001;
constexpr double kHeaviestGas_kg_mol = 0.4;

Result<void> checkGas(const Gas &gas)
{
    if (!(gas.gamma > 1.0 && gas.gamma <= kHighestGamma))
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "The gas has a ratio of specific heats of %1; it must be above 1 and at most %2 (air: 1.402)."),
                {numberText(gas.gamma), numberText(kHighestGamma)}});
    if (!(gas.molarMass_kg_mol >= kLightestGas_kg_mol
            && gas.molarMass_kg_mol <= kHeaviestGas_kg_mol))
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "The gas has a molar mass of %1 kg/mol; it must lie between %2 and %3 kg/mol (air: 0.028966), so check whether it was typed in g/mol."),
                {numberText(gas.molarMass_kg_mol), numberText(kLightestGas_kg_mol),
                    numberText(kHeaviestGas_kg_mol)}});
    return {};
}

bool isUsualTemperature(double temperature_K)
{
    return temperature_K >= kLowestTemperature_K && temperature_K <= kHighestTemperature_K;
}

Result<void> checkTemperature(const char *name, double temperature_K)
{
    if (isUsualTemperature(temperature_K))
        return {};
    const double fromCelsius_K = temperature_K + kCelsiusZero_K;
    if (isUsualTemperature(fromCelsius_K))
        return fail(ErrorKind::DataBlocked,
            Message{DYNCAL_TEXT("core",
                        "%1 = %2 K? Temperatures are in kelvin here: %2 degrees Celsius are %3 K."),
                {name, numberText(temperature_K, 6), numberText(fromCelsius_K, 6)}},
            "SHK-004");
    return fail(ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "%1 = %2 K is outside the range of %3 K to %4 K; enter the temperature of the gas in kelvin."),
            {name, numberText(temperature_K, 6), numberText(kLowestTemperature_K),
                numberText(kHighestTemperature_K)}},
        "SHK-004");
}

/// Ratios of temperature and density across a shock of the given pressure ratio (eqs 3.2, 3.3; the
/// same as 3.6, 3.7).
double temperatureRatio(double gamma, double pressureRatio)
{
    const double g = (gamma + 1.0) / (gamma - 1.0);
    return pressureRatio * (g + pressureRatio) / (1.0 + g * pressureRatio);
}

double densityRatio(double gamma, double pressureRatio)
{
    const double g = (gamma + 1.0) / (gamma - 1.0);
    return (1.0 + g * pressureRatio) / (g + pressureRatio);
}

/// The gas of `before` after a shock of the given pressure ratio, moving at `velocity_m_s`.
GasState stateBehind(
    const Gas &gas, const GasState &before, double pressureRatio, double velocity_m_s)
{
    GasState behind;
    behind.pressure_Pa = before.pressure_Pa * pressureRatio;
    behind.temperature_K = before.temperature_K * temperatureRatio(gas.gamma, pressureRatio);
    behind.density_kg_m3 = before.density_kg_m3 * densityRatio(gas.gamma, pressureRatio);
    behind.soundSpeed_m_s = soundSpeed_m_s(gas, behind.temperature_K);
    behind.velocity_m_s = velocity_m_s;
    return behind;
}

Result<void> checkShockInputs(const Gas &gas, double p1_Pa, double T1_K, double velocity_m_s)
{
    if (auto checked = checkGas(gas); !checked)
        return checked;
    if (!(p1_Pa > 0.0 && std::isfinite(p1_Pa)))
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "p1 = %1 Pa: the pressure in the driven section is absolute here and must be above 0; add the ambient pressure to a gauge reading."),
                {numberText(p1_Pa)}});
    if (auto checked = checkTemperature("T1", T1_K); !checked)
        return checked;
    const double mach = velocity_m_s / soundSpeed_m_s(gas, T1_K);
    if (!(mach > 1.0 && std::isfinite(mach)))
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "Computed Mach number %1 (velocity %2 m/s); a shock needs more than 1: check sample rate, distance, arrival times and T1."),
                {numberText(mach, 3), numberText(velocity_m_s, 5)}},
            "SHK-001");
    return {};
}

} // namespace

double soundSpeed_m_s(const Gas &gas, double temperature_K)
{
    return std::sqrt(gas.gamma * kGasConstant_J_molK * temperature_K / gas.molarMass_kg_mol);
}

GasState gasAtRest(const Gas &gas, double pressure_Pa, double temperature_K)
{
    return {pressure_Pa, temperature_K,
        pressure_Pa * gas.molarMass_kg_mol / (kGasConstant_J_molK * temperature_K),
        soundSpeed_m_s(gas, temperature_K), 0.0};
}

Result<ShockStates> shockStates(const Gas &gas, double p1_Pa, double T1_K, double velocity_m_s)
{
    if (auto checked = checkShockInputs(gas, p1_Pa, T1_K, velocity_m_s); !checked)
        return tl::unexpected(checked.error());
    const double gamma = gas.gamma;
    ShockStates states;
    states.driven = gasAtRest(gas, p1_Pa, T1_K);
    states.velocity_m_s = velocity_m_s;
    states.mach = velocity_m_s / states.driven.soundSpeed_m_s;

    // The excesses over 1 are computed directly: near M = 1 ratio - 1 would lose all digits.
    const double excess2 // p2/p1 - 1, eq 3.1
        = 2.0 * gamma / (gamma + 1.0) * (states.mach - 1.0) * (states.mach + 1.0);
    const double ratio2 = 1.0 + excess2;
    const double u2_m_s = states.driven.soundSpeed_m_s / gamma * excess2 // eq 3.4
        * std::sqrt(2.0 * gamma / (gamma + 1.0) / (ratio2 + (gamma - 1.0) / (gamma + 1.0)));
    states.shocked = stateBehind(gas, states.driven, ratio2, u2_m_s);

    const double ratio5 // p5/p2, eq 3.5
        = ((3.0 * gamma - 1.0) * ratio2 - (gamma - 1.0)) / ((gamma - 1.0) * ratio2 + gamma + 1.0);
    states.reflected = stateBehind(gas, states.shocked, ratio5, 0.0);

    // Eq 3.8 divided by rho2, with rho5/rho2 - 1 written out of eqs 3.5 and 3.7.
    const double excess5 = 2.0 * gamma * excess2 / ((gamma - 1.0) * ratio2 + gamma + 1.0);
    const double g = (gamma + 1.0) / (gamma - 1.0);
    const double densityExcess5 = (g - 1.0) * excess5 / (g + ratio5);
    states.reflectedVelocity_m_s = u2_m_s / densityExcess5;
    states.reflectedMach
        = (states.reflectedVelocity_m_s + u2_m_s) / states.shocked.soundSpeed_m_s; // eq 3.9
    return states;
}

double plateauTime_s(const ShockStates &states, double drivenLength_m)
{
    const double arrival_s = drivenLength_m / states.velocity_m_s;
    const double contactToWall_m = drivenLength_m - states.shocked.velocity_m_s * arrival_s;
    const double meeting_s
        = contactToWall_m / (states.reflectedVelocity_m_s + states.shocked.velocity_m_s);
    return meeting_s + states.reflectedVelocity_m_s * meeting_s / states.reflected.soundSpeed_m_s;
}

Result<double> driverPressure_Pa(
    const ShockStates &states, const Gas &driven, const Gas &driver, double T4_K)
{
    if (auto checked = checkGas(driver); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = checkTemperature("T4", T4_K); !checked)
        return tl::unexpected(checked.error());
    const double ratio2 = states.shocked.pressure_Pa / states.driven.pressure_Pa;
    const double soundRatio = states.driven.soundSpeed_m_s / soundSpeed_m_s(driver, T4_K);
    const double root = std::sqrt(
        2.0 * driven.gamma * (2.0 * driven.gamma + (driven.gamma + 1.0) * (ratio2 - 1.0)));
    const double bracket = 1.0 - (driver.gamma - 1.0) * soundRatio * (ratio2 - 1.0) / root;
    if (!(bracket > 0.0))
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "No driver pressure can produce a shock of Mach %1 with this driver gas at %2 K; check the velocity, T4 and the driver gas."),
                {numberText(states.mach, 4), numberText(T4_K, 5)}});
    return states.shocked.pressure_Pa
        * std::pow(bracket, -2.0 * driver.gamma / (driver.gamma - 1.0)); // eq 3.10
}

Result<double> machOfPressureRatio(const Gas &gas, double ratio)
{
    if (auto checked = checkGas(gas); !checked)
        return tl::unexpected(checked.error());
    if (!(ratio > 1.0 && std::isfinite(ratio)))
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "The pressure ratio p2/p1 is %1; a shock needs more than 1: check both pressures and whether they are absolute."),
                {numberText(ratio, 5)}},
            "SHK-001");
    return std::sqrt(1.0 + (gas.gamma + 1.0) / (2.0 * gas.gamma) * (ratio - 1.0));
}

Result<double> velocityOfDriverPressure_m_s(
    const Gas &driven, double p1_Pa, double T1_K, const Gas &driver, double p4_Pa, double T4_K)
{
    if (!(p4_Pa > p1_Pa && std::isfinite(p4_Pa)))
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "The driver pressure p4 = %1 Pa does not exceed p1 = %2 Pa; both are absolute here: add the ambient pressure to a gauge reading."),
                {numberText(p4_Pa, 6), numberText(p1_Pa, 6)}});
    const double a1_m_s = soundSpeed_m_s(driven, T1_K);
    // p4 grows from p1 at M = 1 without limit; a velocity that no p4 can make is too fast as well.
    double low_m_s = a1_m_s, high_m_s = a1_m_s;
    const auto tooFast = [&](double velocity_m_s) -> Result<bool> {
        const auto states = shockStates(driven, p1_Pa, T1_K, velocity_m_s);
        if (!states)
            return tl::unexpected(states.error());
        const auto needed_Pa = driverPressure_Pa(*states, driven, driver, T4_K);
        if (!needed_Pa
            && (needed_Pa.error().kind == ErrorKind::Usage || !needed_Pa.error().findingId.empty()))
            return tl::unexpected(needed_Pa.error());
        return !needed_Pa || *needed_Pa > p4_Pa;
    };
    for (;;) {
        high_m_s *= 2.0;
        const auto passed = tooFast(high_m_s);
        if (!passed)
            return tl::unexpected(passed.error());
        if (*passed)
            break;
        low_m_s = high_m_s;
    }
    for (;;) {
        const double middle_m_s = 0.5 * (low_m_s + high_m_s);
        if (middle_m_s <= low_m_s || middle_m_s >= high_m_s)
            return middle_m_s;
        const auto passed = tooFast(middle_m_s);
        if (!passed)
            return tl::unexpected(passed.error());
        (*passed ? high_m_s : low_m_s) = middle_m_s;
    }
}

GasState expandedDriver(const ShockStates &states, const Gas &driver, double p4_Pa, double T4_K)
{
    const double p3_Pa = states.shocked.pressure_Pa;
    const double T3_K = T4_K * std::pow(p3_Pa / p4_Pa, (driver.gamma - 1.0) / driver.gamma);
    GasState state = gasAtRest(driver, p3_Pa, T3_K);
    state.velocity_m_s = states.shocked.velocity_m_s;
    return state;
}

} // namespace dyncal
