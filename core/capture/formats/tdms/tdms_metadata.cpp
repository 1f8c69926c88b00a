// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_metadata.h"

#include "core/base/message.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::uint32_t kNoData = 0xFFFFFFFF;
constexpr std::uint32_t kAsBefore = 0;
constexpr std::uint32_t kDaqmxFormatChanging = 0x1269;
constexpr std::uint32_t kDaqmxDigitalLine = 0x126A;

constexpr std::uint32_t kMostObjects = 1 << 16;
constexpr std::uint32_t kMostProperties = 100'000; ///< of one object in one segment
constexpr std::uint64_t kSmallestObject = 13; ///< bytes: path "/", index, number of properties
constexpr std::uint64_t kSmallestProperty = 8; ///< bytes: empty name, type void

constexpr const char *kEnds = DYNCAL_TEXT("core",
    "%1 is damaged: the description of the segment at byte %2 ends before all that it declares.");
constexpr const char *kTooMany = DYNCAL_TEXT("core",
    "%1 is damaged: the segment at byte %2 declares %3 %4, more than it has room for or than any recording has.");

using Unexpected = tl::unexpected<TdmsProblem>;

Unexpected ends()
{
    return Unexpected({kEnds, {}});
}

/// Reads how many things follow; each takes at least `bytes`.
tl::expected<std::uint32_t, TdmsProblem> readNumberOf(
    TdmsCursor &cursor, const char *what, std::uint64_t bytes, std::uint32_t most)
{
    std::uint32_t number = 0;
    if (!cursor.number(number))
        return ends();
    if (number > most || number > cursor.remaining() / bytes)
        return Unexpected({kTooMany, {std::to_string(number), what}});
    return number;
}

Unexpected unknownType(const std::string &path, std::uint32_t type)
{
    return Unexpected(
        {DYNCAL_TEXT("core",
             "%1: channel %3 (segment at byte %2) has samples of the type %4, which cannot be read; write them as integers or float64."),
            {path, tdmsTypeName(static_cast<TdmsType>(type))}});
}

/// Fields of a scaler as in the file: `offset` counts bits for a digital line.
struct ScalerFields
{
    std::uint32_t type = 0;
    std::uint32_t buffer = 0;
    std::uint32_t offset = 0;
    std::uint32_t scaleId = 0;
};

bool readScalerFields(TdmsCursor &cursor, bool digital, ScalerFields &fields)
{
    const std::uint64_t bitmapBytes = digital ? 1 : 4;
    return cursor.number(fields.type) && cursor.number(fields.buffer)
        && cursor.number(fields.offset) && cursor.skip(bitmapBytes)
        && cursor.number(fields.scaleId);
}

tl::expected<void, TdmsProblem> readScaler(
    TdmsCursor &cursor, bool digital, const std::string &path, TdmsRawIndex &index)
{
    ScalerFields fields;
    if (!readScalerFields(cursor, digital, fields))
        return ends();
    const std::optional<TdmsType> type = daqmxType(fields.type);
    if (!type)
        return Unexpected(
            {DYNCAL_TEXT("core",
                 "%1: channel %3 (segment at byte %2) has DAQmx counts of the unknown type %4."),
                {path, std::to_string(fields.type)}});
    TdmsScaler scaler{*type, fields.buffer, fields.offset, -1, fields.scaleId};
    if (digital) {
        if (cursor.byteOrder() == std::endian::big && tdmsTypeBytes(*type) != 1)
            return Unexpected(
                {DYNCAL_TEXT("core",
                     "%1: channel %3 (segment at byte %2) has digital lines of several bytes in big-endian order, which cannot be read."),
                    {path}});
        scaler.type = TdmsType::UInt8; // one bit of one byte, whatever the port's width
        scaler.byteOffset = fields.offset / 8;
        scaler.bit = static_cast<int>(fields.offset % 8);
    }
    index.scalers.push_back(scaler);
    return {};
}

tl::expected<void, TdmsProblem> readDaqmxIndex(
    TdmsCursor &cursor, bool digital, const std::string &path, TdmsRawIndex &index)
{
    const auto scalers = readNumberOf(cursor, "scalers", digital ? 17 : 20, kMostObjects);
    if (!scalers)
        return Unexpected(scalers.error());
    for (std::uint32_t i = 0; i < *scalers; ++i) {
        if (auto scaler = readScaler(cursor, digital, path, index); !scaler)
            return scaler;
    }
    const auto widths = readNumberOf(cursor, "raw buffers", 4, kMostObjects);
    if (!widths)
        return Unexpected(widths.error());
    index.widths.resize(*widths);
    for (std::uint32_t &width : index.widths)
        cursor.number(width); // the bytes were checked before
    const bool plainType = index.type != TdmsType::DaqmxRaw;
    if (index.scalers.empty()
        || (plainType && (index.scalers.size() > 1 || index.scalers[0].type != index.type)))
        return Unexpected(
            {DYNCAL_TEXT("core",
                 "%1 is damaged: the DAQmx counts of channel %3 (segment at byte %2) are not of the type %4 that it declares."),
                {path, tdmsTypeName(index.type)}});
    return {};
}

tl::expected<void, TdmsProblem> readRawIndex(TdmsCursor &cursor, TdmsObjectEntry &entry)
{
    std::uint32_t header = 0;
    if (!cursor.number(header))
        return ends();
    if (header == kNoData || header == kAsBefore) {
        entry.kind = header == kNoData ? TdmsIndexKind::NoData : TdmsIndexKind::AsBefore;
        return {};
    }
    entry.kind = TdmsIndexKind::Given;
    TdmsRawIndex &index = entry.index;
    std::uint32_t type = 0;
    std::uint32_t dimension = 0;
    if (!cursor.number(type) || !cursor.number(dimension) || !cursor.number(index.count))
        return ends();
    index.type = withoutUnit(static_cast<TdmsType>(type));
    if (dimension != 1 || !tdmsTypeBytes(index.type))
        return unknownType(entry.path, type);
    if (header == kDaqmxFormatChanging || header == kDaqmxDigitalLine)
        return readDaqmxIndex(cursor, header == kDaqmxDigitalLine, entry.path, index);
    if (index.type == TdmsType::DaqmxRaw)
        return unknownType(entry.path, type);
    if (index.type == TdmsType::String && !cursor.number(index.textBytes))
        return ends();
    return {};
}

tl::expected<void, TdmsProblem> readObject(TdmsCursor &cursor, TdmsObjectEntry &entry)
{
    if (!cursor.text(entry.path))
        return ends();
    if (auto index = readRawIndex(cursor, entry); !index)
        return index;
    const auto properties = readNumberOf(cursor, "properties", kSmallestProperty, kMostProperties);
    if (!properties)
        return Unexpected(properties.error());
    entry.properties.resize(*properties);
    for (auto &[name, value] : entry.properties) {
        if (!cursor.text(name) || !readTdmsValue(cursor, value))
            return ends();
    }
    return {};
}

/// Reads "/'name'" and takes it off the front, with doubled quotes made single.
bool takeName(std::string_view &path, std::string &name)
{
    if (!path.starts_with("/'"))
        return false;
    for (std::size_t i = 2; i < path.size(); ++i) {
        if (path[i] == '\'' && (i + 1 == path.size() || path[i + 1] != '\'')) {
            path.remove_prefix(i + 1);
            return true;
        }
        i += path[i] == '\'' ? 1 : 0; // skips the first of two quotes
        name += path[i];
    }
    return false;
}

} // namespace

tl::expected<std::vector<TdmsObjectEntry>, TdmsProblem> readTdmsObjects(TdmsCursor &cursor)
{
    const auto number = readNumberOf(cursor, "objects", kSmallestObject, kMostObjects);
    if (!number)
        return Unexpected(number.error());
    std::vector<TdmsObjectEntry> entries(*number);
    for (TdmsObjectEntry &entry : entries) {
        if (const auto object = readObject(cursor, entry); !object)
            return Unexpected(object.error());
    }
    return entries;
}

std::optional<TdmsPath> parseTdmsPath(std::string_view text)
{
    TdmsPath path;
    if (text == "/")
        return path;
    path.level = TdmsLevel::Group;
    if (!takeName(text, path.group))
        return {};
    if (text.empty())
        return path;
    path.level = TdmsLevel::Channel;
    if (!takeName(text, path.channel) || !text.empty())
        return {};
    return path;
}

} // namespace dyncal
