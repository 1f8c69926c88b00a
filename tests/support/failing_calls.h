// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Stands between the program under test and the system's calls that change files: include it in
// one source file of a test program. Makes the k-th such call fail, or ends the process there.

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <functional>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

namespace dyncal::testing {

inline constexpr int kEndedThere = 77; ///< exit code of a process ended at a call

/// What happens at the calls that change files; off until set.
struct FailingCalls
{
    static inline std::atomic<int> countdown = -1; ///< calls left before the one; negative: off
    static inline std::atomic<int> errorNumber = 0; ///< 0: the process ends
    static inline std::atomic<int> seen = 0;
    static inline std::function<void()> action; ///< done before that call, which succeeds then

    /// The call after `calls` others fails with `error`, or ends the process where that is 0.
    static void arm(int calls, int error)
    {
        seen = 0;
        errorNumber = error;
        countdown = calls;
    }
    /// Something happens between two calls, as another program would do it.
    static void armAction(int calls, std::function<void()> what)
    {
        action = std::move(what);
        arm(calls, 0);
    }
    static void disarm()
    {
        countdown = -1;
        action = nullptr;
    }

    /// True (with errno) where this call is to fail.
    static bool isNow()
    {
        if (countdown < 0)
            return false;
        ++seen;
        if (countdown-- != 0)
            return false;
        if (const auto once = std::exchange(action, nullptr)) {
            once();
            return false;
        }
        if (errorNumber == 0)
            ::_exit(kEndedThere);
        errno = errorNumber;
        return true;
    }
};

template <typename Function>
Function *realCall(const char *name)
{
    return reinterpret_cast<Function *>(::dlsym(RTLD_NEXT, name));
}

} // namespace dyncal::testing

#define DYNCAL_CALL(name, ...)                                                                     \
    static auto *const real = dyncal::testing::realCall<decltype(::name)>(#name);                  \
    return dyncal::testing::FailingCalls::isNow() ? -1 : real(__VA_ARGS__)

extern "C" {

inline __attribute__((used)) ssize_t write(int file, const void *bytes, size_t size)
{
    DYNCAL_CALL(write, file, bytes, size);
}

inline __attribute__((used)) ssize_t pwrite(int file, const void *bytes, size_t size, off_t offset)
{
    DYNCAL_CALL(pwrite, file, bytes, size, offset);
}

inline __attribute__((used)) ssize_t pwrite64(
    int file, const void *bytes, size_t size, off64_t offset)
{
    DYNCAL_CALL(pwrite64, file, bytes, size, offset);
}

inline __attribute__((used)) int ftruncate64(int file, off64_t size) noexcept
{
    DYNCAL_CALL(ftruncate64, file, size);
}

inline __attribute__((used)) int fsync(int file)
{
    DYNCAL_CALL(fsync, file);
}

inline __attribute__((used)) int mkdirat(int folder, const char *name, mode_t mode) noexcept
{
    DYNCAL_CALL(mkdirat, folder, name, mode);
}

inline __attribute__((used)) int linkat(
    int from, const char *name, int to, const char *newName, int flags) noexcept
{
    DYNCAL_CALL(linkat, from, name, to, newName, flags);
}

inline __attribute__((used)) int renameat(
    int from, const char *name, int to, const char *newName) noexcept
{
    DYNCAL_CALL(renameat, from, name, to, newName);
}

inline __attribute__((used)) int renameat2(
    int from, const char *name, int to, const char *newName, unsigned flags) noexcept
{
    DYNCAL_CALL(renameat2, from, name, to, newName, flags);
}

inline __attribute__((used)) int unlinkat(int folder, const char *name, int flags) noexcept
{
    DYNCAL_CALL(unlinkat, folder, name, flags);
}

inline __attribute__((used)) int openat(int folder, const char *name, int flags, ...)
{
    using Open = int(int, const char *, int, ...);
    static auto *const real = dyncal::testing::realCall<Open>("openat");
    mode_t mode = 0;
    if ((flags & (O_CREAT | O_TMPFILE)) != 0) {
        va_list more;
        va_start(more, flags);
        mode = va_arg(more, mode_t);
        va_end(more);
    }
    const bool creates = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    return creates && dyncal::testing::FailingCalls::isNow() ? -1 : real(folder, name, flags, mode);
}
}

#undef DYNCAL_CALL
