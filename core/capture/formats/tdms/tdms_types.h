// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <cstdint>
#include <optional>
#include <string>

namespace dyncal {

/// Types of samples and properties, by their numbers in the file.
enum class TdmsType : std::uint32_t {
    Void = 0,
    Int8 = 1,
    Int16 = 2,
    Int32 = 3,
    Int64 = 4,
    UInt8 = 5,
    UInt16 = 6,
    UInt32 = 7,
    UInt64 = 8,
    Float32 = 9,
    Float64 = 10,
    Float32WithUnit = 0x19,
    Float64WithUnit = 0x1A,
    String = 0x20,
    Bool = 0x21,
    Timestamp = 0x44,
    Complex64 = 0x08000C,
    Complex128 = 0x10000D,
    DaqmxRaw = 0xFFFFFFFF,
};

/// Bytes of one value; 0 where values have no fixed size (strings, DAQmx raw data). Empty for
/// numbers that are no type, or one whose size nobody documents (extended, fixed point).
std::optional<Index> tdmsTypeBytes(TdmsType type);

/// "int16", "text", "number 79"
std::string tdmsTypeName(TdmsType type);

/// The same bytes without the mark that a unit belongs to them.
TdmsType withoutUnit(TdmsType type);

/// DAQmx numbers its types in another way; empty for unknown ones.
std::optional<TdmsType> daqmxType(std::uint32_t number);

/// An instant as the file has it: no rounding.
struct TdmsTimestamp
{
    std::int64_t seconds = 0; ///< since 1904-01-01 00:00 UTC, without leap seconds
    std::uint64_t fraction = 0; ///< of a second, in 2^-64 s

    bool operator==(const TdmsTimestamp &) const = default;
};

/// "2012-07-09T23:58:24.593731123456Z": cut, not rounded, to picoseconds, zeros at the end left
/// out. Empty for 1904-01-01 (LabVIEW's "not set") and outside the years 1 to 9999.
std::string isoText(const TdmsTimestamp &time);

} // namespace dyncal
