// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_scene.h"

#include "core/base/portable_random.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/gas_defects.h"

#include <cmath>

namespace dyncal {
namespace {

using Recorded = RecordedConditions;

constexpr double kVelocitySpread = 0.003; ///< relative, shot to shot
constexpr double kTriggerJitter_s = 20e-6; ///< half width
constexpr double kPressureSteps_Pa = 100.0; ///< resolution of the driver's gauge
constexpr Index kSceneStream = 0; ///< random stream of a shot that is not a channel's

double nominalVelocity_m_s(ShotLevel level)
{
    switch (level) {
    case ShotLevel::Low:
        return 430.0; // M 1.25
    case ShotLevel::Medium:
        return 471.4; // M 1.37
    default:
        return 512.8; // M 1.49, the thesis's High shot
    }
}

/// True values, which differ from the recorded ones by errors that are the same in all shots.
struct TrueConditions
{
    double distance_m;
    double T1_K;
    double p1_Pa;
};

TrueConditions drawConditions(std::uint64_t seed)
{
    RandomStream random(seed, 0, kSceneStream);
    const double distance_m = Recorded::distance_m + Recorded::u_distance_m * random.nextNormal();
    const double T1_K = Recorded::T1_K + Recorded::u_T1_K * random.nextNormal();
    const double p1_Pa = Recorded::p1_Pa + Recorded::u_p1_Pa * random.nextNormal();
    return {distance_m, T1_K, p1_Pa};
}

/// When shock and wave pass, from the moment at which the shock passes the side sensor.
void addTimes(ShotScene &scene, double sideArrival_s)
{
    const double velocity_m_s = scene.states.velocity_m_s;
    const double attenuation_per_m = scene.attenuation_per_m;
    scene.plateau_s = plateauTime_s(scene.states, Recorded::drivenLength_m);
    scene.sideArrival_s = sideArrival_s;
    scene.wallArrival_s
        = sideArrival_s + travelTime_s(velocity_m_s, attenuation_per_m, scene.distance_m);
    scene.reflectionAtSide_s
        = scene.wallArrival_s + scene.distance_m / scene.states.reflectedVelocity_m_s;
    scene.burst_s = scene.wallArrival_s
        - travelTime_s(velocity_m_s, attenuation_per_m, Recorded::drivenLength_m);
}

Result<ShotScene> drawScene(
    const TrueConditions &conditions, const SimulationSettings &settings, Index shot)
{
    RandomStream random(settings.seed, shot, kSceneStream);
    const ShotLevel level = settings.shots[static_cast<std::size_t>(shot - 1)];
    const double velocity_m_s
        = nominalVelocity_m_s(level) * (1.0 + kVelocitySpread * random.nextNormal());
    const double jitter_s = kTriggerJitter_s * (2.0 * random.nextUniform() - 1.0);
    ShotScene scene;
    scene.gas = drivenGasOf(settings, shot, conditions.p1_Pa, conditions.T1_K);
    scene.distance_m = conditions.distance_m;
    scene.attenuation_per_m = defectSize(settings, DefectKind::Attenuation, shot, 0.0);
    const auto states = shockStates(scene.gas, conditions.p1_Pa, conditions.T1_K, velocity_m_s);
    if (!states)
        return tl::unexpected(states.error());
    scene.states = *states;
    const double sideVelocity_m_s
        = velocity_m_s * (1.0 + scene.attenuation_per_m * scene.distance_m);
    const auto atSide = shockStates(scene.gas, conditions.p1_Pa, conditions.T1_K, sideVelocity_m_s);
    if (!atSide)
        return tl::unexpected(atSide.error());
    scene.pressureBehindShockAtSide_Pa = atSide->shocked.pressure_Pa;
    const auto p4_Pa = driverPressure_Pa(*states, scene.gas, Recorded::gas, Recorded::T4_K);
    if (!p4_Pa)
        return tl::unexpected(p4_Pa.error());
    // Rounding to steps also removes differences of the C library's pow() between machines.
    scene.driverPressure_Pa = kPressureSteps_Pa * std::round(*p4_Pa / kPressureSteps_Pa);
    addTimes(scene, jitter_s); // the side sensor triggers
    return scene;
}

} // namespace

Result<std::vector<ShotScene>> drawScenes(const SimulationSettings &settings)
{
    const TrueConditions conditions = drawConditions(settings.seed);
    std::vector<ShotScene> scenes;
    for (Index i = 0; i < std::ssize(settings.shots); ++i) {
        auto scene = drawScene(conditions, settings, i + 1);
        if (!scene)
            return tl::unexpected(scene.error());
        scenes.push_back(*scene);
    }
    return scenes;
}

} // namespace dyncal
