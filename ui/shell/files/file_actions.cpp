// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/file_actions.h"

#include "core/base/writing/write_problem.h"
#include "core/certificate/certificate.h"
#include "ui/session/example.h"
#include "ui/session/kept_results.h"
#include "ui/shell/files/capture_filter.h"
#include "ui/shell/files/kept_results_view.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QDir>
#include <QFileInfo>
#include <QWidget>

namespace dyncal {

namespace {

constexpr const char *kProjectSuffix = "dyncal";

bool isProject(const QString &path)
{
    return QFileInfo(path).suffix() == kProjectSuffix;
}

QString projectFilter()
{
    return FileActions::tr("Dyncal projects (*.%1)").arg(kProjectSuffix);
}

} // namespace

FileActions::FileActions(Session &session, CurrentUtc currentUtc, Prompts &prompts,
    Preferences &preferences, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_currentUtc(std::move(currentUtc))
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_window(window)
    , m_holds(m_currentUtc, this)
    , m_jobs(this)
    , m_captures(session, preferences, window)
    , m_exports(session, m_currentUtc, prompts, preferences, window)
    , m_plotExports(session, prompts, preferences, window)
{
    connect(&m_captures, &CaptureImport::busy, this, &FileActions::busy);
    connect(&m_captures, &CaptureImport::progress, this, &FileActions::progress);
    connect(&m_captures, &CaptureImport::idle, this, &FileActions::idle);
    connect(&m_captures, &CaptureImport::newJob, this,
        [this](const ProjectState &state) { startJob(state, {}); });
    connect(&m_exports, &ExportActions::busy, this, &FileActions::busy);
    connect(&m_exports, &ExportActions::progress, this, &FileActions::progress);
    connect(&m_exports, &ExportActions::idle, this, &FileActions::idle);
    connect(&m_exports, &ExportActions::failed, this, &FileActions::showProblem);
    connect(&m_plotExports, &PlotExportActions::idle, this, &FileActions::idle);
    connect(&m_plotExports, &PlotExportActions::failed, this, &FileActions::showProblem);
    connect(&session.undoStack(), &QUndoStack::cleanChanged, this, &FileActions::projectChanged);
}

QString FileActions::projectName() const
{
    if (!m_path.isEmpty())
        return QFileInfo(m_path).completeBaseName();
    return m_session.state().hasShots() ? tr("Untitled") : QString();
}

bool FileActions::isModified() const
{
    return !m_session.undoStack().isClean();
}

bool FileActions::mayDiscard()
{
    if (!isModified())
        return true;
    switch (m_prompts.saveChanges(m_window, projectName())) {
    case Answer::Save:
        return save();
    case Answer::Discard:
        return true;
    case Answer::Cancel:
        break;
    }
    return false;
}

QStringList FileActions::askForCaptures()
{
    const QStringList paths = m_prompts.openFiles(
        m_window, tr("Open captures"), captureFilter(), m_preferences.lastFolder());
    if (!paths.isEmpty())
        m_preferences.setLastFolder(QFileInfo(paths.first()).absolutePath());
    return paths;
}

void FileActions::openCaptures()
{
    const QStringList paths = askForCaptures();
    if (!paths.isEmpty() && mayDiscard())
        readRecordings(paths, false);
}

void FileActions::addCaptures()
{
    const QStringList paths = askForCaptures();
    if (!paths.isEmpty())
        readRecordings(paths, m_session.state().hasShots());
}

void FileActions::openPaths(const QStringList &paths)
{
    if (paths.isEmpty())
        return;
    if (isProject(paths.first())) {
        if (mayDiscard())
            openProjectFile(paths.first());
        return;
    }
    readRecordings(paths, m_session.state().hasShots());
}

void FileActions::openDropped(const QList<QUrl> &places)
{
    QStringList paths;
    for (const QUrl &place : places)
        if (place.isLocalFile())
            paths << place.toLocalFile();
    openPaths(paths);
}

void FileActions::readRecordings(const QStringList &paths, bool add)
{
    if (!m_exports.refuses())
        m_captures.read(paths, add);
}

void FileActions::startJob(const ProjectState &state, const QString &path,
    const ProjectFileHash &onDisk, const ProjectAccess &access, const std::optional<Finding> &older)
{
    m_path = path;
    m_onDisk = onDisk;
    m_holds.keep(access);
    m_older = older;
    emit jobStarted();
    m_session.reset(state);
    emit projectChanged();
}

void FileActions::openExample()
{
    if (m_exports.refuses() || !mayDiscard())
        return;
    emit busy(tr("Making the example"));
    m_jobs.start<CaptureSet>(
        [duration = m_exampleDuration_s](
            const JobControl &control) { return exampleCaptures(control, duration); },
        [this](Result<CaptureSet> set) {
            if (!set) {
                showProblem(set.error());
                return;
            }
            emit idle(tr("The example is open"));
            startJob({std::make_shared<const CaptureSet>(std::move(*set)), {}}, {});
        },
        [this](double done) { emit progress(done); });
}

void FileActions::openAgain()
{
    const QString path = m_path; // saving may choose another
    if (!path.isEmpty() && mayDiscard())
        openProjectFile(path);
}

void FileActions::openProject()
{
    if (!mayDiscard())
        return;
    const QString path = m_prompts.openFile(
        m_window, tr("Open project"), projectFilter(), m_preferences.lastFolder());
    if (!path.isEmpty())
        openProjectFile(path);
}

void FileActions::useProfile()
{
    if (!m_session.state().hasShots()) {
        m_prompts.showProblem(m_window,
            tr("There is no calibration that a profile could be used for; open recordings or a project first."));
        return;
    }
    const QString path = m_prompts.openFile(m_window, tr("Use profile of the laboratory"),
        tr("Profiles (*.json)"), m_preferences.lastFolder());
    if (path.isEmpty())
        return;
    const Result<Recipe> joined = withProfile(m_session.recipe(), path.toStdString());
    if (!joined) {
        showProblem(joined.error());
        return;
    }
    m_session.apply(*joined, tr("Use profile of the laboratory"));
    if (joined->profile)
        emit idle(tr("Profile in use: %1, version %2")
                      .arg(shownText(joined->profile->name), shownText(joined->profile->version)));
}

void FileActions::openProjectFile(const QString &path, const QStringList &otherFolders)
{
    if (m_exports.refuses())
        return;
    emit busy(tr("Opening project"));
    m_jobs.start<OpenedProject>(
        [path, otherFolders, request = m_holds.request()](const JobControl &control) {
            return openedProject(path, otherFolders, request, control);
        },
        [this, path, otherFolders](Result<OpenedProject> opened) {
            if (!opened) {
                locateOrShow(opened.error(), path, otherFolders);
                return;
            }
            m_preferences.setLastFolder(QFileInfo(path).absolutePath());
            m_preferences.addRecentFile(path);
            emit idle(tr("Project opened"));
            startJob(opened->state, path, opened->sha256, opened->access, opened->older);
            if (!otherFolders.isEmpty()) // where they were found is worth a save
                m_session.undoStack().resetClean();
        },
        [this](double done) { emit progress(done); });
}

/// Recordings that were moved are looked for in one folder after the other, as long as the operator
/// names one.
void FileActions::locateOrShow(
    const Error &error, const QString &path, const QStringList &otherFolders)
{
    if (error.findingId != kMissingRecordings) {
        showProblem(error);
        return;
    }
    emit idle({});
    const Result<ProjectFile> file = readProjectFile(path);
    const auto kept = file ? keptResults(file->content) : std::nullopt;
    const auto answer
        = m_prompts.missingRecordings(m_window, translated(error.message), kept.has_value());
    if (answer == MissingRecordings::ViewResults && kept)
        (new KeptResultsView(*kept, QFileInfo(path).completeBaseName(), m_window))->show();
    if (answer != MissingRecordings::Locate)
        return;
    const QString folder = m_prompts.folder(
        m_window, tr("Folder of the recordings"), QFileInfo(path).absolutePath());
    if (!folder.isEmpty())
        openProjectFile(path, otherFolders + QStringList(folder));
}

void FileActions::restoreWork(const RecoveredWork &work, const QString &recordings)
{
    if (m_exports.refuses() || !mayDiscard())
        return;
    m_captures.cancel(); // recordings that arrive later would take the place of the work
    emit busy(tr("Restoring work"));
    m_jobs.start<ProjectState>(
        [file = work.file, recordings](const JobControl &control) {
            return dyncal::openProject(
                file, control, recordings.isEmpty() ? QStringList() : QStringList(recordings));
        },
        [this, work](Result<ProjectState> state) {
            emit idle(state ? tr("Work restored; it is not saved yet") : QString());
            if (!state) {
                emit restoreFailed(work.file, state.error());
                return;
            }
            startJob(*state, work.project, work.projectSha256,
                work.project.isEmpty() ? ProjectAccess()
                                       : accessTo(work.project, m_holds.request()));
            m_session.undoStack().resetClean();
            emit workRestored(work.file);
        },
        [this](double done) { emit progress(done); });
}

void FileActions::openSensor(const std::string &planFolder, const PlannedSensor &sensor)
{
    if (m_exports.refuses() || !mayDiscard())
        return;
    m_captures.cancel(); // recordings that arrive later would be added to the sensor's
    emit busy(tr("Opening the sensor"));
    m_jobs.start<OpenedSensor>(
        [planFolder, sensor](
            const JobControl &control) { return dyncal::openSensor(planFolder, sensor, control); },
        [this](const Result<OpenedSensor> &opened) {
            if (!opened) {
                showProblem(opened.error());
                return;
            }
            emit idle(tr("The sensor is open"));
            if (opened->state.hasShots())
                startJob(opened->state, {});
            emit m_captures.problemsChanged(opened->paths, opened->problems);
        },
        [this](double done) { emit progress(done); });
}

bool FileActions::save()
{
    if (readOnlyReason()) { // it may have been closed there
        m_holds.keep(accessTo(m_path, m_holds.request()));
        emit projectChanged();
    }
    return m_path.isEmpty() || readOnlyReason() ? saveAs() : saveTo(m_path, m_onDisk);
}

bool FileActions::saveAs()
{
    const QString path = m_prompts.saveFile(m_window, tr("Save project"), projectFilter(),
        proposedPath(projectName() + "." + kProjectSuffix), kProjectSuffix);
    if (path.isEmpty() || m_exports.refusesRecording(path))
        return false;
    // The dialog asked about the file that is there now; of its own project the window knows the
    // hash.
    const bool isOwn = QFileInfo(path) == QFileInfo(m_path);
    return saveTo(path, isOwn ? m_onDisk : projectFileHash(path));
}

/// Only what belongs to the recipe that is saved.
QJsonObject FileActions::resultsToKeep() const
{
    const Result<std::string> now = m_currentUtc();
    if (!now || !m_session.isUpToDate() || !m_session.results().model)
        return {};
    const CertificateData certificate
        = makeCertificate(m_session.results(), m_session.recipe(), *now);
    return {{kKeptResults, keptResultsJson(certificate, *now)}};
}

/// Another file than expected is replaced only if the operator says so, and only that one.
bool FileActions::saveTo(const QString &path, const ProjectFileHash &expected)
{
    if (!m_session.isSealed()) {
        m_prompts.showProblem(m_window,
            tr("The recordings are still being read for their hashes, which the project keeps; try again in a moment."));
        return false;
    }
    const ProjectAccess access = accessToSave(path, m_holds.request());
    if (access.readOnly) {
        m_prompts.showProblem(m_window, translated(*access.readOnly));
        return false;
    }
    const QJsonObject kept = resultsToKeep();
    Result<std::string> saved = saveProject(path, m_session.state(), expected, kept);
    while (!saved && saved.error().findingId == kChangedMeanwhile) {
        const ProjectFileHash now = projectFileHash(path);
        const ChangedProject answer = m_prompts.changedProject(m_window, path, now.has_value());
        if (answer == ChangedProject::Cancel)
            return false;
        if (answer == ChangedProject::OtherName)
            return saveAs();
        saved = saveProject(path, m_session.state(), now, kept);
    }
    if (!saved) {
        showProblem(saved.error());
        return false;
    }
    m_path = path;
    m_onDisk = *saved;
    m_holds.keep(access);
    m_older.reset();
    m_preferences.setLastFolder(QFileInfo(path).absolutePath());
    m_preferences.addRecentFile(path);
    m_session.undoStack().setClean();
    emit projectChanged();
    emit idle(tr("Project saved"));
    return true;
}

bool FileActions::mayQuit()
{
    return !m_exports.refuses() && mayDiscard();
}

void FileActions::exportResults()
{
    m_exports.exportResults();
}

void FileActions::exportCertificate()
{
    m_exports.exportCertificate(proposedPath("certificate.pdf"));
}

void FileActions::exportModel()
{
    m_exports.exportModel();
}

void FileActions::cancel()
{
    m_jobs.cancel();
    m_captures.cancel();
    m_exports.cancel();
    emit idle(tr("Cancelled"));
}

void FileActions::stopForMemory()
{
    cancel();
    m_session.cancelComputation();
    showProblem({ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "The memory is used up, so the work in hand was stopped; save your work, close other programs or choose a shorter window."),
            {}},
        {}, 0});
}

void FileActions::showProblem(const Error &error)
{
    emit idle({});
    if (error.kind != ErrorKind::Cancelled)
        m_prompts.showProblem(m_window, translated(error.message));
}

/// Beside the project, or beside the recordings while it has no file.
QString FileActions::proposedPath(const QString &fileName) const
{
    QFileInfo beside(m_path);
    for (const InputFile &input : m_session.state().captures->inputs)
        beside = beside.isFile() ? beside : QFileInfo(rawText(input.path));
    return QDir(beside.isFile() ? beside.absolutePath() : m_preferences.lastFolder())
        .filePath(fileName);
}

} // namespace dyncal
