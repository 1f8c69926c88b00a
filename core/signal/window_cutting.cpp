// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/window_cutting.h"

#include "core/base/number_text.h"
#include "core/signal/baseline_level.h"
#include "core/signal/level_statistics.h"
#include "core/signal/record_findings.h"
#include "core/signal/rounding.h"
#include "core/signal/standstill.h"
#include "core/signal/start_detection.h"
#include "core/signal/step_readings.h"
#include "core/signal/window_bands.h"
#include "core/signal/window_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dyncal {
namespace {

constexpr Index kMargin = 4096; ///< samples kept beside the bands, for filters

std::optional<Error> checkSettings(const CaptureSet &set, const WindowSettings &settings)
{
    const auto usage = [](Message message) {
        return Error{ErrorKind::Usage, std::move(message), {}, 0};
    };
    const auto starts = static_cast<Index>(settings.start_s.size());
    const auto shots = static_cast<Index>(set.shots.size());
    if (starts > 1 && starts != shots)
        return usage(
            {DYNCAL_TEXT("core",
                 "window.start lists %1 times for %2 shots; give one time or one per shot."),
                {std::to_string(starts), std::to_string(shots)}});
    bool finite = std::all_of(settings.start_s.begin(), settings.start_s.end(),
        [](double time_s) { return std::isfinite(time_s); });
    for (const Auto<Interval> &band : {settings.baseline_s, settings.settle_s}) {
        if (band.isAuto())
            continue;
        finite = finite && std::isfinite(band.value->length());
        if (finite && !(band.value->length() > 0.0))
            return usage(
                {DYNCAL_TEXT(
                     "core", "The band %1 to %2 in the window settings must begin before it ends."),
                    {numberWithUnit(band.value->begin, "s"),
                        numberWithUnit(band.value->end, "s")}});
    }
    const auto ends = static_cast<Index>(settings.ownEnds_s.size());
    if (ends > 0 && ends != shots && !settings.endAtPlateau)
        return usage({DYNCAL_TEXT("core",
                          "window.end_s lists %1 ends for %2 shots; give one end or one per shot."),
            {std::to_string(ends), std::to_string(shots)}});
    std::vector<Auto<double>> allEnds_s = settings.ownEnds_s;
    allEnds_s.push_back(settings.end_s);
    for (const Auto<double> &end_s : allEnds_s)
        finite = finite && (end_s.isAuto() || std::isfinite(*end_s.value));
    if (!finite)
        return usage(
            {DYNCAL_TEXT("core", "A time in the window settings is not a finite number."), {}});
    return std::nullopt;
}

/// Cuts the response of one shot.
class ShotWindow
{
public:
    ShotWindow(const Shot &shot, Index number, const WindowSettings &settings,
        const WindowContext &context, const JobControl &control)
        : m_shot(shot)
        , m_settings(settings)
        , m_context(context)
        , m_control(control)
    {
        m_response.shot = number;
        m_response.label = shot.label;
        m_response.level = shot.level;
    }

    /// Adds the response to the result, or only a finding where the baseline is not at rest.
    std::optional<Error> addTo(WindowResult &result)
    {
        if (auto error = findChannel())
            return error;
        if (auto error = findStart())
            return error;
        const Result<WindowBands> bands = resolveBands(*m_channel, m_response.shot,
            m_response.startSample, m_settings, m_context.treatment, plateau_s());
        if (!bands)
            return bands.error();
        m_bands = *bands;
        if (auto error = unusableSamples(*m_channel, m_response.shot, m_bands, m_context.checks))
            return error;
        const std::optional<Standstill> still = standstill(*m_channel, m_bands);
        if (auto error = still
                ? blockingStandstill(*m_channel, m_response.shot, *still, endIsSearched())
                : std::nullopt)
            return error;
        measureLevels();
        if (!m_isAtRest) {
            result.findings.push_back(notAtRest());
            return std::nullopt;
        }
        if (auto error = checkStep())
            return error;
        cutValues();
        measureCharacteristics();
        if (still)
            result.findings.push_back(standstillBehind(*m_channel, m_response.shot, *still));
        for (const Findings &findings :
            {windowFindings(m_response, m_settings, m_context, plateau_s()),
                recordFindings(m_response, *m_channel)})
            result.findings.insert(result.findings.end(), findings.begin(), findings.end());
        result.responses.push_back(std::move(m_response));
        return std::nullopt;
    }

    /// Another channel, over the bands of the DUT's response.
    Result<WindowedResponse> alongside(const Channel &channel, const WindowedResponse &dut)
    {
        m_channel = &channel;
        if (auto error = describeChannel())
            return tl::unexpected(*error);
        takeBands(dut);
        const Index size = channel.samples.size();
        if (m_bands.window.begin < 0 || m_bands.window.end > size || m_bands.settle.end > size
            || m_bands.baseline.begin < 0 || m_bands.baseline.size() < kLeastBaseline)
            return tl::unexpected(shorterThan(dut));
        if (auto error = unusableSamples(channel, m_response.shot, m_bands, m_context.checks))
            return tl::unexpected(*error);
        measureLevels();
        if (auto error = checkStep())
            return tl::unexpected(*error);
        cutValues();
        return std::move(m_response);
    }

private:
    SampleRange samplesOf(const Interval &band_s) const
    {
        const auto sample = [&](double time_s) {
            return m_response.startSample
                + static_cast<Index>(std::llround(time_s * m_response.sampleRate_Hz));
        };
        return {sample(band_s.begin), sample(band_s.end)};
    }

    void takeBands(const WindowedResponse &dut)
    {
        m_response.startSample = static_cast<Index>(
            std::llround((dut.start_s - m_channel->t0_s) * m_channel->sampleRate_Hz));
        m_response.start_s = m_channel->timeOf_s(m_response.startSample);
        m_bands = {samplesOf({0.0, dut.end_s}), samplesOf(dut.baseline_s), samplesOf(dut.settle_s)};
    }

    Error shorterThan(const WindowedResponse &dut) const
    {
        return error(
            {DYNCAL_TEXT("core",
                 "Shot %1: the record of channel %2, from %3 to %4, does not hold the baseline and the response of channel %5; record both over the same time, or shorten the window."),
                {std::to_string(m_response.shot), m_channel->name,
                    numberWithUnit(m_channel->t0_s, "s", 4),
                    numberWithUnit(m_channel->timeOf_s(m_channel->samples.size()), "s", 4),
                    dut.channel}},
            "");
    }

    bool isStep() const { return isStepTreatment(m_context.treatment); }

    bool endIsSearched() const
    {
        return isStep() && !m_settings.endAtPlateau
            && m_settings.endOfShot_s(m_response.shot).isAuto();
    }

    std::optional<double> plateau_s() const
    {
        const auto at = static_cast<std::size_t>(m_response.shot - 1);
        return at < m_context.plateau_s.size() ? m_context.plateau_s[at] : std::nullopt;
    }

    Error error(Message message, const char *id) const
    {
        return {ErrorKind::DataBlocked, std::move(message), id, m_response.shot};
    }

    std::optional<Error> findChannel()
    {
        const std::string number = std::to_string(m_response.shot);
        m_channel = m_shot.channelWithRole(ChannelRole::Dut);
        if (m_channel == nullptr)
            return error(
                {DYNCAL_TEXT("core",
                     "Shot %1 has no DUT channel; choose which channel is the sensor under test (import.channels)."),
                    {number}},
                "CAP-002");
        return describeChannel();
    }

    std::optional<Error> describeChannel()
    {
        const std::string number = std::to_string(m_response.shot);
        if (!(m_channel->sampleRate_Hz > 0.0) || !std::isfinite(m_channel->sampleRate_Hz))
            return error(
                {DYNCAL_TEXT("core",
                     "Shot %1: the sample rate of channel %2 is unknown; give import.sample_rate_hz."),
                    {number, m_channel->name}},
                "");
        m_response.channel = m_channel->name;
        m_response.unit = m_channel->unit;
        m_response.recordedUnit = m_channel->recordedUnit;
        m_response.sampleRate_Hz = m_channel->sampleRate_Hz;
        return std::nullopt;
    }

    Result<DetectedStart> detectedStart() const
    {
        const auto at = static_cast<std::size_t>(m_response.shot - 1);
        if (at < m_context.starts.size() && m_context.starts[at])
            return *m_context.starts[at];
        return detectStart(
            *m_channel, {m_control.stop, {}}, m_response.shot, m_context.checks.stepSigmas);
    }

    std::optional<Error> findStart()
    {
        m_response.startDetected = m_settings.start_s.empty();
        if (m_response.startDetected) {
            const Result<DetectedStart> start = detectedStart();
            if (!start)
                return start.error();
            m_response.startSample = start->sample;
            m_isAtRest = start->baselineAtRest;
        } else {
            const bool perShot = m_settings.start_s.size() > 1;
            const double typed_s
                = m_settings.start_s[perShot ? static_cast<std::size_t>(m_response.shot - 1) : 0];
            const double place = (typed_s - m_channel->t0_s) * m_channel->sampleRate_Hz;
            if (!(place > -0.5) || !(place < static_cast<double>(m_channel->samples.size()) - 0.5))
                return outsideRecord(typed_s);
            m_response.startSample = static_cast<Index>(std::llround(place));
        }
        m_response.start_s = m_channel->timeOf_s(m_response.startSample);
        return std::nullopt;
    }

    Error outsideRecord(double typed_s) const
    {
        return error(
            {DYNCAL_TEXT("core",
                 "Shot %1: window.start %2 lies outside the record, which reaches from %3 to %4."),
                {std::to_string(m_response.shot), numberWithUnit(typed_s, "s", 6),
                    numberWithUnit(m_channel->t0_s, "s", 6),
                    numberWithUnit(m_channel->timeOf_s(m_channel->samples.size()), "s", 6)}},
            "");
    }

    Interval secondsOf(const SampleRange &range) const
    {
        const auto start = m_response.startSample;
        return {static_cast<double>(range.begin - start) / m_response.sampleRate_Hz,
            static_cast<double>(range.end - start) / m_response.sampleRate_Hz};
    }

    void measureLevels()
    {
        m_response.resolution = resolutionOf(*m_channel, m_bands.window);
        const Eigen::VectorXd quiet
            = physicalValues(*m_channel, m_bands.baseline.begin, m_bands.baseline.size());
        if (quiet.size() > 0) {
            const BaselineLevel found
                = baselineLevel(quiet, m_bands.window.begin - m_bands.baseline.end + 1);
            m_response.baseline_s = secondsOf(m_bands.baseline);
            m_response.baseline = found.level;
            m_response.baselineVarianceFactor = found.varianceFactor;
            m_response.baselineSlope_per_s = found.line.slope * m_response.sampleRate_Hz;
            m_response.noiseSd = std::max(found.line.sd, m_response.resolution / std::sqrt(12.0));
            m_response.noise = withoutLine(quiet);
        }
        m_response.end_s = secondsOf(m_bands.window).end;
        if (isStep()) {
            const LineFit line
                = fitLine(physicalValues(*m_channel, m_bands.settle.begin, m_bands.settle.size()));
            m_response.settle_s = secondsOf(m_bands.settle);
            m_response.settled = line.mean;
            m_response.settleSlope_per_s = line.slope * m_response.sampleRate_Hz;
            m_response.step = m_response.settled - m_response.baseline;
        } else {
            const Eigen::ArrayXd excursion
                = physicalValues(*m_channel, m_bands.window.begin, m_bands.window.size()).array()
                - m_response.baseline;
            Index peak = 0;
            excursion.abs().maxCoeff(&peak);
            m_response.step = excursion[peak];
        }
        m_response.snr_dB = m_response.noiseSd > 0.0
            ? 20.0 * std::log10(std::abs(m_response.step) / m_response.noiseSd)
            : std::numeric_limits<double>::infinity();
        if (m_settings.baseline_s.isAuto())
            m_isAtRest = m_isAtRest && isAtRest(quiet, m_response.step, m_response.noiseSd);
    }

    Finding notAtRest() const
    {
        return {.id = "CAP-020",
            .severity = Severity::Block,
            .shot = m_response.shot,
            .channel = m_response.channel,
            .time_s = m_response.start_s,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1: the record moves before the response, its baseline is not at rest; the shot is not used. Exclude it, or set window.start and window.baseline_s by hand."),
                {std::to_string(m_response.shot)}}};
    }

    std::optional<Error> checkStep() const
    {
        double uncertainty = m_response.noiseSd;
        if (isStep())
            uncertainty *= std::sqrt(1.0 / static_cast<double>(m_bands.settle.size())
                + 1.0 / static_cast<double>(std::max<Index>(m_bands.baseline.size(), 1)));
        const double needed = m_context.checks.stepSigmas * uncertainty;
        if (!std::isfinite(needed) || !std::isfinite(m_response.step))
            return error(
                {DYNCAL_TEXT("core",
                     "Shot %1: whether there is a step cannot be told, because the record's values are not there or too large to compute with; check the channel's unit and factor, or exclude the shot."),
                    {std::to_string(m_response.shot)}},
                "CAP-009");
        if (std::abs(m_response.step) > needed)
            return std::nullopt;
        return error(
            {DYNCAL_TEXT("core",
                 "Shot %1: no step between baseline and settle band; it is %2, and %3 would be needed to tell it from noise. Check window.start or exclude the shot."),
                {std::to_string(m_response.shot),
                    numberWithUnit(m_response.step, m_response.unit, 3),
                    numberWithUnit(needed, m_response.unit, 3)}},
            "CAP-009");
    }

    void cutValues()
    {
        const SampleRange &window = m_bands.window;
        const Index size = m_channel->samples.size();
        Index begin = window.begin;
        if (m_bands.baseline.size() > 0)
            begin = std::min(begin, m_bands.baseline.begin);
        begin = std::max<Index>(std::min(begin, window.begin - kMargin), 0);
        const Index end = std::min(window.end + kMargin, size);

        Eigen::VectorXd values = physicalValues(*m_channel, begin, end - begin);
        const auto isInvalid = [](double value) { return !std::isfinite(value); };
        // Margins end at the first invalid sample: a filter must never reach it.
        const auto first = values.begin() + (window.begin - begin);
        const auto last = values.begin() + (window.end - begin);
        const Index head = std::find_if(std::make_reverse_iterator(first),
                               std::make_reverse_iterator(values.begin()), isInvalid)
                               .base()
            - values.begin();
        const Index tail = std::find_if(last, values.end(), isInvalid) - values.begin();

        m_response.valueScale = m_context.remap && isStep() ? m_response.step : 1.0;
        m_response.values = (values.segment(head, tail - head).array() - m_response.baseline)
            / m_response.valueScale;
        m_response.noise /= m_response.valueScale;
        const double resolution = std::abs(m_response.resolution / m_response.valueScale);
        m_response.roundingSd
            = lastingRounding(noiseBeforeRounding(m_response.noise, resolution), resolution);
        m_response.lead = window.begin - begin - head;
        m_response.length = window.size();
    }

    void measureCharacteristics()
    {
        if (!isStep())
            return;
        const Eigen::VectorXd relative
            = m_response.values * (m_response.valueScale / m_response.step);
        const StepReadings found = readStep(relative, m_response.lead, m_response.length,
            std::abs(m_response.noiseSd / m_response.step));
        if (found.rise_samples)
            m_response.riseTime_s = *found.rise_samples / m_response.sampleRate_Hz;
        if (found.overshoot)
            m_response.overshoot_percent = 100.0 * *found.overshoot;
        if (found.settling_samples)
            m_response.settlingTime_s = *found.settling_samples / m_response.sampleRate_Hz;
    }

    const Shot &m_shot;
    const WindowSettings &m_settings;
    const WindowContext &m_context;
    const JobControl &m_control;
    const Channel *m_channel = nullptr;
    bool m_isAtRest = true;
    WindowBands m_bands;
    WindowedResponse m_response;
};

/// Why no response is left.
Error nothingLeft(const WindowResult &result)
{
    if (result.findings.empty())
        return {ErrorKind::Usage, {DYNCAL_TEXT("core", "No shot is included."), {}}, {}, 0};
    const Finding &finding = result.findings.front();
    return {ErrorKind::DataBlocked, finding.message, finding.id, finding.shot};
}

} // namespace

Result<WindowResult> cutWindows(const CaptureSet &set, const WindowSettings &settings,
    const WindowContext &context, const JobControl &control)
{
    if (auto error = checkSettings(set, settings))
        return tl::unexpected(*error);
    WindowResult result;
    std::vector<Error> errors; // of every shot, so that nobody mends one only to be told the next
    const auto shots = static_cast<Index>(set.shots.size());
    for (Index i = 0; i < shots; ++i) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
        const Shot &shot = set.shots[static_cast<std::size_t>(i)];
        if (shot.included) {
            if (auto error = ShotWindow(shot, i + 1, settings, context, control).addTo(result))
                errors.push_back(std::move(*error));
        }
        control.report(static_cast<double>(i + 1) / static_cast<double>(shots));
    }
    if (!errors.empty())
        return tl::unexpected(asOneError(std::move(errors)));
    if (result.responses.empty())
        return tl::unexpected(nothingLeft(result));
    return result;
}

Result<WindowedResponse> cutAlongside(const Shot &shot, const Channel &channel,
    const WindowedResponse &dut, const CheckSettings &checks)
{
    const WindowSettings settings;
    const JobControl control;
    WindowContext context;
    context.checks = checks;
    return ShotWindow(shot, dut.shot, settings, context, control).alongside(channel, dut);
}

} // namespace dyncal
