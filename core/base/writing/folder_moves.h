// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_plan.h"
#include "core/base/writing/written_list.h"

namespace dyncal {

/// Moves of a plan: retires and places file by file, in any state that an earlier attempt left.
/// False with errno if something stands in the way; then what was moved is moved back.
bool carryOutMoves(int staging, int folder, const FolderPlan &plan);

/// Moves everything back that a plan moved, as far as nothing stands in the way.
void takeBackMoves(int staging, int folder, const FolderPlan &plan);

/// Second names in the tree for everything in the folder that is not to be retired. False if that
/// is not possible: the moves must do.
bool linkKept(int folder, int tree, const WrittenList &retired);

} // namespace dyncal
