// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_plan.h"

#include "core/synthesis/defects.h"
#include "core/synthesis/laboratory.h"
#include "core/synthesis/sensor_defects.h"
#include "core/synthesis/step_response.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr double kPreTrigger = 0.1; ///< of the record
constexpr double kShortTail_s = 0.4e-3; ///< length of a short record after the step
constexpr double kDriftPerSecond = 20.0; ///< of the step: 2 % per millisecond
constexpr double kNoiseHeadroom = 5.0; ///< standard deviations
constexpr double kHeadroom = 1.02;
constexpr double kClippedOvershoot = 0.5; ///< part of the overshoot that a clipped record keeps
constexpr double kClippedStep = 0.9; ///< where there is hardly any overshoot
constexpr double kOvershootToSpeakOf = 0.02;
constexpr double kDiaphragm_m = 5.5e-3; ///< diameter of the DUT's, which a tilted front crosses

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

/// The rates: half of the settings' (Fs50), with the clock's error, and as stated.
void chooseRates(RecordAxis &axis, const SimulationSettings &settings, Index shot)
{
    const bool half = hasDefect(settings, DefectKind::Fs50, shot);
    const double nominal_Hz = half ? 0.5 * settings.sampleRate_Hz : settings.sampleRate_Hz;
    axis.count = static_cast<Index>(std::llround(settings.duration_s * nominal_Hz));
    axis.sampleRate_Hz = nominal_Hz * (1.0 + defectSize(settings, DefectKind::Clock, shot, 0.0));
    const double stated_Hz = nominal_Hz * defectSize(settings, DefectKind::Rate, shot, 1.0);
    if (stated_Hz != axis.sampleRate_Hz)
        axis.statedRate_Hz = stated_Hz;
}

RecordAxis axisOf(const SimulationSettings &settings, const ShotScene &scene, Index shot)
{
    RecordAxis axis;
    chooseRates(axis, settings, shot);
    axis.t0_s = -std::round(kPreTrigger * static_cast<double>(axis.count)) / axis.sampleRate_Hz;
    if (hasDefect(settings, DefectKind::Short, shot)) {
        const double kept_s = scene.wallArrival_s + kShortTail_s - axis.t0_s;
        axis.count
            = std::min(axis.count, static_cast<Index>(std::ceil(kept_s * axis.sampleRate_Hz)));
    }
    return axis;
}

NoiseKind noiseOf(const SimulationSettings &settings, Index shot)
{
    if (hasDefect(settings, DefectKind::Flicker, shot))
        return {NoiseColour::Flicker, 0.0};
    if (const auto defect = defectOf(settings, DefectKind::Autoregressive, shot))
        return {NoiseColour::Autoregressive, *defect->size};
    return {};
}

/// A tilt counts where both are asked for.
std::optional<Front> frontOf(const SimulationSettings &settings, const ShotScene &scene, Index shot)
{
    const double angle_deg = defectSize(settings, DefectKind::Tilt, shot, 0.0);
    if (angle_deg > 0.0)
        return Front{
            Front::Kind::Tilt, tiltDuration_s(angle_deg, kDiaphragm_m, scene.states.velocity_m_s)};
    const double duration_s = defectSize(settings, DefectKind::Front, shot, 0.0);
    if (duration_s > 0.0)
        return Front{Front::Kind::Ramp, duration_s};
    return std::nullopt;
}

/// Everything that a shot has only by a defect with a burst.
void addWaveDefects(ShotPlan &plan, const SimulationSettings &settings)
{
    const Index shot = plan.number;
    if (hasDefect(settings, DefectKind::TubeMode, shot))
        plan.tubeMode
            = drawTubeMode(settings.seed, shot, plan.scene.states.reflected.soundSpeed_m_s);
    if (const auto echo = defectOf(settings, DefectKind::Echo, shot))
        plan.echo = EchoOfStep{*echo->size, *echo->time_s};
    plan.front = frontOf(settings, plan.scene, shot);
    const double riseTimes = defectSize(settings, DefectKind::SideDelay, shot, 0.0);
    if (riseTimes > 0.0)
        plan.sideDelay_s = riseTimes * riseTime_s(sideSensor());
}

/// Largest magnitude at the DUT's converter in one shot.
double needed_V(const ShotPlan &plan)
{
    const double drift_V = std::abs(plan.driftPerSecond_V);
    const double untilStep_s = plan.scene.wallArrival_s - plan.axis.t0_s;
    const double duration_s = static_cast<double>(plan.axis.count) / plan.axis.sampleRate_Hz;
    const double early_V = (1.0 + plan.overshoot) * plan.plateau_V() + drift_V * untilStep_s;
    const double late_V = plan.plateau_V() + drift_V * duration_s;
    // The mode starts with a jump, which rings like the step; so does an echo, on top of it. A
    // negative sag rises.
    const double mode = plan.tubeMode ? 2.0 * plan.tubeMode->amplitude : 0.0;
    const double echo = plan.echo ? std::max(plan.echo->share, 0.0) : 0.0;
    const double rise = plan.dut.heat ? std::max(-plan.dut.heat->share, 0.0) : 0.0;
    return kHeadroom * (1.0 + mode) * (1.0 + echo) * (1.0 + rise) * std::max(early_V, late_V)
        + kNoiseHeadroom * plan.noise_V;
}

} // namespace

ShotPlan planShot(const SimulationSettings &settings, const ShotScene &scene, Index shot)
{
    ShotPlan plan;
    plan.number = shot;
    plan.level = notedLevels(settings)[static_cast<std::size_t>(shot - 1)];
    plan.scene = scene;
    plan.dut = sensorOfShot(settings, shot);
    plan.axis = axisOf(settings, scene, shot);
    plan.noise_V = settings.noise * plan.plateau_V();
    plan.noise = noiseOf(settings, shot);
    if (hasDefect(settings, DefectKind::Drift, shot))
        plan.driftPerSecond_V = kDriftPerSecond * plan.dut.sensitivity_V_Pa * scene.step_Pa();
    plan.overshoot = overshootOf(plan.dut);
    plan.burst = !hasDefect(settings, DefectKind::NoStep, shot);
    plan.bow_codes = defectSize(settings, DefectKind::Bow, shot, 0.0);
    if (plan.burst)
        addWaveDefects(plan, settings);
    return plan;
}

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

} // namespace dyncal
