// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/write_claim.h"

#include "core/base/writing/claim_file.h"
#include "core/base/writing/stray_cleaning.h"
#include "core/base/writing/temporary_name.h"
#include "core/base/writing/write_problem.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

/// Making a claim and clearing leftovers takes milliseconds; a longer lock is not Dyncal's.
constexpr std::chrono::seconds kLongestWait{10};
constexpr std::chrono::milliseconds kLook{1};
constexpr int kMostClaims = 100;

bool lockWithin(int folder, std::chrono::steady_clock::time_point end)
{
    while (::flock(folder, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return false;
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(kLook);
    }
    return true;
}

/// Another program may have put a new folder in its place meanwhile.
bool isStillThere(const std::string &path, int folder)
{
    struct stat byName = {};
    struct stat opened = {};
    return ::stat(path.c_str(), &byName) == 0 && ::fstat(folder, &opened) == 0
        && byName.st_dev == opened.st_dev && byName.st_ino == opened.st_ino;
}

bool isFree(int folder, const std::string &name)
{
    struct stat status = {};
    return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 && errno == ENOENT;
}

/// A claim under a name whose temporary name is free too.
FileDescriptor createUnderFreeName(int folder, ClaimText &text)
{
    FileDescriptor file;
    for (int i = 0; i < kMostClaims && !file.valid(); ++i) {
        text.temporary = newTemporaryName();
        if (!isFree(folder, text.temporary)) {
            errno = EEXIST;
            continue;
        }
        file = createClaimFile(folder, text);
        if (!file.valid() && errno != EEXIST)
            break;
    }
    return file;
}

/// Leftovers of other folders are not touched: a planted claim could name any folder.
bool isCleared(const FoundClaim &claim, const std::string &target, const NameRule &mayWrite)
{
    return !claim.isLive
        && (claim.text.kind == ClaimKind::File || (claim.text.target == target && mayWrite));
}

Result<void> clearLocked(
    int folder, const std::string &target, const std::string &shown, const NameRule &mayWrite)
{
    for (const FoundClaim &claim : findClaims(folder)) {
        if (claim.isLive && claim.text.target == target)
            return isBeingWritten(shown);
        if (!isCleared(claim, target, mayWrite))
            continue;
        const Result<void> cleared = clearStray(folder, claim.text, mayWrite);
        if (!cleared && claim.text.target == target)
            return cleared;
        if (cleared)
            ::unlinkat(folder, claimFileName(claim.text.temporary).c_str(), 0);
    }
    return {};
}

} // namespace

FolderLock::FolderLock(const std::string &folder)
{
    const auto end = std::chrono::steady_clock::now() + kLongestWait;
    while (std::chrono::steady_clock::now() <= end) {
        m_folder = FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (!m_folder.valid())
            return;
        if (!lockWithin(m_folder.get(), end))
            break;
        if (isStillThere(folder, m_folder.get()))
            return;
    }
    const int problem = errno;
    m_folder = FileDescriptor();
    errno = problem;
}

FileDescriptor FolderLock::takeFolder()
{
    ::flock(m_folder.get(), LOCK_UN);
    return std::move(m_folder);
}

bool hasLiveClaims(int folder, const std::string &own)
{
    const std::vector<FoundClaim> claims = findClaims(folder);
    return std::ranges::any_of(claims,
        [&](const FoundClaim &claim) { return claim.isLive && claim.text.temporary != own; });
}

Result<void> clearClaims(const std::string &folder, const std::string &target,
    const std::string &shown, const NameRule &mayWrite)
{
    const FolderLock lock(folder);
    if (!lock.valid())
        return errno == EWOULDBLOCK ? isBeingWritten(shown) : cannotWrite(shown);
    return clearLocked(lock.folder(), target, shown, mayWrite);
}

Result<WriteClaim> WriteClaim::take(const std::string &folder, const std::string &target,
    ClaimKind kind, const std::string &shown, const NameRule &mayWrite)
{
    FolderLock lock(folder);
    if (!lock.valid())
        return errno == EWOULDBLOCK ? isBeingWritten(shown) : cannotWrite(shown);
    const Result<void> cleared = clearLocked(lock.folder(), target, shown, mayWrite);
    if (!cleared)
        return tl::unexpected<Error>(cleared.error());
    ClaimText text{{}, kind, target};
    WriteClaim claim;
    claim.m_file = createUnderFreeName(lock.folder(), text);
    if (!claim.m_file.valid())
        return cannotWrite(shown);
    claim.m_temporary = text.temporary;
    claim.m_folder = lock.takeFolder();
    claim.m_folderPath = folder;
    return claim;
}

WriteClaim::WriteClaim(WriteClaim &&other) noexcept = default;

WriteClaim &WriteClaim::operator=(WriteClaim &&other) noexcept
{
    std::swap(m_folder, other.m_folder);
    std::swap(m_file, other.m_file);
    m_folderPath.swap(other.m_folderPath);
    m_temporary.swap(other.m_temporary);
    return *this;
}

WriteClaim::~WriteClaim()
{
    release();
}

void WriteClaim::leaveBehind()
{
    m_file.close();
}

/// The name goes before the lock, so that nobody takes the claim for a leftover.
void WriteClaim::release()
{
    if (m_file.valid())
        ::unlinkat(m_folder.get(), claimFileName(m_temporary).c_str(), 0);
    m_file.close();
}

} // namespace dyncal
