// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/tdms/tdms_cursor.h"
#include "core/capture/formats/tdms/tdms_properties.h"
#include "core/capture/formats/tdms/tdms_types.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// Where one kind of count of a DAQmx channel lies in the raw buffers of its segment.
struct TdmsScaler
{
    TdmsType type = TdmsType::Int16;
    std::uint32_t buffer = 0; ///< one per acquisition card
    std::uint32_t byteOffset = 0; ///< within a row of that buffer
    int bit = -1; ///< 0..7: a digital line, one bit of the byte at byteOffset
    std::uint32_t scaleId = 0;
};

/// Raw data index: how much data of an object a chunk holds, and how.
struct TdmsRawIndex
{
    TdmsType type = TdmsType::Void; ///< without unit mark
    std::uint64_t count = 0; ///< values per chunk
    std::uint64_t textBytes = 0; ///< all texts of a chunk together
    std::vector<TdmsScaler> scalers; ///< not empty: DAQmx data in raw buffers
    std::vector<std::uint32_t> widths; ///< bytes per row of every raw buffer

    bool isDaqmx() const { return !scalers.empty(); }
};

enum class TdmsIndexKind { NoData, AsBefore, Given };

/// What the metadata of one segment say of one object.
struct TdmsObjectEntry
{
    std::string path;
    TdmsIndexKind kind = TdmsIndexKind::NoData;
    TdmsRawIndex index;
    std::vector<std::pair<std::string, TdmsValue>> properties;
};

/// A sentence (DYNCAL_TEXT) with the places %1 file and %2 byte, which the caller fills in, and
/// further ones.
struct TdmsProblem
{
    const char *text = nullptr;
    std::vector<std::string> arguments; ///< from %3 on
};

/// The list of objects of a segment. Declared numbers are compared with the bytes that are left
/// before anything is allocated.
tl::expected<std::vector<TdmsObjectEntry>, TdmsProblem> readTdmsObjects(TdmsCursor &cursor);

enum class TdmsLevel { File, Group, Channel };

/// "/", "/'group'" or "/'group'/'channel'", quotes within names doubled.
struct TdmsPath
{
    TdmsLevel level = TdmsLevel::File;
    std::string group;
    std::string channel;
};

/// Empty if the text is no such path.
std::optional<TdmsPath> parseTdmsPath(std::string_view text);

} // namespace dyncal
