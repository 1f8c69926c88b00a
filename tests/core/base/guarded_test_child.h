// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>

namespace dyncal::testing {

/// Runs `check` in a process of its own and returns its exit code, or -signal if it was killed: for
/// what limits or endangers the whole process. The child ends by `exit`, so that what libraries do
/// at exit is part of the test.
inline int exitCodeOf(const std::function<int()> &check)
{
    const pid_t child = ::fork();
    if (child < 0)
        return 1;
    if (child == 0) {
        for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
            std::signal(crash, SIG_DFL); // the test framework's handler would report it as its own
        std::exit(check());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace dyncal::testing
