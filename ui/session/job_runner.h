// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/free_memory.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "ui/session/job_threads.h"

#include <QElapsedTimer>
#include <QObject>

#include <chrono>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>

namespace dyncal {

/// Runs one background job at a time; the newest request wins. A new start asks the running job to
/// stop and drops its result; with two threads the new job does not wait until the old one has
/// stopped. Results arrive on the thread of `receiver` by a queued call, never after a newer start,
/// a cancel() or the runner's death. Jobs must capture values only. If memory runs out, in the job,
/// for its thread or for the delivery of its result, an error that says so arrives instead.
class JobRunner
{
public:
    explicit JobRunner(QObject *receiver, std::size_t threads = 1)
        : m_receiver(receiver)
        , m_threads(threads)
    {
    }
    ~JobRunner() { cancel(); }
    JobRunner(const JobRunner &) = delete;
    JobRunner &operator=(const JobRunner &) = delete;

    template <typename T>
    using Job = std::function<Result<T>(const JobControl &)>;

    /// `deliver` gets the job's result, or Error Internal when it threw. `progress` gets fractions
    /// at most ten times a second. Both are called on the receiver's thread.
    template <typename T>
    void start(Job<T> job, std::function<void(Result<T>)> deliver, ProgressSink progress = {})
    {
        cancel();
        m_stop = std::stop_source();
        m_running = true;
        ++m_number;
        m_age.start();
        const JobControl control{m_stop.get_token(), throttled(std::move(progress))};
        const auto result = std::make_shared<Outcome<T>>();
        const std::function<void()> end = [this, result, deliver = std::move(deliver)] {
            m_running = false;
            deliver(*result ? std::move(**result) : Result<T>(notEnoughMemory()));
        };
        if (!isMemoryLeft(kThreadBytes)
            || !m_threads.start([this, job = std::move(job), control, result, end] {
                   *result = outcomeOf<T>(job, control);
                   postSurely(control.stop, end, *result);
               }))
            post(m_receiver, control.stop, end);
    }

    void cancel()
    {
        m_stop.request_stop();
        m_running = false;
    }
    bool isRunning() const { return m_running; }
    quint64 number() const { return m_number; } ///< of the job started last, from 1
    qint64 age_ms() const { return m_running ? m_age.elapsed() : 0; }

    /// A call into the receiver's thread that is dropped once `stop` is requested: for results
    /// that a job hands over before it ends.
    static void post(QObject *receiver, std::stop_token stop, std::function<void()> call)
    {
        QMetaObject::invokeMethod(
            receiver,
            [stop = std::move(stop), call = std::move(call)] {
                if (!stop.stop_requested())
                    call();
            },
            Qt::QueuedConnection);
    }

private:
    static constexpr qint64 kProgressInterval_ms = 100;
    static constexpr std::size_t kThreadBytes = std::size_t(12) << 20U; ///< its stack, and some

    static tl::unexpected<Error> notEnoughMemory()
    {
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "There is not enough memory for this work; close other programs or choose a shorter window."),
                {}});
    }

    /// Empty where there was no memory for it.
    template <typename T>
    using Outcome = std::optional<Result<T>>;

    template <typename T>
    static Outcome<T> outcomeOf(const Job<T> &job, const JobControl &control)
    {
        try {
            return guarded<T>(job, control);
        } catch (const std::bad_alloc &) {
            return std::nullopt;
        }
    }

    template <typename T>
    static Result<T> guarded(const Job<T> &job, const JobControl &control)
    {
        try {
            if (control.stopRequested())
                return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
            return job(control);
        } catch (const std::bad_alloc &) {
            throw;
        } catch (const std::exception &problem) {
            return fail(ErrorKind::Internal,
                {DYNCAL_TEXT("core",
                     "The program met an unexpected condition (%1); please report it with your project file."),
                    {problem.what()}});
        }
    }

    /// Called on the job's thread. Without this call the receiver would wait for ever; so if memory
    /// is short, the result is given up to make room, and the call is tried until others have freed
    /// memory.
    template <typename T>
    void postSurely(const std::stop_token &stop, const std::function<void()> &end, T &outcome)
    {
        constexpr std::chrono::milliseconds kPause{20};
        while (!stop.stop_requested()) {
            try {
                post(m_receiver, stop, end);
                return;
            } catch (const std::bad_alloc &) {
                outcome.reset();
                std::this_thread::sleep_for(kPause);
            }
        }
    }

    ProgressSink throttled(ProgressSink progress)
    {
        if (!progress)
            return {};
        auto sinceLast = std::make_shared<QElapsedTimer>();
        QObject *receiver = m_receiver;
        const std::stop_token stop = m_stop.get_token();
        return [=, progress = std::move(progress)](double fraction) {
            if (sinceLast->isValid() && sinceLast->elapsed() < kProgressInterval_ms)
                return;
            sinceLast->start();
            post(receiver, stop, [progress, fraction] { progress(fraction); });
        };
    }

    QObject *m_receiver;
    std::stop_source m_stop;
    QElapsedTimer m_age;
    bool m_running = false;
    quint64 m_number = 0;
    JobThreads m_threads; ///< last: waits for its jobs before other members are destroyed
};

} // namespace dyncal
