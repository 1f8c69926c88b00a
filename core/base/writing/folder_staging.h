// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_contents.h"

#include <string>
#include <vector>

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
    WrittenList retired; ///< own old files, which go
    WrittenList placed; ///< own new files, written.json the last
};

/// Writes the plan under its name, whole and flushed; false with errno.
bool writePlan(int staging, const std::string &name, const FolderPlan &plan);
std::optional<FolderPlan> readPlan(int staging, const std::string &name);

/// Makes the folders on the way to a name; false with errno.
bool makeFoldersFor(int folder, const std::string &name);

/// Removes the folders on the way to a name as far as they are empty.
void removeEmptyFoldersOf(int folder, const std::string &name);

/// Flushes the folder and those below it that hold the files; false with errno.
bool syncFolders(int folder, const WrittenList &files);

/// Moves of a plan: retires and places file by file, in any state that an earlier attempt left.
/// False with errno if something stands in the way; then what was moved is moved back.
bool carryOutMoves(int staging, int folder, const FolderPlan &plan);

/// Second names in the tree for everything in the folder that is not to be retired. False if that
/// is not possible: the moves must do.
bool linkKept(int folder, int tree, const WrittenList &retired);

/// Empties the old folder of an exchange: retired files go if they are still what was looked at,
/// second names go, and what else came into it meanwhile is moved into the new folder, as
/// "NAME.kept-1" if its name is taken there. False if something had to stay.
bool emptyOldTree(int oldTree, int folder, const WrittenList &retired);

/// Completes or takes back what a killed program left of a write into a folder: `staging` is its
/// staging folder in the open folder `place`, `target` the name of the folder written to, or ".".
/// Fails (Usage) if something stands in the way now.
Result<void> recoverFolder(int place, const std::string &staging, const std::string &target);

} // namespace dyncal
