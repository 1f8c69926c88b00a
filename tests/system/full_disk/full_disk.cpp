// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Preloaded into the program as it is built: something is wrong with its disk from the call on that
// the environment names (DYNCAL_FULL_FROM, counted from 0 in each process), by DYNCAL_FULL_KIND:
//   full (or nothing)   no room is left. Calls that take room count; pipes and the terminal are
//   none read-only           nothing can be changed any more; renaming and removing count too
//   vanished:FOLDER     at that call the folder is moved away, to FOLDER.gone; nothing else fails

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

std::string_view kind()
{
    static const char *const kind = std::getenv("DYNCAL_FULL_KIND");
    return kind ? kind : "full";
}

bool isReadOnly()
{
    return kind() == "read-only";
}

void moveAway(std::string_view folder)
{
    static std::atomic<bool> isDone = false;
    if (!isDone.exchange(true))
        std::rename(std::string(folder).c_str(), (std::string(folder) + ".gone").c_str());
}

/// Whether this call fails.
bool isFull()
{
    constexpr std::string_view kVanished = "vanished:";
    static const char *const from = std::getenv("DYNCAL_FULL_FROM");
    static std::atomic<long> calls = 0;
    if (from == nullptr || calls++ < std::atol(from))
        return false;
    if (kind().starts_with(kVanished)) {
        moveAway(kind().substr(kVanished.size()));
        return false;
    }
    errno = isReadOnly() ? EROFS : ENOSPC;
    return true;
}

bool isFile(int file)
{
    struct stat status = {};
    return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

bool creates(int flags)
{
    return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
}

/// Of a file: devices stay writable on a disk that is not.
bool isForWriting(const char *name, int flags)
{
    struct stat status = {};
    const bool isThere = ::stat(name, &status) == 0;
    return isThere ? S_ISREG(status.st_mode) && (flags & O_ACCMODE) != O_RDONLY : creates(flags);
}

template <typename Function>
Function *realCall(const char *name)
{
    return reinterpret_cast<Function *>(::dlsym(RTLD_NEXT, name));
}

} // namespace

#define DYNCAL_REAL(name) static auto *const real = realCall<decltype(::name)>(#name)

extern "C" {

ssize_t write(int file, const void *bytes, size_t size)
{
    DYNCAL_REAL(write);
    return isFile(file) && isFull() ? -1 : real(file, bytes, size);
}

ssize_t pwrite(int file, const void *bytes, size_t size, off_t offset)
{
    DYNCAL_REAL(pwrite);
    return isFile(file) && isFull() ? -1 : real(file, bytes, size, offset);
}

ssize_t pwrite64(int file, const void *bytes, size_t size, off64_t offset)
{
    DYNCAL_REAL(pwrite64);
    return isFile(file) && isFull() ? -1 : real(file, bytes, size, offset);
}

int fsync(int file)
{
    DYNCAL_REAL(fsync);
    return isFile(file) && isFull() ? -1 : real(file);
}

int mkdirat(int folder, const char *name, mode_t mode) noexcept
{
    DYNCAL_REAL(mkdirat);
    return isFull() ? -1 : real(folder, name, mode);
}

int linkat(int from, const char *name, int to, const char *newName, int flags) noexcept
{
    DYNCAL_REAL(linkat);
    return isFull() ? -1 : real(from, name, to, newName, flags);
}

int openat(int folder, const char *name, int flags, ...)
{
    static auto *const real = realCall<int(int, const char *, int, ...)>("openat");
    mode_t mode = 0;
    if (creates(flags)) {
        va_list more;
        va_start(more, flags);
        mode = va_arg(more, mode_t);
        va_end(more);
    }
    return creates(flags) && isFull() ? -1 : real(folder, name, flags, mode);
}

int open64(const char *name, int flags, ...)
{
    static auto *const real = realCall<int(const char *, int, ...)>("open64");
    mode_t mode = 0;
    if (creates(flags)) {
        va_list more;
        va_start(more, flags);
        mode = va_arg(more, mode_t);
        va_end(more);
    }
    return isReadOnly() && isForWriting(name, flags) && isFull() ? -1 : real(name, flags, mode);
}

int renameat(int from, const char *name, int to, const char *newName) noexcept
{
    DYNCAL_REAL(renameat);
    return isReadOnly() && isFull() ? -1 : real(from, name, to, newName);
}

int renameat2(int from, const char *name, int to, const char *newName, unsigned flags) noexcept
{
    DYNCAL_REAL(renameat2);
    return isReadOnly() && isFull() ? -1 : real(from, name, to, newName, flags);
}

int unlinkat(int folder, const char *name, int flags) noexcept
{
    DYNCAL_REAL(unlinkat);
    return isReadOnly() && isFull() ? -1 : real(folder, name, flags);
}

int unlink(const char *name) noexcept
{
    DYNCAL_REAL(unlink);
    return isReadOnly() && isFull() ? -1 : real(name);
}
}
