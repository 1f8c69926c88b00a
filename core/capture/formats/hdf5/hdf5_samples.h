// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/guarded_run.h"
#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/raw_samples.h"

#include <span>
#include <string>
#include <vector>

namespace dyncal {

/// Types of samples in our files and in memory.
struct SampleTypes
{
    hid_t stored;
    hid_t memory;
};
SampleTypes sampleTypes(SampleType type);

/// Samples per chunk of our own files.
constexpr hsize_t kHdf5BlockSamples = 1 << 20;

/// A dataset to unpack: one record, or a table whose columns are records.
struct UnpackOrder
{
    std::uint64_t address = 0; ///< of the dataset in its file
    SampleType type = SampleType::Float64; ///< to deliver
    Index sampleAxis = 0; ///< the dimension along which time runs
    Index samples = 0; ///< its extent
    Index columns = 1; ///< extent of the other dimension, if any
    std::uint64_t chunkBytes = 0; ///< unpacked as a whole; 0: no filter

    /// Samples of each column per piece; a piece holds all columns one behind the other.
    Index samplesPerPiece() const;
};

/// Unpacks datasets and writes them piece by piece, in the byte order of this machine, with a cache
/// of `cacheBytes` for chunks. For the helper process. False if a dataset does not match its order
/// or cannot be read.
bool unpackDatasets(const std::string &path, const std::vector<UnpackOrder> &orders,
    std::size_t cacheBytes, GuardedOutput &output);

/// Writes `count` samples of this memory type to [begin, begin + count) of the dataset.
bool writeSampleBlock(hid_t dataset, hid_t memoryType, hsize_t begin,
    std::span<const std::byte> samples, hsize_t count);

} // namespace dyncal
