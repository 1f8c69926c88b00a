// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms.h"

#include "core/base/number_text.h"
#include "core/capture/formats/tdms/tdms_samples.h"
#include "core/capture/formats/tdms/tdms_shots.h"
#include "core/capture/formats/text/time_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

namespace dyncal {
namespace {

/// Whether a property only tells how to read the samples; such are no notes.
bool isTechnical(const std::string &name)
{
    constexpr std::array<std::string_view, 4> kPrefixes{"NI_", "wf_", "DAQmx_", "unit"};
    return std::any_of(kPrefixes.begin(), kPrefixes.end(),
        [&](std::string_view prefix) { return name.starts_with(prefix); });
}

/// Attributes worth keeping, under the names that other formats have for them.
void keepNotes(const TdmsObject *object, Attributes &notes)
{
    constexpr std::size_t kLongest = 1000;
    constexpr std::size_t kMost = 100;
    static const std::map<std::string, std::string, std::less<>> kNames{{"Author", "operator"},
        {"author", "operator"}, {"Operator", "operator"}, {"Description", "comment"},
        {"description", "comment"}};
    if (object == nullptr)
        return;
    for (const auto &[name, value] : object->properties) {
        const std::string text = valueText(value);
        if (isTechnical(name) || text.empty() || text.size() > kLongest || notes.size() >= kMost)
            continue;
        const auto known = kNames.find(name);
        notes[known != kNames.end() ? known->second : name] = text;
    }
}

void keepStart(const TdmsProperties &properties, Attributes &notes)
{
    const auto start = timestampOf(properties, "wf_start_time");
    const std::string text = start ? isoText(*start) : std::string();
    if (text.empty() || notes.contains("start_utc"))
        return;
    notes["start_utc"] = text;
    notes["start_1904"] = std::to_string(start->seconds) + " s + " + std::to_string(start->fraction)
        + " / 2^64 s"; // with all its digits
}

/// Seconds per unit of the waveform's increment and start: they are in seconds unless something
/// else is said. Empty if it is no time.
std::optional<double> waveformUnit_s(const TdmsProperties &properties)
{
    const std::string unit = textOf(properties, "wf_xunit_string");
    if (!unit.empty())
        return secondsPerUnit(unit);
    return isFrequencyTitle({textOf(properties, "wf_xname"), {}}) ? std::nullopt
                                                                  : std::optional(1.0);
}

/// The increment is a rounded decimal or reciprocal, so a rate has no more than 15 digits.
double sampleRateOf(const TdmsProperties &properties, double unit_s)
{
    constexpr int kDigits = 15;
    const double step_s = unit_s * numberOf(properties, "wf_increment").value_or(0.0);
    const double rate_Hz = step_s > 0.0 ? 1.0 / step_s : 0.0;
    if (!std::isfinite(rate_Hz))
        return 0.0;
    return parseNumber(numberText(rate_Hz, kDigits)).value_or(rate_Hz);
}

class TdmsReader
{
public:
    TdmsReader(const std::string &path, const TdmsContents &contents)
        : m_path(path)
        , m_contents(contents)
        , m_records(contents.file)
    {
    }

    Result<CaptureSet> read()
    {
        TdmsShots plan = tdmsShots(m_contents, m_path);
        m_set.findings = std::move(plan.findings);
        for (const TdmsShotPlan &shot : plan.shots)
            addShot(shot);
        if (m_set.shots.empty())
            return tl::unexpected(nothingRead());
        findDamage();
        findMissingRates();
        return std::move(m_set);
    }

private:
    void addShot(const TdmsShotPlan &plan)
    {
        Shot shot;
        shot.label = std::filesystem::path(m_path).stem().string();
        if (!plan.name.empty())
            shot.label.append(", ").append(plan.name);
        std::map<std::string, int> names;
        for (const TdmsObject *object : plan.channels)
            ++names[object->path.channel];
        keepNotes(m_contents.root(), shot.notes);
        if (!plan.channels.empty())
            keepNotes(m_contents.group(plan.channels.front()->path.group), shot.notes);
        for (const TdmsObject *object : plan.channels) {
            const std::string name = names[object->path.channel] == 1
                ? object->path.channel
                : object->path.group + "/" + object->path.channel;
            addChannels(*object, name, shot);
        }
        if (!shot.channels.empty())
            m_set.shots.push_back(std::move(shot));
    }

    void addChannels(const TdmsObject &object, const std::string &name, Shot &shot)
    {
        if (object.streams.empty() || object.count == 0) {
            const char *text = object.count == 0
                ? DYNCAL_TEXT("core", "Channel %1 has no samples.")
                : DYNCAL_TEXT("core", "Channel %1 has values of the type %2, no samples.");
            return leaveOut({text, {name, tdmsTypeName(object.type)}}, Severity::Info);
        }
        const TdmsObject *root = m_contents.root();
        const TdmsObject *group = m_contents.group(object.path.group);
        const std::array<const TdmsProperties *, 3> holders{&object.properties,
            group != nullptr ? &group->properties : nullptr,
            root != nullptr ? &root->properties : nullptr};
        auto records = m_records.of(object, holders);
        if (!records)
            return leaveOut(records.error(), Severity::Caution);
        const std::optional<double> unit_s = waveformUnit_s(object.properties);
        if (!unit_s)
            return leaveOut(noRecordOverTime(object, name), Severity::Caution);
        for (TdmsRecord &record : *records)
            shot.channels.push_back(channelOf(object, name, *unit_s, std::move(record)));
        keepStart(object.properties, shot.notes);
    }

    static Message noRecordOverTime(const TdmsObject &object, const std::string &name)
    {
        std::string unit = textOf(object.properties, "wf_xunit_string");
        if (unit.empty())
            unit = textOf(object.properties, "wf_xname");
        return {
            DYNCAL_TEXT("core",
                "Channel %1 is no recording over time: its values lie along \"%2\" (wf_xunit_string, wf_xname), and s, ms, us or ns is needed."),
            {name, unit}};
    }

    Channel channelOf(
        const TdmsObject &object, const std::string &name, double unit_s, TdmsRecord record)
    {
        Channel channel;
        channel.name = name + record.suffix;
        channel.samples = std::move(record.samples);
        channel.polynomial = std::move(record.polynomial);
        channel.sampleRate_Hz = sampleRateOf(object.properties, unit_s);
        const double t0_s = unit_s * numberOf(object.properties, "wf_start_offset").value_or(0.0);
        channel.t0_s = std::isfinite(t0_s) ? t0_s : 0.0;
        channel.unit = textOf(object.properties, "unit_string");
        if (channel.unit.empty())
            channel.unit = textOf(object.properties, "NI_UnitDescription");
        if (channel.unit.empty() || record.bareCounts)
            channel.unit = "1";
        if (record.bareCounts)
            m_set.findings.push_back({.id = "CAP-027",
                .severity = Severity::Caution,
                .channel = channel.name,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: channel %2 holds counts of the converter and no scale; state scale and unit, or its values mean nothing."),
                    {m_path, channel.name}}});
        return channel;
    }

    void leaveOut(Message reason, Severity severity)
    {
        m_lastReason = reason;
        m_set.findings.push_back({.id = "CAP-026",
            .severity = severity,
            .message
            = {DYNCAL_TEXT("core", "%1: a channel was left out. %M1"), {m_path}, {reason}}});
    }

    Error nothingRead() const
    {
        if (m_contents.damage)
            return {ErrorKind::FileUnreadable, *m_contents.damage, "CAP-018", 0};
        if (m_lastReason)
            return {ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core", "%1 has no channel that can be read. %M1"), {m_path},
                    {*m_lastReason}},
                "CAP-018", 0};
        return {ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 holds no data; it is likely an incomplete copy or a recording that never began."),
                {m_path}},
            "CAP-018", 0};
    }

    void findDamage()
    {
        if (m_contents.unknownVersion)
            m_set.findings.push_back({.id = "CAP-021",
                .severity = Severity::Info,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 is of the TDMS version %2, which this program does not know; it was read like version 4713."),
                    {m_path, std::to_string(*m_contents.unknownVersion)}}});
        if (m_contents.damage)
            m_set.findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .message = {DYNCAL_TEXT("core", "%M1 What stands before was read."), {},
                    {*m_contents.damage}}});
        const auto cut = std::find_if(
            m_contents.objects.begin(), m_contents.objects.end(), [](const TdmsObject &object) {
                return object.declared > static_cast<double>(object.count);
            });
        if (cut != m_contents.objects.end())
            m_set.findings.push_back(incomplete(*cut));
        else if (m_contents.endsEarly)
            m_set.findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 was not closed by the program that wrote it, or its end is missing; all values that are there were read."),
                    {m_path}}});
    }

    Finding incomplete(const TdmsObject &object) const
    {
        constexpr double kSensible = 1e15;
        const auto found = static_cast<double>(object.count);
        return {.id = "CAP-018",
            .severity = Severity::Caution,
            .channel = object.path.channel,
            .message
            = {DYNCAL_TEXT("core",
                   "%1 is incomplete: channel %2 has %3 of %4 samples. All values that are there were read; copy the file again if the original is whole."),
                {m_path, object.path.channel, std::to_string(object.count),
                    object.declared < kSensible ? numberText(object.declared) : "?"}},
            .value = found,
            .limit = object.declared};
    }

    void findMissingRates()
    {
        for (std::size_t i = 0; i < m_set.shots.size(); ++i) {
            for (const Channel &channel : m_set.shots[i].channels) {
                if (channel.sampleRate_Hz > 0.0)
                    continue;
                m_set.findings.push_back({.id = "CAP-003",
                    .severity = Severity::Caution,
                    .shot = static_cast<Index>(i) + 1,
                    .channel = channel.name,
                    .message
                    = {DYNCAL_TEXT("core",
                           "%1: channel %2 states no time between samples (wf_increment); give import.sample_rate_hz in the recipe."),
                        {m_path, channel.name}}});
                return; // one finding is enough
            }
        }
    }

    const std::string &m_path;
    const TdmsContents &m_contents;
    TdmsRecords m_records;
    CaptureSet m_set;
    std::optional<Message> m_lastReason; ///< why a channel was left out
};

} // namespace

int recogniseTdms(const std::string &, std::string_view head)
{
    return head.starts_with("TDSm") || head.starts_with("TDSh") ? 100 : 0;
}

Result<CaptureSet> readTdms(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<TdmsContents> contents = readTdmsContents(path, control, settings.maxExpansion);
    if (!contents)
        return tl::unexpected(contents.error());
    return TdmsReader(path, *contents).read();
}

} // namespace dyncal
