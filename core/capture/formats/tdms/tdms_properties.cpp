// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_properties.h"

#include "core/base/number_text.h"

#include <cmath>
#include <type_traits>

namespace dyncal {
namespace {

template <typename Bits, typename Number, typename Kept>
bool readNumber(TdmsCursor &cursor, TdmsValue &value)
{
    Bits bits = 0;
    if (!cursor.number(bits))
        return false;
    value = static_cast<Kept>(std::bit_cast<Number>(bits));
    return true;
}

bool readTimestamp(TdmsCursor &cursor, TdmsValue &value)
{
    // Little endian has the fraction first, big endian the seconds, like one number of 128 bits.
    std::uint64_t first = 0;
    std::uint64_t second = 0;
    if (!cursor.number(first) || !cursor.number(second))
        return false;
    if (cursor.byteOrder() == std::endian::big)
        std::swap(first, second);
    value = TdmsTimestamp{static_cast<std::int64_t>(second), first};
    return true;
}

bool readText(TdmsCursor &cursor, TdmsValue &value)
{
    std::string text;
    if (!cursor.text(text))
        return false;
    value = std::move(text);
    return true;
}

const TdmsValue *valueNamed(const TdmsProperties &properties, std::string_view name)
{
    const auto found = properties.find(name);
    return found != properties.end() ? &found->second : nullptr;
}

} // namespace

bool readTdmsValue(TdmsCursor &cursor, TdmsValue &value)
{
    std::uint32_t number = 0;
    if (!cursor.number(number))
        return false;
    const auto type = static_cast<TdmsType>(number);
    switch (withoutUnit(type)) {
    case TdmsType::Int8:
        return readNumber<std::uint8_t, std::int8_t, std::int64_t>(cursor, value);
    case TdmsType::Int16:
        return readNumber<std::uint16_t, std::int16_t, std::int64_t>(cursor, value);
    case TdmsType::Int32:
        return readNumber<std::uint32_t, std::int32_t, std::int64_t>(cursor, value);
    case TdmsType::Int64:
        return readNumber<std::uint64_t, std::int64_t, std::int64_t>(cursor, value);
    case TdmsType::UInt8:
    case TdmsType::Bool:
        return readNumber<std::uint8_t, std::uint8_t, std::uint64_t>(cursor, value);
    case TdmsType::UInt16:
        return readNumber<std::uint16_t, std::uint16_t, std::uint64_t>(cursor, value);
    case TdmsType::UInt32:
        return readNumber<std::uint32_t, std::uint32_t, std::uint64_t>(cursor, value);
    case TdmsType::UInt64:
        return readNumber<std::uint64_t, std::uint64_t, std::uint64_t>(cursor, value);
    case TdmsType::Float32:
        return readNumber<std::uint32_t, float, double>(cursor, value);
    case TdmsType::Float64:
        return readNumber<std::uint64_t, double, double>(cursor, value);
    case TdmsType::Timestamp:
        return readTimestamp(cursor, value);
    case TdmsType::String:
        return readText(cursor, value);
    default:
        break;
    }
    value = std::monostate();
    const std::optional<Index> bytes = tdmsTypeBytes(type);
    return bytes && type != TdmsType::DaqmxRaw && cursor.skip(static_cast<std::uint64_t>(*bytes));
}

std::optional<double> numberOf(const TdmsProperties &properties, std::string_view name)
{
    const TdmsValue *value = valueNamed(properties, name);
    if (value == nullptr)
        return {};
    return std::visit(
        [](const auto &held) -> std::optional<double> {
            if constexpr (std::is_arithmetic_v<std::decay_t<decltype(held)>>)
                return static_cast<double>(held);
            else
                return {};
        },
        *value);
}

std::optional<std::uint64_t> countOf(const TdmsProperties &properties, std::string_view name)
{
    const TdmsValue *value = valueNamed(properties, name);
    if (value == nullptr)
        return {};
    if (const auto *number = std::get_if<std::uint64_t>(value))
        return *number;
    const auto *number = std::get_if<std::int64_t>(value);
    return number != nullptr && *number >= 0 ? std::optional(static_cast<std::uint64_t>(*number))
                                             : std::nullopt;
}

std::string textOf(const TdmsProperties &properties, std::string_view name)
{
    const TdmsValue *value = valueNamed(properties, name);
    const auto *text = value != nullptr ? std::get_if<std::string>(value) : nullptr;
    return text != nullptr ? *text : std::string();
}

std::optional<TdmsTimestamp> timestampOf(const TdmsProperties &properties, std::string_view name)
{
    const TdmsValue *value = valueNamed(properties, name);
    const auto *time = value != nullptr ? std::get_if<TdmsTimestamp>(value) : nullptr;
    return time != nullptr ? std::optional(*time) : std::nullopt;
}

std::string valueText(const TdmsValue &value)
{
    return std::visit(
        [](const auto &held) -> std::string {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, double>)
                return exactNumber(held);
            else if constexpr (std::is_integral_v<Held>)
                return std::to_string(held);
            else if constexpr (std::is_same_v<Held, std::string>)
                return held;
            else if constexpr (std::is_same_v<Held, TdmsTimestamp>)
                return isoText(held);
            else
                return {};
        },
        value);
}

} // namespace dyncal
