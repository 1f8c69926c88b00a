// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/source_watch.h"

namespace dyncal {

namespace {

constexpr int kPause_ms = 1000;

} // namespace

SourceWatch::SourceWatch(QObject *receiver, std::function<void()> changed)
    : m_changed(std::move(changed))
    , m_jobs(receiver)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    QObject::connect(&m_pause, &QTimer::timeout, &m_pause, [this] { look(); });
}

void SourceWatch::watch(const Captures &captures)
{
    if (captures == m_captures)
        return;
    m_captures = captures;
    m_jobs.cancel();
    if (captures->inputs.empty())
        m_pause.stop();
    else
        m_pause.start();
    take(captures, Changes());
}

void SourceWatch::look()
{
    m_jobs.start<Changes>(
        [captures = m_captures](
            const JobControl &) -> Result<Changes> { return changedSources(*captures); },
        [this, captures = m_captures](const Result<Changes> &found) {
            m_pause.start();
            take(captures, found);
        });
}

/// Without memory to look there is nothing new to say; the next look says it.
void SourceWatch::take(const Captures &captures, const Result<Changes> &found)
{
    if (!found || captures != m_captures || *found == m_changes)
        return;
    m_changes = *found;
    m_changed();
}

} // namespace dyncal
