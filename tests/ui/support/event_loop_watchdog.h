// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>

namespace dyncal::test {

/// Measures how long the event loop was kept from its timers while one of these lives.
class EventLoopWatchdog
{
public:
    EventLoopWatchdog()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { tick(); });
        m_sinceLast.start();
        m_timer.start(kInterval_ms);
    }

    /// The longest time between two beats, up to now.
    qint64 longestGap_ms()
    {
        tick();
        return m_longest_ms;
    }

private:
    static constexpr int kInterval_ms = 10;

    void tick() { m_longest_ms = std::max(m_longest_ms, m_sinceLast.restart()); }

    QTimer m_timer;
    QElapsedTimer m_sinceLast;
    qint64 m_longest_ms = 0;
};

} // namespace dyncal::test
