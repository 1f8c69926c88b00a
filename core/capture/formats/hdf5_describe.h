// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5_handle.h"
#include "core/capture/formats/hdf5_tree.h"

#include <optional>
#include <string>

namespace dyncal {

// What only the helper process may do: the library crashes on some damaged files.

/// How much of a file is described.
enum class Hdf5Depth { RootAttributes, Everything };

/// Opens for reading; invalid if it cannot be opened as HDF5.
Hdf5Handle openHdf5File(const std::string &path);

/// The objects of the file and what they state; no samples are read. Links to elsewhere are not
/// followed. Groups nested deeper than 64 and objects beyond 20 000 are left as broken links.
/// Empty if the file cannot be opened.
std::optional<Hdf5Tree> describeHdf5(const std::string &path, Hdf5Depth depth);

/// A dataset by itself. `fileBytes` is held against what it claims.
Hdf5Dataset describeDataset(hid_t dataset, hsize_t fileBytes);

} // namespace dyncal
