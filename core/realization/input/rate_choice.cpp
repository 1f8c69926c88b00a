// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/rate_choice.h"

#include "core/base/number_text.h"
#include "core/realization/input/plateau_drift.h"
#include "core/signal/resampler.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kFewestPerPeriod = 4.0;
constexpr double kFewestPerRise = 10.0;
constexpr double kLargestFilterPerRise = 0.5;
constexpr double kRingTimes = 12.0; ///< e^-12: nothing of the ringing is left
constexpr double kRiseTimes = 20.0;
constexpr Index kSamplesOfDrift = 2000;
constexpr double kStandsOut_dB = 6.0; ///< below the most prominent
constexpr double kHarmonic = 0.03; ///< from a whole multiple

bool keepsResponse(double rate_Hz, Index factor, const SensorTraits &traits)
{
    const double reduced_Hz = rate_Hz / static_cast<double>(factor);
    const double span_s = antiAliasSpan_s(static_cast<double>(factor), rate_Hz);
    if (!traits.ringing.empty())
        return std::ranges::all_of(traits.ringing, [&](const RingingTraits &one) {
            return reduced_Hz >= kFewestPerPeriod * one.frequency_Hz
                && span_s <= one.ringTime_s.value_or(0.0);
        });
    if (traits.riseTime_s)
        return reduced_Hz >= kFewestPerRise / *traits.riseTime_s
            && span_s <= kLargestFilterPerRise * *traits.riseTime_s;
    return false;
}

/// The harmonics of a burst are no modes of their own.
bool standsOut(const Resonance &one, const Resonance &main)
{
    const double ratio = one.frequency_Hz / main.frequency_Hz;
    // A wide maximum says its own frequency to a quarter of its width only.
    const double width = main.q > 0.0 ? 0.25 * std::round(ratio) / main.q : 0.0;
    const bool isHarmonic
        = ratio > 1.5 && std::abs(ratio - std::round(ratio)) < std::max(kHarmonic, width);
    return !isHarmonic && one.prominence_dB >= main.prominence_dB - kStandsOut_dB;
}

Index samplesOf(double span_s, double rate_Hz)
{
    return static_cast<Index>(std::clamp(std::ceil(span_s * rate_Hz), 200.0, 1000.0));
}

} // namespace

SensorTraits sensorTraits(
    const std::vector<WindowedResponse> &responses, const SpectrumResult &spectrum)
{
    SensorTraits traits;
    for (const Resonance &resonance : spectrum.resonances) {
        if (!standsOut(resonance, spectrum.resonances.front()))
            continue;
        traits.ringing.push_back({resonance.frequency_Hz, std::nullopt});
        if (resonance.q > 0.0)
            traits.ringing.back().ringTime_s
                = resonance.q / (std::numbers::pi * resonance.frequency_Hz);
    }
    double sum = 0.0;
    int count = 0;
    for (const WindowedResponse &response : responses) {
        if (response.riseTime_s) {
            sum += *response.riseTime_s;
            ++count;
        }
    }
    if (count > 0)
        traits.riseTime_s = sum / count;
    traits.drifts = traits.ringing.empty() && traits.riseTime_s
        && levelsDriftBehind(responses, kRiseTimes * *traits.riseTime_s);
    return traits;
}

Index chooseReduction(double rate_Hz, const SensorTraits &traits)
{
    static constexpr std::array<Index, 3> kSteps{1, 2, 5};
    Index chosen = 1;
    constexpr Index kBeyondAnyRecord = 1000000000000;
    for (Index decade = 1; decade < kBeyondAnyRecord; decade *= 10) {
        for (const Index step : kSteps) {
            const Index factor = step * decade;
            if (factor > 1 && !keepsResponse(rate_Hz, factor, traits))
                return chosen;
            chosen = factor;
        }
    }
    return chosen;
}

Index chooseSamples(double rate_Hz, const SensorTraits &traits)
{
    if (traits.drifts)
        return kSamplesOfDrift;
    std::optional<double> span_s;
    for (const RingingTraits &one : traits.ringing)
        if (one.ringTime_s)
            span_s = std::max(span_s.value_or(0.0), kRingTimes * *one.ringTime_s);
    if (!span_s && traits.riseTime_s)
        span_s = kRiseTimes * *traits.riseTime_s;
    return span_s ? samplesOf(*span_s, rate_Hz) : 1000;
}

Result<Findings> judgeRate(double rate_Hz, const SensorTraits &traits)
{
    Findings findings;
    if (traits.ringing.empty())
        return findings;
    const double f_Hz = traits.ringing.front().frequency_Hz;
    const double perPeriod = rate_Hz / f_Hz;
    if (perPeriod <= 2.0) {
        const double alias_Hz = std::abs(f_Hz - rate_Hz * std::round(f_Hz / rate_Hz));
        return fail(ErrorKind::DataBlocked,
            Message{
                DYNCAL_TEXT("core",
                    "Model input: a rate of %1 cannot represent the resonance at %2, which would appear at %3; choose more than %4."),
                {numberWithUnit(rate_Hz, "Hz", 4), numberWithUnit(f_Hz, "Hz", 4),
                    numberWithUnit(alias_Hz, "Hz", 3), numberWithUnit(2.0 * f_Hz, "Hz", 4)}},
            "MIN-001");
    }
    if (perPeriod < 10.0) {
        const bool few = perPeriod < kFewestPerPeriod;
        findings.push_back({.id = "MIN-002",
            .severity = few ? Severity::Caution : Severity::Info,
            .message
            = {few ? DYNCAL_TEXT("core",
                   "%1 samples per period of the resonance; damping will be uncertain, 4 or more are better.")
                   : DYNCAL_TEXT("core", "%1 samples per period of the resonance."),
                {numberText(perPeriod, 3)}},
            .value = perPeriod,
            .limit = kFewestPerPeriod});
    }
    return findings;
}

Finding insideFilterFinding(double offset_s, double needed_s)
{
    return {.id = "MIN-006",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The model input starts %1 behind the onset, inside the anti-alias filter; %2 is needed, or damping and order come out wrong."),
            {numberWithUnit(offset_s, "s", 3), numberWithUnit(needed_s, "s", 3)}},
        .value = offset_s,
        .limit = needed_s};
}

} // namespace dyncal
