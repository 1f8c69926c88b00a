// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_generator.h"

#include "core/base/content_hash.h"
#include "core/synthesis/channel_recorder.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/laboratory.h"
#include "core/synthesis/record_defects.h"
#include "core/synthesis/shot_plan.h"
#include "core/synthesis/shot_scene.h"
#include "core/synthesis/shot_signals.h"
#include "core/synthesis/shot_truth.h"
#include "core/synthesis/simulation_checks.h"

#include <array>

namespace dyncal {
namespace {

constexpr double kInvalidDelay_s = 50e-6; ///< after the step

/// The three channels of a shot, in order; the DUT in volts, the others in pascal.
Result<std::vector<Channel>> recordChannels(const ShotPlan &plan, std::uint64_t seed,
    const Digitizer &dutDigitizer, int bits, const JobControl &control)
{
    const std::array<SignalPlan, 3> signals = signalsOf(plan);
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

Result<Shot> recordShot(const SimulationSettings &settings, const ShotPlan &plan,
    const Digitizer &dutDigitizer, const JobControl &control)
{
    auto channels = recordChannels(plan, settings.seed, dutDigitizer, settings.bits, control);
    if (!channels)
        return tl::unexpected(channels.error());
    Shot shot;
    shot.level = plan.level;
    shot.label = levelLabel(plan.level);
    shot.environment = recordedEnvironment(settings, plan.number, plan.scene.driverPressure_Pa);
    shot.channels = std::move(*channels);
    misstateScale(shot.channels[0], defectSize(settings, DefectKind::Scale, plan.number, 1.0));
    if (hasDefect(settings, DefectKind::Psi, plan.number)) // by the sensitivity that he knows
        mislabelAsBar(shot.channels[0], settings.sensor.sensitivity_V_Pa);
    if (hasDefect(settings, DefectKind::Nan, plan.number))
        spoilWithInvalidSamples(
            shot.channels[0], plan.axis.statedTime_s(plan.scene.wallArrival_s + kInvalidDelay_s));
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
        const Digitizer digitizer{
            settings.bits, clip ? clippedRange_V(plan) : range_V, plan.bow_codes};
        const double done = static_cast<double>(plan.number - 1);
        const double all = static_cast<double>(plans.size());
        const JobControl part{
            control.stop, [&](double fraction) { control.report((done + fraction) / all); }};
        auto shot = recordShot(settings, plan, digitizer, part);
        if (!shot)
            return tl::unexpected(shot.error());
        capture.set.shots.push_back(std::move(*shot));
        capture.truth.push_back(truthOf(settings, plan, digitizer));
    }
    return capture;
}

} // namespace dyncal
