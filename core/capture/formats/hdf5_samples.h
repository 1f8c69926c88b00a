// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/formats/hdf5_handle.h"
#include "core/capture/raw_samples.h"

#include <span>
#include <string>

namespace dyncal {

/// How samples of this kind are stored in our files and lie in memory.
struct SampleTypes
{
    hid_t stored;
    hid_t memory;
};
SampleTypes sampleTypes(const RawSamples &samples);

/// Samples per chunk of our own files, and per read or write of any file.
constexpr hsize_t kHdf5BlockSamples = 1 << 20;

/// Readers open files with a chunk cache of this size; a compressed chunk must fit into it, or it
/// would be unpacked once for every block of samples.
constexpr hsize_t kHdf5ChunkCacheBytes = 64 << 20;

/// Rehearse reads every sample and keeps none.
enum class SampleUse { Keep, Rehearse };

/// What a dataset of samples turned out to be.
struct StoredSamples
{
    RawSamples samples;
    bool exactType = true; ///< kept as stored; false = widened (such as uint16 to int32)
};

/// Reads a 1-D dataset of integers or floats, stored contiguous, compact or chunked, with any
/// filter that is installed. What the dataset claims is held against what the file stores before
/// anything is allocated: `budgetBytes` is what of the file no other channel has claimed yet, and
/// is reduced. Errors name `channel` in `path` (CAP-018: incomplete or damaged).
Result<StoredSamples> readSampleDataset(hid_t dataset, const std::string &path,
    const std::string &channel, hsize_t &budgetBytes, SampleUse use, const JobControl &control);

/// Writes `count` samples of this memory type to [begin, begin + count) of the dataset.
bool writeSampleBlock(hid_t dataset, hid_t memoryType, hsize_t begin,
    std::span<const std::byte> samples, hsize_t count);

} // namespace dyncal
