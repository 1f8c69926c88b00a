// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_recovery.h"

#include "core/base/content_hash.h"
#include "core/base/file_descriptor.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/folder_moves.h"
#include "core/base/writing/folder_plan.h"
#include "core/base/writing/set_aside.h"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

constexpr int kMostRecovered = 1000;

/// Moves a file of somebody else, or one changed since, into the new folder, under another name if
/// its own is taken.
bool rescue(int from, const std::string &name, int to)
{
    bool moved = renameToFree(from, name, to, name);
    for (int i = 1; !moved && errno == EEXIST && i < kMostRecovered; ++i)
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
    // Everything in the old folder must have a place in the new one.
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

/// What a killed program left.
struct Leftover
{
    int place; ///< the open folder that holds target and staging
    int inside; ///< the open staging folder
    const std::string &staging;
    const std::string &target;
};

bool isInode(int place, const std::string &name, ino_t inode)
{
    const auto there = identityOf(place, name);
    return there && there->type == FileType::Folder && there->inode == inode;
}

tl::unexpected<Error> cannotRecover(const Leftover &left)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "An earlier write into %1 was interrupted and cannot be completed, because files in it were changed since; what it was writing lies in %2. Choose another folder, or move the changed files away."),
            {left.target, left.staging}});
}

bool areOurNames(const WrittenList &list, const NameRule &mayWrite)
{
    return std::ranges::all_of(list, [&](const WrittenFile &file) {
        return file.file == kWrittenList || (mayWrite && mayWrite(file.file));
    });
}

/// The list that was in the folder when the plan was made: still there, or moved aside already.
WrittenList oldListOf(int staging, int folder, const FolderPlan &plan)
{
    const WrittenFile *wanted = listed(plan.retired, kWrittenList);
    for (const auto &[at, name] : {std::pair(folder, std::string(kWrittenList)),
             std::pair(staging, std::string(kRetired) + '/' + kWrittenList)}) {
        const auto text = wanted ? textAt(at, name, kLongestList) : std::nullopt;
        const auto list
            = text && sha256Hex(*text) == wanted->sha256 ? parseWrittenList(*text) : std::nullopt;
        if (list)
            return *list;
    }
    return {};
}

/// Whether everything that the moves would take out of the folder is on the folder's list.
bool retiresListedOnly(int staging, int folder, const FolderPlan &plan)
{
    const WrittenList old = oldListOf(staging, folder, plan);
    return std::ranges::all_of(plan.retired, [&](const WrittenFile &file) {
        const bool isPlacedAlready = listed(plan.placed, file.file)
            && !identityOf(staging, std::string(kStagedTree) + '/' + file.file);
        const WrittenFile *known = listed(old, file.file);
        return file.file == kWrittenList || isPlacedAlready || !identityOf(folder, file.file)
            || (known && known->sha256 == file.sha256);
    });
}

Result<void> recoverMoves(const Leftover &left, const FolderPlan &plan)
{
    const FileDescriptor folder(openFolderAt(left.place, left.target));
    if (!isInode(left.place, left.target, plan.folder))
        return clearOrSetAside(left.place, left.inside, kRetired, left.target, {})
            ? Result<void>()
            : cannotRecover(left);
    const bool done = folder.valid() && retiresListedOnly(left.inside, folder.get(), plan)
        && carryOutMoves(left.inside, folder.get(), plan);
    return done ? Result<void>() : cannotRecover(left);
}

Result<void> recoverExchange(const Leftover &left, const FolderPlan &plan)
{
    const auto tree = identityOf(left.inside, kStagedTree);
    if (!tree || tree->inode == plan.tree)
        return {}; // emptied already, or not exchanged yet
    const FileDescriptor oldTree(openFolderAt(left.inside, kStagedTree));
    const FileDescriptor folder(openFolderAt(left.place, left.target));
    bool done = false;
    if (tree->inode != plan.folder)
        done = takeBackExchange(left.place, left.inside, left.target, plan);
    else if (!isInode(left.place, left.target, plan.tree))
        done = clearOrSetAside(left.place, left.inside, kStagedTree, left.target, plan.retired);
    else
        done = oldTree.valid() && folder.valid()
            && emptyOldTree(oldTree.get(), folder.get(), plan.retired)
            && ::unlinkat(left.inside, kStagedTree, AT_REMOVEDIR) == 0;
    return done ? Result<void>() : cannotRecover(left);
}

} // namespace

bool emptyOldTree(int oldTree, int folder, const WrittenList &retired)
{
    return emptyFolder(oldTree, folder, {}, retired);
}

Result<void> recoverFolder(
    int place, const std::string &staging, const std::string &target, const NameRule &mayWrite)
{
    const FileDescriptor inside(openFolderAt(place, staging));
    if (!inside.valid() || !isOwnedByUser(inside.get(), "."))
        return {}; // the exchange was not reached, or is not ours
    const Leftover left{place, inside.get(), staging, target};
    for (const char *name : {kMovesPlan, kExchangePlan}) {
        if (!identityOf(inside.get(), name))
            continue;
        const auto plan = readPlan(inside.get(), name);
        if (!plan || !areOurNames(plan->retired, mayWrite) || !areOurNames(plan->placed, mayWrite))
            return {}; // this program never wrote it
        const Result<void> recovered = std::string_view(name) == kMovesPlan
            ? recoverMoves(left, *plan)
            : recoverExchange(left, *plan);
        if (!recovered)
            return recovered;
        break;
    }
    return removeTree(place, staging) ? Result<void>() : cannotRecover(left);
}

} // namespace dyncal
