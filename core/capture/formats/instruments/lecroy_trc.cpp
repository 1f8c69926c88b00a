// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Layout: Teledyne LeCroy, "Remote Control Manual", waveform template LECROY_2_3; LECROY_1_0 (7200
// series) as described by the project RigolWFM (lecroy_1_0_le_trc.ksy). Checked against its
// samples.

#include "core/capture/formats/instruments/lecroy_trc.h"

#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr std::string_view kMark = "WAVEDESC";
constexpr std::size_t kPrefix = 32; ///< longest transfer prefix: '#', a digit, up to 9 digits
constexpr std::size_t kDescriptor = 346; ///< of the longer template
constexpr std::size_t kTriggerBytes = 16; ///< time and offset of one segment
constexpr std::uint32_t kSegments = 100000;
constexpr std::int16_t kSingleSweep = 0, kInterleaved = 1;

/// Where the fields lie that both templates have.
struct Template
{
    const char *name;
    std::size_t triggerTimes; ///< lengths of blocks
    std::size_t wave1, instrument, label, count, gain, bits, interval, offset, units, triggerAt,
        recordType, source;
    bool hasRis; ///< fields for interleaved sampling, sparse transfer and pairs
    int firstSource;
};

constexpr Template kTemplates[] = {
    {"LECROY_2_3", 48, 60, 76, 96, 116, 156, 172, 176, 180, 196, 296, 316, 344, true, 0},
    {"LECROY_1_0", 44, 48, 56, 76, 92, 120, 132, 134, 138, 154, 250, 270, 296, false, 1},
};

struct Descriptor
{
    bool words = false; ///< 16 bits a sample
    std::int32_t descriptorBytes = 0, textBytes = 0, triggerBytes = 0, risBytes = 0;
    std::int32_t wave1Bytes = 0, wave2Bytes = 0;
    std::string instrument, label, verticalUnit, horizontalUnit, recorded;
    std::int32_t serial = 0;
    std::int32_t count = 0, firstValid = 0, lastValid = 0, segments = 0;
    std::int32_t firstPoint = 0, sparsing = 1;
    std::int16_t risSweeps = 1;
    float gain = 0.0F, verticalOffset = 0.0F, acquisitionOffset = 0.0F;
    std::int16_t bits = 0, recordType = 0, source = 0;
    double interval_s = 0.0, offset_s = 0.0;
};

std::string dateText(ByteReader bytes)
{
    const auto seconds = bytes.next<double>();
    const auto minute = bytes.next<std::uint8_t>();
    const auto hour = bytes.next<std::uint8_t>();
    const auto day = bytes.next<std::uint8_t>();
    const auto month = bytes.next<std::uint8_t>();
    const auto year = bytes.next<std::int16_t>();
    if (year <= 0 || !std::isfinite(seconds))
        return {};
    const auto two
        = [](int number) { return std::string(number < 10 ? "0" : "") + std::to_string(number); };
    return std::to_string(year) + "-" + two(month) + "-" + two(day) + " " + two(hour) + ":"
        + two(minute) + ":" + (seconds < 10.0 ? "0" : "") + numberText(seconds, 11);
}

void readSampling(ByteReader &bytes, const Template &layout, Descriptor &wave)
{
    wave.count = bytes.at<std::int32_t>(layout.count);
    bytes.skip(4); // points per screen
    wave.firstValid = bytes.next<std::int32_t>();
    wave.lastValid = bytes.next<std::int32_t>();
    if (layout.hasRis) {
        wave.firstPoint = bytes.next<std::int32_t>();
        wave.sparsing = bytes.next<std::int32_t>();
        bytes.skip(4); // segment transferred
    }
    wave.segments = bytes.next<std::int32_t>();
    wave.gain = bytes.at<float>(layout.gain);
    wave.verticalOffset = bytes.next<float>();
    wave.bits = bytes.at<std::int16_t>(layout.bits);
    wave.interval_s = intendedInterval(bytes.at<float>(layout.interval));
    wave.offset_s = bytes.at<double>(layout.offset);
    wave.recordType = bytes.at<std::int16_t>(layout.recordType);
    if (layout.hasRis)
        wave.risSweeps = bytes.at<std::int16_t>(layout.recordType + 6);
    wave.acquisitionOffset = bytes.at<float>(layout.hasRis ? 340 : 290);
    wave.source = bytes.at<std::int16_t>(layout.source);
}

Descriptor descriptorOf(ByteReader bytes, const Template &layout)
{
    Descriptor wave;
    wave.words = bytes.at<std::int16_t>(32) != 0;
    wave.descriptorBytes = bytes.at<std::int32_t>(36);
    wave.textBytes = bytes.next<std::int32_t>();
    wave.triggerBytes = bytes.at<std::int32_t>(layout.triggerTimes);
    wave.risBytes = layout.hasRis ? bytes.next<std::int32_t>() : 0;
    wave.wave1Bytes = bytes.at<std::int32_t>(layout.wave1);
    wave.wave2Bytes = bytes.next<std::int32_t>();
    bytes.seek(layout.instrument);
    wave.instrument = utf8Text(bytes.text(16));
    wave.serial = bytes.next<std::int32_t>();
    bytes.seek(layout.label);
    wave.label = utf8Text(bytes.text(16));
    readSampling(bytes, layout, wave);
    bytes.seek(layout.units);
    wave.verticalUnit = utf8Text(bytes.text(48));
    wave.horizontalUnit = utf8Text(bytes.text(48));
    bytes.seek(layout.triggerAt);
    wave.recorded = dateText(bytes);
    return wave;
}

class LecroyReader
{
public:
    LecroyReader(const std::string &path, std::shared_ptr<const SampleFile> file)
        : m_path(path)
        , m_file(std::move(file))
    {
    }

    Result<CaptureSet> read()
    {
        if (const Result<void> found = readDescriptor(); !found)
            return tl::unexpected(found.error());
        if (const Result<void> usable = checkKind(); !usable)
            return tl::unexpected(usable.error());
        if (const Result<void> sound = checkNumbers(); !sound)
            return tl::unexpected(sound.error());
        if (const Result<void> added = addShots(); !added)
            return tl::unexpected(added.error());
        Attributes &scope = m_set.instruments["oscilloscope"];
        scope["vendor"] = "Teledyne LeCroy";
        scope["model"] = m_wave.instrument;
        scope["serial"] = std::to_string(m_wave.serial);
        labelShots(m_set, m_path);
        return std::move(m_set);
    }

private:
    Result<void> readDescriptor()
    {
        std::vector<std::byte> head = bytesAt(*m_file, 0, kPrefix + kDescriptor);
        const std::string_view text(reinterpret_cast<const char *>(head.data()), head.size());
        m_begin = text.substr(0, kPrefix + kMark.size()).find(kMark);
        if (m_begin == std::string_view::npos)
            return endsInHeader(m_path);
        head.erase(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(m_begin));
        ByteReader bytes(head);
        bytes.seek(16);
        const std::string name = bytes.text(16);
        for (const Template &layout : kTemplates) {
            if (name == layout.name)
                m_layout = &layout;
        }
        const auto order = bytes.at<std::uint8_t>(34);
        if (!bytes.ok())
            return endsInHeader(m_path);
        if (m_layout == nullptr)
            return unsupportedKind(m_path, "LeCroy template " + utf8Text(name));
        m_order = order == 0 ? std::endian::big : std::endian::little;
        if (head.size() < descriptorBytes())
            return endsInHeader(m_path);
        m_wave = descriptorOf(ByteReader(head, m_order), *m_layout);
        return {};
    }

    std::size_t descriptorBytes() const { return m_layout->hasRis ? kDescriptor : 320; }

    /// Refuses records that are no uniformly sampled signal, or that no sample file has proven.
    Result<void> checkKind() const
    {
        const auto refuse
            = [this](const std::string &kind) { return unsupportedKind(m_path, "LeCroy " + kind); };
        if (m_wave.recordType != kSingleSweep && m_wave.recordType != kInterleaved)
            return refuse("record type " + std::to_string(m_wave.recordType));
        if (m_wave.risSweeps > 1)
            return refuse("random interleaved sampling");
        if (m_wave.horizontalUnit != "S" && m_wave.horizontalUnit != "s")
            return refuse("waveform over \"" + m_wave.horizontalUnit + "\" instead of seconds");
        if (m_wave.sparsing > 1 || m_wave.firstPoint != 0)
            return refuse("sparse transfer");
        // No document says which of the two offsets the old template's counts have.
        if (!m_layout->hasRis && m_wave.verticalOffset != m_wave.acquisitionOffset)
            return refuse("LECROY_1_0 with two vertical offsets ("
                + numberText(double(m_wave.verticalOffset), 6) + " and "
                + numberText(double(m_wave.acquisitionOffset), 6) + ")");
        return {};
    }

    Result<void> checkNumbers() const
    {
        const auto impossible = [this](const char *field, double value) {
            return impossibleField(m_path, field, numberText(value, 9));
        };
        if (m_wave.descriptorBytes < static_cast<std::int32_t>(descriptorBytes()))
            return impossible("WAVE_DESCRIPTOR", m_wave.descriptorBytes);
        for (const std::int32_t bytes : {m_wave.textBytes, m_wave.triggerBytes, m_wave.risBytes,
                 m_wave.wave1Bytes, m_wave.wave2Bytes}) {
            if (bytes < 0)
                return impossible("length of a block", bytes);
        }
        if (m_wave.count <= 0 || m_wave.wave1Bytes / bytesPerPoint() != m_wave.count)
            return impossible("WAVE_ARRAY_COUNT", m_wave.count);
        if (m_wave.segments < 1 || std::uint32_t(m_wave.segments) > kSegments
            || m_wave.count % m_wave.segments != 0)
            return impossible("SUBARRAY_COUNT", m_wave.segments);
        if (m_wave.firstValid < 0 || m_wave.lastValid >= m_wave.count
            || m_wave.firstValid > m_wave.lastValid)
            return impossible("FIRST_VALID_PNT", m_wave.firstValid);
        if (!std::isfinite(m_wave.gain) || m_wave.gain == 0.0F
            || !std::isfinite(m_wave.verticalOffset))
            return impossible("VERTICAL_GAIN", double(m_wave.gain));
        if (!std::isfinite(m_wave.offset_s))
            return impossible("HORIZ_OFFSET", m_wave.offset_s);
        return {};
    }

    int bytesPerPoint() const { return m_wave.words ? 2 : 1; }

    std::string channelName() const
    {
        if (!m_wave.label.empty())
            return m_wave.label;
        const int number = m_wave.source - m_layout->firstSource + 1;
        return number >= 1 && number <= 8 ? "C" + std::to_string(number) : "trace";
    }

    Result<void> addShots()
    {
        const std::uint64_t triggers = m_begin
            + static_cast<std::uint64_t>(m_wave.descriptorBytes + std::int64_t{m_wave.textBytes});
        const std::uint64_t samples = triggers
            + static_cast<std::uint64_t>(m_wave.triggerBytes + std::int64_t{m_wave.risBytes});
        const std::uint64_t there = samples < m_file->size() ? m_file->size() - samples : 0;
        if (there < static_cast<std::uint64_t>(m_wave.wave1Bytes))
            return endsInSamples(
                m_path, channelName(), static_cast<Index>(there) / bytesPerPoint(), m_wave.count);
        if (m_wave.wave2Bytes > 0)
            m_set.findings.push_back(leftOut(m_path, "WAVE_ARRAY_2", "second array"));
        if (m_wave.segments == 1)
            return addShot(samples, m_wave.firstValid, m_wave.lastValid - m_wave.firstValid + 1,
                m_wave.offset_s);
        return addSegments(triggers, samples);
    }

    /// A sequence: every segment has its own time from trigger to first sample.
    Result<void> addSegments(std::uint64_t triggers, std::uint64_t samples)
    {
        const auto segments = static_cast<std::size_t>(m_wave.segments);
        if (m_wave.firstValid != 0 || m_wave.lastValid != m_wave.count - 1)
            return unsupportedKind(m_path, "LeCroy sequence with invalid points");
        if (static_cast<std::size_t>(m_wave.triggerBytes) < segments * kTriggerBytes)
            return impossibleField(m_path, "TRIGTIME_ARRAY", std::to_string(m_wave.triggerBytes));
        const std::vector<std::byte> raw = bytesAt(*m_file, triggers, segments * kTriggerBytes);
        ByteReader bytes(raw, m_order);
        const Index count = m_wave.count / m_wave.segments;
        for (std::size_t k = 0; k < segments; ++k) {
            const auto time_s = bytes.next<double>();
            const auto offset_s = bytes.next<double>();
            if (!std::isfinite(offset_s) || !std::isfinite(time_s))
                return impossibleField(m_path, "TRIGGER_OFFSET", numberText(offset_s));
            const Result<void> added
                = addShot(samples, static_cast<Index>(k) * count, count, offset_s);
            if (!added)
                return added;
            m_set.shots.back().notes["trigger_time_s"] = numberText(time_s);
        }
        return {};
    }

    Result<void> addShot(std::uint64_t samples, Index first, Index count, double start_s)
    {
        Shot shot;
        const Index number = static_cast<Index>(m_set.shots.size()) + 1;
        Channel channel;
        channel.name = channelName();
        channel.unit = m_wave.verticalUnit.empty() ? "1" : m_wave.verticalUnit;
        channel.sampleRate_Hz
            = sampleRateOf(m_wave.interval_s, m_path, channel.name, number, m_set.findings);
        // Points before the first valid one are skipped, so the record begins later.
        channel.t0_s = start_s
            + (m_wave.segments == 1 ? static_cast<double>(first) * m_wave.interval_s : 0.0);
        if (!std::isfinite(channel.t0_s))
            channel.t0_s = start_s;
        channel.polynomial = {-double(m_wave.verticalOffset), double(m_wave.gain)};
        // MAX_VALUE and MIN_VALUE are the edges of the grid, not of the converter: no rails.
        channel.adcBits = m_wave.bits >= 1 && m_wave.bits <= 16 ? m_wave.bits : 0;
        const auto counts = samplesInFile(m_file,
            {m_wave.words ? SampleType::Int16 : SampleType::Int8, m_order, 0,
                {{samples + static_cast<std::uint64_t>(first * bytesPerPoint()), count}}});
        if (!counts)
            return endsInHeader(m_path);
        channel.samples = *counts;
        shot.channels.push_back(std::move(channel));
        if (!m_wave.recorded.empty())
            shot.notes["recorded"] = m_wave.recorded;
        m_set.shots.push_back(std::move(shot));
        return {};
    }

    const std::string &m_path;
    std::shared_ptr<const SampleFile> m_file;
    const Template *m_layout = nullptr;
    std::endian m_order = std::endian::little;
    std::size_t m_begin = 0; ///< of the descriptor in the file
    Descriptor m_wave;
    CaptureSet m_set;
};

} // namespace

int recogniseLecroyTrc(const std::string &, std::string_view head)
{
    const std::size_t mark = head.substr(0, kPrefix + kMark.size()).find(kMark);
    const bool begins = mark == 0 || (mark < kPrefix && head.starts_with('#'));
    return begins && head.substr(mark).substr(0, 23).ends_with("LECROY_") ? 100 : 0;
}

Result<CaptureSet> readLecroyTrc(
    const std::string &path, const ImportSettings &, const JobControl &)
{
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    return LecroyReader(path, *file).read();
}

} // namespace dyncal
