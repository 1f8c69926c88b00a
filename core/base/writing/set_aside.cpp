// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/set_aside.h"

#include "core/base/file_descriptor.h"
#include "core/base/writing/file_identity.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dyncal {
namespace {

constexpr int kMostNames = 1000;

bool hasAnotherName(int folder, const std::string &name)
{
    struct stat status = {};
    return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0
        && !S_ISDIR(status.st_mode) && status.st_nlink > 1;
}

void clear(int folder, const std::string &below, const WrittenList &ours)
{
    for (const std::string &name : namesIn(folder)) {
        const std::string whole = below + name;
        const WrittenFile *own = listed(ours, whole);
        const FileDescriptor inside(openFolderAt(folder, name));
        if (inside.valid()) {
            clear(inside.get(), whole + '/', ours);
            ::unlinkat(folder, name.c_str(), AT_REMOVEDIR); // if it is empty now
        } else if (hasAnotherName(folder, name) || (own && sha256At(folder, name) == own->sha256)) {
            ::unlinkat(folder, name.c_str(), 0);
        }
    }
}

bool setAside(int place, int staging, const std::string &part, const std::string &target)
{
    const std::string base = (target == "." ? "results" : target) + ".kept-";
    bool moved = false;
    for (int i = 1; !moved && i < kMostNames; ++i) {
        moved = renameToFree(staging, part, place, base + std::to_string(i));
        if (!moved && errno != EEXIST)
            break;
    }
    return moved && ::fsync(place) == 0;
}

} // namespace

bool clearOrSetAside(int place, int staging, const std::string &part, const std::string &target,
    const WrittenList &ours)
{
    const FileDescriptor folder(openFolderAt(staging, part));
    if (!folder.valid())
        return !identityOf(staging, part);
    clear(folder.get(), {}, ours);
    return ::unlinkat(staging, part.c_str(), AT_REMOVEDIR) == 0
        || setAside(place, staging, part, target);
}

bool takeBackExchange(int place, int staging, const std::string &target, const FolderPlan &plan)
{
    const auto there = identityOf(place, target);
    if (there && there->inode == plan.tree)
        ::renameat2(staging, kStagedTree, place, target.c_str(), RENAME_EXCHANGE);
    const auto tree = identityOf(staging, kStagedTree);
    if (tree && tree->inode == plan.tree)
        return clearOrSetAside(place, staging, kStagedTree, target, plan.placed);
    return renameToFree(staging, kStagedTree, place, target)
        || setAside(place, staging, kStagedTree, target);
}

} // namespace dyncal
