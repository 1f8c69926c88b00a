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

/// Empties the old folder of an exchange: retired files go if they are still what was looked at,
/// second names go, and what else came into it meanwhile is moved into the new folder, as
/// "NAME.kept-1" if its name is taken there. False if something had to stay.
bool emptyOldTree(int oldTree, int folder, const WrittenList &retired);

/// Completes or takes back what a killed program left of a write into a folder: `staging` is its
/// staging folder in the open folder `place`, `target` the name of the folder written to, or ".".
/// A plan may be planted, in an unpacked archive too: only one of this user is believed that names
/// nothing but what `mayWrite` allows, for the very folder (by its inode) it was made for, and it
/// retires nothing but what the folder's list has; any other is left alone. If the folder of the
/// plan is gone or another has its name, the plan is dropped and what is not ours goes to
/// "TARGET.kept-1". Fails (Usage) if something stands in the way now.
Result<void> recoverFolder(
    int place, const std::string &staging, const std::string &target, const NameRule &mayWrite);

} // namespace dyncal
