// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Preloaded into the program as it is built: its disk is full from the call on that the environment
// names (DYNCAL_FULL_FROM, counted from 0 in each process). Only calls that take room on a disk
// count: pipes and the terminal are none.

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

bool isFull()
{
    static const char *const from = std::getenv("DYNCAL_FULL_FROM");
    static std::atomic<long> calls = 0;
    if (from == nullptr || calls++ < std::atol(from))
        return false;
    errno = ENOSPC;
    return true;
}

bool isFile(int file)
{
    struct stat status = {};
    return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
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
    const bool creates = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    mode_t mode = 0;
    if (creates) {
        va_list more;
        va_start(more, flags);
        mode = va_arg(more, mode_t);
        va_end(more);
    }
    return creates && isFull() ? -1 : real(folder, name, flags, mode);
}
}
