// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/free_memory.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>

#include <functional>
#include <memory>
#include <stop_token>

namespace dyncal {

/// Runs one background job at a time; the newest request wins. A new start asks the running job to
/// stop and drops its result; with two threads the new one does not wait until the old one obeys.
/// Results arrive on the thread of `receiver` by a queued call, never after a newer start, a
/// cancel() or the runner's death. Jobs must capture values only.
///
/// No QFuture is kept: in Qt 6.4 QFuture::takeResult resets the shared state and a second copy's
/// waitForFinished() then never returns.
class JobRunner
{
public:
    explicit JobRunner(QObject *receiver, int threads = 1)
        : m_receiver(receiver)
    {
        m_pool.setMaxThreadCount(threads);
    }
    ~JobRunner()
    {
        cancel();
        m_pool.waitForDone();
    }
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
        if (!isMemoryLeft(kThreadBytes)) { // Qt would keep silent about a thread that never runs
            post(control.stop, [this, deliver] {
                m_running = false;
                deliver(notEnoughMemory());
            });
            return;
        }
        m_pool.start([this, job = std::move(job), deliver = std::move(deliver), control] {
            auto result = std::make_shared<Result<T>>(guarded<T>(job, control));
            post(control.stop, [this, result, deliver] {
                m_running = false;
                deliver(std::move(*result));
            });
        });
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

    void post(std::stop_token stop, std::function<void()> call)
    {
        post(m_receiver, std::move(stop), std::move(call));
    }

    template <typename T>
    static Result<T> guarded(const Job<T> &job, const JobControl &control)
    {
        try {
            if (control.stopRequested())
                return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
            return job(control);
        } catch (const std::bad_alloc &) {
            return notEnoughMemory();
        } catch (const std::exception &problem) {
            return fail(ErrorKind::Internal,
                {DYNCAL_TEXT("core",
                     "The program met an unexpected condition (%1); please report it with your project file."),
                    {problem.what()}});
        }
    }

    ProgressSink throttled(const ProgressSink &progress)
    {
        if (!progress)
            return {};
        auto sinceLast = std::make_shared<QElapsedTimer>();
        QObject *receiver = m_receiver;
        const std::stop_token stop = m_stop.get_token();
        return [=](double fraction) {
            if (sinceLast->isValid() && sinceLast->elapsed() < kProgressInterval_ms)
                return;
            sinceLast->start();
            post(receiver, stop, [progress, fraction] { progress(fraction); });
        };
    }

    QObject *m_receiver;
    QThreadPool m_pool;
    std::stop_source m_stop;
    QElapsedTimer m_age;
    bool m_running = false;
    quint64 m_number = 0;
};

} // namespace dyncal
