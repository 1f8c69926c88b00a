// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/capture/formats/hdf5_handle.h"
#include "core/capture/raw_samples.h"

#include <string>

namespace dyncal {

/// Samples per chunk of our own files, and per read or write of any file.
constexpr hsize_t kHdf5BlockSamples = 1 << 20;

/// Object creation properties that make the file forget when it was written: the same content
/// gives the same bytes.
bool forgetTimes(hid_t creationProperties);

/// An empty 1-D dataset for these samples: little endian, chunked, no filters.
Hdf5Handle createSampleDataset(hid_t group, const std::string &name, const RawSamples &samples);

/// Writes samples [begin, begin + count) of the dataset.
bool writeSampleBlock(hid_t dataset, const RawSamples &samples, hsize_t begin, hsize_t count);

} // namespace dyncal
