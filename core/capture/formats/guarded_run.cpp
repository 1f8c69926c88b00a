// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/guarded_run.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <thread>

namespace dyncal {
namespace {

void limit(int resource, std::uint64_t value)
{
    const rlimit wanted{static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

/// Address space in use now, so that the limit is on what the work adds.
std::uint64_t usedAddressSpace()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

[[noreturn]] void runAsChild(const std::function<void()> &work, const GuardedLimits &limits)
{
    // A handler of the program would report the crash as the program's own.
    for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT})
        ::signal(crash, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_AS, usedAddressSpace() + limits.memoryBytes);
    limit(RLIMIT_CPU, static_cast<std::uint64_t>(limits.time.count()));
    try {
        work();
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

} // namespace

GuardedOutcome rehearse(
    const std::function<void()> &work, const GuardedLimits &limits, const std::stop_token &stop)
{
    const pid_t child = ::fork();
    if (child < 0)
        return GuardedOutcome::NotStarted;
    if (child == 0)
        runAsChild(work, limits);
    // The wall clock too: a child that waits for a lock uses no processor time.
    const auto deadline = std::chrono::steady_clock::now() + 2 * limits.time;
    int status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (stop.stop_requested() || std::chrono::steady_clock::now() > deadline) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
            return stop.stop_requested() ? GuardedOutcome::Stopped : GuardedOutcome::Died;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const bool returned = ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return returned ? GuardedOutcome::Finished : GuardedOutcome::Died;
}

} // namespace dyncal
