// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_paths.h"

#include "core/base/file_descriptor.h"
#include "core/base/writing/file_identity.h"

#include <cerrno>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

constexpr mode_t kFolderMode = 0777; // less the process's umask

} // namespace

bool makeFoldersFor(int folder, const std::string &name)
{
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
        if (::mkdirat(folder, name.substr(0, slash).c_str(), kFolderMode) != 0 && errno != EEXIST)
            return false;
    }
    return true;
}

void removeEmptyFoldersOf(int folder, const std::string &name)
{
    for (std::size_t slash = name.rfind('/'); slash != std::string::npos && slash > 0;
         slash = name.rfind('/', slash - 1))
        ::unlinkat(folder, name.substr(0, slash).c_str(), AT_REMOVEDIR);
}

bool syncFolders(int folder, const WrittenList &files)
{
    std::set<std::string> folders;
    for (const WrittenFile &file : files)
        if (const std::size_t slash = file.file.rfind('/'); slash != std::string::npos)
            folders.insert(file.file.substr(0, slash));
    for (const std::string &name : folders) {
        const FileDescriptor below(openFolderAt(folder, name));
        if (!below.valid() || ::fsync(below.get()) != 0)
            return false;
    }
    return ::fsync(folder) == 0;
}

} // namespace dyncal
