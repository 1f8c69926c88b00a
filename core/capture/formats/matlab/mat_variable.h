// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dyncal {

/// How a number lies in a MAT file (the codes of version 5).
enum class MatNumber : std::uint32_t {
    Int8 = 1,
    UInt8 = 2,
    Int16 = 3,
    UInt16 = 4,
    Int32 = 5,
    UInt32 = 6,
    Float32 = 7,
    Float64 = 9,
    Int64 = 12,
    UInt64 = 13,
};

/// One variable of a MAT file. Real full numeric matrices have samples, of others only name and
/// kind are known.
struct MatVariable
{
    std::string name;
    std::string kind; ///< what it is if it is no real numeric matrix: "struct", "complex", ...
    Index rows = 0;
    Index columns = 0;
    MatNumber number = MatNumber::Float64;
    std::endian order = std::endian::little;
    std::uint64_t offset = 0; ///< of the first number in the file, column by column
    std::shared_ptr<const std::vector<std::byte>> expanded; ///< those numbers if compressed

    Index size() const { return rows * columns; }
    bool isNumeric() const { return kind.empty(); }
};

} // namespace dyncal
