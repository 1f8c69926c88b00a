// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_types.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace dyncal {
namespace {

struct TypeEntry
{
    TdmsType type;
    Index bytes;
    const char *name;
};

constexpr std::array kTypes{
    TypeEntry{TdmsType::Void, 0, "void"},
    TypeEntry{TdmsType::Int8, 1, "int8"},
    TypeEntry{TdmsType::Int16, 2, "int16"},
    TypeEntry{TdmsType::Int32, 4, "int32"},
    TypeEntry{TdmsType::Int64, 8, "int64"},
    TypeEntry{TdmsType::UInt8, 1, "uint8"},
    TypeEntry{TdmsType::UInt16, 2, "uint16"},
    TypeEntry{TdmsType::UInt32, 4, "uint32"},
    TypeEntry{TdmsType::UInt64, 8, "uint64"},
    TypeEntry{TdmsType::Float32, 4, "float32"},
    TypeEntry{TdmsType::Float64, 8, "float64"},
    TypeEntry{TdmsType::Float32WithUnit, 4, "float32"},
    TypeEntry{TdmsType::Float64WithUnit, 8, "float64"},
    TypeEntry{TdmsType::String, 0, "text"},
    TypeEntry{TdmsType::Bool, 1, "boolean"},
    TypeEntry{TdmsType::Timestamp, 16, "time stamp"},
    TypeEntry{TdmsType::Complex64, 8, "complex64"},
    TypeEntry{TdmsType::Complex128, 16, "complex128"},
    TypeEntry{TdmsType::DaqmxRaw, 0, "DAQmx raw data"},
};

const TypeEntry *entryOf(TdmsType type)
{
    const auto found = std::find_if(
        kTypes.begin(), kTypes.end(), [&](const TypeEntry &entry) { return entry.type == type; });
    return found != kTypes.end() ? &*found : nullptr;
}

/// `digits` decimal digits of fraction / 2^64, cut.
std::string decimalDigits(std::uint64_t fraction, int digits)
{
    constexpr std::uint64_t kLow = 0xFFFFFFFF;
    std::string text;
    for (int i = 0; i < digits; ++i) {
        const std::uint64_t low = (fraction & kLow) * 10;
        const std::uint64_t high = (fraction >> 32) * 10 + (low >> 32);
        text += static_cast<char>('0' + (high >> 32));
        fraction = (high << 32) | (low & kLow);
    }
    return text;
}

std::string padded(int value, std::size_t width)
{
    std::string text = std::to_string(value);
    return std::string(width > text.size() ? width - text.size() : 0, '0') + text;
}

} // namespace

std::optional<Index> tdmsTypeBytes(TdmsType type)
{
    const TypeEntry *entry = entryOf(type);
    return entry != nullptr ? std::optional(entry->bytes) : std::nullopt;
}

std::string tdmsTypeName(TdmsType type)
{
    const TypeEntry *entry = entryOf(type);
    return entry != nullptr ? entry->name
                            : "number " + std::to_string(static_cast<std::uint32_t>(type));
}

TdmsType withoutUnit(TdmsType type)
{
    if (type == TdmsType::Float32WithUnit)
        return TdmsType::Float32;
    return type == TdmsType::Float64WithUnit ? TdmsType::Float64 : type;
}

std::optional<TdmsType> daqmxType(std::uint32_t number)
{
    constexpr std::array kOrder{TdmsType::UInt8, TdmsType::Int8, TdmsType::UInt16, TdmsType::Int16,
        TdmsType::UInt32, TdmsType::Int32, TdmsType::UInt64, TdmsType::Int64, TdmsType::Float32,
        TdmsType::Float64};
    constexpr std::uint32_t kTimestamp = 0xFFFFFFFF;
    if (number < kOrder.size())
        return kOrder[number];
    return number == kTimestamp ? std::optional(TdmsType::Timestamp) : std::nullopt;
}

std::string isoText(const TdmsTimestamp &time)
{
    using std::chrono::days;
    using std::chrono::seconds;
    using std::chrono::year;
    constexpr std::chrono::sys_days kEpoch = year(1904) / 1 / 1;
    constexpr std::chrono::sys_days kFirst = year(1) / 1 / 1;
    constexpr std::chrono::sys_days kEnd = year(10000) / 1 / 1;
    constexpr int kDigits = 12;
    const bool unset = time.seconds == 0;
    if (unset || time.seconds < seconds(kFirst - kEpoch).count()
        || time.seconds >= seconds(kEnd - kEpoch).count())
        return {};
    const auto instant = kEpoch + seconds(time.seconds);
    const auto day = std::chrono::floor<days>(instant);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss clock(instant - day);
    std::string text = padded(static_cast<int>(date.year()), 4) + "-"
        + padded(static_cast<int>(static_cast<unsigned>(date.month())), 2) + "-"
        + padded(static_cast<int>(static_cast<unsigned>(date.day())), 2) + "T"
        + padded(static_cast<int>(clock.hours().count()), 2) + ":"
        + padded(static_cast<int>(clock.minutes().count()), 2) + ":"
        + padded(static_cast<int>(clock.seconds().count()), 2);
    std::string digits = decimalDigits(time.fraction, kDigits);
    digits.erase(digits.find_last_not_of('0') + 1);
    return text + (digits.empty() ? "" : ".") + digits + "Z";
}

} // namespace dyncal
