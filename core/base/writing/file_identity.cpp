// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/file_identity.h"

#include "core/base/content_hash.h"
#include "core/base/file_descriptor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dyncal {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::size_t kBlock = 1U << 18U;
constexpr std::size_t kTextBlock = 1U << 14U;

/// The folder of a name's last part, opened part by part, so that no link is followed.
FileDescriptor folderOf(int folder, const std::string &name)
{
    const std::size_t slash = name.rfind('/');
    return FileDescriptor(slash == std::string::npos
            ? ::openat(folder, ".", O_PATH | O_DIRECTORY | O_CLOEXEC)
            : openFolderAt(folder, name.substr(0, slash)));
}

std::string lastPart(const std::string &name)
{
    return name.substr(name.rfind('/') + 1);
}

/// Invalid if it is no regular file, or a link.
FileDescriptor openRegular(int folder, const std::string &name)
{
    const FileDescriptor parent = folderOf(folder, name);
    if (!parent.valid())
        return FileDescriptor();
    FileDescriptor file(::openat(
        parent.get(), lastPart(name).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status = {};
    const bool isRegular
        = file.valid() && ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
    return isRegular ? std::move(file) : FileDescriptor();
}

FileType typeOf(mode_t mode)
{
    if (S_ISREG(mode))
        return FileType::Regular;
    return S_ISDIR(mode) ? FileType::Folder : FileType::Other;
}

} // namespace

int openFolderAt(int folder, const std::string &name)
{
    FileDescriptor at(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    for (std::size_t begin = 0; at.valid() && begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string part = name.substr(begin, end - begin);
        at = FileDescriptor(
            ::openat(at.get(), part.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        begin = end + 1;
    }
    return at.valid() ? ::fcntl(at.get(), F_DUPFD_CLOEXEC, 0) : -1;
}

std::optional<FileIdentity> identityOf(int folder, const std::string &name)
{
    const FileDescriptor parent = folderOf(folder, name);
    struct stat status = {};
    if (!parent.valid()
        || ::fstatat(parent.get(), lastPart(name).c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return std::nullopt;
    return FileIdentity{typeOf(status.st_mode), status.st_dev, status.st_ino,
        static_cast<std::uint64_t>(status.st_size),
        status.st_mtim.tv_sec * kNanosecondsPerSecond + status.st_mtim.tv_nsec};
}

std::uint64_t mountOf(int folder, const std::string &name)
{
    struct statx status = {};
    if (::statx(folder, name.c_str(), AT_SYMLINK_NOFOLLOW, STATX_MNT_ID, &status) == 0
        && (status.stx_mask & STATX_MNT_ID) != 0)
        return status.stx_mnt_id;
    struct stat plain = {};
    return ::fstatat(folder, name.c_str(), &plain, AT_SYMLINK_NOFOLLOW) == 0 ? plain.st_dev : 0;
}

bool isFolderAt(int folder, const std::string &name, int opened)
{
    const auto byName = identityOf(folder, name);
    const auto byDescriptor = identityOf(opened, ".");
    return byName && byDescriptor && byName->isSameFile(*byDescriptor);
}

bool isOwnedByUser(int folder, const std::string &name)
{
    const FileDescriptor parent = folderOf(folder, name);
    struct stat status = {};
    return parent.valid()
        && ::fstatat(parent.get(), lastPart(name).c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0
        && status.st_uid == ::geteuid();
}

std::string sha256At(int folder, const std::string &name)
{
    const FileDescriptor file = openRegular(folder, name);
    if (!file.valid())
        return {};
    Sha256 hash;
    std::array<std::byte, kBlock> block;
    ssize_t got = 0;
    while ((got = ::read(file.get(), block.data(), block.size())) > 0)
        hash.add(std::span(block.data(), static_cast<std::size_t>(got)));
    return got == 0 ? hash.hex() : std::string();
}

std::optional<std::string> textAt(int folder, const std::string &name, std::size_t most)
{
    const FileDescriptor file = openRegular(folder, name);
    std::string text; // not reserved: `most` is only a bound, the text is usually short
    std::array<char, kTextBlock> block;
    ssize_t got = file.valid() ? 1 : -1;
    while (got > 0 && text.size() <= most) {
        got = ::read(file.get(), block.data(), block.size());
        text.append(block.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    }
    return got < 0 || text.size() > most ? std::nullopt : std::optional(std::move(text));
}

std::vector<std::string> namesIn(int folder)
{
    std::vector<std::string> names;
    const int own = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR *)> entries(
        own >= 0 ? ::fdopendir(own) : nullptr, &::closedir);
    while (const dirent *entry = entries ? ::readdir(entries.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..")
            names.push_back(name);
    }
    return names;
}

bool renameToFree(int fromFolder, const std::string &from, int toFolder, const std::string &to)
{
    if (::renameat2(fromFolder, from.c_str(), toFolder, to.c_str(), RENAME_NOREPLACE) == 0)
        return true;
    if (errno != EINVAL && errno != ENOSYS)
        return false;
    // The file system has no such rename. Files: a second name first, then the old name goes.
    // Folders: look first; claims keep other programs of ours away.
    if (::linkat(fromFolder, from.c_str(), toFolder, to.c_str(), 0) == 0)
        return ::unlinkat(fromFolder, from.c_str(), 0) == 0;
    if (errno == EEXIST)
        return false;
    struct stat status = {};
    if (::fstatat(toFolder, to.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
        errno = EEXIST;
        return false;
    }
    return ::renameat(fromFolder, from.c_str(), toFolder, to.c_str()) == 0;
}

bool removeTree(int folder, const std::string &name)
{
    if (::unlinkat(folder, name.c_str(), 0) == 0 || errno == ENOENT)
        return true;
    const FileDescriptor inside(
        ::openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!inside.valid())
        return false;
    for (const std::string &below : namesIn(inside.get()))
        removeTree(inside.get(), below);
    return ::unlinkat(folder, name.c_str(), AT_REMOVEDIR) == 0;
}

} // namespace dyncal
