// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_checks.h"

#include "core/base/number_text.h"
#include "core/signal/window_checks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

constexpr double kLargestDrift = 0.0025; ///< of the step, over half a band
constexpr double kDriftSigmas = 4.0; ///< two bands of every shot are looked at

/// Of the step over half of a band; 0 where it is small or may be noise.
double driftOver(const WindowedResponse &response, double slope_per_s, const Interval &band)
{
    const HalfDrift half = halfDrift(response, slope_per_s, band);
    return half.share > std::max(kLargestDrift, kDriftSigmas * half.u) ? half.share : 0.0;
}

Finding ofReference(
    const char *id, const WindowedResponse &response, Message message, double value, double limit)
{
    return {.id = id,
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .message = std::move(message),
        .value = value,
        .limit = limit};
}

void addDrift(const WindowedResponse &response, Findings &findings)
{
    const double half
        = std::max(driftOver(response, response.baselineSlope_per_s, response.baseline_s),
            driftOver(response, response.settleSlope_per_s, response.settle_s));
    if (half > 0.0)
        findings.push_back(ofReference("CMP-002", response,
            {DYNCAL_TEXT("core",
                 "Shot %1: the level of the reference transducer %2 moves by +-%3 % of its step over a band that is to be level; its step, and so the sensitivity, is wrong by as much or more. Look for a drift of its zero, an amplifier that lets no constant pressure through, or heat."),
                {std::to_string(response.shot), response.channel, numberText(100.0 * half, 2)}},
            100.0 * half, 100.0 * kLargestDrift));
}

void addSign(const WindowedResponse &response, Findings &findings)
{
    if (response.step < 0.0)
        findings.push_back(ofReference("CMP-003", response,
            {DYNCAL_TEXT("core",
                 "Shot %1: the step of the reference transducer %2 is negative (%3), so that the phase is turned by 180 degrees; set its polarity to -1 if it is inverted."),
                {std::to_string(response.shot), response.channel,
                    numberWithUnit(response.step, response.unit)}},
            response.step, 0.0));
}

void addFlatTop(const WindowedResponse &response, const CheckSettings &checks, Findings &findings)
{
    const auto run = runAtExtreme(response, checks.saturationRun);
    if (run)
        findings.push_back(ofReference("CMP-004", response,
            {DYNCAL_TEXT("core",
                 "Shot %1: %2 samples in a row of the reference transducer %3 are equal and the extreme of the window; its record may be saturated there."),
                {std::to_string(response.shot), std::to_string(run->count), response.channel}},
            static_cast<double>(run->count), static_cast<double>(checks.saturationRun)));
}

} // namespace

Findings judgeReferenceRecords(const ReferenceRecords &records, const CheckSettings &checks)
{
    Findings findings;
    for (const WindowedResponse &response : records.responses) {
        addDrift(response, findings);
        addSign(response, findings);
        addFlatTop(response, checks, findings);
    }
    return findings;
}

bool beginsAboveTheLevel(const ReferenceSensitivity &sensitivity, const WindowedResponse &response)
{
    return sensitivity.lowest_Hz() * static_cast<double>(response.length) > response.sampleRate_Hz;
}

Findings judgeLevelOfReference(const ReferenceRecords &records)
{
    constexpr double kMatters = 0.1; // of u: U grows by half a percent of itself
    const ReferencePoint lowest = records.sensitivity.lowest();
    const double change = records.sensitivity.changeBelow();
    const auto isAbove = [&](const WindowedResponse &response) {
        return beginsAboveTheLevel(records.sensitivity, response);
    };
    const auto found = std::ranges::find_if(records.responses, isAbove);
    if (found == records.responses.end() || change <= kMatters * lowest.u_magnitude)
        return {};
    const double level_Hz = found->sampleRate_Hz / static_cast<double>(found->length);
    const char *known = DYNCAL_TEXT("core",
        "The calibration of the reference transducer begins at %1, and the level of the step lies below %2: its sensitivity may be another there by %3 %, as its rows show, which is in the uncertainty. Have it calibrated down to %2, or state the transducer as a model.");
    const char *unknown = DYNCAL_TEXT("core",
        "The calibration of the reference transducer is one row at %1, and the level of the step lies below %2: what its sensitivity is there is not known, so the step has no uncertainty. Have it calibrated down to %2, or state the transducer as a model.");
    const double percent = 100.0 * change / lowest.magnitude;
    std::vector<std::string> arguments{
        numberWithUnit(lowest.frequency_Hz, "Hz", 4), numberWithUnit(level_Hz, "Hz", 2)};
    if (std::isfinite(change))
        arguments.push_back(numberText(percent, 2));
    return {{.id = "CMP-006",
        .severity = Severity::Caution,
        .message = {std::isfinite(change) ? known : unknown, std::move(arguments)},
        .value = std::isfinite(change) ? std::optional(percent) : std::nullopt}};
}

} // namespace dyncal
