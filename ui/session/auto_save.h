// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/session/job_runner.h"
#include "ui/session/recovery_store.h"
#include "ui/session/session.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <optional>

namespace dyncal {

/// When unsaved changes are written to disk; tests shorten the times.
struct AutoSaveDelays
{
    std::chrono::milliseconds rest{2000}; ///< after the last change
    std::chrono::milliseconds latest{30000}; ///< after the first change not written yet
    std::chrono::milliseconds beat{2000}; ///< between signs of life
};

/// Keeps the unsaved changes of a session in the recovery file, written in the background. As soon
/// as there are none (saved, undone, another job) the file is removed.
class AutoSave : public QObject
{
    Q_OBJECT

public:
    AutoSave(Session &session, RecoveryStore &store, CurrentUtc currentUtc,
        const AutoSaveDelays &delays = {});

    /// The project that the session is changing; empty = never saved.
    void setProject(const QString &path, const ProjectFileHash &sha256 = {});
    /// Continues with a file left behind, after its work was restored into the session.
    void adopt(const QString &file);
    /// Waits for what is being written and removes the file: the program ends in good order.
    void end();
    /// The program must end now: what is not in the file yet is written, and the file stays.
    void leave();

signals:
    void saved(const QDateTime &utc);
    void failed(const dyncal::Error &error); ///< again with every attempt
    void nothingToSave(); ///< all changes are saved, or gone

private:
    void follow();
    void write();
    void drop();
    void beat();
    QDateTime now() const;

    Session &m_session;
    RecoveryStore &m_store;
    CurrentUtc m_currentUtc;
    QString m_project;
    ProjectFileHash m_projectSha256; ///< of the project's file before the changes
    QTimer m_rest;
    QTimer m_latest;
    QTimer m_beat; ///< active while there is a file
    std::optional<JobRunner> m_jobs; ///< one thread: writing and removing keep their order
};

} // namespace dyncal
