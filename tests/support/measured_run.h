// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace dyncal::testing {

/// What one run of a program took, its helper processes included.
struct MeasuredRun
{
    int exitCode = -1; ///< -1: it ended by a signal
    int signal = 0; ///< SIGKILL: it was ended because it took too long
    std::string err; ///< the first megabyte
    double wall_s = 0.0;
    double processor_s = 0.0;
    double peak_MiB = 0.0; ///< of itself or its largest helper
};

/// Runs the program with stdout to nowhere and stderr to the file `errPath`, for at most `longest`.
/// Several may run at once.
inline MeasuredRun measuredRun(const std::vector<std::string> &command, const std::string &errPath,
    std::chrono::milliseconds longest = std::chrono::seconds(30))
{
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kLook{1};
    constexpr std::size_t kMostErr = 1 << 20;

    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(
        &files, 2, errPath.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<char *> arguments;
    for (const std::string &argument : command)
        arguments.push_back(const_cast<char *>(argument.c_str()));
    arguments.push_back(nullptr);

    MeasuredRun run;
    pid_t child = 0;
    const auto begin = Clock::now();
    if (::posix_spawn(&child, arguments[0], &files, nullptr, arguments.data(), environ) != 0)
        std::abort();
    ::posix_spawn_file_actions_destroy(&files);
    int status = 0;
    rusage usage{};
    while (::wait4(child, &status, WNOHANG, &usage) == 0) {
        if (Clock::now() - begin > longest) {
            ::kill(child, SIGKILL);
            ::wait4(child, &status, 0, &usage);
            break;
        }
        std::this_thread::sleep_for(kLook);
    }
    run.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
    const auto seconds = [](const timeval &t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    run.processor_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    run.peak_MiB = static_cast<double>(usage.ru_maxrss) / 1024.0;
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;

    if (std::FILE *file = std::fopen(errPath.c_str(), "rb")) {
        run.err.resize(kMostErr);
        run.err.resize(std::fread(run.err.data(), 1, run.err.size(), file));
        std::fclose(file);
    }
    return run;
}

} // namespace dyncal::testing
