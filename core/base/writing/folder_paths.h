// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/written_list.h"

#include <string>

namespace dyncal {

/// Makes the folders on the way to a name; false with errno.
bool makeFoldersFor(int folder, const std::string &name);

/// Removes the folders on the way to a name as far as they are empty.
void removeEmptyFoldersOf(int folder, const std::string &name);

/// Flushes the folder and those below it that hold the files; false with errno.
bool syncFolders(int folder, const WrittenList &files);

} // namespace dyncal
