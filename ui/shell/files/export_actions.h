// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/shell/files/export_job.h"

namespace dyncal {

class Preferences;
class Prompts;
class Session;

/// Writes results, certificate and model where the operator says: only what belongs to the settings
/// on the screen, and only while the recordings are the files that were opened.
class ExportActions : public QObject
{
    Q_OBJECT

public:
    ExportActions(Session &session, CurrentUtc currentUtc, Prompts &prompts,
        Preferences &preferences, QWidget *window);

    void exportResults();
    void exportCertificate(const QString &proposed); ///< path that the dialog offers
    void exportModel();

    /// Why no results may leave the program now: they are not there, not those of the settings on
    /// the screen, or the recordings are not the files that were opened. Empty: they may.
    static std::optional<Message> whyNoResults(const Session &session);

    bool isRunning() const { return m_job.isRunning(); }
    bool refuses(); ///< true, with a message, while something is being written
    bool refusesRecording(const QString &path); ///< with a message, even after a dialog asked
    void cancel() { m_job.cancel(); }

signals:
    void busy(const QString &what);
    void progress(double fraction);
    void idle(const QString &outcome);
    void failed(const dyncal::Error &error);

private:
    bool hasResults();
    bool isBlocked();
    PipelineOutcome outcome() const;
    void startExport(const QString &target, ReportParts parts, const ExportJob::Write &write);

    Session &m_session;
    CurrentUtc m_currentUtc;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QWidget *m_window;
    QString m_target; ///< as named in the message when it is written
    ExportJob m_job;
};

} // namespace dyncal
