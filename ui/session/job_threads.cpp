// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/job_threads.h"

#include "core/base/lanes.h"

#include <new>
#include <system_error>
#include <utility>

namespace dyncal {

JobThreads::~JobThreads()
{
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.clear();
    }
    for (Worker &worker : m_workers)
        worker.thread.join();
}

bool JobThreads::start(Job job)
{
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_workers, [](Worker &worker) {
        if (worker.hasEnded) // it has released the lock, so the join does not wait
            worker.thread.join();
        return worker.hasEnded;
    });
    m_waiting.push_back(std::move(job));
    if (m_workers.size() < m_most)
        addWorker();
    if (m_workers.empty())
        m_waiting.pop_back();
    return !m_workers.empty();
}

/// Adds a thread if the system gives one; else the running threads take the job later.
void JobThreads::addWorker()
{
    std::list<Worker> added;
    try {
        Worker &worker = added.emplace_back();
        worker.thread = std::thread([this, &worker] { work(worker); });
    } catch (const std::system_error &) { // no memory for its stack, or too many threads
        return;
    } catch (const std::bad_alloc &) {
        return;
    }
    m_workers.splice(m_workers.end(), added);
}

void JobThreads::work(Worker &worker)
{
    freeUpperLanes();
    std::unique_lock lock(m_mutex);
    while (!m_waiting.empty()) {
        {
            const Job job = std::move(m_waiting.front());
            m_waiting.pop_front();
            lock.unlock();
            job();
        } // destroys what the job held before the lock is taken
        lock.lock();
    }
    worker.hasEnded = true;
}

} // namespace dyncal
