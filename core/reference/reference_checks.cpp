// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_checks.h"

#include "core/base/number_text.h"
#include "core/signal/window_checks.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kLargestDrift = 0.0025; ///< of the step, over half a band
constexpr double kDriftSigmas = 4.0; ///< two bands of every shot are looked at

struct Drift
{
    double half = 0.0; ///< of the step, over half of the band
    bool isReal = false;
};

Drift driftOver(const WindowedResponse &response, double slope_per_s, const Interval &band)
{
    const double half_s = 0.5 * band.length();
    const double half = std::abs(slope_per_s * half_s / response.step);
    const double u = slopeUncertainty_per_s(response, band) * half_s / std::abs(response.step);
    return {half, half > kLargestDrift && half > kDriftSigmas * u};
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
    const Drift before = driftOver(response, response.baselineSlope_per_s, response.baseline_s);
    const Drift behind = driftOver(response, response.settleSlope_per_s, response.settle_s);
    const double half
        = std::max(before.isReal ? before.half : 0.0, behind.isReal ? behind.half : 0.0);
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
    const double scale = std::abs(response.valueScale);
    const auto run = runAtExtreme(response.window(), response.noiseSd / scale,
        response.resolution / scale, checks.saturationRun);
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

} // namespace dyncal
