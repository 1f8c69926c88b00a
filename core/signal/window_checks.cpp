// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/window_checks.h"

#include "core/base/number_text.h"
#include "core/capture/flat_top.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {
namespace {

constexpr double kSettleDrift_per_ms = 0.01; ///< of the step
constexpr double kBaselineDrift_per_ms = 0.005;
constexpr double kHalfDrift = 0.005; ///< of the step, from the middle of the baseline to its end
constexpr double kSlopeSigmas = 3.0; ///< a slope below so many u may be noise
constexpr double kLeastSnr_dB = 20.0;
constexpr double kMilli = 1e-3;

/// Calls `visit(begin, count)` for every run of at least `least` samples that `isAt` accepts, until
/// it returns true.
template <typename Test, typename Visit>
void forEachRun(Index size, Index least, const Test &isAt, const Visit &visit)
{
    for (Index begin = 0; begin < size;) {
        Index end = begin;
        while (end < size && isAt(end))
            ++end;
        if (end - begin >= least && visit(begin, end - begin))
            return;
        begin = std::max(end, begin + 1);
    }
}

std::string shotText(const WindowedResponse &response)
{
    return std::to_string(response.shot);
}

std::optional<Finding> driftFinding(const char *id, const char *text,
    const WindowedResponse &response, double slope_per_s, const Interval &band, double limit_per_ms,
    double limitOfHalf = HUGE_VAL)
{
    const double drift_per_ms = std::abs(slope_per_s * kMilli / response.step);
    const HalfDrift half = halfDrift(response, slope_per_s, band);
    if ((drift_per_ms <= limit_per_ms && half.share <= limitOfHalf)
        || half.share <= kSlopeSigmas * half.u)
        return std::nullopt;
    return Finding{.id = id,
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .message = {text,
            {shotText(response), numberText(100.0 * drift_per_ms, 2),
                numberText(100.0 * half.share, 2)}},
        .value = 100.0 * drift_per_ms,
        .limit = 100.0 * limit_per_ms};
}

/// FIT that a perfect model of this window would score, in percent.
double attainableFit_percent(const WindowedResponse &response)
{
    const auto window = response.window();
    const double spread = std::sqrt((window.array() - window.mean()).square().mean());
    const double noise = std::abs(response.noiseSd / response.valueScale);
    return 100.0 * std::clamp(1.0 - noise / spread, 0.0, 1.0);
}

Finding saturationFinding(const WindowedResponse &response, const SaturatedRun &run, Index leastRun)
{
    const double begin_s
        = response.start_s + static_cast<double>(run.begin) / response.sampleRate_Hz;
    Finding result{.id = "CAP-007",
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: %2 samples in a row at %3 are equal and the extreme of the window; the record may be saturated there."),
            {shotText(response), std::to_string(run.count), numberWithUnit(begin_s, "s", 6)}},
        .value = static_cast<double>(run.count),
        .limit = static_cast<double>(leastRun)};
    result.time_s = begin_s;
    return result;
}

void addStepFindings(const WindowedResponse &response, Findings &findings)
{
    if (response.step < 0.0)
        findings.push_back({.id = "CAP-012",
            .severity = Severity::Caution,
            .shot = response.shot,
            .channel = response.channel,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1: the step is negative (%2); set import.polarity to -1 if the sensor is inverted."),
                {shotText(response), numberWithUnit(response.step, response.unit)}},
            .value = response.step,
            .limit = 0.0});
    const char *text = DYNCAL_TEXT("core",
        "Shot %1: the settling level still drifts %2 % of the step per ms; the level depends by +-%3 % on where the settle band lies.");
    if (auto drift = driftFinding("WIN-003", text, response, response.settleSlope_per_s,
            response.settle_s, kSettleDrift_per_ms)) {
        drift->causes = {FindingCause::Drift};
        findings.push_back(std::move(*drift));
    }
}

/// The common end moved to `end_s`, or that of this shot alone where each has its own.
Correction movedEnd(const WindowedResponse &response, const WindowSettings &settings, double end_s)
{
    const std::string time = numberWithUnit(end_s, "s", 4);
    if (settings.ownEnds_s.empty())
        return {.label = {DYNCAL_TEXT("core", "Move the end to %1"), {time}},
            .key = "window.end_s",
            .value = numberText(end_s)};
    std::string list;
    for (std::size_t i = 0; i < settings.ownEnds_s.size(); ++i) {
        const Auto<double> own = static_cast<Index>(i) + 1 == response.shot ? Auto<double>(end_s)
                                                                            : settings.ownEnds_s[i];
        list.append(list.empty() ? "[" : ", ")
            .append(own.isAuto() ? std::string("\"auto\"") : numberText(*own.value));
    }
    return {
        .label = {DYNCAL_TEXT("core", "Move the end of shot %1 to %2"), {shotText(response), time}},
        .key = "window.end_s",
        .value = list + "]"};
}

Finding behindPlateau(
    const WindowedResponse &response, const WindowSettings &settings, double plateau_s)
{
    Finding overrun{.id = "WIN-001",
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: the window ends %2 after the computed end of the plateau, %3 behind the start; move window.end_s."),
            {shotText(response), numberWithUnit(response.end_s - plateau_s, "s", 3),
                numberWithUnit(plateau_s, "s", 4)}},
        .value = response.end_s,
        .limit = plateau_s};
    if (plateau_s > 0.0)
        overrun.correction = movedEnd(response, settings, plateau_s);
    return overrun;
}

std::optional<Error> invalidSamples(const Channel &channel, Index shot, const WindowBands &bands)
{
    SampleRange joined = bands.window;
    if (bands.baseline.size() > 0 && bands.baseline.end <= bands.window.begin)
        joined.begin = bands.baseline.begin;
    for (const SampleRange &range : {joined, bands.baseline}) {
        const Eigen::VectorXd values = physicalValues(channel, range.begin, range.size());
        const auto isInvalid = [](double value) { return !std::isfinite(value); };
        const auto first = std::find_if(values.begin(), values.end(), isInvalid);
        if (first == values.end())
            continue;
        Index last = values.size() - 1;
        while (!isInvalid(values[last]))
            --last;
        const Index sample = range.begin + (first - values.begin());
        return Error{ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1, channel %2: invalid samples (%3, from sample %4 to %5) at %6, inside the response window or its baseline; exclude the shot or set import.interpolate_invalid."),
                {std::to_string(shot), channel.name,
                    std::to_string(std::count_if(first, values.end(), isInvalid)),
                    std::to_string(sample), std::to_string(range.begin + last),
                    numberWithUnit(channel.timeOf_s(sample), "s", 6)}},
            "CAP-006", shot};
    }
    return std::nullopt;
}

std::optional<Error> saturatedSamples(
    const Channel &channel, Index shot, const WindowBands &bands, const CheckSettings &checks)
{
    for (const SampleRange &range : {bands.window, bands.baseline}) {
        if (const auto run = runAtRail(channel, range, checks.saturationRun))
            return Error{ErrorKind::DataBlocked,
                {DYNCAL_TEXT("core",
                     "Shot %1, channel %2 is saturated for %3 (%4 samples) at %5, from %6 on, inside the response window or its baseline; the shot cannot be used: exclude it."),
                    {std::to_string(shot), channel.name,
                        numberWithUnit(
                            static_cast<double>(run->count) / channel.sampleRate_Hz, "s", 3),
                        std::to_string(run->count),
                        numberWithUnit(
                            physicalValue(channel, channel.samples.at(run->begin)), channel.unit),
                        numberWithUnit(channel.timeOf_s(run->begin), "s", 6)}},
                "CAP-007", shot};
    }
    return std::nullopt;
}

} // namespace

std::optional<Error> unusableSamples(
    const Channel &channel, Index shot, const WindowBands &bands, const CheckSettings &checks)
{
    std::vector<Error> errors;
    if (auto error = invalidSamples(channel, shot, bands))
        errors.push_back(std::move(*error));
    if (auto error = saturatedSamples(channel, shot, bands, checks))
        errors.push_back(std::move(*error));
    if (errors.empty())
        return std::nullopt;
    return asOneError(std::move(errors));
}

std::optional<SaturatedRun> runAtRail(
    const Channel &channel, const SampleRange &range, Index leastRun)
{
    std::optional<SaturatedRun> result;
    const RawSamples samples = channel.samples.inMemory(range.begin, range.size());
    if (samples.size() == 0) // not readable: reported where the values are read
        return result;
    for (const bool top : {true, false}) {
        const std::optional<double> rail = top ? channel.adcMax : channel.adcMin;
        if (!rail || result)
            continue;
        const auto isAt = [&](Index i) {
            const double raw = samples.at(i);
            return top ? raw >= *rail : raw <= *rail;
        };
        forEachRun(range.size(), leastRun, isAt, [&](Index begin, Index count) {
            result = SaturatedRun{range.begin + begin, count};
            return true;
        });
    }
    return result;
}

std::optional<SaturatedRun> runAtExtreme(const Eigen::Ref<const Eigen::VectorXd> &values,
    double noiseSd, double codeSize, Index leastRun)
{
    std::optional<SaturatedRun> result;
    if (values.size() == 0)
        return result;
    const double highest = values.maxCoeff(), lowest = values.minCoeff();
    const FlatTopScale scale{highest - lowest, noiseSd, codeSize};
    const auto valueAt = [&](Index i) { return values[i]; };
    for (const double extreme : {highest, lowest}) {
        const auto isAt = [&](Index i) { return values[i] == extreme; };
        forEachRun(values.size(), leastRun, isAt, [&](Index begin, Index count) {
            const bool longest = !result || count > result->count;
            if (longest && isCutOff(valueAt, values.size(), {begin, count}, scale))
                result = SaturatedRun{begin, count};
            return false;
        });
    }
    return result;
}

std::optional<SaturatedRun> runAtExtreme(const WindowedResponse &response, Index leastRun)
{
    const double scale = std::abs(response.valueScale);
    return runAtExtreme(
        response.window(), response.noiseSd / scale, response.resolution / scale, leastRun);
}

HalfDrift halfDrift(const WindowedResponse &response, double slope_per_s, const Interval &band)
{
    const double n = std::max(band.length() * response.sampleRate_Hz, 2.0);
    const double u_per_s
        = response.noiseSd * std::sqrt(12.0 / (n * n * n)) * response.sampleRate_Hz;
    const double half = 0.5 * band.length() / std::abs(response.step);
    return {std::abs(slope_per_s) * half, u_per_s * half};
}

Findings windowFindings(const WindowedResponse &response, const WindowSettings &settings,
    const WindowContext &context, std::optional<double> plateau_s)
{
    Findings findings;
    const double code = response.resolution;
    // Also where the converter's rails are known: an amplifier may be cut before them.
    if (const auto run = runAtExtreme(response, context.checks.saturationRun))
        findings.push_back(saturationFinding(response, *run, context.checks.saturationRun));
    if (isStepTreatment(context.treatment))
        addStepFindings(response, findings);
    if (code > 0.0 && std::abs(response.step) < context.checks.leastCodes * code)
        findings.push_back({.id = "CAP-014",
            .severity = Severity::Caution,
            .shot = response.shot,
            .channel = response.channel,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1: the step uses %2 codes of the converter; quantisation limits the result."),
                {shotText(response), numberText(std::abs(response.step) / code, 3)}},
            .value = std::abs(response.step) / code,
            .limit = context.checks.leastCodes});
    // Ends lie on samples, so one sample beyond the plateau's end is no overrun.
    if (plateau_s && response.end_s > *plateau_s + 1.0 / response.sampleRate_Hz)
        findings.push_back(behindPlateau(response, settings, *plateau_s));
    const char *text = DYNCAL_TEXT(
        "core", "Shot %1: the baseline drifts %2 % of the step per ms, +-%3 % over the band.");
    if (auto drift = driftFinding("WIN-004", text, response, response.baselineSlope_per_s,
            response.baseline_s, kBaselineDrift_per_ms, kHalfDrift))
        findings.push_back(std::move(*drift));
    if (response.snr_dB < kLeastSnr_dB)
        findings.push_back({.id = "WIN-006",
            .severity = Severity::Caution,
            .shot = response.shot,
            .channel = response.channel,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1: SNR %2 dB; even a perfect model would score a FIT of about %3 %."),
                {shotText(response), numberText(response.snr_dB, 3),
                    numberText(attainableFit_percent(response), 2)}},
            .value = response.snr_dB,
            .limit = kLeastSnr_dB});
    return findings;
}

} // namespace dyncal
