// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/record_findings.h"

#include "core/base/number_text.h"
#include "core/signal/interpolated_samples.h"
#include "core/signal/level_statistics.h"
#include "core/signal/unrest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr double kLeastUnrest = 0.003; ///< of the step
constexpr Index kFirstSamples = 20000; ///< looked at of a longer record before the baseline
constexpr Index kSamplesLookedAt = 8192; ///< around the start, for interpolation

/// The first samples of a record whose baseline begins later, as `values` are.
Eigen::VectorXd firstSamples(const WindowedResponse &response, const Channel &channel)
{
    const Index count
        = std::min(kFirstSamples, std::max(response.startSample - response.lead, Index(0)));
    const Eigen::VectorXd first = finiteOnly(physicalValues(channel, 0, count));
    return (first.array() - response.baseline) / response.valueScale;
}

/// `before` begins at `time_s` against the start.
bool addUnrest(const WindowedResponse &response, const Eigen::Ref<const Eigen::VectorXd> &before,
    double time_s, Findings &findings)
{
    const double perStep = std::abs(response.valueScale / response.step);
    const double least
        = std::max(kLeastUnrest, response.resolution / std::abs(response.step)) / perStep;
    const auto found = unrestBefore(before, least);
    if (!found)
        return false;
    time_s += static_cast<double>(found->begin) / response.sampleRate_Hz;
    findings.push_back({.id = "WIN-010",
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .time_s = response.start_s + time_s,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: before its start the record is not quiet: %2 before it, it moves by %3 % of the step (standard deviation), elsewhere by %4 %. What moves it is likely in the response, too, and may be taken for the sensor's own: a wave in the wall of the tube, a disturbance, or a record that begins behind its step."),
            {std::to_string(response.shot), numberWithUnit(-time_s, "s", 3),
                numberText(100.0 * perStep * found->size, 2),
                numberText(100.0 * perStep * found->usual, 2)}},
        .value = 100.0 * perStep * found->size,
        .limit = 100.0 * perStep * found->usual,
        .causes = {FindingCause::Noise}});
    return true;
}

void addUnrest(const WindowedResponse &response, const Channel &channel, Findings &findings)
{
    const auto timeOf_s
        = [&](Index sample) { return static_cast<double>(sample) / response.sampleRate_Hz; };
    if (!addUnrest(
            response, response.values.head(response.lead), -timeOf_s(response.lead), findings))
        addUnrest(
            response, firstSamples(response, channel), -timeOf_s(response.startSample), findings);
}

Finding misplaced(const WindowedResponse &response, Message message, double value)
{
    return {.id = "WIN-011",
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .time_s = response.start_s,
        .message = std::move(message),
        .value = value,
        .causes = {FindingCause::Typed}};
}

/// What a response is counted from, against what its record shows before the start.
void addMisplaced(const WindowedResponse &response, Findings &findings)
{
    constexpr Index kLast = 3, kQuiet = 1000;
    constexpr double kGone = 0.1, kOff = 0.005; // of the step
    constexpr double kSigmas = 6.0;
    const double perStep = std::abs(response.valueScale / response.step);
    const double noise = kSigmas * response.noiseSd / std::abs(response.step);
    const auto meanOf = [&](Index begin, Index count) {
        return perStep * response.values.segment(response.lead + begin, count).mean();
    };
    const auto report = [&](const char *text, double share) {
        findings.push_back(misplaced(response,
            {text, {std::to_string(response.shot), numberText(100.0 * share, 3)}}, 100.0 * share));
    };
    const Index count = std::min(kQuiet, response.lead / 2);
    if (count < kLast)
        return;
    const double gone = std::abs(meanOf(-kLast, kLast));
    // The samples next to the start are left out: a response may begin softly.
    const double off = std::abs(meanOf(-count - count / 4 - kLast, count));
    if (off > std::max(kOff, noise / std::sqrt(static_cast<double>(count))))
        report(
            DYNCAL_TEXT("core",
                "Shot %1: before its start the record lies %2 % of the step away from the baseline that it is counted from; the step and the sensitivity are wrong by as much. Let the baseline be found, or place it just before the start."),
            off);
    else if (!response.startDetected && gone > std::max(kGone, noise / std::sqrt(double(kLast))))
        report(
            DYNCAL_TEXT("core",
                "Shot %1: at the typed start the record has left its baseline by %2 % of the step already: the response began before. Move the start, or let it be found."),
            gone);
}

/// First sample from the start on that has left the baseline by a share of the step, as the next;
/// none: the number of samples.
Index samplesTo(double share, const WindowedResponse &response)
{
    const double level = share * std::abs(response.step / response.valueScale);
    const Eigen::VectorXd &values = response.values;
    Index k = response.lead;
    while (k + 1 < values.size()
        && !(std::abs(values[k]) >= level && std::abs(values[k + 1]) >= level))
        ++k;
    return k - response.lead;
}

/// A start typed before the response: the model takes the quiet stretch for a part of it.
void addEarly(const WindowedResponse &response, Findings &findings)
{
    constexpr Index kSlack = 2;
    constexpr Index kMostDelay = 4; // of the way on; eight equal poles in series have 3.5
    if (response.startDetected)
        return;
    const Index quarter = samplesTo(0.25, response), half = samplesTo(0.5, response);
    if (quarter <= kMostDelay * (half - quarter) + kSlack)
        return;
    const double quarter_s = static_cast<double>(quarter) / response.sampleRate_Hz;
    const double half_s = static_cast<double>(half) / response.sampleRate_Hz;
    findings.push_back(misplaced(response,
        {DYNCAL_TEXT("core",
             "Shot %1: the record takes %2 from the typed start to a quarter of the step and just %3 from there to the half, so the response begins later; the model takes the quiet stretch for a part of it. Move the start, or let it be found."),
            {std::to_string(response.shot), numberWithUnit(quarter_s, "s", 3),
                numberWithUnit(half_s - quarter_s, "s", 3)}},
        quarter_s));
}

void addInterpolation(const WindowedResponse &response, Findings &findings)
{
    const Index begin = std::max(response.lead - kSamplesLookedAt / 4, Index(0));
    const Index count = std::min(kSamplesLookedAt, response.values.size() - begin);
    const auto found = interpolatedSamples(
        response.values.segment(begin, count), response.resolution / std::abs(response.valueScale));
    if (!found)
        return;
    const char *repeated = DYNCAL_TEXT("core",
        "Shot %1, channel %2: each value stands %3 times in a row, so the record was measured at %4 and written at %5; S(f), band edges and rise time have the repetition in them. Export it at the rate at which it was measured.");
    const char *onLines = DYNCAL_TEXT("core",
        "Shot %1, channel %2: between every %3 samples the others lie on straight lines, so the record was measured at %4 and written at %5; S(f), band edges and rise time have the interpolation in them. Export it at the rate at which it was measured.");
    findings.push_back({.id = "CAP-034",
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .message = {found->isRepeated ? repeated : onLines,
            {std::to_string(response.shot), response.channel, std::to_string(found->factor),
                numberWithUnit(
                    response.sampleRate_Hz / static_cast<double>(found->factor), "Hz", 4),
                numberWithUnit(response.sampleRate_Hz, "Hz", 4)}},
        .value = static_cast<double>(found->factor),
        .limit = 1.0,
        .causes = {FindingCause::Rate}});
}

} // namespace

Findings recordFindings(const WindowedResponse &response, const Channel &channel)
{
    Findings findings;
    addUnrest(response, channel, findings);
    addMisplaced(response, findings);
    addEarly(response, findings);
    addInterpolation(response, findings);
    return findings;
}

} // namespace dyncal
