// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/window_bands.h"

#include "core/base/number_text.h"
#include "core/signal/automatic_length.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {
namespace {

constexpr Index kLongestBaseline = 20000;
constexpr Index kLeastGuard = 5, kLargestGuard = 1000, kGuardShare = 20;
constexpr double kSettleBegin = 0.6, kSettleEnd = 0.95; ///< of the window

std::string secondsText(double time_s)
{
    return numberWithUnit(time_s, "s", 6);
}

/// Finds the parts of one record one after the other: each needs the ones before.
class BandFinder
{
public:
    BandFinder(const Channel &channel, Index shot, Index start, const WindowSettings &settings,
        ResponseTreatment treatment)
        : m_channel(channel)
        , m_shot(shot)
        , m_start(start)
        , m_settings(settings)
        , m_treatment(treatment)
    {
    }

    Result<WindowBands> run(std::optional<double> plateau_s)
    {
        if (auto error = findBaseline())
            return tl::unexpected(*error);
        if (auto error = findWindow(plateau_s))
            return tl::unexpected(*error);
        if (auto error = findSettle())
            return tl::unexpected(*error);
        return m_bands;
    }

private:
    Index size() const { return m_channel.samples.size(); }
    double timeOf_s(Index sample) const
    {
        return static_cast<double>(sample - m_start) / m_channel.sampleRate_Hz;
    }
    /// Nearest sample, also outside the record; clamped where the number would overflow.
    Index sampleAt(double time_s) const
    {
        const double limit = 2.0 * static_cast<double>(size());
        const double offset = std::clamp(time_s * m_channel.sampleRate_Hz, -limit, limit);
        return m_start + static_cast<Index>(std::llround(offset));
    }
    SampleRange samplesOf(const Interval &band_s) const
    {
        return {sampleAt(band_s.begin), sampleAt(band_s.end)};
    }

    std::optional<Error> findBaseline()
    {
        if (!m_settings.subtractBaseline)
            return std::nullopt;
        if (m_settings.baseline_s.isAuto()) {
            const Index guard = std::clamp(m_start / kGuardShare, kLeastGuard, kLargestGuard);
            const Index end = std::max<Index>(m_start - guard, 0);
            m_bands.baseline = {std::max<Index>(end - kLongestBaseline, 0), end};
        } else {
            m_bands.baseline = samplesOf(*m_settings.baseline_s.value);
        }
        const SampleRange &band = m_bands.baseline;
        if (band.begin < 0 || band.end > size())
            return outsideRecord();
        if (band.size() < kLeastBaseline)
            return shortBaseline();
        if (band.begin < m_start && band.end > m_start)
            return overlap();
        return std::nullopt;
    }

    std::optional<Error> findWindow(std::optional<double> plateau_s)
    {
        if (m_settings.endAtPlateau && !plateau_s)
            return Error{ErrorKind::DataBlocked,
                {DYNCAL_TEXT("core",
                     "Shot %1: the window is to end with the computed plateau, but there are no shock data to compute it from; give them or a time for window.end_s."),
                    {std::to_string(m_shot)}},
                {}, m_shot};
        const Index limit = size() - m_start;
        const Auto<double> end_s = m_settings.endOfShot_s(m_shot);
        Index length = 0;
        if (m_settings.endAtPlateau)
            length = std::min(sampleAt(*plateau_s) - m_start, limit);
        else if (end_s.isAuto())
            length = plateau_s ? std::min(automaticLength(), sampleAt(*plateau_s) - m_start)
                               : automaticLength();
        else
            length = sampleAt(*end_s.value) - m_start;
        if (length > limit)
            return beyondRecord(length);
        if (length < kLeastWindow)
            return shortWindow(length);
        m_bands.window = {m_start, m_start + length};
        if (m_bands.baseline.size() > 0 && m_bands.baseline.overlaps(m_bands.window))
            return overlap();
        return std::nullopt;
    }

    Index automaticLength() const
    {
        const SampleRange &band = m_bands.baseline;
        const bool lateBaseline = band.size() > 0 && band.begin >= m_start;
        const Index limit = (lateBaseline ? band.begin : size()) - m_start;
        const LineFit line
            = fitLine(finiteOnly(physicalValues(m_channel, band.begin, band.size())));
        const double code = countSize(m_channel, m_channel.samples.at(m_start));
        const double noiseSd = std::max(line.sd, code / std::sqrt(12.0));
        if (isStepTreatment(m_treatment))
            return automaticStepLength(m_channel, m_start, limit, line.mean, noiseSd);
        if (band.size() == 0)
            return limit; // without a baseline the level to decay to is not known
        return automaticDecayLength(m_channel, m_start, limit, line.mean, noiseSd);
    }

    std::optional<Error> findSettle()
    {
        if (!isStepTreatment(m_treatment))
            return std::nullopt;
        const auto length = static_cast<double>(m_bands.window.size());
        if (m_settings.settle_s.isAuto())
            m_bands.settle = {m_start + static_cast<Index>(kSettleBegin * length),
                m_start + static_cast<Index>(kSettleEnd * length)};
        else
            m_bands.settle = samplesOf(*m_settings.settle_s.value);
        const SampleRange &band = m_bands.settle;
        if (band.begin >= m_start && band.end <= m_bands.window.end && band.size() >= 1)
            return std::nullopt;
        return Error{ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1: the settle band %2 to %3 must lie within the window, 0 to %4 behind the start; move window.settle_s or window.end_s."),
                {std::to_string(m_shot), secondsText(timeOf_s(band.begin)),
                    secondsText(timeOf_s(band.end)), secondsText(timeOf_s(m_bands.window.end))}},
            {}, m_shot};
    }

    Error outsideRecord() const
    {
        // As typed: samples far outside the record are not told apart.
        const Interval asked = m_settings.baseline_s.value.value_or(
            Interval{timeOf_s(m_bands.baseline.begin), timeOf_s(m_bands.baseline.end)});
        return {ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1: the baseline %2 to %3 leaves the record, which reaches from %4 to %5 relative to the start; move window.baseline_s."),
                {std::to_string(m_shot), secondsText(asked.begin), secondsText(asked.end),
                    secondsText(timeOf_s(0)), secondsText(timeOf_s(size()))}},
            "WIN-002", m_shot};
    }

    Error shortBaseline() const
    {
        return {ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1: the baseline has %2 samples and needs at least %3; choose another window.baseline_s, or null to subtract nothing."),
                {std::to_string(m_shot), std::to_string(m_bands.baseline.size()),
                    std::to_string(kLeastBaseline)}},
            "WIN-002", m_shot};
    }

    Error overlap() const
    {
        return {ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1: the baseline %2 to %3 overlaps the response, which begins at 0; move window.baseline_s or window.end_s."),
                {std::to_string(m_shot), secondsText(timeOf_s(m_bands.baseline.begin)),
                    secondsText(timeOf_s(m_bands.baseline.end))}},
            "WIN-002", m_shot};
    }

    Error beyondRecord(Index length) const
    {
        return {ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1 ends %2 behind its start, before the window's end at %3; set window.end_s to %2 at most or exclude the shot."),
                {std::to_string(m_shot), secondsText(timeOf_s(size())),
                    secondsText(timeOf_s(m_start + length))}},
            {}, m_shot};
    }

    Error shortWindow(Index length) const
    {
        return {ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1: the window has %2 samples and needs at least %3; set window.end_s."),
                {std::to_string(m_shot), std::to_string(length), std::to_string(kLeastWindow)}},
            {}, m_shot};
    }

    const Channel &m_channel;
    Index m_shot;
    Index m_start;
    const WindowSettings &m_settings;
    ResponseTreatment m_treatment;
    WindowBands m_bands;
};

} // namespace

Result<WindowBands> resolveBands(const Channel &channel, Index shot, Index start,
    const WindowSettings &settings, ResponseTreatment treatment, std::optional<double> plateau_s)
{
    return BandFinder(channel, shot, start, settings, treatment).run(plateau_s);
}

} // namespace dyncal
