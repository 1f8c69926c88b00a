// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Layout: IBM/Microsoft "Multimedia Programming Interface and Data Specifications 1.0" (RIFF,
// RIFX), Microsoft "Multiple Channel Audio Data and WAVE Files" (extensible header), EBU Tech 3306
// (RF64) and ITU-R BS.2088 (BW64).

#include "core/capture/formats/instruments/wav.h"

#include "core/base/number_text.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace dyncal {
namespace {

constexpr std::size_t kRiffHeader = 12;
constexpr std::size_t kChunkHeader = 8;
constexpr std::size_t kFormatBytes = 40; ///< of an extensible format chunk
constexpr std::uint32_t kNotWritten = 0xFFFFFFFF; ///< length of a stream, or it is in ds64
constexpr int kChunks = 1000; ///< more than any writer puts before the samples
constexpr int kMostWavChannels = 256; ///< more than any recorder has
constexpr std::uint16_t kPcm = 1, kFloat = 3, kExtensible = 0xFFFE;

struct WavFormat
{
    std::uint16_t tag = 0, channels = 0, frameBytes = 0, bits = 0, validBits = 0;
    std::uint32_t rate_Hz = 0, bytesPerSecond = 0;

    int containerBytes() const { return channels > 0 ? frameBytes / channels : 0; }
};

/// The stretch of the file that has the samples.
struct WavData
{
    std::uint64_t begin = 0;
    std::uint64_t bytes = 0; ///< as declared
    bool declared = true;
};

/// Signed integers of 24 bits, which are no SampleType, given out as 32 bits.
class Int24Source : public SampleSource
{
public:
    Int24Source(std::shared_ptr<const SampleFile> file, std::uint64_t offset, Index stride,
        std::endian order)
        : m_file(std::move(file))
        , m_offset(offset)
        , m_stride(stride)
        , m_order(order)
    {
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        constexpr Index kBufferBytes = 1 << 20;
        const Index rows = std::max<Index>(kBufferBytes / m_stride, 1);
        std::vector<std::byte> buffer;
        for (Index done = 0; done < count; done += rows) {
            const Index here = std::min(rows, count - done);
            buffer.resize(static_cast<std::size_t>((here - 1) * m_stride + 3));
            if (!m_file->read(m_offset + static_cast<std::uint64_t>((begin + done) * m_stride),
                    buffer.size(), buffer.data()))
                return false;
            for (Index k = 0; k < here; ++k) {
                const std::int32_t value = valueOf(buffer.data() + k * m_stride);
                std::memcpy(target + (done + k) * Index(sizeof value), &value, sizeof value);
            }
        }
        return true;
    }

    bool isUnchanged() const override { return m_file->unchanged(); }

private:
    std::int32_t valueOf(const std::byte *sample) const
    {
        const bool little = m_order == std::endian::little;
        const auto low = std::to_integer<std::uint32_t>(sample[little ? 0 : 2]);
        const auto middle = std::to_integer<std::uint32_t>(sample[1]);
        const auto high = std::to_integer<std::uint32_t>(sample[little ? 2 : 0]);
        return static_cast<std::int32_t>(high << 24 | middle << 16 | low << 8) >> 8;
    }

    std::shared_ptr<const SampleFile> m_file;
    std::uint64_t m_offset;
    Index m_stride;
    std::endian m_order;
};

std::endian byteOrderOf(std::string_view head)
{
    return head.starts_with("RIFX") ? std::endian::big : std::endian::little;
}

/// The tag of an extensible format is the first field of its GUID if the rest is the usual one.
std::uint16_t tagOfGuid(ByteReader &bytes)
{
    const auto tag = bytes.next<std::uint32_t>();
    const auto second = bytes.next<std::uint16_t>();
    const auto third = bytes.next<std::uint16_t>();
    const std::span<const std::byte> rest = bytes.take(8);
    constexpr std::array<std::uint8_t, 8> kRest{0x80, 0x00, 0x00, 0xAA, 0x00, 0x38, 0x9B, 0x71};
    const bool usual = second == 0 && third == 0x10 && rest.size() == kRest.size()
        && std::equal(rest.begin(), rest.end(), kRest.begin(),
            [](std::byte a, std::uint8_t b) { return std::to_integer<std::uint8_t>(a) == b; });
    return usual && tag < kExtensible ? static_cast<std::uint16_t>(tag) : kExtensible;
}

std::optional<WavFormat> formatOf(ByteReader bytes)
{
    WavFormat format;
    format.tag = bytes.next<std::uint16_t>();
    format.channels = bytes.next<std::uint16_t>();
    format.rate_Hz = bytes.next<std::uint32_t>();
    format.bytesPerSecond = bytes.next<std::uint32_t>();
    format.frameBytes = bytes.next<std::uint16_t>();
    format.bits = bytes.next<std::uint16_t>();
    format.validBits = format.bits;
    if (format.tag == kExtensible) {
        bytes.skip(2); // size of the extension
        const auto valid = bytes.next<std::uint16_t>();
        format.validBits = valid == 0 ? format.bits : valid; // 0 = not said
        bytes.skip(4); // places of the loudspeakers
        format.tag = tagOfGuid(bytes);
    }
    return bytes.ok() ? std::optional(format) : std::nullopt;
}

class WavReader
{
public:
    WavReader(const std::string &path, std::shared_ptr<const SampleFile> file)
        : m_path(path)
        , m_file(std::move(file))
    {
    }

    Result<CaptureSet> read()
    {
        if (const Result<void> found = findChunks(); !found)
            return tl::unexpected(found.error());
        if (const Result<void> format = checkFormat(); !format)
            return tl::unexpected(format.error());
        const Index frames = frameCount();
        if (frames == 0)
            return endsInHeader(m_path);
        Shot shot;
        const double rate_Hz = sampleRate();
        for (Index c = 0; c < m_format->channels; ++c)
            shot.channels.push_back(channelOf(c, frames, rate_Hz));
        m_set.shots.push_back(std::move(shot));
        labelShots(m_set, m_path);
        return std::move(m_set);
    }

private:
    /// Goes from chunk to chunk up to the samples.
    Result<void> findChunks()
    {
        const std::vector<std::byte> head = bytesAt(*m_file, 0, kRiffHeader);
        const std::string tag = ByteReader(head).text(4);
        m_order = byteOrderOf(tag);
        ByteReader bytes(head, m_order);
        const auto riffBytes = bytes.at<std::uint32_t>(4);
        if (bytes.text(4) != "WAVE")
            return endsInHeader(m_path);
        std::uint64_t position = kRiffHeader;
        for (int k = 0; k < kChunks; ++k) {
            const std::vector<std::byte> start
                = bytesAt(*m_file, position, kChunkHeader + kFormatBytes);
            ByteReader chunk(start, m_order);
            const std::string id = chunk.text(4);
            const auto size = chunk.next<std::uint32_t>();
            if (!chunk.ok())
                return endsInHeader(m_path);
            if (id == "data")
                return setData(position + kChunkHeader, size, riffBytes);
            if (id == "fmt") {
                const auto room = std::min<std::size_t>(size, chunk.remaining());
                m_format = formatOf(ByteReader(chunk.take(room), m_order));
            } else if (id == "ds64") {
                chunk.skip(8); // length of the whole
                const auto bytes64 = chunk.next<std::uint64_t>();
                if (chunk.ok())
                    m_longDataBytes = bytes64;
            }
            position += kChunkHeader + size + size % 2;
        }
        return impossibleField(m_path, "number of chunks", "more than 1000");
    }

    Result<void> setData(std::uint64_t begin, std::uint32_t size, std::uint32_t riffBytes)
    {
        m_data = {begin, size, true};
        if (size == kNotWritten && m_longDataBytes)
            m_data.bytes = *m_longDataBytes;
        else if (size == kNotWritten)
            m_data.declared = false;
        else if (size == 0) // empty, or the recorder never updated its header
            m_data.declared = riffBytes != kNotWritten && riffBytes + 8ULL > begin;
        return {};
    }

    Result<void> checkFormat() const
    {
        if (!m_format)
            return endsInHeader(m_path);
        const WavFormat &format = *m_format;
        if (format.channels > kMostWavChannels)
            return impossibleField(m_path, "number of channels", std::to_string(format.channels));
        if (format.channels == 0 || format.frameBytes % format.channels != 0
            || format.frameBytes == 0)
            return impossibleField(m_path, "bytes per frame", std::to_string(format.frameBytes));
        const int container = 8 * format.containerBytes();
        if (format.tag == kFloat && (container == 32 || container == 64)
            && container == format.bits)
            return {};
        if (format.tag != kPcm)
            return unsupportedKind(m_path,
                "WAV with format tag " + std::to_string(format.tag) + " and "
                    + std::to_string(format.bits) + " bits");
        if (format.bits == 0 || (format.bits + 7) / 8 * 8 != container
            || format.validBits > format.bits)
            return impossibleField(m_path, "bits per sample", std::to_string(format.bits));
        if (container > 32)
            return unsupportedKind(
                m_path, "WAV with integers of " + std::to_string(container) + " bits");
        return {};
    }

    /// Whole frames in the file; a finding if they are not as many as declared.
    Index frameCount()
    {
        const std::uint64_t there
            = m_data.begin < m_file->size() ? m_file->size() - m_data.begin : 0;
        const std::uint64_t bytes = m_data.declared ? std::min(m_data.bytes, there) : there;
        const auto frames = static_cast<Index>(bytes / m_format->frameBytes);
        const auto declared = static_cast<Index>(
            std::min<std::uint64_t>(m_data.bytes / m_format->frameBytes, PTRDIFF_MAX));
        if (!m_data.declared)
            m_set.findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 was written as a stream without its length; it was read up to its end (%2 samples per channel), which nothing confirms."),
                    {m_path, std::to_string(frames)}}});
        else if (m_data.bytes > there || bytes % m_format->frameBytes != 0)
            m_set.findings.push_back({.id = "CAP-018",
                .severity = Severity::Caution,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 ends after %2 of the %3 samples per channel that it declares, or within one; it is likely an incomplete copy."),
                    {m_path, std::to_string(frames), std::to_string(declared)}},
                .value = static_cast<double>(frames),
                .limit = static_cast<double>(declared)});
        return frames;
    }

    /// The header states the rate twice, so a wrong one shows.
    double sampleRate()
    {
        const double rate_Hz = m_format->rate_Hz;
        const double implied_Hz
            = static_cast<double>(m_format->bytesPerSecond) / m_format->frameBytes;
        if (rate_Hz > 0.0 && rate_Hz == implied_Hz)
            return rate_Hz;
        m_set.findings.push_back({.id = "CAP-016",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "%1 states %2 samples per second, but its bytes per second mean %3; state the sample rate in the recipe's import section if it is known."),
                {m_path, numberText(rate_Hz), numberText(implied_Hz, 7)}},
            .value = implied_Hz,
            .limit = rate_Hz});
        return 0.0;
    }

    Channel channelOf(Index index, Index frames, double rate_Hz) const
    {
        Channel channel;
        channel.name = "channel " + std::to_string(index + 1);
        channel.unit = "1";
        channel.sampleRate_Hz = rate_Hz;
        if (m_format->tag == kPcm)
            scaleCounts(channel);
        channel.samples = samplesOf(index, frames);
        return channel;
    }

    /// Integers of up to 8 bits are unsigned around 128; the valid bits are the upper ones.
    void scaleCounts(Channel &channel) const
    {
        const int container = 8 * m_format->containerBytes();
        const double full = std::ldexp(1.0, container - 1);
        const double step = std::ldexp(1.0, container - m_format->validBits);
        const double zero = container == 8 ? full : 0.0;
        channel.polynomial = {-zero / full, 1.0 / full};
        channel.adcMin = zero - full;
        channel.adcMax = zero + full - step;
        channel.adcBits = m_format->validBits;
    }

    RawSamples samplesOf(Index index, Index frames) const
    {
        const int bytes = m_format->containerBytes();
        const std::uint64_t begin = m_data.begin + static_cast<std::uint64_t>(index * bytes);
        if (bytes == 3)
            return RawSamples(
                std::make_shared<Int24Source>(m_file, begin, m_format->frameBytes, m_order),
                SampleType::Int32, frames);
        SampleType type = SampleType::UInt8;
        if (m_format->tag == kFloat)
            type = bytes == 4 ? SampleType::Float32 : SampleType::Float64;
        else if (bytes > 1)
            type = bytes == 2 ? SampleType::Int16 : SampleType::Int32;
        return samplesInFile(m_file, {type, m_order, m_format->frameBytes, {{begin, frames}}})
            .value_or(RawSamples());
    }

    const std::string &m_path;
    std::shared_ptr<const SampleFile> m_file;
    std::endian m_order = std::endian::little;
    std::optional<WavFormat> m_format;
    std::optional<std::uint64_t> m_longDataBytes; ///< of a file beyond 4 GB
    WavData m_data;
    CaptureSet m_set;
};

} // namespace

int recogniseWav(const std::string &, std::string_view head)
{
    const bool container = head.starts_with("RIFF") || head.starts_with("RIFX")
        || head.starts_with("RF64") || head.starts_with("BW64");
    return container && head.substr(0, kRiffHeader).ends_with("WAVE") ? 100 : 0;
}

Result<CaptureSet> readWav(const std::string &path, const ImportSettings &, const JobControl &)
{
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    return WavReader(path, *file).read();
}

} // namespace dyncal
