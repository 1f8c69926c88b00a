// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/record_pressure.h"

#include "core/base/number_text.h"
#include "core/signal/baseline_level.h"
#include "core/signal/rounding.h"
#include "core/signal/start_detection.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kMostQuiet = 1 << 20;
constexpr double kQuietBeforeStart = 0.75;
/// Samples read beside the window, in lengths of the filter: what its ends cost.
constexpr Index kMarginInFilters = 4;

tl::unexpected<Error> refusedRecord(const char *text, std::vector<std::string> arguments)
{
    return fail(ErrorKind::Usage, {text, std::move(arguments)});
}

/// "V" of "Pa/V"
std::string recordedUnitOf(const CorrectionFilter &filter)
{
    return filter.unit.substr(std::min(filter.unit.find('/') + 1, filter.unit.size()));
}

Result<void> checkChannel(const Channel &channel, Index shot, const CorrectionFilter &filter)
{
    const std::string needed = recordedUnitOf(filter);
    if (channel.unit != needed)
        return refusedRecord(
            DYNCAL_TEXT("core",
                "Shot %1: channel %2 is in \"%3\", but the calibration is of a sensor in \"%4\"; state the unit and scale of the recording (section import of a recipe)."),
            {std::to_string(shot), channel.name, channel.unit, needed});
    if (channel.sampleRate_Hz != filter.rate_Hz)
        return refusedRecord(
            DYNCAL_TEXT("core",
                "Shot %1 was recorded at %2, the filter is for %3; correct recordings of different rates one after the other."),
            {std::to_string(shot), numberWithUnit(channel.sampleRate_Hz, "Hz", 9),
                numberWithUnit(filter.rate_Hz, "Hz", 9)});
    return {};
}

/// Samples whose times lie in the interval, as far as the record has them.
SampleRange samplesIn(const Channel &channel, const Interval &interval_s)
{
    const auto sampleAt = [&](double time_s) {
        const double at = std::ceil((time_s - channel.t0_s) * channel.sampleRate_Hz - 1e-6);
        return static_cast<Index>(std::clamp(at, 0.0, static_cast<double>(channel.samples.size())));
    };
    const Index begin = sampleAt(interval_s.begin);
    return {begin, std::max(begin, sampleAt(interval_s.end))};
}

Result<SampleRange> quietRange(
    const Channel &channel, Index shot, const std::optional<Interval> &quiet_s)
{
    if (quiet_s)
        return samplesIn(channel, *quiet_s);
    const Result<DetectedStart> start = detectStart(channel, {}, shot);
    if (!start)
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1: no start of a pressure was found in channel %2, so its level and noise without pressure are not known; state a stretch without pressure (--quiet)."),
                {std::to_string(shot), channel.name}});
    return SampleRange{
        0, static_cast<Index>(kQuietBeforeStart * static_cast<double>(start->sample))};
}

/// The record without pressure.
struct QuietRecord
{
    SampleRange range;
    double level = 0.0;
    double slope = 0.0; ///< per sample, where it drifts steadily
    WindowedResponse noise;
};

Result<void> checkQuiet(const Eigen::VectorXd &values, const Channel &channel, Index shot)
{
    if (values.size() < kFewestQuiet)
        return refusedRecord(
            DYNCAL_TEXT("core",
                "Shot %1: channel %2 has %3 samples without pressure, but at least %4 are needed to know its level and noise; state a longer stretch (--quiet)."),
            {std::to_string(shot), channel.name, std::to_string(values.size()),
                std::to_string(kFewestQuiet)});
    if (values.allFinite())
        return {};
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "Shot %1: channel %2 has samples without pressure that are no numbers; state another stretch (--quiet)."),
            {std::to_string(shot), channel.name}});
}

QuietRecord quietOf(const Channel &channel, const SampleRange &range, const Eigen::VectorXd &values)
{
    const BaselineLevel baseline = baselineLevel(values, 0);
    const double slope = baseline.varianceFactor > 1.0 ? baseline.line.slope : 0.0;
    QuietRecord quiet{range, values.mean(), slope, {}};
    WindowedResponse &noise = quiet.noise;
    noise.sampleRate_Hz = channel.sampleRate_Hz;
    noise.noise = values.array() - quiet.level;
    const double resolution = resolutionOf(channel, range);
    const double sd = std::sqrt(noise.noise.squaredNorm() / static_cast<double>(values.size() - 1));
    noise.noiseSd = std::max(sd, resolution / std::sqrt(12.0));
    noise.roundingSd = lastingRounding(noiseBeforeRounding(noise.noise, resolution), resolution);
    return quiet;
}

Result<QuietRecord> quietRecord(
    const Channel &channel, Index shot, const std::optional<Interval> &quiet_s)
{
    Result<SampleRange> range = quietRange(channel, shot, quiet_s);
    if (!range)
        return tl::unexpected<Error>(range.error());
    range->begin = std::max(range->begin, range->end - kMostQuiet);
    const Eigen::VectorXd values = physicalValues(channel, range->begin, range->end - range->begin);
    return checkQuiet(values, channel, shot).map([&] { return quietOf(channel, *range, values); });
}

Result<SampleRange> windowRange(
    const Channel &channel, Index shot, const std::optional<Interval> &window_s)
{
    const SampleRange all{0, channel.samples.size()};
    const SampleRange range = window_s ? samplesIn(channel, *window_s) : all;
    const Index count = range.end - range.begin;
    if (count > 0 && count <= kMostCorrected)
        return range;
    return refusedRecord(
        DYNCAL_TEXT("core",
            "Shot %1: the stretch to be corrected has %2 samples of channel %3; it needs 1 to %4 (--window)."),
        {std::to_string(shot), std::to_string(count), channel.name,
            std::to_string(kMostCorrected)});
}

/// The samples from `first` on, `count` of them.
CorrectedPressure part(const CorrectedPressure &whole, Index first, Index count)
{
    CorrectedPressure kept = whole;
    kept.time_s += static_cast<double>(first) / whole.rate_Hz;
    for (const auto member : {&CorrectedPressure::pressure_Pa, &CorrectedPressure::u_response_Pa,
             &CorrectedPressure::bound_Pa, &CorrectedPressure::u_Pa, &CorrectedPressure::k})
        kept.*member = Eigen::VectorXd((whole.*member).segment(first, count));
    return kept;
}

/// What of the pressure lies in the window.
Result<CorrectedPressure> withinWindow(
    const CorrectedPressure &whole, const Channel &channel, const SampleRange &window)
{
    const auto at
        = static_cast<Index>(std::lround((whole.time_s - channel.t0_s) * channel.sampleRate_Hz));
    const Index first = std::max<Index>(window.begin - at, 0);
    const Index end = std::min(window.end - at, whole.pressure_Pa.size());
    if (end > first)
        return part(whole, first, end - first);
    return refusedRecord(
        DYNCAL_TEXT("core",
            "The window %1 to %2 lies where the filter would need samples beyond the ends of the recording; choose another (--window)."),
        {numberWithUnit(channel.timeOf_s(window.begin), "s"),
            numberWithUnit(channel.timeOf_s(window.end), "s")});
}

Result<CorrectedPressure> pressureIn(const Channel &channel, const SampleRange &window,
    const QuietRecord &quiet, const CorrectionFilter &filter, std::optional<double> beyond_Pa,
    const JobControl &control)
{
    const Index margin = kMarginInFilters * filter.taps.size();
    const Index begin = std::max<Index>(window.begin - margin, 0);
    const Index end = std::min(window.end + margin, channel.samples.size());
    const RecordedStretch stretch{
        physicalValues(channel, begin, end - begin).array() - quiet.level, channel.timeOf_s(begin)};
    return correctedPressure(stretch, NoiseDensity(quiet.noise), filter, beyond_Pa, control)
        .and_then(
            [&](const CorrectedPressure &whole) { return withinWindow(whole, channel, window); });
}

/// A zero that drifts before the pressure drifts on behind it, in no uncertainty.
Findings driftOf(const Channel &channel, Index shot, const QuietRecord &quiet,
    const CorrectedPressure &pressure, double gain)
{
    const double end_s
        = pressure.time_s + static_cast<double>(pressure.pressure_Pa.size() - 1) / pressure.rate_Hz;
    const double middle_s
        = 0.5 * (channel.timeOf_s(quiet.range.begin) + channel.timeOf_s(quiet.range.end));
    const double perSecond_Pa = quiet.slope * channel.sampleRate_Hz * gain;
    const double atEnd_Pa = perSecond_Pa * (end_s - middle_s);
    const Index last = pressure.u_Pa.size() - 1;
    const double U_Pa = pressure.k[last] * pressure.u_Pa[last];
    if (!(std::abs(atEnd_Pa) > U_Pa))
        return {};
    return {{.id = "COR-001",
        .severity = Severity::Caution,
        .shot = shot,
        .channel = channel.name,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1, channel %2: before the pressure the record drifts by %3 per ms; if it goes on so, the pressure at the end is off by %4, and its U there is %5. Take the drift off the recording, use an amplifier that does not drift, or correct a shorter stretch (--window)."),
            {std::to_string(shot), channel.name, numberWithUnit(1e-3 * perSecond_Pa, "Pa", 2),
                numberWithUnit(atEnd_Pa, "Pa", 2), numberWithUnit(U_Pa, "Pa", 2)}},
        .value = atEnd_Pa,
        .limit = U_Pa,
        .causes = {FindingCause::Drift}}};
}

tl::unexpected<Error> unreadable(const Channel &channel, Index shot)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "Shot %1: the samples of channel %2 cannot be read any more; leave the recording alone meanwhile."),
            {std::to_string(shot), channel.name}});
}

} // namespace

Result<RecordPressure> recordPressure(const Channel &channel, Index shot,
    const CorrectionFilter &filter, const RecordOptions &options, const JobControl &control)
{
    if (const Result<void> checked = checkChannel(channel, shot, filter); !checked)
        return tl::unexpected<Error>(checked.error());
    const Result<SampleRange> window = windowRange(channel, shot, options.window_s);
    const Result<QuietRecord> quiet = quietRecord(channel, shot, options.quiet_s);
    if (!channel.samples.isWhole())
        return unreadable(channel, shot);
    if (!window || !quiet)
        return tl::unexpected<Error>(window ? quiet.error() : window.error());
    Result<CorrectedPressure> pressure
        = pressureIn(channel, *window, *quiet, filter, options.beyond_Pa, control);
    if (!channel.samples.isWhole())
        return unreadable(channel, shot);
    return pressure.map([&](const CorrectedPressure &found) {
        return RecordPressure{found,
            {channel.timeOf_s(quiet->range.begin), channel.timeOf_s(quiet->range.end)},
            quiet->level, quiet->noise.noiseSd,
            driftOf(channel, shot, *quiet, found, filter.gain())};
    });
}

} // namespace dyncal
