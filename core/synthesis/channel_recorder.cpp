// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/channel_recorder.h"

#include <algorithm>
#include <cstdint>

namespace dyncal {
namespace {

constexpr Index kBlock = 1 << 16;

/// Half to even, for magnitudes below 2^51: the sum has no bits for fractions.
double roundHalfToEven(double x)
{
    constexpr double kNoFraction = 0x1.8p52;
    return (x + kNoFraction) - kNoFraction;
}

/// The noise-free part of a plan, ready to be evaluated block by block.
class CleanSignal
{
public:
    CleanSignal(const SignalPlan &plan, const RecordAxis &axis)
        : m_plan(plan)
        , m_axis(axis)
    {
        for (const PressureEvent &event : plan.events)
            m_responses.emplace_back(event.oscillation
                    ? StepResponse(plan.sensor, *event.oscillation)
                    : StepResponse(plan.sensor, event.relaxation_s),
                event.front);
    }

    void evaluate(std::span<double> volts, Index firstSample) const
    {
        const double first = static_cast<double>(firstSample);
        const double sensitivity_V_Pa = m_plan.sensor.sensitivity_V_Pa;
        const double drift_V = m_plan.driftPerSecond_V / m_axis.sampleRate_Hz; // per sample
        for (std::size_t i = 0; i < volts.size(); ++i)
            volts[i]
                = sensitivity_V_Pa * m_plan.initial_Pa + drift_V * (first + static_cast<double>(i));
        const double start_s = m_axis.t0_s + first / m_axis.sampleRate_Hz;
        for (std::size_t e = 0; e < m_responses.size(); ++e) {
            const PressureEvent &event = m_plan.events[e];
            m_responses[e].addTo(volts, start_s - event.time_s, m_axis.sampleRate_Hz,
                sensitivity_V_Pa * event.change_Pa);
        }
    }

private:
    const SignalPlan &m_plan;
    const RecordAxis &m_axis;
    std::vector<FrontResponse> m_responses;
};

template <typename Count>
Result<RawSamples> record(const SignalPlan &plan, const RecordAxis &axis,
    const Digitizer &digitizer, RandomStream random, const JobControl &control)
{
    const CleanSignal clean(plan, axis);
    NoiseSource noise(plan.noise, axis.count, random);
    const double lowest = digitizer.lowestCount();
    const double highest = digitizer.highestCount();
    std::vector<Count> counts(static_cast<std::size_t>(axis.count));
    std::vector<double> volts(static_cast<std::size_t>(std::min(axis.count, kBlock)));
    for (Index begin = 0; begin < axis.count; begin += kBlock) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, Message{});
        const Index length = std::min(kBlock, axis.count - begin);
        const std::span<double> block(volts.data(), static_cast<std::size_t>(length));
        clean.evaluate(block, begin);
        if (plan.noise_V > 0.0)
            noise.addTo(block, plan.noise_V);
        for (std::size_t i = 0; i < block.size(); ++i)
            counts[static_cast<std::size_t>(begin) + i] = static_cast<Count>(
                roundHalfToEven(std::clamp(digitizer.position(block[i]), lowest, highest)));
        control.report(static_cast<double>(begin + length) / static_cast<double>(axis.count));
    }
    return RawSamples(std::move(counts));
}

} // namespace

double Digitizer::position(double volts) const
{
    const double counts = volts / step_V();
    if (bow_codes == 0.0)
        return counts;
    const double x = std::clamp(volts / range_V, -1.0, 1.0);
    return counts + bow_codes * (1.0 - x * x);
}

Result<Channel> recordChannel(const SignalPlan &plan, const RecordAxis &axis,
    const Digitizer &digitizer, RandomStream random, const JobControl &control)
{
    auto samples = digitizer.bits <= 16
        ? record<std::int16_t>(plan, axis, digitizer, random, control)
        : record<std::int32_t>(plan, axis, digitizer, random, control);
    if (!samples)
        return tl::unexpected(samples.error());
    Channel channel;
    channel.samples = std::move(*samples);
    channel.sampleRate_Hz = axis.statedRate_Hz.value_or(axis.sampleRate_Hz);
    channel.t0_s = axis.statedTime_s(axis.t0_s);
    channel.polynomial = {0.0, digitizer.step_V()};
    channel.quantity = std::string("voltage");
    channel.adcMin = digitizer.lowestCount();
    channel.adcMax = digitizer.highestCount();
    channel.adcBits = digitizer.bits;
    return channel;
}

} // namespace dyncal
