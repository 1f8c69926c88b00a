// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <cstdint>
#include <optional>

namespace dyncal {

/// Larger compressed chunks are not read: each must be unpacked whole in memory.
constexpr hsize_t kHdf5LargestPackedChunk = 64 << 20;

/// What must be known of the file to judge what its datasets claim.
struct Hdf5FileFacts
{
    hsize_t bytes = 0;
    hsize_t userBlockBytes = 0; ///< before the HDF5 part
    std::uint64_t allowedBytes = 0; ///< of the ExpansionBudget
};

/// Describes a dataset; empty if its statements are impossible.
std::optional<Hdf5Dataset> describeDataset(hid_t dataset, const Hdf5FileFacts &file);

} // namespace dyncal
