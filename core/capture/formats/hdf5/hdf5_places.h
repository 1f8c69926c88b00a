// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/file_samples.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <optional>
#include <string>

namespace dyncal {

/// A dataset whose samples are wanted.
struct Hdf5Wish
{
    const Hdf5Dataset *dataset = nullptr; ///< one with a storage, of at most two dimensions
    std::uint64_t address = 0; ///< of its object
    std::string name; ///< for errors: "accel_1 of shot 001"
    Index sampleAxis = 0; ///< the dimension along which time runs
};

/// Number of samples and of columns; empty unless the dataset has a storage, at most two dimensions
/// and no absurd extents.
struct Hdf5Extents
{
    Index samples = 0;
    Index columns = 1;
};
std::optional<Hdf5Extents> extentsOf(const Hdf5Wish &wish);

/// Where the samples of one column lie in the file, for a dataset that is InFile; `column` is less
/// than the number of columns. Empty if the blocks do not make up the dataset. samplesInFile()
/// checks that they lie within the file.
std::optional<SampleLayout> layoutOfColumn(const Hdf5Wish &wish, Index column);

} // namespace dyncal
