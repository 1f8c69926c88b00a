// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_check.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

namespace dyncal {
namespace {

constexpr Index kRunAtRail = 3; ///< consecutive samples that count as saturation

/// One pass over a channel's raw values.
struct Survey
{
    double lowest = 0.0;
    double highest = 0.0;
    Index invalid = 0;
    Index firstInvalid = -1;
    Index longestTop = 0; ///< samples of the longest run at the highest value
    Index topBegin = -1;
    Index longestBottom = 0;
    Index bottomBegin = -1;
};

template <typename T>
bool isValid(T value)
{
    if constexpr (std::is_floating_point_v<T>)
        return std::isfinite(value);
    return true;
}

/// Longest run of one value, seen in order.
class RunLength
{
public:
    explicit RunLength(double level)
        : m_level(level)
    {
    }

    void see(double value, Index i)
    {
        m_run = value == m_level ? m_run + 1 : 0;
        if (m_run > m_longest) {
            m_longest = m_run;
            m_begin = i - m_run + 1;
        }
    }

    Index longest() const { return m_longest; }
    Index begin() const { return m_begin; }

private:
    double m_level;
    Index m_run = 0;
    Index m_longest = 0;
    Index m_begin = -1;
};

void findExtremes(const RawSamples &samples, Survey &survey)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    samples.visitBlocks(0, samples.size(), [&](auto values, Index first) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!isValid(values[i])) {
                if (survey.invalid++ == 0)
                    survey.firstInvalid = first + static_cast<Index>(i);
                continue;
            }
            low = std::min(low, static_cast<double>(values[i]));
            high = std::max(high, static_cast<double>(values[i]));
        }
    });
    const bool any = low <= high;
    survey.lowest = any ? low : 0.0;
    survey.highest = any ? high : 0.0;
}

Survey surveyOf(const RawSamples &samples)
{
    Survey survey;
    findExtremes(samples, survey);
    if (survey.lowest == survey.highest)
        return survey;
    RunLength top(survey.highest);
    RunLength bottom(survey.lowest);
    samples.visitBlocks(0, samples.size(), [&](auto values, Index first) {
        for (const auto value : values) {
            top.see(static_cast<double>(value), first);
            bottom.see(static_cast<double>(value), first++);
        }
    });
    survey.longestTop = top.longest();
    survey.topBegin = top.begin();
    survey.longestBottom = bottom.longest();
    survey.bottomBegin = bottom.begin();
    return survey;
}

class ChannelChecks
{
public:
    ChannelChecks(Findings &findings, Index shot, const Channel &channel)
        : m_findings(findings)
        , m_shot(shot)
        , m_channel(channel)
        , m_survey(surveyOf(channel.samples))
    {
    }

    void run()
    {
        const bool isDut = m_channel.role == ChannelRole::Dut;
        if (m_channel.samples.size() == 0 || m_survey.lowest == m_survey.highest) {
            add("CAP-008", isDut ? Severity::Block : Severity::Caution, {},
                {DYNCAL_TEXT("core",
                     "Channel '%1' of shot %2 is flat: all %3 samples are %4. Check cable and "
                     "role."),
                    {m_channel.name, std::to_string(m_shot),
                        std::to_string(m_channel.samples.size()),
                        numberWithUnit(
                            physicalValue(m_channel, m_survey.lowest), m_channel.unit)}});
            return;
        }
        if (!isDut)
            return;
        checkInvalid();
        // Without known rails a flat top of a recording is the only sign; noise-free data have
        // flat stretches of their own, but hardly at their extreme.
        if (!m_channel.adcMax || m_survey.highest >= *m_channel.adcMax)
            checkSaturation(m_survey.highest, m_survey.longestTop, m_survey.topBegin);
        if (!m_channel.adcMin || m_survey.lowest <= *m_channel.adcMin)
            checkSaturation(m_survey.lowest, m_survey.longestBottom, m_survey.bottomBegin);
    }

private:
    void checkInvalid()
    {
        if (m_survey.invalid == 0)
            return;
        const double time_s = m_channel.timeOf_s(m_survey.firstInvalid);
        add("CAP-006", Severity::Caution, time_s,
            {DYNCAL_TEXT("core",
                 "Shot %1, %2: %3 invalid samples, the first at %4 (sample %5). Inside the "
                 "response "
                 "window they block the shot; exclude it or set import.interpolate_invalid."),
                {std::to_string(m_shot), m_channel.name, std::to_string(m_survey.invalid),
                    numberWithUnit(time_s, "s", 6), std::to_string(m_survey.firstInvalid)}},
            static_cast<double>(m_survey.invalid));
    }

    void checkSaturation(double level, Index length, Index begin)
    {
        if (length < kRunAtRail)
            return;
        const double time_s = m_channel.timeOf_s(begin);
        add("CAP-007", Severity::Caution, time_s,
            {DYNCAL_TEXT("core",
                 "Shot %1, %2 is saturated for %3 at %4, from %5 on. Inside the response window "
                 "that "
                 "blocks the shot; use a wider range."),
                {std::to_string(m_shot), m_channel.name,
                    numberWithUnit(static_cast<double>(length) / m_channel.sampleRate_Hz, "s", 3),
                    numberWithUnit(physicalValue(m_channel, level), m_channel.unit),
                    numberWithUnit(time_s, "s", 6)}},
            static_cast<double>(length), static_cast<double>(kRunAtRail));
    }

    void add(const char *id, Severity severity, std::optional<double> time_s, Message message,
        std::optional<double> value = {}, std::optional<double> limit = {})
    {
        m_findings.push_back(
            {id, severity, m_shot, m_channel.name, time_s, std::move(message), value, limit});
    }

    Findings &m_findings;
    Index m_shot;
    const Channel &m_channel;
    Survey m_survey;
};

/// "100, 100, 50 MHz" in shot order.
std::string listOf(const std::vector<double> &values, const char *unit)
{
    std::string text;
    for (const double value : values)
        text.append(text.empty() ? "" : ", ").append(numberWithUnit(value, unit, 6));
    return text;
}

bool allEqual(const std::vector<double> &values)
{
    return std::all_of(values.begin(), values.end(),
        [&](double value) { return std::abs(value - values.front()) <= 1e-9 * values.front(); });
}

void compareShots(const CaptureSet &set, Findings &findings)
{
    std::vector<double> rates_Hz;
    std::vector<double> durations_s;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Channel *dut
            = set.shots[i].included ? set.shots[i].channelWithRole(ChannelRole::Dut) : nullptr;
        if (!dut)
            continue;
        rates_Hz.push_back(dut->sampleRate_Hz);
        durations_s.push_back(dut->duration_s());
        if (!dut->sha256.empty() && !seen.insert(dut->sha256).second) {
            findings.push_back(
                {"CAP-011", Severity::Caution, static_cast<Index>(i) + 1, dut->name, {},
                    {DYNCAL_TEXT(
                         "core", "Shot %1 holds the same data as a shot before it; exclude one."),
                        {std::to_string(i + 1)}},
                    {}, {}});
        }
    }
    if (rates_Hz.size() == 1) {
        findings.push_back({"CAP-017", Severity::Info, 0, {}, {},
            {DYNCAL_TEXT("core", "One shot: PCA is skipped and repeatability cannot be evaluated."),
                {}},
            1.0, 2.0});
        return;
    }
    if (!rates_Hz.empty() && !allEqual(rates_Hz)) {
        findings.push_back({"CAP-004", Severity::Caution, 0, {}, {},
            {DYNCAL_TEXT("core",
                 "Shots have different sample rates (%1). For PCA they are brought to %2; the "
                 "model "
                 "input resamples each from its own rate."),
                {listOf(rates_Hz, "Hz"),
                    numberWithUnit(*std::min_element(rates_Hz.begin(), rates_Hz.end()), "Hz", 6)}},
            {}, {}});
    }
    if (!durations_s.empty() && !allEqual(durations_s)) {
        findings.push_back({"CAP-005", Severity::Info, 0, {}, {},
            {DYNCAL_TEXT(
                 "core", "Shots have different lengths (%1); what all of them have is used."),
                {listOf(durations_s, "s")}},
            {}, {}});
    }
}

} // namespace

Findings checkCaptures(const CaptureSet &set)
{
    Findings findings;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Shot &shot = set.shots[i];
        const Index number = static_cast<Index>(i) + 1;
        if (!shot.included)
            continue;
        if (!shot.channelWithRole(ChannelRole::Dut)) {
            findings.push_back({"CAP-002", Severity::Block, number, {}, {},
                {DYNCAL_TEXT("core",
                     "Shot %1 has no DUT channel. Choose which channel is the sensor under test "
                     "(import.channels in the recipe)."),
                    {std::to_string(number)}},
                {}, {}});
        }
        for (const Channel &channel : shot.channels)
            ChannelChecks(findings, number, channel).run();
    }
    compareShots(set, findings);
    return findings;
}

} // namespace dyncal
