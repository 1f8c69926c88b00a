// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// What a file system on other machines is called ("NFS", "SMB", ...), by the number that statfs
/// gives; empty for one of this machine. Locks of such a file system cannot be relied on, and two
/// programs that write one SQLite file without them destroy it.
std::string networkFileSystem(long type);

/// The same of the file system that a path, or the nearest folder above that exists, lies on.
std::string networkFileSystemOf(const std::string &path);

} // namespace dyncal
