// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/auto_save.h"

#include <QFile>

namespace dyncal {

AutoSave::AutoSave(
    Session &session, RecoveryStore &store, CurrentUtc currentUtc, const AutoSaveDelays &delays)
    : m_session(session)
    , m_store(store)
    , m_currentUtc(std::move(currentUtc))
{
    m_jobs.emplace(this);
    for (QTimer *timer : {&m_rest, &m_latest})
        timer->setSingleShot(true);
    m_latest.setTimerType(Qt::PreciseTimer); // a coarse one may be early by a twentieth
    m_rest.setInterval(delays.rest);
    m_latest.setInterval(delays.latest);
    m_beat.setInterval(delays.beat);
    connect(&m_rest, &QTimer::timeout, this, &AutoSave::write);
    connect(&m_latest, &QTimer::timeout, this, &AutoSave::write);
    connect(&m_beat, &QTimer::timeout, this, &AutoSave::beat);
    connect(&session, &Session::recipeChanged, this, &AutoSave::follow);
    connect(&session, &Session::capturesChanged, this, &AutoSave::follow);
    connect(&session.undoStack(), &QUndoStack::cleanChanged, this, &AutoSave::follow);
}

QDateTime AutoSave::now() const
{
    const QDateTime time = timeOf(m_currentUtc);
    return time.isValid() ? time : QDateTime::fromSecsSinceEpoch(0, Qt::UTC);
}

void AutoSave::setProject(const QString &path, const ProjectFileHash &sha256)
{
    if (path == m_project && sha256 == m_projectSha256)
        return;
    m_project = path;
    m_projectSha256 = sha256;
    follow();
}

void AutoSave::follow()
{
    if (!m_jobs)
        return;
    if (m_session.undoStack().isClean()) {
        drop();
        return;
    }
    m_rest.start();
    if (!m_latest.isActive())
        m_latest.start();
}

void AutoSave::write()
{
    m_rest.stop();
    m_latest.stop();
    if (!m_store.file()) {
        emit failed(m_store.file().error());
        return;
    }
    const QDateTime time = now();
    m_beat.start();
    m_jobs->start<void>(
        [file = *m_store.file(), state = m_session.state(), project = m_project, time,
            sha256 = m_projectSha256](
            const JobControl &) { return writeRecoveryFile(file, state, project, time, sha256); },
        [this, time](const Result<void> &written) {
            if (written) {
                emit saved(time);
                return;
            }
            m_latest.start(); // tries again: there may be room on the disk by then
            emit failed(written.error());
        });
}

void AutoSave::drop()
{
    m_rest.stop();
    m_latest.stop();
    emit nothingToSave();
    if (!m_beat.isActive())
        return;
    m_beat.stop();
    m_jobs->start<void>(
        [file = *m_store.file()](const JobControl &) -> Result<void> {
            QFile::remove(file);
            return {};
        },
        [](const Result<void> &) {});
}

void AutoSave::beat()
{
    if (m_jobs->isRunning())
        return;
    m_jobs->start<void>(
        [file = *m_store.file(), time = now()](const JobControl &) -> Result<void> {
            markAlive(file, time);
            return {};
        },
        [](const Result<void> &) {});
}

void AutoSave::adopt(const QString &file)
{
    m_jobs.emplace(this); // waits for what the old one still does
    m_store.adopt(file);
    m_beat.start();
}

void AutoSave::leave()
{
    const bool isBehind = m_rest.isActive() || m_latest.isActive();
    for (QTimer *timer : {&m_rest, &m_latest, &m_beat})
        timer->stop();
    m_jobs.reset(); // waits for what is being written
    if (isBehind && m_store.file())
        (void)writeRecoveryFile(
            *m_store.file(), m_session.state(), m_project, now(), m_projectSha256);
}

void AutoSave::end()
{
    if (!m_jobs)
        return;
    m_jobs.reset();
    for (QTimer *timer : {&m_rest, &m_latest, &m_beat})
        timer->stop();
    if (m_store.file())
        QFile::remove(*m_store.file());
}

} // namespace dyncal
