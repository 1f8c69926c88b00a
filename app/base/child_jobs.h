// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>

namespace dyncal {

/// How a job's process ended.
struct ChildEnd
{
    int exitCode = 0; ///< meaningless where a signal ended it
    int signal = 0; ///< 0: it ended by itself
    std::string answer; ///< what the job wrote, at most 60 000 bytes
};

/// What a job gives back from its process.
struct ChildAnswer
{
    int exitCode = 0;
    std::string text;
};

struct ChildJobs
{
    std::size_t count = 0;
    unsigned atOnce = 1;
    std::function<ChildAnswer(std::size_t job)> work; ///< in a forked process of its own
    std::function<void(std::size_t job, const ChildEnd &end)> ended; ///< here, one at a time
    std::function<void()> idle = {}; ///< here, some times a second
};

/// Runs jobs 0 .. count - 1, `atOnce` at a time, each in a forked copy of this process: whatever
/// happens to one, none of the others notices. They end with this process, however it ends. Asked
/// to stop, no more are started and those that run are asked to stop (takeStopsFromParent) and
/// awaited. False if the system could start no process. To be called on the first thread; `work`
/// may use what is safe after fork in a threaded program.
bool runChildJobs(const ChildJobs &jobs, const std::stop_token &stop);

} // namespace dyncal
