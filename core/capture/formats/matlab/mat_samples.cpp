// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/matlab/mat_samples.h"

#include "core/capture/formats/bytes/byte_reader.h"

#include <utility>

namespace dyncal {
namespace {

template <typename T>
T numberAt(const std::byte *raw, std::endian order)
{
    return ByteReader({raw, sizeof(T)}, order).next<T>();
}

/// Numbers out of a block in memory, as Out.
template <typename In, typename Out>
std::optional<RawSamples> converted(
    const std::byte *raw, std::endian order, Index stepBytes, Index count)
{
    std::vector<Out> values(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) {
        const In value = numberAt<In>(raw + i * stepBytes, order);
        const auto out = static_cast<Out>(value);
        if constexpr (sizeof(In) == 8 && !std::is_same_v<In, Out>) {
            constexpr std::int64_t kExact = std::int64_t(1) << 53;
            if (std::cmp_greater(value, kExact) || std::cmp_less(value, -kExact))
                return {};
        }
        values[static_cast<std::size_t>(i)] = out;
    }
    return RawSamples(std::move(values));
}

std::optional<RawSamples> samplesInMemory(
    const std::byte *raw, const MatVariable &variable, Index stepBytes, Index count)
{
    const std::endian order = variable.order;
    switch (variable.number) {
    case MatNumber::Int8:
        return converted<std::int8_t, std::int8_t>(raw, order, stepBytes, count);
    case MatNumber::UInt8:
        return converted<std::uint8_t, std::uint8_t>(raw, order, stepBytes, count);
    case MatNumber::Int16:
        return converted<std::int16_t, std::int16_t>(raw, order, stepBytes, count);
    case MatNumber::UInt16:
        return converted<std::uint16_t, std::uint16_t>(raw, order, stepBytes, count);
    case MatNumber::Int32:
        return converted<std::int32_t, std::int32_t>(raw, order, stepBytes, count);
    case MatNumber::UInt32:
        return converted<std::uint32_t, double>(raw, order, stepBytes, count);
    case MatNumber::Float32:
        return converted<float, float>(raw, order, stepBytes, count);
    case MatNumber::Float64:
        return converted<double, double>(raw, order, stepBytes, count);
    case MatNumber::Int64:
        return converted<std::int64_t, double>(raw, order, stepBytes, count);
    case MatNumber::UInt64:
        return converted<std::uint64_t, double>(raw, order, stepBytes, count);
    }
    return {};
}

/// The type that keeps such numbers as they are, if there is one.
std::optional<SampleType> sampleTypeOf(MatNumber number)
{
    switch (number) {
    case MatNumber::Int8:
        return SampleType::Int8;
    case MatNumber::UInt8:
        return SampleType::UInt8;
    case MatNumber::Int16:
        return SampleType::Int16;
    case MatNumber::UInt16:
        return SampleType::UInt16;
    case MatNumber::Int32:
        return SampleType::Int32;
    case MatNumber::Float32:
        return SampleType::Float32;
    case MatNumber::Float64:
        return SampleType::Float64;
    case MatNumber::UInt32:
    case MatNumber::Int64:
    case MatNumber::UInt64:
        break;
    }
    return {};
}

} // namespace

Index bytesOfMatNumber(MatNumber number)
{
    switch (number) {
    case MatNumber::Int8:
    case MatNumber::UInt8:
        return 1;
    case MatNumber::Int16:
    case MatNumber::UInt16:
        return 2;
    case MatNumber::Int32:
    case MatNumber::UInt32:
    case MatNumber::Float32:
        return 4;
    case MatNumber::Float64:
    case MatNumber::Int64:
    case MatNumber::UInt64:
        return 8;
    }
    return 0;
}

std::optional<RawSamples> matSamples(const std::shared_ptr<const SampleFile> &file,
    const MatVariable &variable, Index first, Index step, Index count)
{
    const Index size = bytesOfMatNumber(variable.number);
    if (variable.expanded)
        return samplesInMemory(
            variable.expanded->data() + first * size, variable, step * size, count);
    const std::uint64_t offset = variable.offset + static_cast<std::uint64_t>(first * size);
    if (const auto type = sampleTypeOf(variable.number))
        return samplesInFile(file, {*type, variable.order, step * size, {{offset, count}}});
    const auto bytes = static_cast<std::size_t>(((count - 1) * step + 1) * size);
    const std::vector<std::byte> raw = bytesAt(*file, offset, bytes);
    return raw.size() == bytes ? samplesInMemory(raw.data(), variable, step * size, count)
                               : std::nullopt;
}

} // namespace dyncal
