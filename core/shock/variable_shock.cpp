// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/variable_shock.h"

#include "core/base/number_text.h"

#include <cmath>

namespace dyncal {
namespace {

/// Root of f in [low, high], f(low) and f(high) of different sign: bisection to the last bit (the
/// functions are smooth, but near M = 1 so flat that faster methods gain nothing).
template <typename Function>
double rootBetween(double low, double high, Function f)
{
    const bool rising = f(high) > 0.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high)
            break;
        ((f(middle) > 0.0) == rising ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

/// The gas behind a shock that moves with `speed` relative to the gas ahead.
struct Behind
{
    double pressureRatio = 1.0;
    double temperature_K = 0.0;
    double densityRatio = 1.0;
};

class VariableGas
{
public:
    VariableGas(const HeatCapacity &heatCapacity, double molarMass_kg_mol)
        : m_heatCapacity(heatCapacity)
        , m_R_J_kgK(kGasConstant_J_molK / molarMass_kg_mol)
    {
    }

    double R_J_kgK() const { return m_R_J_kgK; }

    /// Excess of enthalpy over what the shock's energy balance allows, for one ratio of densities
    /// ahead over behind: 0 at the solution.
    double energyDefect(double T_K, double speed_m_s, double ratio) const
    {
        const Behind behind = across(T_K, speed_m_s, ratio);
        const double gained = m_R_J_kgK
            * (enthalpyOverR_K(m_heatCapacity, behind.temperature_K)
                - enthalpyOverR_K(m_heatCapacity, T_K));
        return gained - 0.5 * speed_m_s * speed_m_s * (1.0 - ratio) * (1.0 + ratio);
    }

    /// The state that conserves mass and momentum; `energyDefect` is left.
    Behind across(double T_K, double speed_m_s, double ratio) const
    {
        const double p = 1.0 + speed_m_s * speed_m_s / (m_R_J_kgK * T_K) * (1.0 - ratio);
        return {p, T_K * p * ratio, 1.0 / ratio};
    }

    GasState state(double pressure_Pa, double T_K, double velocity_m_s) const
    {
        return {pressure_Pa, T_K, pressure_Pa / (m_R_J_kgK * T_K),
            std::sqrt(gammaAt(m_heatCapacity, T_K) * m_R_J_kgK * T_K), velocity_m_s};
    }

    const HeatCapacity &heatCapacity() const { return m_heatCapacity; }

private:
    const HeatCapacity &m_heatCapacity;
    double m_R_J_kgK;
};

/// Strictly between the strongest compression and the trivial solution 1: the defect is positive
/// just below 1 for M > 1 and negative at the other end.
constexpr double kDensest = 1e-3;

double incidentRatio(const VariableGas &gas, double T1_K, double velocity_m_s, double start)
{
    // Start: the solution for constant gamma; the root lies within a factor of two of its excess.
    const double high = 1.0 - 0.5 * (1.0 - start);
    return rootBetween(
        kDensest, high, [&](double ratio) { return gas.energyDefect(T1_K, velocity_m_s, ratio); });
}

double reflectedRatio(const VariableGas &gas, const GasState &shocked, double start)
{
    const double high = 1.0 - 0.5 * (1.0 - start);
    return rootBetween(kDensest, high, [&](double ratio) {
        return gas.energyDefect(shocked.temperature_K, shocked.velocity_m_s / (1.0 - ratio), ratio);
    });
}

Error outsideValidity(double T_K)
{
    return {ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "The gas reaches %1 K, and the variable heat capacity holds from %2 K to %3 K; choose a constant one or another gas."),
            {numberText(T_K, 5), numberText(kLowestHeatCapacity_K),
                numberText(kHighestHeatCapacity_K)}},
        "SHK-009"};
}

} // namespace

Result<ShockStates> shockStatesOf(
    const GasModel &gas, double p1_Pa, double T1_K, double velocity_m_s)
{
    auto start = shockStates(gas.constants, p1_Pa, T1_K, velocity_m_s);
    if (!start || !gas.heatCapacity)
        return start;
    const VariableGas variable(*gas.heatCapacity, gas.constants.molarMass_kg_mol);
    ShockStates states;
    states.velocity_m_s = velocity_m_s;
    states.driven = variable.state(p1_Pa, T1_K, 0.0);
    states.mach = velocity_m_s / states.driven.soundSpeed_m_s;

    const double ratio2 = incidentRatio(
        variable, T1_K, velocity_m_s, start->driven.density_kg_m3 / start->shocked.density_kg_m3);
    const Behind second = variable.across(T1_K, velocity_m_s, ratio2);
    states.shocked = variable.state(
        p1_Pa * second.pressureRatio, second.temperature_K, velocity_m_s * (1.0 - ratio2));

    const double ratio5 = reflectedRatio(
        variable, states.shocked, start->shocked.density_kg_m3 / start->reflected.density_kg_m3);
    const double speed_m_s = states.shocked.velocity_m_s / (1.0 - ratio5);
    const Behind fifth = variable.across(states.shocked.temperature_K, speed_m_s, ratio5);
    states.reflected = variable.state(
        states.shocked.pressure_Pa * fifth.pressureRatio, fifth.temperature_K, 0.0);
    states.reflectedVelocity_m_s = speed_m_s - states.shocked.velocity_m_s;
    states.reflectedMach = speed_m_s / states.shocked.soundSpeed_m_s;
    if (states.reflected.temperature_K > kHighestHeatCapacity_K)
        return tl::unexpected(outsideValidity(states.reflected.temperature_K));
    return states;
}

Result<double> velocityOfShockedPressure_m_s(
    const GasModel &gas, double p1_Pa, double T1_K, double p2_Pa)
{
    const auto mach = machOfPressureRatio(gas.constants, p2_Pa / p1_Pa);
    if (!mach)
        return tl::unexpected(mach.error());
    const double soundSpeed = soundSpeed_m_s(gas.constants, T1_K);
    double excess = (*mach - 1.0) * (*mach + 1.0); // M^2 - 1; p2 - p1 is nearly proportional
    for (int i = 0; gas.heatCapacity && i < 100; ++i) {
        const auto states = shockStatesOf(gas, p1_Pa, T1_K, soundSpeed * std::sqrt(1.0 + excess));
        if (!states)
            return tl::unexpected(states.error());
        const double factor = (p2_Pa - p1_Pa) / (states->shocked.pressure_Pa - p1_Pa);
        excess *= factor;
        if (std::abs(factor - 1.0) < 1e-15)
            break;
    }
    return soundSpeed * std::sqrt(1.0 + excess);
}

} // namespace dyncal
