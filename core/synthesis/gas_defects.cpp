// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/gas_defects.h"

#include "core/base/portable_random.h"
#include "core/shock/moist_air.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/recorded_conditions.h"

#include <array>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kTubeMode_Hz = 6.8e3; ///< thesis, chapter 5
constexpr double kTubeModeSoundSpeed_m_s = 444.4; ///< its High shot
constexpr double kTubeModeAmplitude = 0.03;
constexpr Index kTubeModeStream = 4; ///< after those of scene and channels
constexpr Gas kNitrogen{1.4, 0.028014};
constexpr double kWaterCp_J_molK = 33.59; ///< vapour at 298 K (NIST-JANAF)
constexpr double kWaterMolarMass_kg_mol = 0.018015;
constexpr Gas kWaterVapour{
    kWaterCp_J_molK / (kWaterCp_J_molK - kGasConstant_J_molK), kWaterMolarMass_kg_mol};
/// Vapour pressure comes from the C library's exp(); rounded, it is the same on every machine.
constexpr double kFractionStep = 1e-9;

struct Component
{
    Gas gas;
    double fraction; ///< of the moles
};

/// Molar heat capacities and masses of ideal gases add up by mole fraction.
Gas mixtureOf(const std::array<Component, 3> &components)
{
    double cp_R = 0.0;
    double molarMass_kg_mol = 0.0;
    for (const Component &component : components) {
        cp_R += component.fraction * component.gas.gamma / (component.gas.gamma - 1.0);
        molarMass_kg_mol += component.fraction * component.gas.molarMass_kg_mol;
    }
    return {cp_R / (cp_R - 1.0), molarMass_kg_mol};
}

} // namespace

Gas drivenGasOf(const SimulationSettings &settings, Index shot, double p1_Pa, double T1_K)
{
    const double nitrogen = defectSize(settings, DefectKind::OtherGas, shot, 0.0);
    const double humidity = defectSize(settings, DefectKind::Humidity, shot, 0.0);
    if (nitrogen == 0.0 && humidity == 0.0)
        return RecordedConditions::gas;
    const double water
        = kFractionStep * std::round(waterFraction(p1_Pa, T1_K, humidity) / kFractionStep);
    const double dry = 1.0 - water;
    return mixtureOf({{{RecordedConditions::gas, dry * (1.0 - nitrogen)},
        {kNitrogen, dry * nitrogen}, {kWaterVapour, water}}});
}

TubeModeOfShot drawTubeMode(std::uint64_t seed, Index shot, double a5_m_s)
{
    RandomStream random(seed, shot, kTubeModeStream);
    TubeModeOfShot mode;
    mode.oscillation.frequency_Hz = kTubeMode_Hz * a5_m_s / kTubeModeSoundSpeed_m_s;
    mode.oscillation.zeta = 0.005 + 0.015 * random.nextUniform();
    mode.oscillation.phase_rad = std::numbers::pi * (2.0 * random.nextUniform() - 1.0);
    mode.amplitude = kTubeModeAmplitude * (0.7 + 0.6 * random.nextUniform());
    return mode;
}

double travelTime_s(double velocity_m_s, double attenuation_per_m, double distance_m)
{
    // The series of ln(1 + y)/y: no difference of nearly equal numbers, and no library function.
    constexpr int kTerms = 20;
    const double y = attenuation_per_m * distance_m;
    double sum = 0.0;
    for (int n = kTerms; n >= 1; --n)
        sum = 1.0 / n - y * sum;
    return distance_m / velocity_m_s * sum;
}

} // namespace dyncal
