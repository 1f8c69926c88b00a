// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/claim_file.h"

#include "core/base/writing/file_identity.h"
#include "core/base/writing/temporary_name.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

constexpr std::string_view kSuffix = ".claim";
constexpr std::string_view kFirstLine = "dyncal-claim/1\n";
constexpr std::size_t kLongestClaim = 4096;
// Other users must see that somebody is writing, whatever the process's umask.
constexpr mode_t kReadable = 0644;

std::string bytesOf(const ClaimText &text)
{
    return std::string(kFirstLine) + text.temporary + '\n'
        + (text.kind == ClaimKind::File ? "file\n" : "folder\n") + text.target;
}

std::optional<ClaimText> parse(std::string_view bytes, std::string_view temporary)
{
    const auto skip = [&](std::string_view wanted) {
        const bool found = bytes.starts_with(wanted);
        bytes.remove_prefix(found ? wanted.size() : 0);
        return found;
    };
    if (!skip(kFirstLine) || !skip(temporary) || !skip("\n"))
        return std::nullopt;
    ClaimText text{std::string(temporary), ClaimKind::File, {}};
    if (skip("folder\n"))
        text.kind = ClaimKind::Folder;
    else if (!skip("file\n"))
        return std::nullopt;
    text.target = bytes;
    const bool isName
        = !text.target.empty() && text.target != ".." && text.target.find('/') == std::string::npos;
    return isName ? std::optional(text) : std::nullopt;
}

bool writeAndLock(int file, std::string_view bytes)
{
    (void)::fchmod(file, kReadable); // whatever the umask; some file systems have no modes
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written >= 0 && written < static_cast<ssize_t>(bytes.size()))
        errno = ENOSPC;
    return written == static_cast<ssize_t>(bytes.size()) && ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

/// The file gets its name when it is complete, so that nobody sees half a claim.
FileDescriptor createNameless(int folder, const ClaimText &text)
{
    FileDescriptor file(::openat(folder, ".", O_TMPFILE | O_RDWR | O_CLOEXEC, kReadable));
    if (!file.valid() || !writeAndLock(file.get(), bytesOf(text)))
        return FileDescriptor();
    const std::string self = "/proc/self/fd/" + std::to_string(file.get());
    const bool isNamed = ::linkat(AT_FDCWD, self.c_str(), folder,
                             claimFileName(text.temporary).c_str(), AT_SYMLINK_FOLLOW)
        == 0;
    return isNamed ? std::move(file) : FileDescriptor();
}

/// For file systems without nameless files.
FileDescriptor createNamed(int folder, const ClaimText &text)
{
    const std::string name = claimFileName(text.temporary);
    FileDescriptor file(::openat(
        folder, name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kReadable));
    if (!file.valid() || writeAndLock(file.get(), bytesOf(text)))
        return file;
    const int problem = errno;
    ::unlinkat(folder, name.c_str(), 0);
    errno = problem;
    return FileDescriptor();
}

std::optional<FoundClaim> readClaim(int folder, const std::string &name)
{
    const std::string temporary = name.substr(0, name.size() - kSuffix.size());
    FileDescriptor file(
        ::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status = {};
    if (!file.valid() || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
    std::array<char, kLongestClaim> bytes{};
    const ssize_t got = ::read(file.get(), bytes.data(), bytes.size());
    const auto text = got > 0
        ? parse(std::string_view(bytes.data(), static_cast<std::size_t>(got)), temporary)
        : std::nullopt;
    if (!text)
        return std::nullopt;
    const bool isLive = ::flock(file.get(), LOCK_EX | LOCK_NB) != 0;
    if (!isLive && status.st_uid != ::geteuid())
        return std::nullopt; // only that user clears it
    return FoundClaim{*text, std::move(file), isLive};
}

} // namespace

std::string claimFileName(const std::string &temporary)
{
    return temporary + std::string(kSuffix);
}

FileDescriptor createClaimFile(int folder, const ClaimText &text)
{
    FileDescriptor file = createNameless(folder, text);
    const bool isOther = !file.valid() && errno != EEXIST && errno != ENOSPC && errno != EDQUOT
        && errno != EFBIG && errno != EACCES && errno != EROFS;
    return isOther ? createNamed(folder, text) : std::move(file);
}

std::vector<FoundClaim> findClaims(int folder)
{
    std::vector<FoundClaim> claims;
    for (const std::string &name : namesIn(folder)) {
        if (!name.ends_with(kSuffix)
            || !isTemporaryName(std::string_view(name).substr(0, name.size() - kSuffix.size())))
            continue;
        if (auto claim = readClaim(folder, name))
            claims.push_back(std::move(*claim));
    }
    return claims;
}

} // namespace dyncal
