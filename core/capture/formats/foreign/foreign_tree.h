// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_open.h"

#include <string>
#include <vector>

namespace dyncal {

/// A dataset of an HDF5 file that is no capture of ours, and where it is.
struct ForeignDataset
{
    std::string path; ///< "/entry/data"
    std::string name; ///< "data"
    const Hdf5Object *object = nullptr;
    std::vector<const Hdf5Object *> groups; ///< it lies in, the nearest first, the root last
};

/// Every dataset once, in the order of the tree.
std::vector<ForeignDataset> datasetsOf(const Hdf5Tree &tree);

/// Number of links that lead to other files or places, or cannot be followed.
Index linksNotFollowed(const Hdf5Tree &tree);

/// A table has at most so many columns that become channels.
constexpr Index kMaxTableColumns = 64;

/// What a dataset can be as channels.
struct ForeignChannels
{
    std::vector<std::string> names; ///< empty if it can be none
    Index samples = 0;
    Index sampleAxis = 0;
    Message whyNot; ///< if it can be none
};

/// None, for this reason.
ForeignChannels noChannels(Message why);

/// At least two numbers along one dimension are one channel named by the path; a table's columns,
/// or its rows if those are longer, are channels "path[:,0]" or "path[0,:]".
ForeignChannels channelsOf(const ForeignDataset &dataset, const std::string &file);

} // namespace dyncal
