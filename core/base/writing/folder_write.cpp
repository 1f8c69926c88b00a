// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_write.h"

#include "core/base/content_hash.h"
#include "core/base/writing/file_modes.h"
#include "core/base/writing/folder_moves.h"
#include "core/base/writing/folder_paths.h"
#include "core/base/writing/folder_plan.h"
#include "core/base/writing/folder_recovery.h"
#include "core/base/writing/set_aside.h"
#include "core/base/writing/write_problem.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kPrivateFolder = 0700;
constexpr mode_t kFileMode = 0666;

/// `mode`: the permissions to keep, if it replaces a file.
bool writeFile(int folder, const FolderFile &file, std::optional<mode_t> mode)
{
    if (!makeFoldersFor(folder, file.name))
        return false;
    FileDescriptor out(::openat(folder, file.name.c_str(),
        O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kFileMode));
    std::string_view bytes = file.bytes;
    while (out.valid() && !bytes.empty()) {
        const ssize_t written = ::write(out.get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return out.valid() && (!mode || ::fchmod(out.get(), *mode) == 0) && ::fsync(out.get()) == 0
        && out.close();
}

std::optional<mode_t> modeBefore(const FolderContents &before, const std::string &name)
{
    if (name == kWrittenList)
        return before.list ? std::optional(before.listMode) : std::nullopt;
    const auto own = std::ranges::find_if(
        before.own, [&](const OwnFile &file) { return file.listed.file == name; });
    return own != before.own.end() ? std::optional(own->mode) : std::nullopt;
}

const NameRule &completedBy(const FolderRequest &request)
{
    return request.mayComplete ? request.mayComplete : request.mayWrite;
}

tl::unexpected<Error> cancelled()
{
    return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
}

/// The exchange puts a new folder in the place of the old one, which must not be anybody's working
/// folder; its owner and access list would be lost.
bool mayBeExchanged(const FolderPlace &place, int folder, int tree)
{
    std::error_code error;
    const fs::path here = fs::current_path(error);
    const auto [end, ignored] = std::mismatch(
        place.path.begin(), place.path.end(), here.native().begin(), here.native().end());
    struct stat old = {};
    struct stat now = {};
    return place.claimTarget != "." && (error || end != place.path.end())
        && ::flistxattr(folder, nullptr, 0) <= 0 && ::fstat(folder, &old) == 0
        && ::fstat(tree, &now) == 0 && old.st_uid == now.st_uid && old.st_gid == now.st_gid
        && ::fchmod(tree, old.st_mode & kPermissions) == 0;
}

bool exchange(int first, const std::string &firstName, int second, const std::string &secondName)
{
    return ::renameat2(first, firstName.c_str(), second, secondName.c_str(), RENAME_EXCHANGE) == 0;
}

WrittenList retiredOf(const FolderContents &before)
{
    WrittenList retired;
    for (const OwnFile &own : before.own)
        retired.push_back(own.listed);
    if (before.list)
        retired.push_back({kWrittenList, {}, before.listSha256});
    return retired;
}

/// Locks the folders below that hold our files: a program that writes into one of them has it open,
/// and an exchange would remove it. Empty if a program does.
std::optional<std::vector<FolderLock>> lockBelow(
    const FolderPlace &place, int folder, const FolderPlan &plan)
{
    std::set<std::string> parts;
    for (const WrittenList &list : {plan.retired, plan.placed})
        for (const WrittenFile &file : list)
            if (const std::size_t slash = file.file.find('/'); slash != std::string::npos)
                parts.insert(file.file.substr(0, slash));
    std::vector<FolderLock> locks;
    for (const std::string &part : parts) {
        if (!identityOf(folder, part))
            continue;
        locks.emplace_back((fs::path(place.path) / part).string());
        if (!locks.back().valid() || hasLiveClaims(locks.back().folder(), {}))
            return std::nullopt;
    }
    return locks;
}

bool isAnyLeft(int staging, const WrittenList &retired)
{
    const FileDescriptor old(openFolderAt(staging, kRetired));
    return old.valid() && std::ranges::any_of(retired, [&](const WrittenFile &file) {
        return identityOf(old.get(), file.file).has_value();
    });
}

} // namespace

FolderWrite::FolderWrite(FolderRequest request, FolderPlace place, WriteClaim claim)
    : m_request(std::move(request))
    , m_place(std::move(place))
    , m_claim(std::move(claim))
{
}

FolderWrite::~FolderWrite()
{
    release();
}

void FolderWrite::release()
{
    if (!m_claim || m_claim->folder() < 0)
        return;
    if (m_mustStay || !removeTree(m_claim->folder(), m_claim->temporary()))
        m_claim->leaveBehind();
    m_claim.reset();
    for (auto parent = m_place.made.rbegin(); parent != m_place.made.rend(); ++parent)
        ::rmdir(parent->c_str()); // those that stayed empty
}

Result<FolderWrite> FolderWrite::begin(const FolderRequest &request)
{
    Result<FolderPlace> place = locateFolder(request.folder);
    if (!place)
        return tl::unexpected<Error>(place.error());
    Result<WriteClaim> claim = WriteClaim::take(place->claimFolder, place->claimTarget,
        ClaimKind::Folder, place->shown, completedBy(request));
    if (!claim)
        return tl::unexpected<Error>(claim.error());
    FolderWrite write(request, std::move(*place), std::move(*claim));
    if (write.m_place.exists && write.m_place.claimTarget != ".") {
        const Result<void> cleared
            = clearClaims(write.m_place.path, ".", write.m_place.shown, completedBy(request));
        if (!cleared)
            return tl::unexpected<Error>(cleared.error());
    }
    const Result<FolderContents> contents
        = inspectFolder(write.m_place, write.m_claim->folder(), request, request.names);
    if (!contents)
        return tl::unexpected<Error>(contents.error());
    return write;
}

Result<void> FolderWrite::commit(const std::vector<FolderFile> &files, const JobControl &control)
{
    const Result<void> done = commitClaimed(files, control);
    release();
    return done;
}

Result<void> FolderWrite::commitClaimed(
    const std::vector<FolderFile> &files, const JobControl &control)
{
    std::vector<std::string> names{kWrittenList};
    for (const FolderFile &file : files)
        names.push_back(file.name);
    // The list of earlier files is checked like the others: its name must not belong to somebody
    // else.
    const Result<FolderContents> before
        = inspectFolder(m_place, m_claim->folder(), m_request, names);
    if (!before)
        return tl::unexpected<Error>(before.error());
    if (const Result<void> staged = stage(files, *before, control); !staged)
        return staged;
    if (control.stopRequested())
        return cancelled();
    if (const Result<void> may = m_request.mayCommit ? m_request.mayCommit() : Result<void>(); !may)
        return may;
    return before->folder.valid() ? replaceFolder(*before) : placeNewFolder();
}

Result<void> FolderWrite::stage(
    const std::vector<FolderFile> &files, const FolderContents &before, const JobControl &control)
{
    const int place = m_claim->folder();
    if (::mkdirat(place, m_claim->temporary().c_str(), kPrivateFolder) != 0)
        return cannotWrite(m_place.shown);
    m_staging = FileDescriptor(openFolderAt(place, m_claim->temporary()));
    if (!m_staging.valid() || ::mkdirat(m_staging.get(), kStagedTree, kFolderMode) != 0)
        return cannotWrite(m_place.shown);
    m_tree = FileDescriptor(openFolderAt(m_staging.get(), kStagedTree));
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (control.stopRequested())
            return cancelled();
        if (!writeFile(m_tree.get(), files[i], modeBefore(before, files[i].name)))
            return cannotWrite((fs::path(m_place.shown) / files[i].name).string());
        m_placed.push_back({files[i].name, m_request.writer, sha256Hex(files[i].bytes)});
        control.report(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    }
    WrittenList all = m_placed;
    all.insert(all.end(), before.others.begin(), before.others.end());
    const std::string list = writtenListText(all);
    m_placed.push_back({kWrittenList, {}, sha256Hex(list)});
    const std::optional<mode_t> mode = modeBefore(before, kWrittenList);
    if (!writeFile(m_tree.get(), {kWrittenList, list}, mode)
        || !syncFolders(m_tree.get(), m_placed))
        return cannotWrite((fs::path(m_place.shown) / kWrittenList).string());
    return {};
}

Result<void> FolderWrite::placeNewFolder()
{
    if (!isStillThere(-1))
        return wasMoved(m_place.shown);
    if (!renameToFree(m_staging.get(), kStagedTree, m_claim->folder(), m_place.claimTarget))
        return errno == EEXIST ? existsAlready(m_place.shown) : cannotWrite(m_place.shown);
    return ::fsync(m_claim->folder()) == 0 ? Result<void>() : cannotWrite(m_place.shown);
}

/// Whether the path and the claim still mean this folder (none yet: the place for it).
bool FolderWrite::isStillThere(int folder) const
{
    struct stat byPath = {};
    struct stat claimed = {};
    const bool isParentThere = ::stat(m_place.claimFolder.c_str(), &byPath) == 0
        && ::fstat(m_claim->folder(), &claimed) == 0 && byPath.st_dev == claimed.st_dev
        && byPath.st_ino == claimed.st_ino;
    return isParentThere
        && (folder < 0 || isFolderAt(m_claim->folder(), m_place.claimTarget, folder));
}

Result<void> FolderWrite::replaceFolder(const FolderContents &before)
{
    const FolderLock lock(m_place.path);
    if (!lock.valid() && errno != EWOULDBLOCK)
        return isStillThere(before.folder.get()) ? cannotWrite(m_place.shown)
                                                 : wasMoved(m_place.shown);
    if (!lock.valid() || hasLiveClaims(lock.folder(), m_claim->temporary()))
        return isBeingWritten(m_place.shown);
    const auto tree = identityOf(m_staging.get(), kStagedTree);
    const auto folder = identityOf(before.folder.get(), ".");
    const FolderPlan plan{
        tree ? tree->inode : 0, folder ? folder->inode : 0, retiredOf(before), m_placed};
    if (!isStillThere(before.folder.get()))
        return wasMoved(m_place.shown);
    const auto below = lockBelow(m_place, before.folder.get(), plan);
    if (below && mayBeExchanged(m_place, before.folder.get(), m_tree.get())
        && linkKept(before.folder.get(), m_tree.get(), plan.retired)
        && writePlan(m_staging.get(), kExchangePlan, plan)
        && exchange(m_staging.get(), kStagedTree, m_claim->folder(), m_place.claimTarget))
        return finishExchange(before, plan);
    ::unlinkat(m_staging.get(), kExchangePlan, 0);
    return moveFiles(before, plan);
}

/// Names can change until the exchange itself, so what was exchanged is checked after it.
Result<void> FolderWrite::finishExchange(const FolderContents &before, const FolderPlan &plan)
{
    const int place = m_claim->folder();
    if (!isFolderAt(m_staging.get(), kStagedTree, before.folder.get()) || !isStillThere(-1)) {
        m_mustStay = !takeBackExchange(place, m_staging.get(), m_place.claimTarget, plan);
        return wasMoved(m_place.shown);
    }
    // Only an empty folder is removed: somebody may still be putting files into it.
    m_mustStay = !emptyOldTree(before.folder.get(), m_tree.get(), plan.retired)
        || ::unlinkat(m_staging.get(), kStagedTree, AT_REMOVEDIR) != 0;
    return ::fsync(place) == 0 ? Result<void>() : cannotWrite(m_place.shown);
}

Result<void> FolderWrite::moveFiles(const FolderContents &before, const FolderPlan &plan)
{
    const int folder = before.folder.get();
    if (!isStillThere(folder))
        return wasMoved(m_place.shown);
    if (!writePlan(m_staging.get(), kMovesPlan, plan))
        return cannotWrite(m_place.shown);
    const bool moved = carryOutMoves(m_staging.get(), folder, plan);
    const int problem = errno;
    if (moved && isStillThere(folder))
        return {};
    if (moved)
        takeBackMoves(m_staging.get(), folder, plan);
    m_mustStay = isAnyLeft(m_staging.get(), plan.retired);
    return moved ? wasMoved(m_place.shown) : cannotWrite(m_place.shown, problem);
}

} // namespace dyncal
