// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dyncal {

/// One dataset of an HDF5 file (MAT v7.3 included) as the import dialog lists it.
struct DatasetEntry
{
    std::string path; ///< "/entry/detector/data": its folders are the groups of the tree
    std::string type; ///< "int16", "uint16 big-endian", "float64", "text", "compound"
    std::vector<std::uint64_t> shape; ///< empty = one value
    Attributes attributes; ///< numbers and texts that are one value
    /// Names of the channels it becomes, the keys of ImportSettings::channels: its path, or
    /// "path[:,0]", "path[:,1]" for the columns of a table. Empty if it becomes none, or has too
    /// few values to be a recording.
    std::vector<std::string> channels;
    Message whyNot; ///< what keeps it from being channels; no text if nothing does
};

/// All datasets of the file in the order of the tree; nothing of their samples is read. Fails
/// (CAP-018) where the file is damaged or is no HDF5. As every reader of HDF5 here it works in a
/// helper process: a file that crashes the library is an error like any other.
Result<std::vector<DatasetEntry>> listDatasets(
    const std::string &path, const JobControl &control = {});

} // namespace dyncal
