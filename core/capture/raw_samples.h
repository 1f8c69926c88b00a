// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace dyncal {

/// How one sample is kept: exactly as the source recorded it.
enum class SampleType { Int16, Int32, Float32, Float64, Int8, UInt8, UInt16 };

/// 1, 2, 4 or 8.
Index bytesPerSample(SampleType type);

/// Samples that are not in memory, usually in their recording.
class SampleSource
{
public:
    SampleSource() = default;
    SampleSource(const SampleSource &) = delete;
    SampleSource &operator=(const SampleSource &) = delete;
    virtual ~SampleSource() = default;

    /// Copies samples [begin, begin + count), which must lie within the record, to `target` in the
    /// byte order of this machine. False if they are no longer what they were when the source was
    /// opened (file changed, shortened, unreachable): then nothing of `target` may be used.
    /// Several threads may read at once.
    virtual bool read(Index begin, Index count, std::byte *target) const = 0;

    /// Whether they are still what they were when the source was opened, as far as can be told
    /// without reading them.
    virtual bool isUnchanged() const { return true; }

    void noteFailure() const { m_hasFailed = true; }
    bool hasFailed() const { return m_hasFailed; }

private:
    mutable std::atomic<bool> m_hasFailed = false; ///< what was made of them may have gaps
};

/// The samples of one channel exactly as recorded: integer counts where the source has counts.
/// Immutable and shared, so copies of a shot cost nothing. They are in memory or read from their
/// file on demand; only the part that an analysis asks for is converted to double (`physicalValues`
/// in channel.h), never whole records.
class RawSamples
{
public:
    /// In the order of SampleType.
    using Counts = std::variant<std::vector<std::int16_t>, std::vector<std::int32_t>,
        std::vector<float>, std::vector<double>, std::vector<std::int8_t>,
        std::vector<std::uint8_t>, std::vector<std::uint16_t>>;

    /// Samples visited at a time if they are not in memory.
    static constexpr Index kBlock = 1 << 20;

    RawSamples();
    explicit RawSamples(Counts counts);
    RawSamples(std::shared_ptr<const SampleSource> source, SampleType type, Index size);

    Index size() const { return m_size; }
    SampleType type() const { return m_type; }
    bool isInteger() const
    {
        return m_type != SampleType::Float32 && m_type != SampleType::Float64;
    }
    bool isInMemory() const { return m_source == nullptr; }
    /// Whether every sample could be read so far and still can: false of a file that changed, also
    /// if only a name of it did.
    bool isWhole() const
    {
        return isInMemory() || (!m_source->hasFailed() && m_source->isUnchanged());
    }
    /// Whether both are one and the same record, however it is kept; equal copies are not.
    bool sharesWith(const RawSamples &other) const
    {
        return m_counts == other.m_counts && m_source == other.m_source && m_size == other.m_size;
    }

    /// Raw value (count, or value for floating point sources) of sample `i`, 0 <= i < size(); NaN
    /// if the source cannot be read any more. For single samples; in a loop use visitBlocks().
    double at(Index i) const;

    /// Calls `visit(std::span<const T> values, Index first)` for stretches that together are
    /// [begin, end), in order; T is the type of the samples. In memory that is one stretch,
    /// otherwise one per block of at most kBlock samples. Stops and returns false if the source
    /// cannot be read any more. `visit` may return bool: false ends the visit (and the call returns
    /// true).
    template <typename Visit>
    bool visitBlocks(Index begin, Index end, Visit &&visit) const;

    /// The samples [begin, begin + count) copied into memory; empty if they cannot be read.
    RawSamples inMemory(Index begin, Index count) const;
    RawSamples inMemory() const { return isInMemory() ? *this : inMemory(0, m_size); }

private:
    template <typename T, typename Visit>
    static bool goesOn(Visit &visit, std::span<const T> values, Index first);
    template <typename T, typename Visit>
    bool visitAs(Index begin, Index end, Visit &visit) const;

    std::shared_ptr<const Counts> m_counts; ///< null where a source has them
    std::shared_ptr<const SampleSource> m_source;
    SampleType m_type = SampleType::Int16;
    Index m_size = 0;
};

/// SHA-256 of the samples as little-endian bytes; empty if they cannot be read.
std::string sha256OfSamples(const RawSamples &samples);

template <typename T, typename Visit>
bool RawSamples::goesOn(Visit &visit, std::span<const T> values, Index first)
{
    if constexpr (std::is_same_v<decltype(visit(values, first)), bool>)
        return visit(values, first);
    visit(values, first);
    return true;
}

template <typename T, typename Visit>
bool RawSamples::visitAs(Index begin, Index end, Visit &visit) const
{
    const auto count = static_cast<std::size_t>(end - begin);
    if (m_source == nullptr) {
        const auto &values = std::get<std::vector<T>>(*m_counts);
        goesOn<T>(visit, std::span(values).subspan(static_cast<std::size_t>(begin), count), begin);
        return true;
    }
    std::vector<T> block(std::min(count, static_cast<std::size_t>(kBlock)));
    for (Index first = begin; first < end; first += kBlock) {
        const std::span values(
            block.data(), static_cast<std::size_t>(std::min(end - first, kBlock)));
        if (!m_source->read(first, std::ssize(values), std::as_writable_bytes(values).data())) {
            m_source->noteFailure();
            return false;
        }
        if (!goesOn<T>(visit, values, first))
            return true;
    }
    return true;
}

template <typename Visit>
bool RawSamples::visitBlocks(Index begin, Index end, Visit &&visit) const
{
    switch (m_type) {
    case SampleType::Int16:
        return visitAs<std::int16_t>(begin, end, visit);
    case SampleType::Int32:
        return visitAs<std::int32_t>(begin, end, visit);
    case SampleType::Float32:
        return visitAs<float>(begin, end, visit);
    case SampleType::Float64:
        return visitAs<double>(begin, end, visit);
    case SampleType::Int8:
        return visitAs<std::int8_t>(begin, end, visit);
    case SampleType::UInt8:
        return visitAs<std::uint8_t>(begin, end, visit);
    case SampleType::UInt16:
        return visitAs<std::uint16_t>(begin, end, visit);
    }
    return false;
}

} // namespace dyncal
