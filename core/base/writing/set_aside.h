// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_plan.h"
#include "core/base/writing/written_list.h"

#include <string>

namespace dyncal {

/// Removes a folder of the staging folder as far as nothing is lost with it: the listed files if
/// they are still what was written, and names of files that have another one. What else is in it is
/// somebody's and goes beside `target` in `place`, where it is seen, as "TARGET.kept-1". False if
/// it had to stay.
bool clearOrSetAside(int place, int staging, const std::string &part, const std::string &target,
    const WrittenList &ours);

/// Undoes an exchange that met another folder than the one that was looked at, which gets its name
/// back (or "TARGET.kept-1" where something else has that by now). False if it had to stay.
bool takeBackExchange(int place, int staging, const std::string &target, const FolderPlan &plan);

} // namespace dyncal
