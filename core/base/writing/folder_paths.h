// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/writing/written_list.h"

#include <string>
#include <vector>

namespace dyncal {

// None of these follows a link.

/// The folder that a name lies in; invalid with errno.
FileDescriptor parentOf(int folder, const std::string &name);

/// Makes the folders on the way to a name; false with errno. New ones are added to `made`, the
/// deepest last.
bool makeFoldersFor(int folder, const std::string &name, std::vector<std::string> *made = nullptr);

/// Removes a folder if it is empty.
void removeEmptyFolder(int folder, const std::string &name);

/// Removes the folders on the way to a name as far as they are empty.
void removeEmptyFoldersOf(int folder, const std::string &name);

/// Flushes the folder and those below it that hold the files; false with errno.
bool syncFolders(int folder, const WrittenList &files);

} // namespace dyncal
