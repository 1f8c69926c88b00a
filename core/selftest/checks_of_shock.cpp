// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_shock.h"

#include "core/base/constants.h"
#include "core/pipeline/shock_stage.h"
#include "core/selftest/known_records.h"
#include "core/shock/moist_air.h"
#include "core/shock/tube_waves.h"
#include "core/shock/variable_shock.h"
#include "core/shock/velocity_fit.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr double kShockP1_Pa = 1e5;
constexpr double kShockT1_K = 300.0;
constexpr Gas kDiatomic{1.4, 0.028966};
constexpr Gas kThesisAir{1.402, 0.028966};

/// sqrt(gamma R T / M), written out: the fractions below are relative to it.
double soundSpeedAtRest_m_s()
{
    return std::sqrt(1.4 * 8.314462618 * kShockT1_K / 0.028966);
}

std::optional<ShockStates> shockAtMach2(DataChange &change)
{
    const auto states = shockStates(
        kDiatomic, change(kShockP1_Pa), change(kShockT1_K), change(2.0 * soundSpeedAtRest_m_s()));
    return states ? std::optional(*states) : std::nullopt;
}

std::optional<ShockStates> thesisShock(DataChange &change)
{
    const auto states = shockStates(kThesisAir, change(101100.0), change(294.15), change(512.82));
    return states ? std::optional(*states) : std::nullopt;
}

double densityRatio(DataChange &change)
{
    const auto states = shockAtMach2(change);
    return states ? states->shocked.density_kg_m3 / states->driven.density_kg_m3 : kUnknown;
}

double reflectedPressureRatio(DataChange &change)
{
    const auto states = shockAtMach2(change);
    return states ? states->reflected.pressure_Pa / kShockP1_Pa : kUnknown;
}

double reflectedTemperatureRatio(DataChange &change)
{
    const auto states = shockAtMach2(change);
    return states ? states->reflected.temperature_K / kShockT1_K : kUnknown;
}

double reflectedMachNumber(DataChange &change)
{
    const auto states = shockAtMach2(change);
    return states ? states->reflectedMach : kUnknown;
}

double driverPressureRatio(DataChange &change)
{
    const auto states = shockAtMach2(change);
    if (!states)
        return kUnknown;
    const auto p4_Pa = driverPressure_Pa(*states, kDiatomic, kDiatomic, change(kShockT1_K));
    return p4_Pa ? *p4_Pa / kShockP1_Pa : kUnknown;
}

double machOfFourAndAHalf(DataChange &change)
{
    return machOfPressureRatio(kDiatomic, change(4.5)).value_or(kUnknown);
}

/// With a heat capacity that does not change the solution of the conservation laws is the same.
double ratioByConservation(DataChange &change)
{
    GasModel gas;
    gas.constants = kDiatomic;
    gas.heatCapacity = HeatCapacity{};
    const auto states = shockStatesOf(
        gas, change(kShockP1_Pa), change(kShockT1_K), change(2.0 * soundSpeedAtRest_m_s()));
    return states ? states->reflected.pressure_Pa / kShockP1_Pa : kUnknown;
}

double thesisReflectedPressure_Pa(DataChange &change)
{
    const auto states = thesisShock(change);
    return states ? states->reflected.pressure_Pa : kUnknown;
}

double thesisReflectedTemperature_K(DataChange &change)
{
    const auto states = thesisShock(change);
    return states ? states->reflected.temperature_K : kUnknown;
}

double thesisDriverPressure_Pa(DataChange &change)
{
    const auto states = thesisShock(change);
    return states
        ? driverPressure_Pa(*states, kThesisAir, kThesisAir, change(295.35)).value_or(kUnknown)
        : kUnknown;
}

double thesisPlateau_s(DataChange &change)
{
    const auto states = thesisShock(change);
    return states ? plateauTime_s(*states, change(0.97)) : kUnknown;
}

/// The driver's rarefaction at the end wall, its driver 0.2 m long.
double thesisRarefaction_s(DataChange &change)
{
    const auto states = thesisShock(change);
    if (!states)
        return kUnknown;
    TubeGeometry geometry{change(0.97), change(0.2),
        gasAtRest(kThesisAir, change(684846.955), change(295.35)), kThesisAir};
    const TubeWaves waves = tubeWaves(*states, geometry);
    return waves.plateauEnd == PlateauEnd::DriverRarefaction ? waves.plateau_s : kUnknown;
}

double soundSpeedOfMoistAir_m_s(DataChange &change)
{
    const auto air = moistAir(change(101100.0), change(294.15), change(0.5), change(4e-4));
    return air ? air->soundSpeed_m_s : kUnknown;
}

/// Three sensors that a shock of 500 m/s passes.
double fittedVelocity_m_s(DataChange &change)
{
    std::vector<Sighting> sightings;
    for (const double distance_m : {0.8, 0.4, 0.1})
        sightings.push_back({.channel = "side",
            .distance_m = change(distance_m),
            .u_distance_m = change(2e-4),
            .time_s = change((1.0 - distance_m) / 500.0),
            .u_time_s = change(1e-7)});
    const auto fit = fitVelocity(sightings, Attenuation::None);
    return fit ? fit->velocity_m_s : kUnknown;
}

/// The recipe of a shock at M = 2 into that gas.
Recipe recipeAtRest(DataChange &change)
{
    Recipe recipe;
    recipe.shock.p1_Pa = change(kShockP1_Pa);
    recipe.shock.T1_K = change(kShockT1_K);
    recipe.shock.drivenGas = {1.4, 0.028966, "custom", kConstantHeatCapacity};
    recipe.shock.attenuation = "none";
    recipe.shock.useDutArrival = false;
    return recipe;
}

ShockConditions expectedConditions(const CaptureSet &set, const Recipe &recipe)
{
    const auto starts = detectStarts(set, arrivalChannels(recipe.shock));
    if (!starts)
        return {};
    const auto expected = expectedShock(set, *starts, recipe);
    if (!expected || expected->conditions.shots.empty())
        return {};
    return expected->conditions.shots.front();
}

double expectedStepRatio(DataChange &change)
{
    Recipe recipe = recipeAtRest(change);
    recipe.shock.velocity_m_s = PerShot(change(2.0 * soundSpeedAtRest_m_s()));
    return expectedConditions(shockRecords(), recipe).step_Pa.value_or(kUnknown) / kShockP1_Pa;
}

/// From the records of two sensors 0.4 m apart, 1 ms after each other.
double expectedVelocity_m_s(DataChange &change)
{
    Recipe recipe = recipeAtRest(change);
    for (const auto &[channel, distance_m] : {std::pair("far", 0.8), std::pair("near", 0.4)}) {
        ArrivalSensor sensor{channel, change(distance_m), change(2e-4)};
        sensor.delay_s = 0.0;
        recipe.shock.arrivalSensors.push_back(sensor);
    }
    const ShockConditions shock = expectedConditions(shockRecords(), recipe);
    return shock.states ? shock.states->velocity_m_s : kUnknown;
}

std::vector<CheckSpec> fractionsAtMach2()
{
    const Message source{
        DYNCAL_TEXT("core", "Rankine-Hugoniot relations in exact fractions, M = 2, gamma = 7/5"),
        {}};
    return {{"shock", {DYNCAL_TEXT("core", "density ratio of the incident shock"), {}}, source,
                8.0 / 3.0, 1e-13, densityRatio},
        {"shock", {DYNCAL_TEXT("core", "pressure ratio p5/p1"), {}}, source, 15.0, 1e-12,
            reflectedPressureRatio},
        {"shock", {DYNCAL_TEXT("core", "temperature ratio T5/T1"), {}}, source, 2.5, 1e-13,
            reflectedTemperatureRatio},
        {"shock", {DYNCAL_TEXT("core", "Mach number of the reflected shock"), {}}, source,
            std::sqrt(3.0), 1e-13, reflectedMachNumber},
        {"shock", {DYNCAL_TEXT("core", "driver pressure p4/p1"), {}}, source,
            4.5 * std::pow(4.0 / 3.0, 7.0), 1e-11, driverPressureRatio},
        {"shock", {DYNCAL_TEXT("core", "Mach number from p2/p1 = 9/2"), {}}, source, 2.0, 1e-14,
            machOfFourAndAHalf},
        {"shock", {DYNCAL_TEXT("core", "p5/p1 by the conservation laws, cp(T) constant"), {}},
            source, 15.0, 1e-11, ratioByConservation},
        {"expected_shock", {DYNCAL_TEXT("core", "step over p1, velocity typed"), {}}, source, 14.0,
            1e-12, expectedStepRatio}};
}

std::vector<CheckSpec> publishedShockValues()
{
    const Message thesis{
        DYNCAL_TEXT("core", "table 4.2 of the thesis, recomputed to nine digits"), {}};
    return {{"shock", {DYNCAL_TEXT("core", "p5 of the thesis's shot, Pa"), {}}, thesis, 535676.931,
                1e-3, thesisReflectedPressure_Pa},
        {"shock", {DYNCAL_TEXT("core", "T5 of the thesis's shot, K"), {}}, thesis, 490.704689, 1e-6,
            thesisReflectedTemperature_K},
        {"shock", {DYNCAL_TEXT("core", "p4 of the thesis's shot, Pa"), {}}, thesis, 684846.955,
            1e-3, thesisDriverPressure_Pa},
        {"shock", {DYNCAL_TEXT("core", "plateau of the thesis's tube, s"), {}},
            {DYNCAL_TEXT("core", "x-t diagram of 0.97 m in closed form"), {}}, 1.626e-3, 5e-7,
            thesisPlateau_s},
        {"shock", {DYNCAL_TEXT("core", "plateau of that tube with a driver of 0.2 m, s"), {}},
            {DYNCAL_TEXT("core", "way through the fan, integrated, and an Euler solution"), {}},
            0.889e-3, 5e-7, thesisRarefaction_s},
        {"shock", {DYNCAL_TEXT("core", "speed of sound of moist air, m/s"), {}},
            {DYNCAL_TEXT("core", "Cramer 1993, 21 degC, 50 %, 101.1 kPa"), {}}, 344.6135, 5e-5,
            soundSpeedOfMoistAir_m_s}};
}

} // namespace

std::vector<CheckSpec> checksOfShock()
{
    const Message division{DYNCAL_TEXT("core", "distance over time"), {}};
    std::vector<CheckSpec> checks = fractionsAtMach2();
    for (CheckSpec &check : publishedShockValues())
        checks.push_back(std::move(check));
    checks.push_back({"shock", {DYNCAL_TEXT("core", "velocity fitted to three sensors, m/s"), {}},
        division, 500.0, 1e-9, fittedVelocity_m_s});
    checks.push_back({"expected_shock",
        {DYNCAL_TEXT("core", "velocity from the records of two sensors, m/s"), {}}, division, 400.0,
        1e-9, expectedVelocity_m_s});
    return checks;
}

} // namespace dyncal
