// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/written_list.h"

#include <optional>
#include <string>

#include <sys/types.h>

namespace dyncal {

// Names inside the staging folder ".dyncal-XXXX".
inline constexpr const char *kStagedTree = "tree"; ///< the new files, as they will lie
inline constexpr const char *kRetired = "old"; ///< where the moves put what they replace
inline constexpr const char *kExchangePlan
    = "exchange"; ///< there: the tree may have been exchanged
inline constexpr const char *kMovesPlan = "moves"; ///< there: the moves have begun

/// What the folders are to become, written down before anything changes.
struct FolderPlan
{
    ino_t tree = 0; ///< inode of the staged tree
    ino_t folder = 0; ///< inode of the folder that it is to replace, or whose files are moved
    WrittenList retired; ///< own old files, which go
    WrittenList placed; ///< own new files, written.json the last
};

/// Writes the plan under its name, whole and flushed; false with errno.
bool writePlan(int staging, const std::string &name, const FolderPlan &plan);
/// Empty if there is none, or it is not this user's.
std::optional<FolderPlan> readPlan(int staging, const std::string &name);

} // namespace dyncal
