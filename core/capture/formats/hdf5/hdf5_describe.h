// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <optional>
#include <string>

namespace dyncal {

// Only the helper process may call these: the library crashes on some damaged files.

/// How much of a file is described.
enum class Hdf5Depth { RootAttributes, Everything };

/// Opens for reading, with a chunk cache of `cacheBytes` per dataset; invalid if that fails.
Hdf5Handle openHdf5File(const std::string &path, std::size_t cacheBytes);

/// The objects of the file and what they state; no samples are read. Links to other files or paths
/// are not followed; groups nested deeper than 64 and objects beyond 20 000 are not read. Empty if
/// the file or any object in it cannot be opened or is impossible: then nothing in the file can be
/// trusted. The description takes no more memory than the budget allows.
std::optional<Hdf5Tree> describeHdf5(
    const std::string &path, Hdf5Depth depth, const ExpansionBudget &budget);
/// The same of a file that is open.
std::optional<Hdf5Tree> describeHdf5(hid_t file, Hdf5Depth depth, const ExpansionBudget &budget);

} // namespace dyncal
