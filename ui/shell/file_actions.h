// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/shell/preferences.h"
#include "ui/shell/prompts.h"

#include <QObject>
#include <QPointer>

namespace dyncal {

/// What the program gives the window for writing results: the same that the command line uses.
struct Outputs
{
    std::function<Result<std::string>()> currentUtc; ///< ISO 8601 with Z
    /// Writes results, recipe, certificate, plots and tables into an existing folder.
    std::function<Result<std::vector<std::string>>(const PipelineOutcome &, const Recipe &,
        const std::string &createdUtc, const std::string &folder)>
        writeRun;
};

/// Opening, saving and exporting: what the File menu does. Reading and writing of data runs in the
/// background; a failure leaves the job as it was and shows one message.
class FileActions : public QObject
{
    Q_OBJECT

public:
    FileActions(Session &session, Outputs outputs, Prompts &prompts, Preferences &preferences,
        QWidget *window);

    void openCaptures(); ///< asks for files, starts a new job
    void addCaptures(); ///< asks for files, adds their shots to the job
    void openExample();
    void openProject();
    void openProjectFile(const QString &path);
    /// Files or folders from a drop or the command line: a project is opened; recordings start a
    /// job or are added to the one that is open.
    void openPaths(const QStringList &paths);
    bool save();
    bool saveAs();
    void exportResults();
    void exportCertificate();

    /// False when the operator wants to keep working on unsaved changes.
    bool mayDiscard();
    bool isModified() const;
    bool isBusy() const { return m_jobs.isRunning(); }
    void cancel();

    QString projectName() const;

    /// Length of the built-in example; tests shorten it.
    void setExampleDuration(double seconds) { m_exampleDuration_s = seconds; }

signals:
    void busy(const QString &what);
    void progress(double fraction);
    void idle(const QString &outcome);
    void projectChanged(); ///< name or modified state

private:
    QStringList askForCaptures();
    void readRecordings(const QStringList &paths, bool add);
    void takeRecordings(const CaptureSet &set, bool add);
    void startJob(const ProjectState &state, const QString &path);
    bool saveTo(const QString &path);
    Result<void> writeResults(const QString &folder);
    Result<void> writeCertificate(const QString &path);
    bool hasResults();
    void sayBusy(const QString &work);
    void showProblem(const Error &error);
    QString proposedPath(const QString &fileName) const;

    Session &m_session;
    Outputs m_outputs;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QWidget *m_window;
    QString m_path; ///< of the project; empty = never saved
    double m_exampleDuration_s = 0.02;
    JobRunner m_jobs;
};

} // namespace dyncal
