// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/capture_reading.h"
#include "ui/session/job_runner.h"
#include "ui/session/session.h"

#include <QObject>

class QWidget;

namespace dyncal {

class ImportDialog;
class Preferences;

/// Brings recordings into the job: reads them in the background, asks what only the operator knows
/// (the answer may hold for all files), takes what can be read and lists the rest. One import
/// section holds for all files of a job, so if it changes, earlier files may have to be read again.
class CaptureImport : public QObject
{
    Q_OBJECT

public:
    CaptureImport(Session &session, Preferences &preferences, QWidget *window);

    /// Reads files or folders into the job (`add`) or into a new one.
    void read(const QStringList &paths, bool add);
    /// Changes the import section as one undo step.
    void change(const ImportSettings &next, const QString &step);
    /// Reads the files of the job once more, as one undo step: they were changed, or moved to
    /// `folder` (empty: nowhere else).
    void rereadJob(const QString &folder);
    /// Shows how one file is read. Changes apply to the job if the file is part of it; else the
    /// file is read with them.
    void edit(const QString &path);

    bool isRunning() const { return m_jobs.isRunning(); }
    void cancel() { m_jobs.cancel(); }

signals:
    void busy(const QString &what);
    void progress(double fraction);
    void idle(const QString &outcome);
    void newJob(const dyncal::ProjectState &state);
    void problemsChanged(
        const std::vector<std::string> &tried, const std::vector<dyncal::FileProblem> &problems);

private:
    struct Request
    {
        QStringList paths;
        bool add = false;
        ImportSettings settings;
        bool mayAsk = true;
        QString step;
        QString asked{}; ///< the file of the last question, to ask only once
        bool again = false; ///< the files of the job, too
        QString folder{}; ///< where those are that are not where they were
    };
    struct Outcome;

    void start(const Request &request);
    void deliver(const Request &request, const std::shared_ptr<const Outcome> &outcome);
    void ask(
        const QString &path, const Request &request, const std::shared_ptr<const Outcome> &outcome);
    void take(const Request &request, const Outcome &outcome);
    void addToJob(const Request &request, const Outcome &outcome);
    ImportDialog *openDialog(const QString &path, const ImportSettings &settings, int files);

    Session &m_session;
    Preferences &m_preferences;
    QWidget *m_window;
    JobRunner m_jobs;
};

} // namespace dyncal
