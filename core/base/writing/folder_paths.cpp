// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_paths.h"

#include "core/base/writing/file_identity.h"
#include "core/base/writing/file_modes.h"

#include <cerrno>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {

FileDescriptor parentOf(int folder, const std::string &name)
{
    const std::size_t slash = name.rfind('/');
    return FileDescriptor(slash == std::string::npos
            ? ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)
            : openFolderAt(folder, name.substr(0, slash)));
}

bool makeFoldersFor(int folder, const std::string &name, std::vector<std::string> *made)
{
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
        const std::string path = name.substr(0, slash);
        const FileDescriptor parent = parentOf(folder, path);
        if (!parent.valid())
            return false;
        const std::string last = path.substr(path.rfind('/') + 1);
        if (::mkdirat(parent.get(), last.c_str(), kFolderMode) == 0) {
            if (made != nullptr)
                made->push_back(path);
        } else if (errno != EEXIST) {
            return false;
        }
    }
    return true;
}

void removeEmptyFolder(int folder, const std::string &name)
{
    if (const FileDescriptor parent = parentOf(folder, name); parent.valid())
        ::unlinkat(parent.get(), name.substr(name.rfind('/') + 1).c_str(), AT_REMOVEDIR);
}

void removeEmptyFoldersOf(int folder, const std::string &name)
{
    for (std::size_t slash = name.rfind('/'); slash != std::string::npos && slash > 0;
         slash = name.rfind('/', slash - 1))
        removeEmptyFolder(folder, name.substr(0, slash));
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
