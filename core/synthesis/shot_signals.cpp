// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_signals.h"

#include "core/synthesis/laboratory.h"

namespace dyncal {
namespace {

using Recorded = RecordedConditions;

constexpr double kDisturbance = -0.15; ///< of the step, when the contact surface's wave is back
constexpr double kDisturbanceTime_s = 0.3e-3;
constexpr double kDriverFall_s = 1.5e-3;
constexpr double kSideNoise_Pa = 150.0;
constexpr double kDriverNoise_Pa = 300.0;

SignalPlan dutSignal(const ShotPlan &plan)
{
    SignalPlan signal{plan.dut, 0.0, {}, plan.driftPerSecond_V, plan.noise_V, plan.noise};
    if (!plan.burst)
        return signal;
    const double step_Pa = plan.scene.step_Pa();
    signal.events = {{plan.scene.wallArrival_s, step_Pa, 0.0, {}, plan.front},
        {plan.scene.wallArrival_s + plan.scene.plateau_s, kDisturbance * step_Pa,
            kDisturbanceTime_s}};
    if (plan.tubeMode)
        signal.events.push_back({plan.scene.wallArrival_s, plan.tubeMode->amplitude * step_Pa, 0.0,
            plan.tubeMode->oscillation});
    if (plan.echo)
        signal.events.push_back({plan.scene.wallArrival_s + plan.echo->delay_s,
            plan.echo->share * step_Pa, 0.0, {}, plan.front});
    return signal;
}

SignalPlan sideSignal(const ShotPlan &plan)
{
    const SensorSpec &sensor = sideSensor();
    SignalPlan signal{sensor, 0.0, {}, 0.0, kSideNoise_Pa * sensor.sensitivity_V_Pa};
    if (!plan.burst)
        return signal;
    const ShotScene &scene = plan.scene;
    const ShockStates &states = scene.states;
    const double disturbance_s = scene.wallArrival_s + scene.plateau_s
        + scene.distance_m / states.reflected.soundSpeed_m_s;
    const double p2_Pa = scene.pressureBehindShockAtSide_Pa;
    signal.events = {
        {scene.sideArrival_s + plan.sideDelay_s, p2_Pa - states.driven.pressure_Pa, 0.0},
        {scene.reflectionAtSide_s + plan.sideDelay_s, states.reflected.pressure_Pa - p2_Pa, 0.0},
        {disturbance_s + plan.sideDelay_s, kDisturbance * scene.step_Pa(), kDisturbanceTime_s}};
    return signal;
}

SignalPlan driverSignal(const ShotPlan &plan)
{
    const SensorSpec &sensor = driverSensor();
    const ShotScene &scene = plan.scene;
    SignalPlan signal{sensor, scene.driverPressure_Pa - scene.states.driven.pressure_Pa, {}, 0.0,
        kDriverNoise_Pa * sensor.sensitivity_V_Pa};
    if (!plan.burst)
        return signal;
    // The sensor sits half way along the driver section.
    const double fan_s = scene.burst_s
        + 0.5 * Recorded::driverLength_m / soundSpeed_m_s(Recorded::gas, Recorded::T4_K);
    signal.events
        = {{fan_s, scene.states.shocked.pressure_Pa - scene.driverPressure_Pa, kDriverFall_s}};
    return signal;
}

} // namespace

std::array<SignalPlan, 3> signalsOf(const ShotPlan &plan)
{
    return {dutSignal(plan), sideSignal(plan), driverSignal(plan)};
}

} // namespace dyncal
