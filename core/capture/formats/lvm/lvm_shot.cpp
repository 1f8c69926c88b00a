// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm_shot.h"

#include "core/base/number_text.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/lvm/lvm_rate.h"

#include <algorithm>
#include <span>

namespace dyncal {
namespace {

constexpr double kPreciseRate = 1e-4; ///< relative; no finding up to here
constexpr double kUselessRate = 1e-2; ///< a rate known worse is not used

/// Makes the channels of one segment.
class ShotMaker
{
public:
    ShotMaker(const std::string &path, Index number, const LvmSegment &segment,
        const LvmFileHeader &file, LvmRows rows, Findings &findings)
        : m_path(path)
        , m_number(number)
        , m_segment(segment)
        , m_multi(file.xColumns == LvmXColumns::Multi)
        , m_rows(std::move(rows))
        , m_findings(findings)
    {
    }

    Shot make()
    {
        Shot shot;
        shot.notes = m_segment.notes;
        for (const std::string &comment : m_rows.comments()) {
            std::string &note = shot.notes["comment"];
            note.append(note.empty() ? "" : "; ").append(comment);
        }
        compareColumns();
        compareCounts();
        std::vector<double> rates_Hz;
        for (std::size_t i = 0; i < m_segment.channels.size(); ++i)
            rates_Hz.push_back(m_rows.values()[i].size() > 0 ? sampleRateOf(i) : 0.0);
        sayPrecision();
        std::vector<SampleColumn> values = m_rows.takeValues();
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (values[i].size() > 0)
                shot.channels.push_back(
                    channelOf(m_segment.channels[i], rates_Hz[i], values[i].take()));
        }
        return shot;
    }

private:
    static Channel channelOf(
        const LvmChannel &header, double sampleRate_Hz, std::vector<double> values)
    {
        Channel channel;
        channel.name
            = header.name.empty() ? "column " + std::to_string(header.column + 1) : header.name;
        channel.unit = header.unit.empty() ? "1" : header.unit;
        channel.sampleRate_Hz = sampleRate_Hz;
        channel.t0_s = header.x0 * header.xUnit_s;
        channel.samples = RawSamples(std::move(values));
        return channel;
    }

    /// One X column for all belongs to the first channel and those of the same Delta_X.
    bool hasOwnX(const LvmChannel &channel) const
    {
        return channel.xColumn && (m_multi || isAsFast(channel));
    }

    bool isAsFast(const LvmChannel &channel) const
    {
        return channel.deltaX == m_segment.channels.front().deltaX;
    }

    double sampleRateOf(std::size_t index)
    {
        const LvmChannel &channel = m_segment.channels[index];
        const SampleColumn &values = m_rows.values()[index];
        const auto count = static_cast<std::size_t>(values.size());
        std::span<const double> x;
        bool isShort = false;
        if (hasOwnX(channel)) {
            x = m_rows.x()[m_multi ? index : 0].values();
            isShort = !x.empty() && x.size() < count;
            x = x.first(std::min(count, x.size()));
        }
        LvmRate rate = lvmRate(channel, x, m_rows.xResolution());
        // A slower channel with gaps was appended block by block, so its rows are no time axis.
        const bool blocks = values.hasGaps() && !m_multi && !isAsFast(channel);
        if (rate.contradicted || isShort || blocks) {
            contradict(channel, rate.meanStep);
            return 0.0;
        }
        rate.sampleRate_Hz /= channel.xUnit_s;
        if (rate.relativePrecision > m_worstPrecision) {
            m_worstPrecision = rate.relativePrecision;
            m_vagueChannel = &channel;
            m_vagueRate_Hz = rate.sampleRate_Hz;
        }
        return rate.relativePrecision > kUselessRate ? 0.0 : rate.sampleRate_Hz;
    }

    void contradict(const LvmChannel &channel, double mean)
    {
        m_findings.push_back({.id = "CAP-016",
            .severity = Severity::Caution,
            .shot = m_number,
            .channel = channel.name,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: Delta_X of channel %2 is %3, but its X values are not uniform or step by %4 on average; state the sample rate in the recipe's import section if it is known."),
                {m_path, channel.name, numberText(channel.deltaX, 7), numberText(mean, 7)}},
            .value = mean,
            .limit = channel.deltaX});
    }

    /// A rate of 1/0.000977 is known to 0.05 % only, and so is every frequency.
    void sayPrecision()
    {
        if (m_vagueChannel == nullptr || m_worstPrecision <= kPreciseRate)
            return;
        const std::vector<std::string> words{m_path, m_vagueChannel->name,
            numberWithUnit(m_vagueRate_Hz, "Hz", 7), numberText(100.0 * m_worstPrecision, 2)};
        if (m_worstPrecision > kUselessRate)
            m_findings.push_back({.id = "CAP-003",
                .severity = Severity::Caution,
                .shot = m_number,
                .channel = m_vagueChannel->name,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: Delta_X of channel %2 is printed with so few digits that its sample rate of %3 is known to %4 % only, so it was not taken; state sample_rate_hz in the recipe's import section."),
                    words}});
        else
            m_findings.push_back({.id = "CAP-003",
                .severity = m_worstPrecision > kRateTolerance ? Severity::Caution : Severity::Info,
                .shot = m_number,
                .channel = m_vagueChannel->name,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: the sample rate of channel %2, %3, is known to %4 % only, as Delta_X is printed with few digits; state sample_rate_hz in the recipe's import section if you know it better."),
                    words}});
    }

    void compareColumns()
    {
        const auto declared = static_cast<Index>(m_segment.channels.size());
        if (m_segment.namedChannels > declared)
            m_findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .shot = m_number,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: the header declares %2 channels, but %3 columns have names; the last ones were not read."),
                    {m_path, std::to_string(declared), std::to_string(m_segment.namedChannels)}}});
        const auto &values = m_rows.values();
        const auto empty = std::count_if(values.begin(), values.end(),
            [](const SampleColumn &column) { return column.size() == 0; });
        if (empty > 0)
            m_findings.push_back({.id = "CAP-018",
                .severity = Severity::Info,
                .shot = m_number,
                .message
                = {DYNCAL_TEXT("core", "%1: %2 of %3 channels have no samples and were left out."),
                    {m_path, std::to_string(empty), std::to_string(declared)}}});
    }

    void compareCounts()
    {
        for (std::size_t i = 0; i < m_segment.channels.size(); ++i) {
            const Index found = m_rows.values()[i].size();
            const Index declared = m_segment.channels[i].declaredSamples.value_or(found);
            if (found == declared)
                continue;
            sayCounts(m_segment.channels[i].name, found, declared);
            return;
        }
    }

    /// LabVIEW appends to a segment, so more samples than declared are normal; but the appended
    /// ones may be the next shot.
    void sayCounts(const std::string &channel, Index found, Index declared)
    {
        const bool blocks = declared > 1 && found > declared;
        const std::vector<std::string> words{
            m_path, channel, std::to_string(found), std::to_string(declared)};
        if (blocks)
            m_findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .shot = m_number,
                .channel = channel,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: channel %2 has %3 samples where its header declares %4, so blocks were appended and are read as one record. If each is a shot of its own, save with one header per segment."),
                    words},
                .value = static_cast<double>(found),
                .limit = static_cast<double>(declared)});
        else
            m_findings.push_back({.id = "CAP-018",
                .severity = found < declared ? Severity::Caution : Severity::Info,
                .shot = m_number,
                .channel = channel,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: channel %2 has %3 samples where its header declares %4; if it has fewer, the file may be an incomplete copy."),
                    words},
                .value = static_cast<double>(found),
                .limit = static_cast<double>(declared)});
    }

    const std::string &m_path;
    Index m_number;
    const LvmSegment &m_segment;
    bool m_multi;
    LvmRows m_rows;
    Findings &m_findings;
    double m_worstPrecision = 0.0;
    const LvmChannel *m_vagueChannel = nullptr;
    double m_vagueRate_Hz = 0.0;
};

} // namespace

Shot lvmShot(const std::string &path, Index number, const LvmSegment &segment,
    const LvmFileHeader &file, LvmRows rows, Findings &findings)
{
    return ShotMaker(path, number, segment, file, std::move(rows), findings).make();
}

} // namespace dyncal
