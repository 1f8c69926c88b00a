// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_plan.h"
#include "core/base/writing/written_list.h"

#include <string>

namespace dyncal {

/// Removes a folder of the staging folder without loss: the listed files if they are unchanged, and
/// names of files that have another name. Anything else belongs to somebody and is moved beside
/// `target` in `place`, where it is seen, as "TARGET.kept-1". False if something had to stay.
bool clearOrSetAside(int place, int staging, const std::string &part, const std::string &target,
    const WrittenList &ours);

/// Undoes an exchange that replaced another folder than the one checked before. That folder gets
/// its name back (or "TARGET.kept-1" where the name is taken by now). False if it had to stay.
bool takeBackExchange(int place, int staging, const std::string &target, const FolderPlan &plan);

} // namespace dyncal
