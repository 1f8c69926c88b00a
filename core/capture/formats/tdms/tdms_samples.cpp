// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_samples.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace dyncal {
namespace {

/// The sample type that equals the stream's type in the file; empty if there is none.
std::optional<SampleType> directType(const TdmsStream &stream)
{
    if (stream.bit >= 0)
        return {};
    switch (stream.type) {
    case TdmsType::Int8:
        return SampleType::Int8;
    case TdmsType::Int16:
        return SampleType::Int16;
    case TdmsType::Int32:
        return SampleType::Int32;
    case TdmsType::UInt8:
        return SampleType::UInt8;
    case TdmsType::UInt16:
        return SampleType::UInt16;
    case TdmsType::Float32:
        return SampleType::Float32;
    case TdmsType::Float64:
        return SampleType::Float64;
    default:
        return {};
    }
}

Index bytesOf(const TdmsStream &stream)
{
    return tdmsTypeBytes(stream.type).value_or(0);
}

template <typename T>
void toDoubles(const std::byte *bytes, std::span<double> values)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        T value;
        std::memcpy(&value, bytes + i * sizeof(T), sizeof(T));
        values[i] = static_cast<double>(value);
    }
}

void toDoubles(const TdmsStream &stream, const std::byte *bytes, std::span<double> values)
{
    switch (stream.type) {
    case TdmsType::Int8:
        return toDoubles<std::int8_t>(bytes, values);
    case TdmsType::Int16:
        return toDoubles<std::int16_t>(bytes, values);
    case TdmsType::Int32:
        return toDoubles<std::int32_t>(bytes, values);
    case TdmsType::Int64:
        return toDoubles<std::int64_t>(bytes, values);
    case TdmsType::UInt16:
        return toDoubles<std::uint16_t>(bytes, values);
    case TdmsType::UInt32:
        return toDoubles<std::uint32_t>(bytes, values);
    case TdmsType::UInt64:
        return toDoubles<std::uint64_t>(bytes, values);
    case TdmsType::Float32:
        return toDoubles<float>(bytes, values);
    case TdmsType::Float64:
        return toDoubles<double>(bytes, values);
    default:
        return toDoubles<std::uint8_t>(bytes, values);
    }
}

/// Bits or truth values as 0 and 1.
void toTruth(const TdmsStream &stream, std::byte *bytes, Index count)
{
    for (Index i = 0; i < count; ++i) {
        const auto value = std::to_integer<unsigned>(bytes[i]);
        const bool truth = stream.bit >= 0 ? ((value >> stream.bit) & 1U) != 0 : value != 0;
        bytes[i] = std::byte{truth};
    }
}

bool isTruth(const TdmsStream &stream)
{
    return stream.bit >= 0 || stream.type == TdmsType::Bool;
}

/// Reads samples of a stream as they are; bits and truth values become 0 and 1.
bool readStream(
    const SampleFile &file, const TdmsStream &stream, Index begin, Index count, std::byte *target)
{
    if (!stream.runs.read(file, bytesOf(stream), begin, count, target))
        return false;
    if (isTruth(stream))
        toTruth(stream, target, count);
    return true;
}

class DirectSource : public SampleSource
{
public:
    DirectSource(std::shared_ptr<const SampleFile> file, TdmsStream stream)
        : m_file(std::move(file))
        , m_stream(std::move(stream))
    {
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        return readStream(*m_file, m_stream, begin, count, target);
    }

    bool isUnchanged() const override { return m_file->unchanged(); }

private:
    std::shared_ptr<const SampleFile> m_file;
    TdmsStream m_stream;
};

/// Double precision values, computed block by block.
class ComputedSource : public SampleSource
{
public:
    ComputedSource(std::shared_ptr<const SampleFile> file, std::vector<TdmsStream> streams,
        TdmsScaleChain chain)
        : m_file(std::move(file))
        , m_streams(std::move(streams))
        , m_chain(std::move(chain))
    {
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        constexpr Index kBlock = 4096;
        std::vector<std::vector<double>> raw(m_streams.size());
        std::vector<double> values;
        for (Index done = 0; done < count; done += kBlock) {
            const Index here = std::min(kBlock, count - done);
            for (std::size_t s = 0; s < m_streams.size(); ++s) {
                if (!readDoubles(m_streams[s], begin + done, here, raw[s]))
                    return false;
            }
            values.resize(static_cast<std::size_t>(here));
            evaluate(m_chain, raw, values);
            std::memcpy(target + done * static_cast<Index>(sizeof(double)), values.data(),
                values.size() * sizeof(double));
        }
        return true;
    }

    bool isUnchanged() const override { return m_file->unchanged(); }

private:
    bool readDoubles(
        const TdmsStream &stream, Index begin, Index count, std::vector<double> &values) const
    {
        std::vector<std::byte> bytes(static_cast<std::size_t>(count * bytesOf(stream)));
        values.resize(static_cast<std::size_t>(count));
        if (!readStream(*m_file, stream, begin, count, bytes.data()))
            return false;
        toDoubles(stream, bytes.data(), values);
        return true;
    }

    std::shared_ptr<const SampleFile> m_file;
    std::vector<TdmsStream> m_streams;
    TdmsScaleChain m_chain;
};

struct Range
{
    double lowest = 0.0;
    double highest = 0.0; ///< equal: the type has no limits
};

template <typename T>
Range rangeOf()
{
    return {static_cast<double>(std::numeric_limits<T>::lowest()),
        static_cast<double>(std::numeric_limits<T>::max())};
}

Range rangeOf(const TdmsStream &stream)
{
    switch (stream.type) {
    case TdmsType::Int8:
        return rangeOf<std::int8_t>();
    case TdmsType::Int16:
        return rangeOf<std::int16_t>();
    case TdmsType::Int32:
        return rangeOf<std::int32_t>();
    case TdmsType::UInt8:
        return rangeOf<std::uint8_t>();
    case TdmsType::UInt16:
        return rangeOf<std::uint16_t>();
    case TdmsType::UInt32:
        return rangeOf<std::uint32_t>();
    default:
        return {};
    }
}

TdmsScaleChain rawChain()
{
    TdmsScaleChain chain;
    chain.nodes.emplace_back();
    return chain;
}

/// The streams that a chain uses; its nodes are renumbered to these.
std::vector<TdmsStream> usedStreams(const TdmsObject &channel, TdmsScaleChain &chain)
{
    std::vector<TdmsStream> used;
    std::vector<std::size_t> original;
    for (TdmsScaleNode &node : chain.nodes) {
        if (node.kind != TdmsScaleNode::Kind::Raw)
            continue;
        const auto known = std::find(original.begin(), original.end(), node.stream);
        if (known == original.end()) {
            original.push_back(node.stream);
            used.push_back(channel.streams[node.stream]);
            node.stream = used.size() - 1;
        } else {
            node.stream = static_cast<std::size_t>(known - original.begin());
        }
    }
    return used;
}

Index shortest(const std::vector<TdmsStream> &streams)
{
    Index size = std::numeric_limits<Index>::max();
    for (const TdmsStream &stream : streams)
        size = std::min(size, stream.runs.size());
    return size;
}

bool isLarge(TdmsType type)
{
    return type == TdmsType::Int64 || type == TdmsType::UInt64;
}

} // namespace

TdmsRecords::TdmsRecords(std::shared_ptr<const SampleFile> file)
    : m_file(std::move(file))
    , m_scanBytesLeft(m_file->size())
{
}

tl::expected<std::vector<TdmsRecord>, Message> TdmsRecords::of(
    const TdmsObject &channel, std::span<const TdmsProperties *const> holders)
{
    const bool daqmx = channel.index && channel.index->isDaqmx();
    const bool bare = channel.type == TdmsType::DaqmxRaw;
    TdmsCounts counts;
    counts.daqmx = bare;
    if (daqmx) {
        for (const TdmsStream &stream : channel.streams)
            counts.scaleIds.push_back(stream.scaleId);
    }
    auto chain = tdmsScaleChain(channel.path.channel, holders, counts);
    if (!chain)
        return tl::unexpected(chain.error());
    std::vector<TdmsRecord> records;
    if (*chain) {
        const bool isRaw = (*chain)->isRaw();
        auto record = isRaw ? unscaled(channel, (*chain)->nodes[0].stream)
                            : scaled(channel, std::move(**chain));
        if (!record)
            return tl::unexpected(record.error());
        records.push_back(std::move(*record));
        return records;
    }
    for (std::size_t i = 0; i < channel.streams.size(); ++i) {
        auto record = unscaled(channel, i);
        if (!record)
            return tl::unexpected(record.error());
        record->suffix = " (counts " + std::to_string(channel.streams[i].scaleId) + ")";
        records.push_back(std::move(*record));
    }
    return records;
}

tl::expected<TdmsRecord, Message> TdmsRecords::unscaled(
    const TdmsObject &channel, std::size_t index)
{
    const TdmsStream &stream = channel.streams[index];
    TdmsRecord record;
    record.bareCounts = channel.type == TdmsType::DaqmxRaw && stream.bit < 0;
    std::optional<SampleType> type = directType(stream);
    if (!type && isTruth(stream))
        type = SampleType::UInt8;
    if (type) {
        record.samples
            = RawSamples(std::make_shared<DirectSource>(m_file, stream), *type, stream.runs.size());
        return record;
    }
    if (const auto fits = checkLargeIntegers(channel.path.channel, stream); !fits)
        return tl::unexpected(fits.error());
    record.samples
        = RawSamples(std::make_shared<ComputedSource>(m_file, std::vector{stream}, rawChain()),
            SampleType::Float64, stream.runs.size());
    return record;
}

tl::expected<TdmsRecord, Message> TdmsRecords::scaled(
    const TdmsObject &channel, TdmsScaleChain chain)
{
    const Range range = rangeOf(channel.streams[chain.nodes[0].stream]);
    if (auto polynomial = asPolynomial(chain, range.lowest, range.highest)) {
        auto record = unscaled(channel, polynomial->stream);
        if (record) {
            record->polynomial = std::move(polynomial->coefficients);
            record->bareCounts = false;
        }
        return record;
    }
    std::vector<TdmsStream> streams = usedStreams(channel, chain);
    for (const TdmsStream &stream : streams) {
        if (const auto fits = checkLargeIntegers(channel.path.channel, stream); !fits)
            return tl::unexpected(fits.error());
    }
    TdmsRecord record;
    const Index size = shortest(streams);
    record.samples
        = RawSamples(std::make_shared<ComputedSource>(m_file, std::move(streams), std::move(chain)),
            SampleType::Float64, size);
    return record;
}

tl::expected<void, Message> TdmsRecords::checkLargeIntegers(
    const std::string &channel, const TdmsStream &stream)
{
    constexpr std::int64_t kExact = std::int64_t{1} << 53;
    constexpr Index kBlock = 1 << 15;
    if (!isLarge(stream.type))
        return {};
    const auto bytes = static_cast<std::uint64_t>(stream.runs.size()) * sizeof(std::int64_t);
    if (bytes > m_scanBytesLeft)
        return tl::unexpected(
            Message{DYNCAL_TEXT("core", "Channel %1 claims samples that belong to other channels."),
                {channel}});
    m_scanBytesLeft -= bytes;
    std::vector<std::int64_t> block(static_cast<std::size_t>(kBlock));
    for (Index first = 0; first < stream.runs.size(); first += kBlock) {
        const Index here = std::min(kBlock, stream.runs.size() - first);
        const std::span values(block.data(), static_cast<std::size_t>(here));
        if (!readStream(*m_file, stream, first, here, std::as_writable_bytes(values).data()))
            return tl::unexpected(Message{
                DYNCAL_TEXT("core", "Channel %1 cannot be read; the file changed meanwhile."),
                {channel}});
        const bool fits = std::all_of(values.begin(), values.end(), [&](std::int64_t value) {
            return value <= kExact && value >= (stream.type == TdmsType::UInt64 ? 0 : -kExact);
        });
        if (!fits)
            return tl::unexpected(Message{
                DYNCAL_TEXT("core",
                    "Channel %1 has 64 bit integers beyond 2^53, which a floating point number does not hold exactly; write it as int32 or float64."),
                {channel}});
    }
    return {};
}

} // namespace dyncal
