// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/raw_samples.h"

#include <string>

namespace dyncal {

// New objects of our own files, without times, so that the same content gives the same bytes. The
// handle is invalid if the library refused.

/// A new file in the newest format, which has checksums on its metadata; overwrites.
Hdf5Handle createFile(const std::string &path);

/// A group that remembers the order in which members were added: shots and channels keep theirs.
Hdf5Handle createGroup(hid_t parent, const std::string &name);

/// An empty 1-D dataset for these samples: little endian, chunked, no filters.
Hdf5Handle createSampleDataset(hid_t group, const std::string &name, const RawSamples &samples);

} // namespace dyncal
