// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/base/writing/written_list.h"

#include <functional>
#include <string>

namespace dyncal {

/// Whether this program may have given a file this name.
using NameRule = std::function<bool(const std::string &)>;

/// Empties the old folder of an exchange. Retired files are removed if they are unchanged, second
/// names are removed, and whatever else was put there meanwhile is moved into the new folder, as
/// "NAME.kept-1" if its name is taken. False if something had to stay.
bool emptyOldTree(int oldTree, int folder, const WrittenList &retired);

/// Completes or undoes what a killed program left of a write into a folder: `staging` is its
/// staging folder in the open folder `place`, `target` the name of the folder written to, or ".". A
/// plan may be planted, e.g. in an unpacked archive. So a plan is trusted only if it belongs to
/// this user, names only files that `mayWrite` allows, is for this very folder (by inode) and
/// retires only files of the folder's list; any other is left alone. If the plan's folder is gone
/// or another has its name, the plan is dropped and what is not ours goes to "TARGET.kept-1". Fails
/// (Usage) if something is in the way.
Result<void> recoverFolder(
    int place, const std::string &staging, const std::string &target, const NameRule &mayWrite);

} // namespace dyncal
