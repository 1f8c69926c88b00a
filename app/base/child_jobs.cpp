// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/child_jobs.h"

#include "app/base/interrupt.h"

#include "core/base/file_descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

constexpr std::size_t kLongestAnswer = 60000; // a pipe holds 64 KiB without a reader
constexpr int kLookAgain_ms = 100;
constexpr int kOutOfMemory = 5; // as ExitCode::Internal

struct RunningChild
{
    std::size_t job;
    pid_t process;
    FileDescriptor answer; ///< end of the pipe to read from
    FileDescriptor ended; ///< becomes readable when the process has ended
};

void writeAll(int descriptor, std::string text)
{
    text.resize(std::min(text.size(), kLongestAnswer));
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
        if (written < 0 && errno != EINTR)
            return;
        done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
}

/// All that is there: the writer has ended, but a process that it started may hold the other end.
std::string readAll(int descriptor)
{
    ::fcntl(descriptor, F_SETFL, O_NONBLOCK);
    std::string text(kLongestAnswer, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t got = ::read(descriptor, text.data() + done, text.size() - done);
        if (got == 0 || (got < 0 && errno != EINTR))
            break;
        done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    text.resize(done);
    return text;
}

/// What a job throws is its answer, too: only lack of memory is expected here.
ChildAnswer answerOf(const ChildJobs &jobs, std::size_t job)
{
    try {
        return jobs.work(job);
    } catch (const std::bad_alloc &) {
        return {kOutOfMemory, "not enough memory"};
    } catch (const std::exception &e) {
        return {kOutOfMemory, e.what()};
    }
}

[[noreturn]] void runAsChild(const ChildJobs &jobs, std::size_t job, int answer, pid_t parent)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) // it ended before its death signal was set
        ::_exit(1);
    takeStopsFromParent();
    const ChildAnswer given = answerOf(jobs, job);
    writeAll(answer, given.text);
    std::cout.flush();
    std::cerr.flush();
    ::_exit(given.exitCode);
}

/// Not open where the system has no such descriptors. (The function of this name in glibc 2.36 has
/// no C linkage.)
FileDescriptor openedProcess(pid_t process)
{
    return FileDescriptor(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
}

std::optional<RunningChild> startChild(const ChildJobs &jobs, std::size_t job)
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return std::nullopt;
    FileDescriptor out(ends[0]);
    const FileDescriptor in(ends[1]);
    const pid_t parent = ::getpid();
    std::cout.flush(); // or else the child would write it, too
    const pid_t child = ::fork();
    if (child < 0)
        return std::nullopt;
    if (child == 0)
        runAsChild(jobs, job, in.get(), parent);
    return RunningChild{job, child, std::move(out), openedProcess(child)};
}

/// Those that have ended are told and taken out.
void collectEnded(const ChildJobs &jobs, std::vector<RunningChild> &running)
{
    std::erase_if(running, [&](RunningChild &child) {
        int status = 0;
        if (::waitpid(child.process, &status, WNOHANG) != child.process)
            return false;
        const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        jobs.ended(child.job, {WEXITSTATUS(status), signal, readAll(child.answer.get())});
        return true;
    });
}

void waitForOne(const std::vector<RunningChild> &running)
{
    std::vector<pollfd> ends;
    ends.reserve(running.size());
    for (const RunningChild &child : running)
        ends.push_back({child.ended.get(), POLLIN, 0}); // poll leaves out what is not open
    const bool areKnown
        = std::ranges::all_of(running, [](const auto &child) { return child.ended.valid(); });
    ::poll(ends.data(), ends.size(), areKnown ? kLookAgain_ms : 2);
}

void askToStop(const std::vector<RunningChild> &running)
{
    for (const RunningChild &child : running)
        ::kill(child.process, kStopChild);
}

/// The child finds the signal blocked, so that none is lost before it waits for it.
void holdStopSignal()
{
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, kStopChild);
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

} // namespace

bool runChildJobs(const ChildJobs &jobs, const std::stop_token &stop)
{
    holdStopSignal();
    std::vector<RunningChild> running;
    std::size_t next = 0;
    bool isAsked = false;
    bool couldStart = true;
    while (!running.empty() || (next < jobs.count && couldStart && !stop.stop_requested())) {
        while (couldStart && !stop.stop_requested() && next < jobs.count
            && running.size() < jobs.atOnce) {
            std::optional<RunningChild> child = startChild(jobs, next);
            couldStart = child.has_value() || !running.empty(); // later there may be room again
            if (!child)
                break;
            running.push_back(std::move(*child));
            ++next;
        }
        if (stop.stop_requested() && !std::exchange(isAsked, true))
            askToStop(running);
        if (!running.empty())
            waitForOne(running);
        collectEnded(jobs, running);
        if (jobs.idle)
            jobs.idle();
    }
    return couldStart;
}

} // namespace dyncal
