// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/guarded_run.h"

#include "core/base/file_descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <memory>

namespace dyncal {
namespace {

using Clock = std::chrono::steady_clock;

/// A second limit, in real time: work that waits (for a lock, a lost disk) uses no processor time.
constexpr std::chrono::seconds kSilence{30};
constexpr std::size_t kPipeBytes = 1 << 20;
constexpr std::size_t kReceiveBytes = 1 << 16; ///< a larger buffer costs more than it saves

/// Never raises what is in force already.
void limit(int resource, std::uint64_t value)
{
    rlimit now{};
    ::getrlimit(static_cast<__rlimit_resource>(resource), &now);
    const rlim_t least = std::min(static_cast<rlim_t>(value), now.rlim_cur);
    const rlimit wanted{least, least};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

/// Address space in use now, so that the limit is on what the work adds.
std::uint64_t usedAddressSpace()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// A handler of the program would report the child's crash as the program's own. Ctrl+C reaches all
/// processes of the terminal at once: the program decides what it means, and the child ends with
/// it.
void forgetSignalHandling()
{
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        ::signal(number, SIG_IGN);
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE, SIGPROF})
        ::signal(number, SIG_DFL);
    ::signal(SIGXFSZ, SIG_IGN); // or else a warning to stderr kills it where stderr is a file
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// What the program knows before the fork.
struct Parent
{
    pid_t id = ::getpid();
    std::uint64_t addressSpace = usedAddressSpace();
};

[[noreturn]] void runAsChild(const std::function<void(GuardedOutput &)> &work, int descriptor,
    const GuardedLimits &limits, const Parent &parent)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent.id) // the parent ended before its death signal was set
        ::_exit(1);
    forgetSignalHandling();
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0); // it reads files and writes none
    limit(RLIMIT_AS, parent.addressSpace + limits.memoryBytes);
    GuardedOutput output(descriptor, limits.time);
    try {
        work(output);
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

/// Passes on what arrives until the other end is closed.
GuardedOutcome receiveAll(int descriptor,
    const std::function<bool(std::span<const std::byte>)> &receive, const std::stop_token &stop)
{
    constexpr int kLook_ms = 20;
    const auto buffer = std::make_unique_for_overwrite<std::byte[]>(kReceiveBytes);
    for (auto heard = Clock::now(); Clock::now() - heard < kSilence;) {
        if (stop.stop_requested())
            return GuardedOutcome::Stopped;
        pollfd wait{descriptor, POLLIN, 0};
        if (::poll(&wait, 1, kLook_ms) <= 0)
            continue;
        const ssize_t got = ::read(descriptor, buffer.get(), kReceiveBytes);
        if (got == 0)
            return GuardedOutcome::Finished;
        if (got > 0 && !receive(std::span(buffer.get(), static_cast<std::size_t>(got))))
            return GuardedOutcome::Died;
        if (got < 0 && errno != EINTR && errno != EAGAIN)
            return GuardedOutcome::Died;
        heard = Clock::now();
    }
    return GuardedOutcome::Died;
}

/// How a child ended that was not killed here.
GuardedOutcome endOf(pid_t child)
{
    int status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(child, &status, 0)) < 0 && errno == EINTR) { }
    if (ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return GuardedOutcome::Finished;
    const bool killed = ended == child && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
    return killed ? GuardedOutcome::Killed : GuardedOutcome::Died;
}

} // namespace

GuardedOutput::GuardedOutput(int descriptor, std::chrono::milliseconds time)
    : m_descriptor(descriptor)
    , m_time(time)
{
    restartClock();
}

void GuardedOutput::write(std::span<const std::byte> bytes)
{
    restartClock();
    while (!bytes.empty()) {
        const ssize_t done = ::write(m_descriptor, bytes.data(), bytes.size());
        if (done < 0 && errno != EINTR)
            ::_exit(1);
        bytes = bytes.subspan(static_cast<std::size_t>(done > 0 ? done : 0));
    }
}

void GuardedOutput::restartClock() const
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(m_time);
    const auto rest = std::chrono::duration_cast<std::chrono::microseconds>(m_time - seconds);
    const itimerval timer{{0, 0}, {seconds.count(), rest.count()}};
    ::setitimer(ITIMER_PROF, &timer, nullptr); // SIGPROF ends the process
}

GuardedOutcome runGuarded(const std::function<void(GuardedOutput &)> &work,
    const std::function<bool(std::span<const std::byte>)> &receive, const GuardedLimits &limits,
    const std::stop_token &stop)
{
    const Parent parent;
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return GuardedOutcome::NotStarted;
    const FileDescriptor out(ends[0]);
    FileDescriptor in(ends[1]);
    ::fcntl(in.get(), F_SETPIPE_SZ, static_cast<int>(kPipeBytes)); // faster, if it may be
    const pid_t child = ::fork();
    if (child < 0)
        return GuardedOutcome::NotStarted;
    if (child == 0)
        runAsChild(work, in.get(), limits, parent);
    in.close();
    const GuardedOutcome received = receiveAll(out.get(), receive, stop);
    if (received != GuardedOutcome::Finished)
        ::kill(child, SIGKILL);
    const GuardedOutcome end = endOf(child);
    const GuardedOutcome outcome = received == GuardedOutcome::Finished ? end : received;
    const bool stopped = outcome != GuardedOutcome::Finished && stop.stop_requested();
    return stopped ? GuardedOutcome::Stopped : outcome;
}

} // namespace dyncal
