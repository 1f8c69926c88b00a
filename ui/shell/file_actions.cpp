// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/file_actions.h"

#include "core/base/atomic_file.h"
#include "core/capture/format_registry.h"
#include "core/pipeline/model_export.h"
#include "ui/session/example.h"
#include "ui/session/project_file.h"
#include "ui/text/core_text.h"

#include <QDir>
#include <QFileInfo>

namespace dyncal {

namespace {

constexpr const char *kProjectSuffix = "dyncal";

bool isProject(const QString &path)
{
    return QFileInfo(path).suffix() == kProjectSuffix;
}

QString captureFilter()
{
    QStringList patterns;
    for (const CaptureFormat &format : captureFormats())
        for (const std::string &extension : format.extensions)
            patterns << "*." + QString::fromStdString(extension);
    patterns.removeDuplicates();
    return FileActions::tr("Recordings (%1)").arg(patterns.join(' ')) + ";;"
        + FileActions::tr("All files (*)");
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
    , m_jobs(this)
    , m_captures(session, preferences, window)
    , m_export(this)
{
    connect(&m_captures, &CaptureImport::busy, this, &FileActions::busy);
    connect(&m_captures, &CaptureImport::progress, this, &FileActions::progress);
    connect(&m_captures, &CaptureImport::idle, this, &FileActions::idle);
    connect(&m_captures, &CaptureImport::newJob, this,
        [this](const ProjectState &state) { startJob(state, {}); });
    connect(&m_export, &ExportJob::progress, this, &FileActions::progress);
    connect(&m_export, &ExportJob::failed, this, &FileActions::showProblem);
    connect(&m_export, &ExportJob::finished, this,
        [this] { emit idle(tr("Written: %1").arg(m_exportTarget)); });
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

void FileActions::readRecordings(const QStringList &paths, bool add)
{
    if (!isExporting())
        m_captures.read(paths, add);
}

void FileActions::startJob(const ProjectState &state, const QString &path)
{
    m_path = path;
    m_session.reset(state);
    emit projectChanged();
}

void FileActions::openExample()
{
    if (isExporting() || !mayDiscard())
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

void FileActions::openProject()
{
    if (!mayDiscard())
        return;
    const QString path = m_prompts.openFile(
        m_window, tr("Open project"), projectFilter(), m_preferences.lastFolder());
    if (!path.isEmpty())
        openProjectFile(path);
}

void FileActions::openProjectFile(const QString &path)
{
    if (isExporting())
        return;
    emit busy(tr("Opening project"));
    m_jobs.start<ProjectState>(
        [path](const JobControl &control) { return dyncal::openProject(path, control); },
        [this, path](Result<ProjectState> state) {
            if (!state) {
                showProblem(state.error());
                return;
            }
            m_preferences.setLastFolder(QFileInfo(path).absolutePath());
            m_preferences.addRecentFile(path);
            emit idle(tr("Project opened"));
            startJob(*state, path);
        },
        [this](double done) { emit progress(done); });
}

void FileActions::restoreWork(const RecoveredWork &work, const QString &recordings)
{
    if (isExporting() || !mayDiscard())
        return;
    m_captures.cancel(); // recordings that arrive later would take the place of the work
    emit busy(tr("Restoring work"));
    m_jobs.start<ProjectState>(
        [file = work.file, recordings](
            const JobControl &control) { return dyncal::openProject(file, control, recordings); },
        [this, work](Result<ProjectState> state) {
            emit idle(state ? tr("Work restored; it is not saved yet") : QString());
            if (!state) {
                emit restoreFailed(work.file, state.error());
                return;
            }
            startJob(*state, work.project);
            m_session.undoStack().resetClean();
            emit workRestored(work.file);
        },
        [this](double done) { emit progress(done); });
}

bool FileActions::save()
{
    return m_path.isEmpty() ? saveAs() : saveTo(m_path);
}

bool FileActions::saveAs()
{
    const QString path = m_prompts.saveFile(m_window, tr("Save project"), projectFilter(),
        proposedPath(projectName() + "." + kProjectSuffix), kProjectSuffix);
    return !path.isEmpty() && saveTo(path);
}

bool FileActions::saveTo(const QString &path)
{
    if (!m_session.isSealed()) {
        m_prompts.showProblem(m_window,
            tr("The recordings are still being read for their hashes, which the project keeps; "
               "try again in a moment."));
        return false;
    }
    const Result<void> saved = saveProject(path, m_session.state());
    if (!saved) {
        showProblem(saved.error());
        return false;
    }
    m_path = path;
    m_preferences.setLastFolder(QFileInfo(path).absolutePath());
    m_preferences.addRecentFile(path);
    m_session.undoStack().setClean();
    emit projectChanged();
    emit idle(tr("Project saved"));
    return true;
}

/// Only results that belong to the settings on the screen are written.
bool FileActions::hasResults()
{
    QString problem;
    if (m_session.isComputing())
        problem = tr("The results are still being computed; try again in a moment.");
    else if (!m_session.isUpToDate())
        problem = tr("The results are out of date because the computation was cancelled; press "
                     "F9 to compute them again.");
    else if (!m_session.results().model)
        problem = tr("There is no model yet: open recordings and clear what blocks the stages.");
    if (!problem.isEmpty())
        m_prompts.showProblem(m_window, problem);
    return problem.isEmpty();
}

bool FileActions::isExporting()
{
    if (m_export.isRunning())
        m_prompts.showProblem(m_window,
            tr("Results are still being written to %1; wait until they are, or press Cancel.")
                .arg(m_exportTarget));
    return m_export.isRunning();
}

bool FileActions::mayQuit()
{
    return !isExporting() && mayDiscard();
}

void FileActions::exportResults()
{
    if (isExporting() || !hasResults())
        return;
    const QString folder = m_prompts.folder(
        m_window, tr("Export results into a folder"), m_preferences.lastFolder());
    if (folder.isEmpty())
        return;
    startExport(folder, ReportParts::CertificateAndPlots,
        [folder = folder.toStdString()](
            const RunFiles &run, const JobControl &control) -> Result<void> {
            const auto written = writeRunFiles(run, folder, control);
            if (!written)
                return tl::unexpected<Error>(written.error());
            return {};
        });
}

void FileActions::exportCertificate()
{
    if (isExporting() || !hasResults())
        return;
    if (m_session.error()) { // a calibration that did not come to its end has no certificate
        showProblem(*m_session.error());
        return;
    }
    const QString path = m_prompts.saveFile(m_window, tr("Export certificate"),
        tr("PDF documents (*.pdf)"), proposedPath("certificate.pdf"), "pdf");
    if (path.isEmpty())
        return;
    startExport(path, ReportParts::Certificate,
        [path = path.toStdString()](const RunFiles &run, const JobControl &) {
            return writeFileAtomically(path, run.drawn.front().bytes);
        });
}

void FileActions::exportModel()
{
    if (isExporting() || !hasResults())
        return;
    const std::vector<ModelFile> files = modelFiles(m_session.results());
    if (files.empty()) {
        m_prompts.showProblem(m_window,
            tr("The model of order %1 diverges, so there is nothing to export; choose another "
               "order.")
                .arg(m_session.results().model->order));
        return;
    }
    const QString folder = m_prompts.folder(
        m_window, tr("Export the model into a folder"), m_preferences.lastFolder());
    if (folder.isEmpty())
        return;
    for (const ModelFile &file : files) {
        const QString path = QDir(folder).filePath(QString::fromStdString(file.name));
        if (const auto written = writeFileAtomically(path.toStdString(), file.bytes); !written) {
            showProblem(written.error());
            return;
        }
    }
    emit idle(tr("Model written to %1").arg(folder));
}

void FileActions::startExport(
    const QString &target, ReportParts parts, const ExportJob::Write &write)
{
    const Result<std::string> created = m_currentUtc();
    if (!created) {
        showProblem(created.error());
        return;
    }
    m_exportTarget = target;
    emit busy(tr("Writing %1").arg(QFileInfo(target).fileName()));
    const PipelineOutcome outcome{m_session.results(), m_session.error(), m_session.failedStage()};
    m_export.start({outcome, m_session.recipe(), *created, {}}, parts, write);
}

void FileActions::cancel()
{
    m_jobs.cancel();
    m_captures.cancel();
    m_export.cancel();
    emit idle(tr("Cancelled"));
}

void FileActions::showProblem(const Error &error)
{
    emit idle({});
    if (error.kind != ErrorKind::Cancelled)
        m_prompts.showProblem(m_window, translated(error.message));
}

QString FileActions::proposedPath(const QString &fileName) const
{
    return QDir(m_preferences.lastFolder()).filePath(fileName);
}

} // namespace dyncal
