// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_check.h"

#include "core/base/number_text.h"
#include "core/capture/flat_top.h"
#include "core/capture/record_survey.h"
#include "core/capture/sensor_card.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace dyncal {
namespace {

/// Largest range of a flat record's values, in units of checks.flatCodes.
constexpr double kFlatRange = 8.0;

class ChannelChecks
{
public:
    ChannelChecks(
        Findings &findings, Index shot, const Channel &channel, const CheckSettings &settings)
        : m_findings(findings)
        , m_shot(shot)
        , m_channel(channel)
        , m_settings(settings)
        , m_survey(surveyRecord(channel.samples))
    {
    }

    void run()
    {
        if (!m_survey.readable) {
            addUnreadable();
        } else if (m_survey.invalid == m_survey.size) {
            addEmpty();
        } else if (m_survey.isConstant()) {
            addConstant();
        } else if (isFlat()) {
            addFlat();
        } else if (isDut()) {
            checkInvalid();
            checkSaturation(m_survey.top, m_channel.adcMax,
                m_channel.adcMax && m_survey.highest >= *m_channel.adcMax);
            checkSaturation(m_survey.bottom, m_channel.adcMin,
                m_channel.adcMin && m_survey.lowest <= *m_channel.adcMin);
        }
    }

private:
    bool isDut() const { return m_channel.role == ChannelRole::Dut; }

    /// A trigger's signal may be one code high; a sensor's is larger.
    bool isFlat() const
    {
        const bool isSensor = isDut() || m_channel.role == ChannelRole::DrivenSide
            || m_channel.role == ChannelRole::Driver;
        return isSensor && m_channel.samples.isInteger() && m_survey.sd < m_settings.flatCodes
            && m_survey.highest - m_survey.lowest <= kFlatRange * m_settings.flatCodes;
    }

    Severity ofFlat() const { return isDut() ? Severity::Block : Severity::Caution; }

    void addUnreadable()
    {
        m_findings.push_back({.id = "CAP-015",
            .severity = Severity::Block,
            .shot = m_shot,
            .channel = m_channel.name,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1, channel '%2': the samples cannot be read any more, because the file changed or is out of reach; open it again."),
                {std::to_string(m_shot), m_channel.name}}});
    }

    void addEmpty()
    {
        const char *none = DYNCAL_TEXT(
            "core", "Channel '%1' of shot %2 has no samples. Check the file and the role.");
        const char *invalid = DYNCAL_TEXT("core",
            "Channel '%1' of shot %2 has no valid sample: none of its %3 samples is a number. Check the file and the role.");
        m_findings.push_back({.id = "CAP-008",
            .severity = ofFlat(),
            .shot = m_shot,
            .channel = m_channel.name,
            .message = {m_survey.size == 0 ? none : invalid,
                {m_channel.name, std::to_string(m_shot), std::to_string(m_survey.size)}}});
    }

    void addConstant()
    {
        const char *all = DYNCAL_TEXT("core",
            "Channel '%1' of shot %2 is flat: all %3 samples are %4. Check cable and role.");
        const char *valid = DYNCAL_TEXT("core",
            "Channel '%1' of shot %2 is flat: all its valid samples (%3) are %4. Check cable and role.");
        const char *single = DYNCAL_TEXT("core",
            "Channel '%1' of shot %2 has a single valid sample, %4, which is no record. Check the file and the role.");
        const Index count = m_survey.size - m_survey.invalid;
        m_findings.push_back({.id = "CAP-008",
            .severity = ofFlat(),
            .shot = m_shot,
            .channel = m_channel.name,
            .message = {count == 1         ? single
                    : m_survey.invalid > 0 ? valid
                                           : all,
                {m_channel.name, std::to_string(m_shot), std::to_string(count),
                    numberWithUnit(physicalValue(m_channel, m_survey.lowest), m_channel.unit)}}});
    }

    void addFlat()
    {
        m_findings.push_back({.id = "CAP-008",
            .severity = ofFlat(),
            .shot = m_shot,
            .channel = m_channel.name,
            .message
            = {DYNCAL_TEXT("core",
                   "Channel '%1' of shot %2 is flat: its standard deviation is %3 codes of the converter (%4 is the limit). Check cable and role."),
                {m_channel.name, std::to_string(m_shot), numberText(m_survey.sd, 2),
                    numberText(m_settings.flatCodes, 3)}},
            .value = m_survey.sd,
            .limit = m_settings.flatCodes});
    }

    void checkInvalid()
    {
        if (m_survey.invalid == 0)
            return;
        const double time_s = m_channel.timeOf_s(m_survey.firstInvalid);
        m_findings.push_back({.id = "CAP-006",
            .severity = Severity::Caution,
            .shot = m_shot,
            .channel = m_channel.name,
            .time_s = time_s,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1, %2: %3 invalid samples from %4 on (samples %5 to %6). Inside the response window they block the shot; exclude it or set import.interpolate_invalid."),
                {std::to_string(m_shot), m_channel.name, std::to_string(m_survey.invalid),
                    numberWithUnit(time_s, "s", 6), std::to_string(m_survey.firstInvalid),
                    std::to_string(m_survey.lastInvalid)}},
            .value = static_cast<double>(m_survey.invalid)});
    }

    /// Where the converter's limits are known, only a run at a limit is saturation; inside the
    /// window it blocks. Where they are not, the window stage blocks a signal that stands still too
    /// long.
    void checkSaturation(const EqualRun &run, const std::optional<double> &rail, bool atRail)
    {
        if (run.count < m_settings.saturationRun)
            return;
        if (rail ? !atRail : !isCutOff(m_channel.samples, m_survey, run))
            return;
        const char *known = DYNCAL_TEXT("core",
            "Shot %1, %2 is saturated for %3 at %4, from %5 on. Inside the response window that blocks the shot; use a wider range.");
        const char *unknown = DYNCAL_TEXT("core",
            "Shot %1, %2 looks cut off for %3 at %4, from %5 on. More than 20 % of the response window like that blocks the shot; use a wider range.");
        const double time_s = m_channel.timeOf_s(run.begin);
        m_findings.push_back({.id = "CAP-007",
            .severity = Severity::Caution,
            .shot = m_shot,
            .channel = m_channel.name,
            .time_s = time_s,
            .message = {rail ? known : unknown,
                {std::to_string(m_shot), m_channel.name,
                    numberWithUnit(
                        static_cast<double>(run.count) / m_channel.sampleRate_Hz, "s", 3),
                    numberWithUnit(
                        physicalValue(m_channel, m_channel.samples.at(run.begin)), m_channel.unit),
                    numberWithUnit(time_s, "s", 6)}},
            .value = static_cast<double>(run.count),
            .limit = static_cast<double>(m_settings.saturationRun)});
    }

    Findings &m_findings;
    Index m_shot;
    const Channel &m_channel;
    const CheckSettings &m_settings;
    RecordSurvey m_survey;
};

const Channel *includedDut(const Shot &shot)
{
    return shot.included ? shot.channelWithRole(ChannelRole::Dut) : nullptr;
}

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

std::string inputNameOf(const CaptureSet &set, std::size_t shot)
{
    const auto input = static_cast<std::size_t>(set.shots[shot].input);
    return input < set.inputs.size() ? " (" + set.inputs[input].file + ")" : std::string();
}

/// CAP-011 for an included shot whose DUT recorded just what an earlier one did.
void checkTwins(const CaptureSet &set, Findings &findings)
{
    std::map<std::string, std::size_t> seen;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Channel *dut = includedDut(set.shots[i]);
        if (!dut || dut->sha256.empty())
            continue;
        const auto [first, isNew] = seen.emplace(dut->sha256, i);
        if (isNew)
            continue;
        findings.push_back({.id = "CAP-011",
            .severity = Severity::Caution,
            .shot = static_cast<Index>(i) + 1,
            .channel = dut->name,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1%2 and shot %3%4 hold identical data; a shot counted twice makes the scatter look smaller than it is. Exclude one of them."),
                {std::to_string(first->second + 1), inputNameOf(set, first->second),
                    std::to_string(i + 1), inputNameOf(set, i)}}});
    }
}

void compareShots(const CaptureSet &set, Findings &findings)
{
    std::vector<double> rates_Hz;
    std::vector<double> durations_s;
    for (const Shot &shot : set.shots) {
        if (const Channel *dut = includedDut(shot)) {
            rates_Hz.push_back(dut->sampleRate_Hz);
            durations_s.push_back(dut->duration_s());
        }
    }
    if (rates_Hz.size() == 1) {
        findings.push_back({.id = "CAP-017",
            .severity = Severity::Info,
            .message = {DYNCAL_TEXT("core",
                            "One shot: PCA is skipped and repeatability cannot be evaluated."),
                {}},
            .value = 1.0,
            .limit = 2.0});
        return;
    }
    if (!rates_Hz.empty() && !allEqual(rates_Hz)) {
        findings.push_back({.id = "CAP-004",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "Shots have different sample rates (%1). For PCA they are brought to %2; the model input resamples each from its own rate."),
                {listOf(rates_Hz, "Hz"),
                    numberWithUnit(
                        *std::min_element(rates_Hz.begin(), rates_Hz.end()), "Hz", 6)}}});
    }
    if (!durations_s.empty() && !allEqual(durations_s)) {
        findings.push_back({.id = "CAP-005",
            .severity = Severity::Info,
            .message = {DYNCAL_TEXT("core",
                            "Shots have different lengths (%1); what all of them have is used."),
                {listOf(durations_s, "s")}}});
    }
}

} // namespace

Findings checkCaptures(const CaptureSet &set, const CheckSettings &settings)
{
    Findings findings;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Shot &shot = set.shots[i];
        const Index number = static_cast<Index>(i) + 1;
        if (!shot.included)
            continue;
        if (!shot.channelWithRole(ChannelRole::Dut)) {
            findings.push_back({.id = "CAP-002",
                .severity = Severity::Block,
                .shot = number,
                .message
                = {DYNCAL_TEXT("core",
                       "Shot %1 has no DUT channel. Choose which channel is the sensor under test (import.channels in the recipe)."),
                    {std::to_string(number)}}});
        }
        for (const Channel &channel : shot.channels)
            ChannelChecks(findings, number, channel, settings).run();
    }
    checkTwins(set, findings);
    std::ranges::move(checkOneSensor(set), std::back_inserter(findings));
    compareShots(set, findings);
    return findings;
}

} // namespace dyncal
