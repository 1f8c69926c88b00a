// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_recovery.h"

#include "core/base/file_descriptor.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/folder_moves.h"
#include "core/base/writing/folder_plan.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

constexpr int kMostNames = 1000;

/// Somebody else's, or changed since: it goes into the new folder, whatever its name is there.
bool rescue(int from, const std::string &name, int to)
{
    bool moved = renameToFree(from, name, to, name);
    for (int i = 1; !moved && errno == EEXIST && i < kMostNames; ++i)
        moved = renameToFree(from, name, to, name + ".kept-" + std::to_string(i));
    return moved;
}

bool emptyFolder(int from, int to, const std::string &below, const WrittenList &retired);

bool emptyEntry(
    int from, int to, const std::string &below, const std::string &name, const WrittenList &retired)
{
    const auto identity = identityOf(from, name);
    if (!identity)
        return true;
    if (const WrittenFile *file = listed(retired, below + name);
        file && sha256At(from, name) == file->sha256)
        return ::unlinkat(from, name.c_str(), 0) == 0;
    const auto there = identityOf(to, name);
    if (identity->type != FileType::Folder && there && there->isSameFile(*identity))
        return ::unlinkat(from, name.c_str(), 0) == 0;
    const FileDescriptor inside(identity->type == FileType::Folder ? openFolderAt(from, name) : -1);
    const bool isPartOfOurs = inside.valid()
        && std::ranges::any_of(retired,
            [&](const WrittenFile &file) { return file.file.starts_with(below + name + '/'); });
    if (!isPartOfOurs)
        return rescue(from, name, to);
    if (!there)
        ::mkdirat(to, name.c_str(), 0777);
    const FileDescriptor target(openFolderAt(to, name));
    // Of the old folder nothing may be left without a place in the new one.
    return target.valid() && emptyFolder(inside.get(), target.get(), below + name + '/', retired)
        && ::unlinkat(from, name.c_str(), AT_REMOVEDIR) == 0
        && (there || ::unlinkat(to, name.c_str(), AT_REMOVEDIR) == 0 || errno == ENOTEMPTY);
}

bool emptyFolder(int from, int to, const std::string &below, const WrittenList &retired)
{
    bool emptied = true;
    for (const std::string &name : namesIn(from))
        emptied = emptyEntry(from, to, below, name, retired) && emptied;
    return emptied;
}

tl::unexpected<Error> cannotRecover(const std::string &target, const std::string &staging)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "An earlier write into %1 was interrupted and cannot be completed, because files in "
             "it were changed since; what it was writing lies in %2. Choose another folder, or "
             "move the changed files away."),
            {target, staging}});
}

Result<void> recoverExchange(
    int place, const std::string &staging, const std::string &target, const FolderPlan &plan)
{
    const auto tree = identityOf(place, staging + '/' + kStagedTree);
    const bool wasExchanged = tree && tree->inode != plan.tree;
    if (!wasExchanged)
        return {};
    const FileDescriptor oldTree(openFolderAt(place, staging + '/' + kStagedTree));
    const FileDescriptor folder(openFolderAt(place, target));
    if (!oldTree.valid() || !folder.valid()
        || !emptyOldTree(oldTree.get(), folder.get(), plan.retired))
        return cannotRecover(target, staging);
    return {};
}

} // namespace

bool emptyOldTree(int oldTree, int folder, const WrittenList &retired)
{
    return emptyFolder(oldTree, folder, {}, retired);
}

Result<void> recoverFolder(int place, const std::string &staging, const std::string &target)
{
    const FileDescriptor inside(openFolderAt(place, staging));
    if (!inside.valid())
        return {}; // it had not come so far
    if (const auto plan = readPlan(inside.get(), kMovesPlan)) {
        const FileDescriptor folder(openFolderAt(place, target));
        if (!folder.valid() || !carryOutMoves(inside.get(), folder.get(), *plan))
            return cannotRecover(target, staging);
    } else if (const auto exchange = readPlan(inside.get(), kExchangePlan)) {
        const Result<void> recovered = recoverExchange(place, staging, target, *exchange);
        if (!recovered)
            return recovered;
    }
    return removeTree(place, staging) ? Result<void>() : cannotRecover(target, staging);
}

} // namespace dyncal
