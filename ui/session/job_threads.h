// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <thread>

namespace dyncal {

/// Threads of background jobs, which end when nothing is left to do. QThreadPool keeps silent about
/// a thread that the system did not start, and then waits for it for ever; and a QThread ends the
/// program where it finds no memory for its event loop, which no job needs.
class JobThreads
{
public:
    using Job = std::function<void()>; ///< lets no exception out

    explicit JobThreads(std::size_t most)
        : m_most(most)
    {
    }
    ~JobThreads(); ///< waits for running jobs; those not begun are dropped
    JobThreads(const JobThreads &) = delete;
    JobThreads &operator=(const JobThreads &) = delete;

    /// Runs the job at once, or as soon as one of the `most` threads is done with those before it.
    /// False if the system gives no thread: it is never run then.
    [[nodiscard]] bool start(Job job);

private:
    struct Worker
    {
        std::thread thread;
        bool hasEnded = false;
    };

    void addWorker();
    void work(Worker &worker);

    std::mutex m_mutex; ///< of all that follows
    std::deque<Job> m_waiting;
    std::list<Worker> m_workers;
    std::size_t m_most;
};

} // namespace dyncal
