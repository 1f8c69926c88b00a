// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/file_descriptor.h"
#include "tests/core/base/writing/folder_snapshot.h"

#include <fcntl.h>

#include <set>

namespace dyncal::testing {

/// The folder opened, as the writers hold it.
inline FileDescriptor opened(const std::filesystem::path &folder)
{
    return FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

/// A file of these bytes, with the folders on its way.
inline void put(const std::filesystem::path &file, const std::string &bytes)
{
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
}

/// How many files this process has open: the same before and after whatever leaks none.
inline std::size_t openFiles()
{
    std::size_t count = 0;
    for ([[maybe_unused]] const auto &entry : std::filesystem::directory_iterator("/proc/self/fd"))
        ++count;
    return count;
}

/// All names in a folder, hidden ones too.
inline std::set<std::string> entriesOf(const std::filesystem::path &folder)
{
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

} // namespace dyncal::testing
