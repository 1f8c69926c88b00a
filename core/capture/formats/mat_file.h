// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/file_samples.h"
#include "core/capture/formats/expansion_budget.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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

/// Bytes of one number; 0 for a code that is no number.
Index bytesOfMatNumber(MatNumber number);

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

/// 4 for the version 4, 5 for the versions 5 to 7.2; 0 = neither (7.3 is HDF5).
int matVersion(std::string_view head);

/// Lists the variables of a MAT file of version 4 or 5 to 7.2. Compressed matrices are expanded
/// into memory as far as the budget goes, more fails. Fails with CAP-018 where the file is cut or
/// contradicts itself.
Result<std::vector<MatVariable>> listMatFile(const std::string &path,
    const std::shared_ptr<const SampleFile> &file, ExpansionBudget &budget,
    const JobControl &control);

/// The numbers first, first + step, ... of a numeric variable, `count` of them, which must be
/// there: left in the file where they can be; whole numbers of 32 bits without sign and of 64 bits
/// become float64. Empty if 64-bit numbers are no exact float64 or the file cannot be read any
/// more.
std::optional<RawSamples> matSamples(const std::shared_ptr<const SampleFile> &file,
    const MatVariable &variable, Index first, Index step, Index count);

} // namespace dyncal
