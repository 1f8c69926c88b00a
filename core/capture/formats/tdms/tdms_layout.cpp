// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_layout.h"

#include "core/base/message.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

using Objects = std::vector<TdmsObject *>;
using Unexpected = tl::unexpected<TdmsProblem>;
__extension__ using Wide = unsigned __int128;

constexpr Wide kTooWide = std::numeric_limits<std::uint64_t>::max();

/// The whole chunks of a segment and the rest after them.
struct Chunks
{
    Wide bytes = 0; ///< of one chunk
    std::uint64_t whole = 0;
    std::uint64_t rest = 0; ///< bytes after the last whole chunk
};

Chunks chunksOf(const TdmsRegion &region, Wide bytes)
{
    if (bytes == 0)
        return {};
    if (bytes > region.bytes)
        return {bytes, 0, region.bytes};
    const auto narrow = static_cast<std::uint64_t>(bytes);
    return {bytes, region.bytes / narrow, region.bytes % narrow};
}

std::uint64_t bytesOf(const TdmsRawIndex &index)
{
    return static_cast<std::uint64_t>(tdmsTypeBytes(index.type).value_or(0));
}

Wide plainBytes(const TdmsRawIndex &index)
{
    return index.type == TdmsType::String ? Wide(index.textBytes)
                                          : Wide(index.count) * bytesOf(index);
}

/// How many values the segment declares, all its chunks together.
void declare(const TdmsRegion &region, const Chunks &chunks, const Objects &objects)
{
    if (chunks.bytes == 0)
        return;
    const double bytes = static_cast<double>(chunks.bytes);
    const double declared = std::max(static_cast<double>(chunks.whole + (chunks.rest > 0 ? 1 : 0)),
        std::floor(static_cast<double>(region.declaredBytes) / bytes));
    for (TdmsObject *object : objects)
        object->declared += declared * static_cast<double>(object->index->count);
}

void place(TdmsObject &object, std::size_t stream, TdmsRun run)
{
    if (stream < object.streams.size())
        object.streams[stream].runs.append(run);
}

Index indexOf(std::uint64_t count)
{
    return static_cast<Index>(count); // whole chunks lie within the file, so it fits
}

tl::expected<void, TdmsProblem> placeInterleaved(const TdmsRegion &region, const Objects &objects)
{
    Wide width = 0;
    for (const TdmsObject *object : objects) {
        if (object->index->type == TdmsType::String
            || object->index->count != objects.front()->index->count)
            return Unexpected(
                {DYNCAL_TEXT("core",
                     "%1 is damaged: the segment at byte %2 interleaves channels of different lengths, or texts."),
                    {}});
        width += bytesOf(*object->index);
    }
    const std::uint64_t count = objects.front()->index->count;
    if (width == 0 || count == 0)
        return {};
    declare(region, chunksOf(region, width * count), objects);
    const std::uint64_t rows = region.bytes / static_cast<std::uint64_t>(width);
    std::uint64_t offset = region.begin;
    for (TdmsObject *object : objects) {
        place(
            *object, 0, {offset, indexOf(rows), 1, 0, static_cast<Index>(width), region.bigEndian});
        object->count += rows;
        offset += bytesOf(*object->index);
    }
    return {};
}

/// The values of an object in a last chunk that is not whole. If the file ends there, channels were
/// being written one after the other; a closed segment has fewer values of every channel.
std::uint64_t valuesInRest(
    const TdmsRegion &region, const Chunks &chunks, const TdmsRawIndex &index, std::uint64_t room)
{
    const std::uint64_t bytes = bytesOf(index);
    if (bytes == 0)
        return 0;
    if (region.ended)
        return std::min(index.count, room / bytes);
    return static_cast<std::uint64_t>(Wide(index.count) * chunks.rest / chunks.bytes);
}

void placeRest(const TdmsRegion &region, const Chunks &chunks, const Objects &objects)
{
    const std::uint64_t end = region.begin + region.bytes;
    std::uint64_t offset = end - chunks.rest;
    for (TdmsObject *object : objects) {
        const TdmsRawIndex &index = *object->index;
        const bool text = index.type == TdmsType::String;
        if (text && (!region.ended || index.textBytes > end - offset))
            return; // texts have no fixed size, so what follows cannot be found
        if (text) {
            offset += index.textBytes;
            continue;
        }
        const std::uint64_t values = valuesInRest(region, chunks, index, end - offset);
        place(
            *object, 0, {offset, indexOf(values), 1, 0, indexOf(bytesOf(index)), region.bigEndian});
        object->count += values;
        offset += values * bytesOf(index);
        if (region.ended && values < index.count)
            return;
    }
}

tl::expected<void, TdmsProblem> placeContiguous(const TdmsRegion &region, const Objects &objects)
{
    Wide bytes = 0;
    for (const TdmsObject *object : objects)
        bytes += plainBytes(*object->index);
    if (bytes > kTooWide && !region.ended)
        return Unexpected(
            {DYNCAL_TEXT("core",
                 "%1 is damaged: the segment at byte %2 declares more samples than any file can hold."),
                {}});
    const Chunks chunks = chunksOf(region, bytes);
    declare(region, chunks, objects);
    std::uint64_t offset = region.begin;
    for (TdmsObject *object : objects) {
        if (chunks.whole == 0)
            break;
        const TdmsRawIndex &index = *object->index;
        place(*object, 0,
            {offset, indexOf(index.count), indexOf(chunks.whole), static_cast<std::uint64_t>(bytes),
                indexOf(bytesOf(index)), region.bigEndian});
        object->count += index.count * chunks.whole;
        offset += static_cast<std::uint64_t>(plainBytes(index));
    }
    if (chunks.rest > 0)
        placeRest(region, chunks, objects);
    return {};
}

/// Checks that every scaler lies within a row of its buffer.
bool scalersFit(const Objects &objects)
{
    const std::vector<std::uint32_t> &widths = objects.front()->index->widths;
    return std::all_of(objects.begin(), objects.end(), [&](const TdmsObject *object) {
        const TdmsRawIndex &index = *object->index;
        return index.widths == widths
            && std::all_of(
                index.scalers.begin(), index.scalers.end(), [&](const TdmsScaler &scaler) {
                    const auto bytes
                        = static_cast<std::uint64_t>(tdmsTypeBytes(scaler.type).value_or(0));
                    return scaler.buffer < widths.size()
                        && scaler.byteOffset + bytes <= widths[scaler.buffer];
                });
    });
}

/// Whether scalers use the same bytes more than four times on average, so that a small file would
/// claim endless samples.
bool overlapEndlessly(const Objects &objects)
{
    constexpr std::uint64_t kBitsPerByte = 8;
    constexpr std::uint64_t kTimes = 4;
    std::vector<std::uint64_t> bits(objects.front()->index->widths.size(), 0);
    for (const TdmsObject *object : objects) {
        for (const TdmsScaler &scaler : object->index->scalers)
            bits[scaler.buffer] += scaler.bit >= 0
                ? 1
                : kBitsPerByte * static_cast<std::uint64_t>(tdmsTypeBytes(scaler.type).value_or(0));
    }
    return !std::equal(bits.begin(), bits.end(), objects.front()->index->widths.begin(),
        [](std::uint64_t used, std::uint64_t width) {
            return used <= kTimes * kBitsPerByte * width;
        });
}

/// One raw buffer of a chunk.
struct Buffer
{
    std::uint64_t width = 0;
    std::uint64_t rows = 0;
    std::uint64_t offset = 0; ///< from the start of the chunk
};

std::vector<Buffer> buffersOf(const Objects &objects)
{
    std::vector<Buffer> buffers;
    for (const std::uint32_t width : objects.front()->index->widths)
        buffers.push_back({width, 0, 0});
    for (const TdmsObject *object : objects) {
        for (const TdmsScaler &scaler : object->index->scalers)
            buffers[scaler.buffer].rows
                = std::max(buffers[scaler.buffer].rows, object->index->count);
    }
    return buffers;
}

/// Adds `chunks` chunks from `begin` on, of which each holds at most `room` bytes.
void placeBuffers(const TdmsRegion &region, const Objects &objects,
    const std::vector<Buffer> &buffers, std::uint64_t begin, std::uint64_t chunks,
    std::uint64_t chunkBytes, std::uint64_t room)
{
    for (TdmsObject *object : objects) {
        const TdmsRawIndex &index = *object->index;
        std::uint64_t least = index.count;
        for (std::size_t i = 0; i < index.scalers.size(); ++i) {
            const Buffer &buffer = buffers[index.scalers[i].buffer];
            const std::uint64_t there
                = room > buffer.offset ? (room - buffer.offset) / buffer.width : 0;
            const std::uint64_t values = std::min(index.count, there);
            place(*object, i,
                {begin + buffer.offset + index.scalers[i].byteOffset, indexOf(values),
                    indexOf(chunks), chunkBytes, static_cast<Index>(buffer.width),
                    region.bigEndian});
            least = std::min(least, values);
        }
        object->count += least * chunks;
    }
}

tl::expected<void, TdmsProblem> placeDaqmx(const TdmsRegion &region, const Objects &objects)
{
    if (!scalersFit(objects) || overlapEndlessly(objects))
        return Unexpected(
            {DYNCAL_TEXT("core",
                 "%1 is damaged: DAQmx channels of the segment at byte %2 do not fit into their raw buffers."),
                {}});
    std::vector<Buffer> buffers = buffersOf(objects);
    Wide bytes = 0;
    for (Buffer &buffer : buffers) {
        buffer.offset = static_cast<std::uint64_t>(std::min(bytes, kTooWide));
        bytes = std::min<Wide>(bytes + Wide(buffer.rows) * buffer.width, kTooWide);
    }
    const Chunks chunks = chunksOf(region, bytes);
    declare(region, chunks, objects);
    const auto chunkBytes = static_cast<std::uint64_t>(bytes);
    if (chunks.whole > 0)
        placeBuffers(region, objects, buffers, region.begin, chunks.whole, chunkBytes, chunkBytes);
    if (chunks.rest > 0)
        placeBuffers(region, objects, buffers, region.begin + region.bytes - chunks.rest, 1,
            chunkBytes, chunks.rest);
    return {};
}

} // namespace

tl::expected<void, TdmsProblem> placeTdmsRegion(
    const TdmsRegion &region, const std::vector<TdmsObject *> &objects)
{
    if (objects.empty())
        return {};
    const auto daqmx = std::count_if(objects.begin(), objects.end(),
        [](const TdmsObject *object) { return object->index->isDaqmx(); });
    if (daqmx == std::ssize(objects))
        return placeDaqmx(region, objects);
    if (daqmx > 0)
        return Unexpected(
            {DYNCAL_TEXT("core",
                 "%1 is damaged: the segment at byte %2 mixes DAQmx raw data with other samples."),
                {}});
    const bool rows = region.interleaved && objects.size() > 1;
    return rows ? placeInterleaved(region, objects) : placeContiguous(region, objects);
}

} // namespace dyncal
