// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_generator.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/synthesis/channel_recorder.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/laboratory.h"
#include "core/synthesis/shot_scene.h"
#include "core/synthesis/simulation_checks.h"
#include "core/synthesis/step_response.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {
namespace {

using Recorded = RecordedConditions;

constexpr double kPreTrigger = 0.1; ///< of the record
constexpr double kShortTail_s = 0.4e-3; ///< length of a short record after the step
constexpr double kInvalidDelay_s = 50e-6; ///< after the step
constexpr double kDisturbance = -0.15; ///< of the step, when the contact surface's wave is back
constexpr double kDisturbanceTime_s = 0.3e-3;
constexpr double kDriverFall_s = 1.5e-3;
constexpr double kSideNoise_Pa = 150.0;
constexpr double kDriverNoise_Pa = 300.0;
constexpr double kNoiseHeadroom = 5.0; ///< standard deviations
constexpr double kHeadroom = 1.02;
constexpr double kClippedOvershoot = 0.5; ///< part of the overshoot that a clipped record keeps
constexpr double kClippedStep = 0.9; ///< where there is hardly any overshoot
constexpr double kOvershootToSpeakOf = 0.02;

/// All that is needed to record one shot.
struct ShotPlan
{
    Index number = 0; ///< from 1
    ShotLevel level = ShotLevel::None;
    ShotScene scene;
    SensorSpec dut;
    RecordAxis axis;
    double noise_V = 0.0;
    double driftPerSecond_V = 0.0;
    double overshoot = 0.0; ///< of the DUT's step response, relative
    bool burst = true;
    std::optional<TubeModeOfShot> tubeMode;

    double plateau_V() const { return std::abs(dut.sensitivity_V_Pa) * scene.step_Pa(); }
};

/// Largest value of the unit step response over many periods, minus 1.
double overshootOf(const SensorSpec &sensor)
{
    constexpr double kSamplesPerPeriod = 32.0;
    double fastest_Hz = 0.0;
    for (const SensorMode &mode : sensor.modes)
        fastest_Hz = std::max(fastest_Hz, mode.f0_Hz);
    std::vector<double> values(1 << 16, 0.0);
    StepResponse(sensor).addTo(values, 0.0, kSamplesPerPeriod * fastest_Hz, 1.0);
    return *std::max_element(values.begin(), values.end()) - 1.0;
}

RecordAxis axisOf(const SimulationSettings &settings, const ShotScene &scene, Index shot)
{
    const bool half = hasDefect(settings, DefectKind::Fs50, shot);
    RecordAxis axis;
    axis.sampleRate_Hz = half ? 0.5 * settings.sampleRate_Hz : settings.sampleRate_Hz;
    axis.count = static_cast<Index>(std::llround(settings.duration_s * axis.sampleRate_Hz));
    axis.t0_s = -std::round(kPreTrigger * static_cast<double>(axis.count)) / axis.sampleRate_Hz;
    if (hasDefect(settings, DefectKind::Short, shot)) {
        const double kept_s = scene.wallArrival_s + kShortTail_s - axis.t0_s;
        axis.count
            = std::min(axis.count, static_cast<Index>(std::ceil(kept_s * axis.sampleRate_Hz)));
    }
    return axis;
}

ShotPlan planShot(const SimulationSettings &settings, const ShotScene &scene, Index shot)
{
    ShotPlan plan;
    plan.number = shot;
    plan.level = settings.shots[static_cast<std::size_t>(shot - 1)];
    plan.scene = scene;
    plan.dut = hasDefect(settings, DefectKind::RingVar, shot) ? looselyMounted(settings.sensor)
                                                              : settings.sensor;
    plan.axis = axisOf(settings, scene, shot);
    plan.noise_V = settings.noise * plan.plateau_V();
    if (hasDefect(settings, DefectKind::Drift, shot))
        plan.driftPerSecond_V = kDriftPerSecond * plan.dut.sensitivity_V_Pa * scene.step_Pa();
    plan.overshoot = overshootOf(plan.dut);
    plan.burst = !hasDefect(settings, DefectKind::NoStep, shot);
    if (plan.burst && hasDefect(settings, DefectKind::TubeMode, shot))
        plan.tubeMode = drawTubeMode(settings.seed, shot, scene.states.reflected.soundSpeed_m_s);
    return plan;
}

/// Largest magnitude at the DUT's converter in one shot.
double needed_V(const ShotPlan &plan)
{
    const double drift_V = std::abs(plan.driftPerSecond_V);
    const double untilStep_s = plan.scene.wallArrival_s - plan.axis.t0_s;
    const double duration_s = static_cast<double>(plan.axis.count) / plan.axis.sampleRate_Hz;
    const double early_V = (1.0 + plan.overshoot) * plan.plateau_V() + drift_V * untilStep_s;
    const double late_V = plan.plateau_V() + drift_V * duration_s;
    // The mode starts with a jump, which rings like the step.
    const double mode = plan.tubeMode ? 2.0 * plan.tubeMode->amplitude : 0.0;
    return kHeadroom * (1.0 + mode) * std::max(early_V, late_V) + kNoiseHeadroom * plan.noise_V;
}

/// The smallest range of the 1-2-5 series that fits all shots, as an operator would choose it.
double commonRange_V(const std::vector<ShotPlan> &plans)
{
    double most_V = 0.0;
    for (const ShotPlan &plan : plans)
        most_V = std::max(most_V, needed_V(plan));
    constexpr std::array<double, 11> kDecades_V{
        1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
    for (const double decade_V : kDecades_V) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * decade_V >= most_V)
                return factor * decade_V;
        }
    }
    return most_V; // beyond what checkSensor lets through
}

double clippedRange_V(const ShotPlan &plan)
{
    return plan.plateau_V()
        * (plan.overshoot > kOvershootToSpeakOf ? 1.0 + kClippedOvershoot * plan.overshoot
                                                : kClippedStep);
}

SignalPlan dutSignal(const ShotPlan &plan)
{
    SignalPlan signal{plan.dut, 0.0, {}, plan.driftPerSecond_V, plan.noise_V};
    if (!plan.burst)
        return signal;
    const double step_Pa = plan.scene.step_Pa();
    signal.events = {{plan.scene.wallArrival_s, step_Pa, 0.0},
        {plan.scene.wallArrival_s + plan.scene.plateau_s, kDisturbance * step_Pa,
            kDisturbanceTime_s}};
    if (plan.tubeMode)
        signal.events.push_back({plan.scene.wallArrival_s, plan.tubeMode->amplitude * step_Pa, 0.0,
            plan.tubeMode->oscillation});
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
    signal.events = {
        {scene.sideArrival_s, states.shocked.pressure_Pa - states.driven.pressure_Pa, 0.0},
        {scene.reflectionAtSide_s, states.reflected.pressure_Pa - states.shocked.pressure_Pa, 0.0},
        {disturbance_s, kDisturbance * scene.step_Pa(), kDisturbanceTime_s}};
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

/// The three channels of a shot, in order; the DUT in volts, the others in pascal.
Result<std::vector<Channel>> recordChannels(const ShotPlan &plan, std::uint64_t seed,
    const Digitizer &dutDigitizer, int bits, const JobControl &control)
{
    const std::array<SignalPlan, 3> signals{dutSignal(plan), sideSignal(plan), driverSignal(plan)};
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        const JobControl part{control.stop,
            [&](double fraction) { control.report((static_cast<double>(i) + fraction) / 3.0); }};
        auto channel = recordChannel(signals[i], plan.axis,
            i == 0 ? dutDigitizer : Digitizer{bits, kPressureRange_V},
            RandomStream(seed, plan.number, static_cast<Index>(i) + 1), part);
        if (!channel)
            return tl::unexpected(channel.error());
        labelChannel(*channel, i, signals[i].sensor);
        channels.push_back(std::move(*channel));
    }
    return channels;
}

ShotTruth truthOf(const ShotPlan &plan, const Digitizer &digitizer)
{
    ShotTruth truth{{"f0_Hz", plan.dut.modes.front().f0_Hz}, {"zeta", plan.dut.modes.front().zeta},
        {"sensitivity", plan.dut.sensitivity_V_Pa}, {"noise_sd_V", plan.noise_V},
        {"input_range_V", digitizer.range_V}, {"p1_Pa", plan.scene.states.driven.pressure_Pa},
        {"T1_K", plan.scene.states.driven.temperature_K}, {"p4_Pa", plan.scene.driverPressure_Pa},
        {"distance_m", plan.scene.distance_m}, {"step_Pa", 0.0}};
    if (plan.dut.realPole_Hz)
        truth["real_pole_Hz"] = *plan.dut.realPole_Hz;
    if (!plan.burst)
        return truth;
    const ShotTruth shock{{"arrival_s", plan.scene.wallArrival_s},
        {"side_arrival_s", plan.scene.sideArrival_s}, {"plateau_s", plan.scene.plateau_s},
        {"velocity_m_s", plan.scene.states.velocity_m_s}, {"mach", plan.scene.states.mach},
        {"p2_Pa", plan.scene.states.shocked.pressure_Pa},
        {"p5_Pa", plan.scene.states.reflected.pressure_Pa},
        {"a5_m_s", plan.scene.states.reflected.soundSpeed_m_s}};
    truth.insert(shock.begin(), shock.end());
    if (plan.tubeMode) {
        truth["tube_mode_Hz"] = plan.tubeMode->oscillation.frequency_Hz;
        truth["tube_mode_zeta"] = plan.tubeMode->oscillation.zeta;
        truth["tube_mode_phase_rad"] = plan.tubeMode->oscillation.phase_rad;
        truth["tube_mode_amplitude"] = plan.tubeMode->amplitude;
    }
    truth["step_Pa"] = plan.scene.step_Pa();
    return truth;
}

Result<Shot> recordShot(const SimulationSettings &settings, const ShotPlan &plan,
    const Digitizer &dutDigitizer, const JobControl &control)
{
    auto channels = recordChannels(plan, settings.seed, dutDigitizer, settings.bits, control);
    if (!channels)
        return tl::unexpected(channels.error());
    Shot shot;
    shot.level = plan.level;
    shot.label = levelLabel(plan.level);
    shot.environment = recordedEnvironment(plan.scene.driverPressure_Pa);
    shot.channels = std::move(*channels);
    if (hasDefect(settings, DefectKind::Psi, plan.number))
        mislabelAsBar(shot.channels[0], plan.dut.sensitivity_V_Pa);
    if (hasDefect(settings, DefectKind::Nan, plan.number))
        spoilWithInvalidSamples(shot.channels[0], plan.scene.wallArrival_s + kInvalidDelay_s);
    if (hasDefect(settings, DefectKind::Swap, plan.number))
        swapRoles(shot);
    for (Channel &channel : shot.channels)
        channel.sha256 = sha256OfSamples(channel.samples);
    return shot;
}

} // namespace

Result<SimulatedCapture> simulateShots(
    const SimulationSettings &settings, const JobControl &control)
{
    if (auto checked = checkSimulation(settings); !checked)
        return tl::unexpected(checked.error());
    const auto scenes = drawScenes(settings);
    if (!scenes)
        return tl::unexpected(scenes.error());
    std::vector<ShotPlan> plans;
    for (std::size_t i = 0; i < scenes->size(); ++i)
        plans.push_back(planShot(settings, (*scenes)[i], static_cast<Index>(i) + 1));

    const double range_V = commonRange_V(plans);
    SimulatedCapture capture{laboratorySet(settings), {}};
    for (const ShotPlan &plan : plans) {
        const bool clip = hasDefect(settings, DefectKind::Clip, plan.number);
        const Digitizer digitizer{settings.bits, clip ? clippedRange_V(plan) : range_V};
        const double done = static_cast<double>(plan.number - 1);
        const double all = static_cast<double>(plans.size());
        const JobControl part{
            control.stop, [&](double fraction) { control.report((done + fraction) / all); }};
        auto shot = recordShot(settings, plan, digitizer, part);
        if (!shot)
            return tl::unexpected(shot.error());
        capture.set.shots.push_back(std::move(*shot));
        capture.truth.push_back(truthOf(plan, digitizer));
    }
    return capture;
}

} // namespace dyncal
