// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>

#include <time.h>

namespace dyncal::test {

/// Measures how long the event loop was kept from its timers while one of these lives, and how much
/// of that was work of this thread: the rest is other programs', or waiting.
class EventLoopWatchdog
{
public:
    EventLoopWatchdog()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { tick(); });
        m_sinceLast.start();
        m_cpu_ns = cpu_ns();
        m_timer.start(kInterval_ms);
    }

    /// The longest time between two beats, up to now.
    qint64 longestGap_ms()
    {
        tick();
        return m_longest_ms;
    }

    /// The most processor time that this thread took between two beats, up to now.
    qint64 longestWork_ms()
    {
        tick();
        return m_longestWork_ns / 1'000'000;
    }

private:
    static constexpr int kInterval_ms = 10;

    static qint64 cpu_ns()
    {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return qint64(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
    }

    void tick()
    {
        m_longest_ms = std::max(m_longest_ms, m_sinceLast.restart());
        const qint64 now_ns = cpu_ns();
        m_longestWork_ns = std::max(m_longestWork_ns, now_ns - m_cpu_ns);
        m_cpu_ns = now_ns;
    }

    QTimer m_timer;
    QElapsedTimer m_sinceLast;
    qint64 m_longest_ms = 0;
    qint64 m_cpu_ns = 0;
    qint64 m_longestWork_ns = 0;
};

} // namespace dyncal::test
