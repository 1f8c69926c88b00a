// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/session/project_file.h"
#include "ui/session/recovery_store.h"
#include "ui/session/sensor_opening.h"
#include "ui/session/session.h"
#include "ui/shell/files/export_actions.h"
#include "ui/shell/files/hold_keeper.h"
#include "ui/shell/files/plot_export_actions.h"
#include "ui/shell/import/capture_import.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"

#include <QObject>
#include <QPointer>

namespace dyncal {

/// Opening, saving and exporting: what the File menu does. Reading and writing of data runs in the
/// background; a failure leaves the job as it was and shows one message.
class FileActions : public QObject
{
    Q_OBJECT

public:
    FileActions(Session &session, CurrentUtc currentUtc, Prompts &prompts, Preferences &preferences,
        QWidget *window);

    void openCaptures(); ///< asks for files, starts a new job
    void addCaptures(); ///< asks for files, adds their shots to the job
    void openExample();
    void openProject();
    /// Recordings that are not where they were are looked for in `otherFolders`, by name.
    void openProjectFile(const QString &path, const QStringList &otherFolders = {});
    /// Files or folders from a drop or the command line: a project is opened; recordings start a
    /// job or are added to the one that is open.
    void openPaths(const QStringList &paths);
    void openDropped(const QList<QUrl> &places); ///< those of files
    /// Opens what a stopped program left behind, as unsaved changes of its project; recordings that
    /// are not where they were are looked for in the folder `recordings`. Emits workRestored or
    /// restoreFailed; neither if the operator keeps what is open.
    void restoreWork(const RecoveredWork &work, const QString &recordings = {});
    /// Opens a sensor of a batch as a new job: its recordings with its recipe (openSensor()).
    void openSensor(const std::string &planFolder, const PlannedSensor &sensor);
    /// The project once more, as it is on the disk now.
    void openAgain();
    void useProfile(); ///< asks for a laboratory's profile and puts it over the recipe
    bool save();
    bool saveAs();
    void exportResults();
    void exportCertificate();
    void exportModel(); ///< MAT, JSON, CSV, MATLAB and Python scripts into a folder

    void exportPlot(const PlotWidget *plot) { m_plotExports.exportPlot(*plot); }
    void exportPlots(const std::vector<StagePage *> &pages) { m_plotExports.exportAll(pages); }

    /// Reading of recordings, its questions and its problems.
    CaptureImport &captures() { return m_captures; }

    /// False when the operator wants to keep working on unsaved changes.
    bool mayDiscard();
    bool isModified() const;
    bool isBusy() const
    {
        return m_jobs.isRunning() || m_captures.isRunning() || m_exports.isRunning();
    }
    /// False, with a message, while results are being written: quitting would leave half of them.
    bool mayQuit();
    void cancel();
    void stopForMemory(); ///< cancels everything, and says why

    QString projectName() const;
    QString projectPath() const { return m_path; } ///< empty = never saved
    const ProjectFileHash &projectHash() const { return m_onDisk; }
    /// From now on others are told that a project is open here, by this account on this machine.
    /// Without this call nobody is.
    void holdProjectsAs(const std::string &name, const std::string &machine)
    {
        m_holds.holdAs(name, machine);
    }
    /// Why the project cannot be saved where it lies, if so.
    const std::optional<Message> &readOnlyReason() const { return m_holds.access().readOnly; }
    /// What is to be known before a project of an older version is saved.
    const std::optional<Finding> &olderProject() const { return m_older; }

    /// Length of the built-in example; tests shorten it.
    void setExampleDuration(double seconds) { m_exampleDuration_s = seconds; }

signals:
    void busy(const QString &what);
    void progress(double fraction);
    void idle(const QString &outcome);
    void jobStarted(); ///< another one than before; projectChanged() follows
    void projectChanged(); ///< name, modified state, or whether it may be saved
    void workRestored(const QString &file);
    void restoreFailed(const QString &file, const dyncal::Error &error);

private:
    QStringList askForCaptures();
    void readRecordings(const QStringList &paths, bool add);
    void startJob(const ProjectState &state, const QString &path,
        const ProjectFileHash &onDisk = {}, const ProjectAccess &access = {},
        const std::optional<Finding> &older = {});
    void locateOrShow(const Error &error, const QString &path, const QStringList &otherFolders);
    QJsonObject resultsToKeep() const;
    bool saveTo(const QString &path, const ProjectFileHash &expected);
    void showProblem(const Error &error);
    QString proposedPath(const QString &fileName) const;

    Session &m_session;
    CurrentUtc m_currentUtc;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QWidget *m_window;
    QString m_path; ///< of the project; empty = never saved
    ProjectFileHash m_onDisk; ///< the project's file as it was read or saved last
    HoldKeeper m_holds;
    std::optional<Finding> m_older;
    double m_exampleDuration_s = 0.02;
    JobRunner m_jobs;
    CaptureImport m_captures;
    ExportActions m_exports;
    PlotExportActions m_plotExports;
};

} // namespace dyncal
