// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/correction/correction_window.h"

#include "core/capture/source_check.h"
#include "ui/session/session.h"
#include "ui/shell/correction/correction_form.h"
#include "ui/shell/correction/correction_view.h"
#include "ui/shell/files/capture_filter.h"
#include "ui/shell/files/export_actions.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/inspector_scroll.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/core_text.h"
#include "ui/text/progress_format.h"
#include "ui/text/shown_text.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QProgressBar>
#include <QScrollArea>

namespace dyncal {

namespace {

constexpr QSize kCorrectionSize(1200, 800);
constexpr int kProgressSteps = 1000;

} // namespace

CorrectionWindow::CorrectionWindow(Session &session, CurrentUtc currentUtc, Prompts &prompts,
    Preferences &preferences, QWidget *parent)
    : QDialog(parent)
    , m_session(session)
    , m_currentUtc(std::move(currentUtc))
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_job(this)
{
    setObjectName("correctionWindow");
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    new QVBoxLayout(this);
    for (const auto change : {&Session::recipeChanged, &Session::capturesChanged})
        connect(&session, change, this, [this] {
            if (m_form->choice().isOfProject || m_form->choice().isReadAsProject)
                setOutdated();
        });
    buildContents();
    resize(kCorrectionSize);
}

void CorrectionWindow::buildContents()
{
    m_isRebuilding = false;
    const CorrectionChoice choice = m_form ? m_form->choice() : CorrectionChoice();
    // A button that loses the keyboard while its box is destroyed looks through what is left of it.
    if (QWidget *focused = focusWidget())
        focused->clearFocus();
    delete m_contents;
    m_contents = new QWidget(this);
    setWindowTitle(tr("Correct a recording"));
    m_form = new CorrectionForm;
    m_form->setChoice(choice);
    m_view = new CorrectionView(m_cursors);
    m_verdict = new FormLabel({});
    m_verdict->setObjectName("correctionVerdict");
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *columns = new QHBoxLayout;
    auto *shown = new QScrollArea; // plots keep their height on a small screen
    shown->setFrameShape(QFrame::NoFrame);
    shown->setFocusPolicy(Qt::NoFocus);
    shown->setWidgetResizable(true);
    shown->setWidget(m_view);
    columns->addWidget(shown, 1);
    columns->addWidget(new InspectorScroll(m_form));
    auto *rows = new QVBoxLayout(m_contents);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(columns, 1);
    rows->addWidget(m_verdict);
    rows->addWidget(buildButtons());
    layout()->addWidget(m_contents);
    connect(m_form, &CorrectionForm::edited, this, &CorrectionWindow::setOutdated);
    connect(m_form, &CorrectionForm::readingEdited, this, &CorrectionWindow::openRecordings);
    connect(m_form, &CorrectionForm::resultsWanted, this, &CorrectionWindow::chooseResults);
    connect(m_form, &CorrectionForm::recordingsWanted, this, &CorrectionWindow::chooseRecordings);
    if (m_report)
        m_view->showReport(*m_report);
    showState();
}

QWidget *CorrectionWindow::buildButtons()
{
    auto *buttons = new QDialogButtonBox;
    m_progress = new QProgressBar;
    m_progress->setObjectName("correctionProgress");
    m_progress->setRange(0, kProgressSteps);
    m_progress->setFormat(progressFormat());
    m_progress->setAccessibleName(tr("Progress of the correction"));
    m_correct = buttons->addButton(tr("C&orrect"), QDialogButtonBox::ActionRole);
    m_correct->setObjectName("correctionStart");
    m_correct->setDefault(true);
    m_save = buttons->addButton(tr("&Save..."), QDialogButtonBox::ActionRole);
    m_save->setObjectName("correctionSave");
    m_save->setToolTip(
        tr("Pressure, filter and calibration as CSV, JSON, MAT and Python, into a folder"));
    m_close = buttons->addButton(QDialogButtonBox::Close);
    m_close->setObjectName("correctionClose");
    connect(m_correct, &QPushButton::clicked, this, &CorrectionWindow::correct);
    connect(m_save, &QPushButton::clicked, this, &CorrectionWindow::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &CorrectionWindow::reject);
    auto *line = new QWidget;
    auto *row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_progress, 1);
    row->addStretch();
    row->addWidget(buttons);
    return line;
}

void CorrectionWindow::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    // Queued, as in the main window: several such events come with one change.
    if (event->type() != QEvent::LanguageChange || m_isRebuilding)
        return;
    m_isRebuilding = true;
    QMetaObject::invokeMethod(this, &CorrectionWindow::buildContents, Qt::QueuedConnection);
}

void CorrectionWindow::chooseResults()
{
    const QString path = m_prompts.openFile(this, tr("Results of the sensor's calibration"),
        tr("Results (results.json *.json);;All files (*)"), m_preferences.lastFolder());
    if (path.isEmpty())
        return;
    m_preferences.setLastFolder(QFileInfo(path).absolutePath());
    CorrectionChoice choice = m_form->choice();
    choice.results = path;
    m_form->setChoice(choice);
    setOutdated();
}

void CorrectionWindow::chooseRecordings()
{
    const QStringList paths = m_prompts.openFiles(
        this, tr("Recordings to correct"), captureFilter(), m_preferences.lastFolder());
    if (paths.isEmpty())
        return;
    m_preferences.setLastFolder(QFileInfo(paths.first()).absolutePath());
    CorrectionChoice choice = m_form->choice();
    choice.recordings = paths;
    choice.channel.clear();
    m_form->setChoice(choice);
    openRecordings();
}

/// To know their channels.
void CorrectionWindow::openRecordings()
{
    CorrectionChoice choice = m_form->choice();
    choice.channels.clear();
    m_form->setChoice(choice);
    setOutdated();
    if (choice.recordings.isEmpty())
        return;
    std::vector<std::string> paths;
    for (const QString &path : choice.recordings)
        paths.push_back(path.toStdString());
    choice.channel.clear(); // a reader may take named channels only
    m_job.start<QStringList>(
        [paths, import = readingRecipe(choice, m_session.recipe()).import](
            const JobControl &control) { return channelsOf(paths, import, control); },
        [this](Result<QStringList> channels) {
            if (!channels)
                return fail(channels.error());
            CorrectionChoice opened = m_form->choice();
            opened.channels = *channels;
            if (!channels->contains(opened.channel))
                opened.channel.clear();
            m_form->setChoice(opened);
            end(State::Nothing);
        },
        progress());
    begin(State::Opening);
}

void CorrectionWindow::correct()
{
    m_isCurrent = false;
    Result<CorrectionTask> task = taskOf(m_form->choice(), m_session.recipe());
    if (!task)
        return fail(task.error());
    if (m_form->choice().isOfProject) {
        if (const auto why = ExportActions::whyNoResults(m_session))
            return fail({ErrorKind::Usage, *why, {}, 0});
        const Result<std::string> created = m_currentUtc();
        if (!created)
            return fail(created.error());
        task->run = ProjectRun{{m_session.results(), m_session.error(), m_session.failedStage()},
            m_session.recipe(), *created};
    }
    m_resultsOfReport = task->results;
    m_job.start<CorrectionReport>(
        [task = std::move(*task)](
            const JobControl &control) { return correctionReport(task, control); },
        [this](Result<CorrectionReport> report) {
            if (report)
                showReport(std::move(*report));
            else
                fail(report.error());
        },
        progress());
    begin(State::Correcting);
}

void CorrectionWindow::showReport(CorrectionReport report)
{
    m_report = std::move(report);
    m_isCurrent = true;
    m_view->showReport(*m_report);
    end(State::Corrected);
}

void CorrectionWindow::save()
{
    const QString folder = m_prompts.folder(
        this, tr("Save the correction into a folder"), m_preferences.lastFolder());
    if (folder.isEmpty())
        return;
    using Paths = std::vector<std::string>;
    m_job.start<Paths>(
        [folder = folder.toStdString(), report = *m_report, results = m_resultsOfReport](
            const JobControl &control) -> Result<Paths> {
            if (const Result<void> same = checkSources(*report.captures); !same)
                return tl::unexpected<Error>(same.error());
            Result<FolderWrite> target
                = FolderWrite::begin(correctionFolder(folder, *report.captures, {results}));
            if (!target)
                return tl::unexpected<Error>(target.error());
            return writeCorrection(*report.outcome, *target, control);
        },
        [this, folder](const Result<Paths> &written) {
            if (!written)
                return fail(written.error());
            m_written = folder;
            end(State::Corrected);
        },
        progress());
    begin(State::Writing);
}

ProgressSink CorrectionWindow::progress()
{
    return [this](double fraction) {
        m_progress->setValue(static_cast<int>(kProgressSteps * fraction));
    };
}

/// Of a job that was started.
void CorrectionWindow::begin(State state)
{
    m_progress->setValue(0);
    m_written.clear();
    end(state);
}

void CorrectionWindow::end(State state)
{
    m_state = state;
    showState();
}

void CorrectionWindow::fail(const Error &error)
{
    m_error = error;
    end(State::Failed);
}

void CorrectionWindow::reject()
{
    if (!isRunning()) {
        QDialog::reject();
        return;
    }
    m_job.cancel();
    end(State::Stopped);
}

/// What is on show stays, pale, until it is corrected again.
void CorrectionWindow::setOutdated()
{
    m_isCurrent = false;
    if (isRunning() && m_state == State::Writing)
        return showState(); // it is written as it was when that was asked for
    m_job.cancel();
    end(State::Nothing);
}

QString CorrectionWindow::sentence() const
{
    switch (m_state) {
    case State::Nothing:
        return m_report
            ? tr("What is on show is of earlier settings; press Correct.")
            : tr("Choose the calibration of the sensor and a recording of it, then press Correct.");
    case State::Opening:
        return tr("The recordings are being opened.");
    case State::Correcting:
        return tr("The recordings are being corrected.");
    case State::Writing:
        return tr("The correction is being written.");
    case State::Stopped:
        return tr("Stopped; nothing was changed.");
    case State::Failed:
        return withFieldLabels(translated(m_error->message));
    case State::Corrected:
        break;
    }
    if (!m_report->outcome)
        return tr(
            "Nothing was corrected: the recordings do not hold the pressure, as the findings say.");
    return m_written.isEmpty()
        ? tr("Corrected: the pressure is relative to that before it, with its band of 95 %.")
        : tr("Written: %1").arg(shownText(m_written));
}

void CorrectionWindow::showState()
{
    const bool isBusy = isRunning();
    m_verdict->setText(sentence());
    m_progress->setVisible(isBusy);
    m_form->setEnabled(!isBusy);
    m_correct->setEnabled(!isBusy);
    m_save->setEnabled(!isBusy && m_isCurrent && m_report && m_report->outcome);
    m_close->setText(isBusy ? tr("&Cancel") : tr("&Close"));
    m_view->setNotice(m_report && !m_isCurrent
            ? tr("Of earlier settings: press Correct to compute it again.")
            : QString());
}

} // namespace dyncal
