// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/start_detection.h"

#include "core/base/number_text.h"
#include "core/signal/event_search.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kLeastSamples = 64;
constexpr double kLeastSigmas = 4.0; ///< that even a clear change of level must exceed; less, and
                                     ///< the samples before it are no baseline
constexpr double kBurstRatio = 2.0; ///< least ratio of a burst's height to the drift
constexpr Index kLeastQuiet = 32; ///< samples before the start, to know what quiet means
constexpr Index kQuietStretch = 20000; ///< samples before the start that are looked at
constexpr Index kSlowBlocks = 64; ///< a response may take this long to rise or to reach its height
constexpr double kFirstThreshold = 0.05; ///< of the height, before the baseline is known well
constexpr double kLeastThreshold = 0.005; ///< of the height: vibration that arrives before the
                                          ///< shock through the wall is not the response
constexpr int kPasses = 4;
constexpr double kLargestBefore = 0.65; ///< of the height; more before: the tail of a decay
constexpr double kLeastNoise = 1e-9; ///< of the height: keeps stepToNoise finite without noise
constexpr double kWanderFactor = 3.0; ///< threshold over the baseline's movement
constexpr Index kSupport = 8; ///< samples of which half must lie beyond the threshold
constexpr Index kLongestAverage = 64;
constexpr double kAverageShare = 0.2; ///< largest threshold, of the height

/// What the record is like before a sample.
struct Quiet
{
    double level = 0.0;
    double noiseSd = 0.0;
    double wander = 0.0; ///< how far the level moves from one piece to the next
    double drift = 0.0; ///< per sample
    Index samples = 0; ///< valid ones that this was taken from
    Index age = 0; ///< samples from the middle of that piece to the end
};

/// Level of the last of eight pieces, and how much the eight differ.
Quiet levelOfLastPiece(const Eigen::VectorXd &values)
{
    const Index piece = std::clamp<Index>(values.size() / 8, 8, 1024);
    const Index pieces = std::min<Index>(values.size() / piece, 8);
    Quiet quiet;
    double squares = 0.0;
    for (Index i = 0; i < pieces; ++i) {
        const double level = median(values.segment(values.size() - (pieces - i) * piece, piece));
        squares += i > 0 ? (level - quiet.level) * (level - quiet.level) : 0.0;
        quiet.level = level;
    }
    quiet.age = piece / 2;
    quiet.wander = std::sqrt(squares / static_cast<double>(std::max<Index>(pieces - 1, 1)));
    return quiet;
}

Quiet quietBefore(const Channel &channel, Index end)
{
    const Index count = std::min(end, kQuietStretch);
    const Eigen::VectorXd values = finiteOnly(physicalValues(channel, end - count, count));
    Quiet quiet = levelOfLastPiece(values);
    quiet.samples = values.size();
    quiet.drift = std::abs(fitLine(values).slope);
    const double code = countSize(channel, channel.samples.at(end - 1));
    quiet.noiseSd = std::max(robustNoiseSd(values, std::clamp<Index>(values.size() / 8, 16, 1024)),
        code / std::sqrt(12.0));
    return quiet;
}

/// How far a sample (or the mean of `average` samples from it on) must be from the level.
struct Crossing
{
    double level = 0.0;
    double threshold = 0.0;
    Index average = 1;
};

/// Marks the samples of [0, count) that lie beyond the threshold; `values` has the samples after
/// them that the average needs.
Eigen::Array<bool, Eigen::Dynamic, 1> beyond(
    const Eigen::VectorXd &values, Index count, const Crossing &crossing)
{
    Eigen::Array<bool, Eigen::Dynamic, 1> marks(count);
    for (Index i = 0; i < count; ++i) {
        const Index length = std::min(crossing.average, values.size() - i);
        const double distance = std::abs(values.segment(i, length).mean() - crossing.level);
        marks[i] = distance > crossing.threshold; // false for invalid samples
    }
    return marks;
}

/// Walks back from `event` as long as no more than `gap` samples in a row are quiet; a sample
/// counts as moving if it and half of the samples after it lie beyond the threshold.
Index walkBack(const Channel &channel, Index event, const Crossing &crossing, Index gap)
{
    constexpr Index kChunk = 8192;
    const Index size = channel.samples.size();
    Index earliest = event;
    for (Index end = event; end > 0;) {
        const Index begin = std::max<Index>(end - kChunk, 0);
        const Index marked = std::min(end + kSupport, size) - begin;
        const Index loaded = std::min(begin + marked + crossing.average, size) - begin;
        const auto marks = beyond(physicalValues(channel, begin, loaded), marked, crossing);
        for (Index i = end - 1; i >= begin; --i) {
            const Index at = i - begin, span = std::min(kSupport, marked - at);
            if (marks[at] && 2 * marks.segment(at, span).count() >= span)
                earliest = i;
            else if (earliest - i > gap)
                return earliest;
        }
        end = begin;
    }
    return earliest;
}

/// First sample of [begin, end) that is at least half the height away from the level.
Index firstHalfHeight(const Channel &channel, Index begin, Index end, const Crossing &half)
{
    const Index loaded = std::min(end + half.average, channel.samples.size()) - begin;
    const auto marks = beyond(physicalValues(channel, begin, loaded), end - begin, half);
    for (Index i = 0; i < marks.size(); ++i) {
        const Index span = std::min(kSupport / 2, marks.size() - i);
        if (marks[i] && 2 * marks.segment(i, span).count() >= span)
            return begin + i;
    }
    return end - 1;
}

/// What a change must exceed to be told from what comes before it.
struct Needed
{
    double height = 0.0;
    double factor = 0.0; ///< times the noise, or times what the drift explains
    double explained = 0.0; ///< the noise, or what the drift gives
    bool byDrift = false;
};

Error noStepFound(const Channel &channel, Index shot, double height, const Needed &needed)
{
    if (!std::isfinite(height) || !std::isfinite(needed.height))
        return {ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1, channel %2: no step found, because the record's values are not there or too large to compute with; check the channel's unit and factor, or exclude the shot."),
                {std::to_string(shot), channel.name}},
            "CAP-009", shot};
    const char *noise = DYNCAL_TEXT("core",
        "Shot %1, channel %2: no step found. The largest change is %3, and more than %4 is needed, %5 times the noise of %6: set window.start by hand or exclude the shot.");
    const char *drift = DYNCAL_TEXT("core",
        "Shot %1, channel %2: no step found. The largest change is %3, and more than %4 is needed, %5 times the %6 that the record drifts in the same time: set window.start by hand or exclude the shot.");
    return {ErrorKind::DataBlocked,
        {needed.byDrift ? drift : noise,
            {std::to_string(shot), channel.name, numberWithUnit(height, channel.unit, 3),
                numberWithUnit(needed.height, channel.unit, 3), numberText(needed.factor),
                numberWithUnit(needed.explained, channel.unit, 3)}},
        "CAP-009", shot};
}

Error noQuiet(const Channel &channel, Index shot, Index start)
{
    return {ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "Shot %1, channel %2: the start cannot be detected, because the record moves or holds no numbers from sample %3 (%4) on and at least %5 quiet samples are needed before. Set window.start by hand."),
            {std::to_string(shot), channel.name, std::to_string(start),
                numberWithUnit(channel.timeOf_s(start), "s", 6), std::to_string(kLeastQuiet)}},
        "CAP-009", shot};
}

Error tooShort(const Channel &channel, Index shot)
{
    return {ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "Shot %1, channel %2: the start cannot be detected in %3 samples, at least %4 are needed. Set window.start by hand."),
            {std::to_string(shot), channel.name, std::to_string(channel.samples.size()),
                std::to_string(kLeastSamples)}},
        "CAP-009", shot};
}

Error nothingValid(const Channel &channel, Index shot)
{
    return {ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "Shot %1, channel %2: there are no valid samples to find a start in; exclude the shot."),
            {std::to_string(shot), channel.name}},
        "CAP-009", shot};
}

/// Samples that are left out between the quiet stretch and a start: a response may begin too softly
/// to be seen.
Index guardBefore(Index start)
{
    return std::clamp<Index>(start / 20, 5, 1000);
}

/// Everything known of the event while its start is being narrowed down.
class StartSearch
{
public:
    StartSearch(const Channel &channel, const BlockScan &scan, Index shot, double eventSigmas)
        : m_channel(channel)
        , m_scan(scan)
        , m_shot(shot)
        , m_eventSigmas(eventSigmas)
        , m_event(findEvent(scan))
        , m_begin(std::max<Index>(m_event.block - 2, 0) * scan.blockSize)
        , m_end(std::min((m_event.block + 2) * scan.blockSize, channel.samples.size()))
    {
    }

    Result<DetectedStart> run()
    {
        // The quiet stretch must end before a response that rises slowly to its steepest place.
        const Index slow = std::min(m_begin / 4, kSlowBlocks * m_scan.blockSize);
        Index quietEnd = std::max(m_begin - slow, kLeastQuiet);
        m_quiet = quietBefore(m_channel, quietEnd);
        if (m_quiet.samples < kLeastQuiet)
            return tl::unexpected(noQuiet(m_channel, m_shot, m_begin));
        m_height = height();
        if (!isEvent(quietEnd))
            return tl::unexpected(noStep(quietEnd));
        narrow(kFirstThreshold * m_height);
        for (int pass = 0; pass < kPasses; ++pass) {
            quietEnd = m_start - guardBefore(m_start);
            if (quietEnd < kLeastQuiet)
                return tl::unexpected(noQuiet(m_channel, m_shot, m_start));
            m_quiet = quietBefore(m_channel, quietEnd);
            if (m_quiet.samples < kLeastQuiet)
                return tl::unexpected(noQuiet(m_channel, m_shot, m_start));
            const Index before = m_start;
            narrow(std::max(kWanderFactor * m_quiet.wander, kLeastThreshold * m_height));
            if (m_start == before)
                break;
        }
        if (!isEvent(quietEnd))
            return tl::unexpected(noStep(quietEnd));
        return found(quietEnd);
    }

private:
    Error noStep(Index quietEnd) const
    {
        return noStepFound(m_channel, m_shot, m_height, needed(quietEnd));
    }

    double height() const
    {
        const Eigen::VectorXd values
            = withoutSpikes(physicalValues(m_channel, m_begin, m_end - m_begin));
        const double near = largestDistance(values, m_quiet.level);
        if (!m_event.isSignificant)
            return near;
        const Index blocks = std::min(kSlowBlocks, m_scan.level.size() - m_event.block);
        const auto later = m_scan.level.segment(m_event.block, blocks).array();
        return std::max(near, (later - m_quiet.level).abs().maxCoeff());
    }

    /// A clear change of level must only stand out of the noise before it; a burst also out of what
    /// the record drifts.
    Needed needed(Index quietEnd) const
    {
        const double sigmas = m_event.isSignificant ? kLeastSigmas : m_eventSigmas;
        const Needed byNoise{sigmas * m_quiet.noiseSd, sigmas, m_quiet.noiseSd, false};
        const double drift = m_quiet.drift * static_cast<double>(m_end - quietEnd + m_quiet.age);
        const Needed byDrift{kBurstRatio * drift, kBurstRatio, drift, true};
        return !m_event.isSignificant && byDrift.height > byNoise.height ? byDrift : byNoise;
    }

    bool isEvent(Index quietEnd) const { return m_height > needed(quietEnd).height; }

    void narrow(double leastThreshold)
    {
        // Where single samples are too noisy, means of several must cross.
        const double needed = kStartSigmas * m_quiet.noiseSd / (kAverageShare * m_height);
        const auto average = static_cast<Index>(
            std::clamp(std::ceil(needed * needed), 1.0, static_cast<double>(kLongestAverage)));
        m_threshold = std::max(leastThreshold,
            kStartSigmas * m_quiet.noiseSd / std::sqrt(static_cast<double>(average)));
        const Index event
            = firstHalfHeight(m_channel, m_begin, m_end, {m_quiet.level, 0.5 * m_height, average});
        const Index gap = std::clamp<Index>(m_scan.blockSize, 16, 512);
        m_start = walkBack(m_channel, event, {m_quiet.level, m_threshold, average}, gap);
        // A mean crosses as soon as the step fills a share of its samples; the start lies after the
        // others.
        const double share = std::max(1.0 - m_threshold / m_height, 0.0);
        const auto shift = static_cast<Index>(static_cast<double>(average - 1) * share);
        m_start = std::min(m_start + shift, event);
    }

    Result<DetectedStart> found(Index quietEnd) const
    {
        const Index count = std::min(quietEnd, kQuietStretch);
        const Eigen::VectorXd before
            = finiteOnly(physicalValues(m_channel, quietEnd - count, count));
        if (largestDistance(withoutSpikes(withoutLine(before)), 0.0) >= kLargestBefore * m_height)
            return tl::unexpected(noQuiet(m_channel, m_shot, 0));
        return DetectedStart{m_start, m_channel.timeOf_s(m_start), m_threshold, m_quiet.level,
            m_quiet.noiseSd, m_height / std::max(m_quiet.noiseSd, kLeastNoise * m_height),
            isAtRest(before, m_height, m_quiet.noiseSd)};
    }

    const Channel &m_channel;
    const BlockScan &m_scan;
    Index m_shot;
    double m_eventSigmas;
    Event m_event;
    Index m_begin, m_end; ///< samples within which the event happens
    Index m_start = 0;
    double m_height = 0.0;
    double m_threshold = 0.0;
    Quiet m_quiet;
};

} // namespace

Result<DetectedStart> detectStart(
    const Channel &channel, const JobControl &control, Index shot, double eventSigmas)
{
    if (channel.samples.size() < kLeastSamples)
        return tl::unexpected(tooShort(channel, shot));
    const Result<BlockScan> scan = scanBlocks(channel, control);
    if (!scan)
        return tl::unexpected(scan.error());
    if (!scan->anyValid)
        return tl::unexpected(nothingValid(channel, shot));
    return StartSearch(channel, *scan, shot, eventSigmas).run();
}

std::optional<double> crossingTime_s(const Channel &channel, double level, Index from)
{
    constexpr Index kChunk = 8192;
    const Index size = channel.samples.size();
    for (Index begin = std::max<Index>(from, 0); begin + 1 < size; begin += kChunk - 1) {
        const Eigen::VectorXd values
            = physicalValues(channel, begin, std::min(kChunk, size - begin));
        for (Index i = 0; i + 1 < values.size(); ++i) {
            const double before = values[i] - level, behind = values[i + 1] - level;
            if (before == 0.0)
                return channel.timeOf_s(begin + i);
            if ((before < 0.0) != (behind < 0.0) && std::isfinite(before - behind))
                return channel.timeOf_s(begin + i)
                    + before / (before - behind) / channel.sampleRate_Hz;
        }
    }
    return std::nullopt;
}

} // namespace dyncal
