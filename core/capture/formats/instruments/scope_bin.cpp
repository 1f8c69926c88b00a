// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Layout: Keysight InfiniiVision 2000 X-Series User's Guide, "Binary Data (.bin) Format"; Rigol
// DHO1000 User Guide 19.2.4; both as described by the project RigolWFM (agilent_agxx_bin.ksy,
// rigol_dho800_1000_bin.ksy, rigol_mso5000_bin.ksy), whose sample files this was checked against.

#include "core/capture/formats/instruments/scope_bin.h"

#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace dyncal {
namespace {

constexpr std::size_t kWaveformHeader = 140; ///< bytes of it that are described
constexpr std::uint32_t kWaveforms = 100000; ///< more than any memory of segments holds
constexpr std::size_t kMostTraces = 64; ///< of one segment, with all that is computed from others

enum WaveformType : std::uint32_t { Normal = 1, PeakDetect = 2, Average = 3, Logic = 6 };
enum BufferType : std::uint16_t { FloatBuffer = 1 };
enum XUnit : std::uint32_t { Seconds = 2 };

/// What differs between the two makers.
struct Maker
{
    std::string_view tag; ///< first two characters
    const char *vendor;
    double startSign; ///< first sample's time = sign * x origin
};

// Keysight's x origin is the time of the first sample. Rigol's manual says the same, but its files
// hold the distance from the first sample to the trigger, positive with pretrigger (all samples).
constexpr Maker kKeysight{"AG", "Keysight", 1.0};
constexpr Maker kRigol{"RG", "Rigol", -1.0};

struct Waveform
{
    std::uint32_t headerBytes = 0, type = 0, buffers = 0, points = 0, xUnit = 0, yUnit = 0;
    double interval_s = 0.0, origin_s = 0.0;
    std::string date, time, frame, label;
    std::uint32_t segment = 0;
};

struct Buffer
{
    std::uint32_t headerBytes = 0;
    std::uint16_t type = 0, bytesPerPoint = 0;
    std::uint64_t bytes = 0;
    std::uint64_t begin = 0; ///< of its samples in the file
};

Waveform waveformOf(ByteReader bytes)
{
    Waveform wave;
    wave.headerBytes = bytes.next<std::uint32_t>();
    wave.type = bytes.next<std::uint32_t>();
    wave.buffers = bytes.next<std::uint32_t>();
    wave.points = bytes.next<std::uint32_t>();
    bytes.skip(4 + 4 + 8); // number of averages, range and origin of the display
    wave.interval_s = intendedInterval(bytes.next<double>());
    wave.origin_s = bytes.next<double>();
    wave.xUnit = bytes.next<std::uint32_t>();
    wave.yUnit = bytes.next<std::uint32_t>();
    wave.date = bytes.text(16);
    wave.time = bytes.text(16);
    wave.frame = bytes.text(24);
    wave.label = utf8Text(bytes.text(16));
    bytes.skip(8); // time tag of the segment
    wave.segment = bytes.next<std::uint32_t>();
    return wave;
}

const char *unitName(std::uint32_t code)
{
    constexpr std::array kNames{"1", "V", "s", "1", "A", "dB", "Hz"};
    return code < kNames.size() ? kNames[code] : "1";
}

class ScopeBinReader
{
public:
    ScopeBinReader(
        const std::string &path, const Maker &maker, std::shared_ptr<const SampleFile> file)
        : m_path(path)
        , m_maker(maker)
        , m_file(std::move(file))
    {
    }

    Result<CaptureSet> read()
    {
        const Result<std::uint32_t> waveforms = readFileHeader();
        if (!waveforms)
            return tl::unexpected(waveforms.error());
        for (std::uint32_t i = 0; i < *waveforms; ++i) {
            if (const Result<void> done = readWaveform(i); !done)
                return tl::unexpected(done.error());
        }
        for (auto &[segment, shot] : m_shots)
            m_set.shots.push_back(std::move(shot));
        if (m_set.shots.empty())
            return noSignal(m_path);
        labelShots(m_set, m_path);
        return std::move(m_set);
    }

private:
    /// Number of waveforms. Version 03 counts bytes in 64 bits.
    Result<std::uint32_t> readFileHeader()
    {
        const std::vector<std::byte> head = bytesAt(*m_file, 0, 16);
        ByteReader bytes(head);
        const std::string tag = bytes.text(4);
        const bool known = tag == std::string(m_maker.tag) + "01"
            || tag == std::string(m_maker.tag) + "03"
            || (tag == std::string(m_maker.tag) + "10" && m_maker.tag == "AG");
        if (!known)
            return unsupportedKind(m_path, std::string(m_maker.vendor) + " .bin " + tag);
        m_wide = tag.ends_with("03");
        bytes.skip(m_wide ? 8 : 4); // size of the file; the real one is used
        const auto waveforms = bytes.next<std::uint32_t>();
        if (!bytes.ok())
            return endsInHeader(m_path);
        if (waveforms > kWaveforms)
            return impossibleField(m_path, "number of waveforms", std::to_string(waveforms));
        m_position = bytes.position();
        return waveforms;
    }

    Result<void> readWaveform(std::uint32_t index)
    {
        const std::vector<std::byte> head = bytesAt(*m_file, m_position, kWaveformHeader);
        const Waveform wave = waveformOf(ByteReader(head));
        if (head.size() < kWaveformHeader)
            return endsInHeader(m_path);
        const bool known = wave.headerBytes == kWaveformHeader
            || (wave.headerBytes > kWaveformHeader && m_maker.tag == "AG");
        if (!known)
            return unsupportedKind(m_path,
                std::string(m_maker.vendor) + " .bin with waveform headers of "
                    + std::to_string(wave.headerBytes) + " bytes");
        m_position += wave.headerBytes;
        for (std::uint32_t k = 0; k < wave.buffers; ++k) {
            const Result<Buffer> buffer = readBuffer(wave, index);
            if (!buffer)
                return tl::unexpected(buffer.error());
            if (const Result<void> added = addBuffer(wave, *buffer, index); !added)
                return added;
        }
        return {};
    }

    std::string nameOf(const Waveform &wave, std::uint32_t index) const
    {
        return wave.label.empty() ? "channel " + std::to_string(index + 1) : wave.label;
    }

    Result<Buffer> readBuffer(const Waveform &wave, std::uint32_t index)
    {
        const std::size_t size = m_wide ? 16 : 12;
        const std::vector<std::byte> head = bytesAt(*m_file, m_position, size);
        ByteReader bytes(head);
        Buffer buffer;
        buffer.headerBytes = bytes.next<std::uint32_t>();
        buffer.type = bytes.next<std::uint16_t>();
        buffer.bytesPerPoint = bytes.next<std::uint16_t>();
        buffer.bytes = m_wide ? bytes.next<std::uint64_t>() : bytes.next<std::uint32_t>();
        if (!bytes.ok())
            return endsInHeader(m_path);
        if (buffer.headerBytes != size)
            return impossibleField(
                m_path, "size of a data header", std::to_string(buffer.headerBytes));
        buffer.begin = m_position + size;
        const std::uint64_t there = m_file->size() - buffer.begin;
        if (buffer.bytes > there)
            return endsInSamples(m_path, nameOf(wave, index),
                static_cast<Index>(there / std::max<std::uint64_t>(buffer.bytesPerPoint, 1)),
                static_cast<Index>(wave.points));
        m_position = buffer.begin + buffer.bytes;
        return buffer;
    }

    Result<void> addBuffer(const Waveform &wave, const Buffer &buffer, std::uint32_t index)
    {
        const std::string name = nameOf(wave, index);
        if (wave.type == PeakDetect)
            return unsupportedKind(m_path,
                std::string(m_maker.vendor)
                    + " peak detect (minima and maxima in place of samples)");
        const bool isSignal = (wave.type == Normal || wave.type == Average)
            && buffer.type == FloatBuffer && wave.xUnit == Seconds;
        if (!isSignal) {
            if (m_leftOut.insert(name).second)
                m_set.findings.push_back(leftOut(m_path, name,
                    wave.xUnit == Seconds ? "digital channel or histogram" : "no axis of times"));
            return {};
        }
        if (buffer.bytesPerPoint != sizeof(float))
            return impossibleField(m_path, "bytes per point", std::to_string(buffer.bytesPerPoint));
        if (buffer.bytes != std::uint64_t{wave.points} * sizeof(float) || wave.points == 0)
            return impossibleField(m_path, "number of points", std::to_string(wave.points));
        if (!std::isfinite(wave.origin_s))
            return impossibleField(m_path, "time of the first point", numberText(wave.origin_s));
        Shot &shot = m_shots[wave.segment];
        if (shot.channels.size() >= kMostTraces)
            return impossibleField(m_path, "number of waveforms", "more than 64 at a time");
        Channel channel = channelOf(wave, freeChannelName(shot, name));
        const auto samples = samplesInFile(m_file,
            {SampleType::Float32, std::endian::little, 0,
                {{buffer.begin, static_cast<Index>(wave.points)}}});
        if (!samples)
            return endsInHeader(m_path);
        channel.samples = *samples;
        shot.channels.push_back(std::move(channel));
        if (!wave.date.empty())
            shot.notes["recorded"] = wave.date + " " + wave.time;
        return {};
    }

    Channel channelOf(const Waveform &wave, const std::string &name)
    {
        Channel channel;
        channel.name = name;
        channel.unit = unitName(wave.yUnit);
        channel.sampleRate_Hz = sampleRateOf(
            wave.interval_s, m_path, name, static_cast<Index>(m_shots.size()), m_set.findings);
        channel.t0_s = m_maker.startSign * wave.origin_s + 0.0; // no -0
        if (!wave.frame.empty()) {
            const std::size_t colon = std::min(wave.frame.find(':'), wave.frame.size());
            Attributes &scope = m_set.instruments["oscilloscope"];
            scope["vendor"] = m_maker.vendor;
            scope["model"] = utf8Text(wave.frame.substr(0, colon));
            scope["serial"] = utf8Text(wave.frame.substr(std::min(colon + 1, wave.frame.size())));
        }
        return channel;
    }

    const std::string &m_path;
    const Maker &m_maker;
    std::shared_ptr<const SampleFile> m_file;
    bool m_wide = false; ///< sizes have 64 bits
    std::uint64_t m_position = 0;
    std::map<std::uint32_t, Shot> m_shots; ///< by number of the segment
    std::set<std::string> m_leftOut;
    CaptureSet m_set;
};

int recognise(const Maker &maker, std::string_view head)
{
    if (!head.starts_with(maker.tag))
        return 0;
    const std::string_view version = head.substr(2, 2);
    return version == "01" || version == "03" || version == "10" ? 100 : 0;
}

Result<CaptureSet> readWith(const Maker &maker, const std::string &path)
{
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    return ScopeBinReader(path, maker, *file).read();
}

} // namespace

int recogniseKeysightBin(const std::string &, std::string_view head)
{
    return recognise(kKeysight, head);
}

int recogniseRigolBin(const std::string &, std::string_view head)
{
    return recognise(kRigol, head);
}

Result<CaptureSet> readKeysightBin(
    const std::string &path, const ImportSettings &, const JobControl &)
{
    return readWith(kKeysight, path);
}

Result<CaptureSet> readRigolBin(const std::string &path, const ImportSettings &, const JobControl &)
{
    return readWith(kRigol, path);
}

} // namespace dyncal
