// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_plan.h"
#include "core/base/writing/written_list.h"

namespace dyncal {

/// Carries out a plan by moves: retires old files and places new ones, one by one, also after an
/// earlier attempt was interrupted. False with errno if something is in the way; then all is moved
/// back.
bool carryOutMoves(int staging, int folder, const FolderPlan &plan);

/// Moves back everything that a plan moved, where the old name is free.
void takeBackMoves(int staging, int folder, const FolderPlan &plan);

/// Gives everything in the folder that is not to be retired a second name in the tree. False if
/// that is not possible: the caller must use moves.
bool linkKept(int folder, int tree, const WrittenList &retired);

} // namespace dyncal
