// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_window.h"

#include "core/base/allowed_threads.h"
#include "core/batch/batch_files.h"
#include "ui/shell/batch/batch_plan_dialog.h"
#include "ui/shell/files/file_actions.h"
#include "ui/text/core_text.h"
#include "ui/text/progress_format.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace dyncal {

namespace {

constexpr QSize kFirstSize(1360, 720);
constexpr int kMostJobs = 1024;
constexpr int kPlanSteps = 1000; ///< of the progress bar, while a plan is made

} // namespace

BatchWindow::BatchWindow(
    FileActions &files, Prompts &prompts, Preferences &preferences, QWidget *parent)
    : QDialog(parent, Qt::Window)
    , m_files(files)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_table(new BatchTable(this))
    , m_plan(new QLabel(this))
    , m_outcome(new QLabel(this))
    , m_jobsLabel(new QLabel(this))
    , m_jobs(new QSpinBox(this))
    , m_partial(new QCheckBox(this))
    , m_progress(new QProgressBar(this))
    , m_follower(this)
    , m_process(QCoreApplication::applicationFilePath(), this)
    , m_job(this)
{
    setObjectName("batchWindow");
    auto *column = new QVBoxLayout(this);
    const auto addRow = [&](void (BatchWindow::*add)(QHBoxLayout &)) {
        auto *row = new QHBoxLayout;
        (this->*add)(*row);
        column->addLayout(row);
    };
    addRow(&BatchWindow::addPlanRow);
    column->addWidget(m_table, 1);
    column->addWidget(m_progress);
    column->addWidget(m_outcome);
    addRow(&BatchWindow::addRunRow);
    m_progress->setObjectName("batchProgress");
    m_outcome->setObjectName("batchOutcome");
    m_outcome->setWordWrap(true);
    connect(m_table, &BatchTable::activated, this, &BatchWindow::openSensor);
    connect(m_table, &BatchTable::selectionChanged, this, &BatchWindow::showWork);
    connect(&m_follower, &BatchFollower::changed, this, &BatchWindow::showMoment);
    connect(&m_follower, &BatchFollower::problemChanged, this, &BatchWindow::showOutcome);
    connect(&m_process, &ProgramCall::ended, this, [this](const ProgramAnswer &answer) {
        const QString problem = problemOf(answer);
        showOutcome(!problem.isEmpty() ? problem
                : answer.isStopped     ? tr("The run was stopped; what is complete is kept.")
                                       : tr("The run has ended."));
        m_follower.lookNow();
    });
    resize(kFirstSize);
    showWords();
}

QPushButton *BatchWindow::addButton(QHBoxLayout &row, const char *name, void (BatchWindow::*act)())
{
    auto *button = new QPushButton(this);
    button->setObjectName(name);
    button->setAutoDefault(false); // Return in the table opens a sensor
    connect(button, &QPushButton::clicked, this, act);
    row.addWidget(button);
    return button;
}

void BatchWindow::addPlanRow(QHBoxLayout &row)
{
    m_openPlan = addButton(row, "batchOpenPlan", &BatchWindow::askForPlan);
    m_newPlan = addButton(row, "batchNewPlan", &BatchWindow::askForNewPlan);
    m_plan->setObjectName("batchPlan");
    row.addWidget(m_plan, 1);
}

void BatchWindow::addRunRow(QHBoxLayout &row)
{
    m_jobs->setObjectName("batchJobs");
    m_jobs->setRange(1, kMostJobs);
    m_jobs->setValue(static_cast<int>(allowedThreads()));
    m_jobsLabel->setBuddy(m_jobs);
    m_partial->setObjectName("batchPartial");
    row.addWidget(m_jobsLabel);
    row.addWidget(m_jobs);
    m_run = addButton(row, "batchRun", &BatchWindow::run);
    m_stop = addButton(row, "batchStop", &BatchWindow::stop);
    row.addStretch();
    m_open = addButton(row, "batchOpenSensor", &BatchWindow::openSelected);
    row.addWidget(m_partial);
    m_merge = addButton(row, "batchMerge", &BatchWindow::merge);
}

void BatchWindow::showWords()
{
    setWindowTitle(tr("Batch"));
    m_openPlan->setText(tr("&Open plan..."));
    m_openPlan->setToolTip(tr("A plan made here or by dyncal batch plan"));
    m_newPlan->setText(tr("&New plan..."));
    m_newPlan->setToolTip(tr("List the sensors below a folder, with their recipe"));
    m_jobsLabel->setText(tr("Sensors at a &time"));
    m_jobs->setToolTip(tr("How many sensors are computed at a time, each on one processor"));
    m_run->setText(tr("&Run"));
    m_run->setToolTip(tr("Compute what is not complete yet"));
    m_stop->setText(tr("&Stop"));
    m_stop->setToolTip(tr("Stop in good order; what is complete is kept"));
    m_open->setText(tr("O&pen sensor"));
    m_open->setToolTip(tr("Open its recordings and recipe in the main window"));
    m_partial->setText(tr("also if sensors are &missing"));
    m_merge->setText(tr("Write s&ummary..."));
    m_merge->setToolTip(tr("One row for each sensor, in the order of the plan, as CSV"));
    m_progress->setAccessibleName(tr("Progress of the batch"));
    m_table->showWords();
    showMoment();
}

void BatchWindow::openPlan(const QString &path)
{
    const QString whole = QFileInfo(path).absoluteFilePath();
    m_preferences.setLastFolder(QFileInfo(whole).absolutePath());
    showOutcome({});
    m_follower.follow(whole);
}

void BatchWindow::askForPlan()
{
    const QString path = m_prompts.openFile(
        this, tr("Open plan"), tr("Plans (*.jsonl)"), m_preferences.lastFolder());
    if (!path.isEmpty())
        openPlan(path);
}

void BatchWindow::askForNewPlan()
{
    auto *dialog = new BatchPlanDialog(m_prompts, m_preferences, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { makePlan(dialog->request()); });
    dialog->open();
}

void BatchWindow::makePlan(const BatchRequest &request)
{
    m_progress->setRange(0, kPlanSteps);
    m_progress->setFormat(progressFormat());
    m_progress->setValue(0);
    m_job.start<bool>(
        [request](const JobControl &control) -> Result<bool> {
            const Result<BatchPlan> plan = planBatch(request, control);
            if (!plan)
                return tl::unexpected(plan.error());
            return writePlanFile(request.plan, *plan).map([] { return true; });
        },
        [this, path = rawText(request.plan)](const Result<bool> &made) {
            if (made)
                openPlan(path);
            showOutcome(made ? tr("The plan is made.") : translated(made.error().message));
        },
        [this](double done) { m_progress->setValue(static_cast<int>(kPlanSteps * done)); });
    showOutcome(tr("The sensors are being listed, and their recordings read for their hashes."));
}

void BatchWindow::run()
{
    const auto &plan = m_follower.moment().plan;
    if (!plan || isBusy())
        return;
    if (const Result<void> methods = checkMethods(*plan); !methods) {
        showOutcome(translated(methods.error().message));
        return;
    }
    m_process.start({QStringLiteral("batch"), QStringLiteral("run"), m_follower.planPath(),
        QStringLiteral("--jobs"), QString::number(m_jobs->value())});
    showOutcome({});
    m_follower.lookNow();
}

void BatchWindow::stop()
{
    if (m_process.isRunning())
        m_process.stop();
    if (m_job.isRunning())
        m_job.cancel();
    showOutcome(m_process.isRunning() ? tr("The run is being stopped.") : tr("Stopped."));
}

void BatchWindow::merge()
{
    const QString plan = m_follower.planPath();
    const QFileInfo place(plan);
    const QString path = m_prompts.saveFile(this, tr("Summary to write"), tr("CSV (*.csv)"),
        place.absolutePath() + "/" + place.completeBaseName() + ".csv", "csv");
    if (path.isEmpty())
        return;
    m_progress->setRange(0, 0);
    m_job.start<bool>(
        [plan = plan.toStdString(), summary = path.toStdString(), partial = m_partial->isChecked()](
            const JobControl &) -> Result<bool> {
            return mergeBatch(plan, summary, partial).map([](const auto &) { return true; });
        },
        [this, path](const Result<bool> &written) {
            showOutcome(written ? tr("Written: %1").arg(shownText(QFileInfo(path).fileName()))
                                : translated(written.error().message));
        });
    showWork();
}

void BatchWindow::openSelected()
{
    if (const auto sensor = m_table->selected())
        openSensor(*sensor);
}

void BatchWindow::openSensor(std::size_t sensor)
{
    const auto &plan = m_follower.moment().plan;
    m_files.openSensor(folderOfPlan(m_follower.planPath().toStdString()), (*plan)[sensor]);
    parentWidget()->raise();
    parentWidget()->activateWindow();
}

void BatchWindow::showMoment()
{
    m_table->setMoment(m_follower.moment());
    const QString path = m_follower.planPath();
    m_plan->setText(
        path.isEmpty() ? tr("No plan is open.") : shownText(QFileInfo(path).fileName()));
    m_plan->setToolTip(shownText(path));
    showWork();
}

/// What is not missing is done; where nothing is missing, a run checks what there is.
void BatchWindow::showProgress()
{
    const BatchTally tally = tallyOf(m_follower.moment());
    const auto missing = static_cast<int>(tally.count(SensorState::Missing));
    const auto total = static_cast<int>(tally.total());
    m_progress->setRange(0, missing > 0 ? total : 0);
    m_progress->setValue(total - missing);
}

void BatchWindow::showWork()
{
    const bool hasPlan = m_follower.moment().plan != nullptr;
    m_progress->setVisible(isBusy());
    if (m_process.isRunning())
        showProgress();
    for (QPushButton *button : {m_openPlan, m_newPlan})
        button->setEnabled(!isBusy());
    for (QPushButton *button : {m_run, m_merge})
        button->setEnabled(hasPlan && !isBusy());
    m_stop->setEnabled(isBusy() && !m_process.isStopping());
    m_open->setEnabled(m_table->selected().has_value());
}

void BatchWindow::showOutcome(const QString &sentence)
{
    m_outcome->setText(sentence);
    showWork();
}

void BatchWindow::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showWords();
}

void BatchWindow::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    m_follower.lookNow();
}

/// A run goes on behind a closed window; only the looks rest.
void BatchWindow::hideEvent(QHideEvent *event)
{
    QDialog::hideEvent(event);
    m_follower.rest();
}

BatchWindow &showBatchWindow(
    FileActions &files, Prompts &prompts, Preferences &preferences, QWidget &parent)
{
    auto *window = parent.findChild<BatchWindow *>(QString(), Qt::FindDirectChildrenOnly);
    if (!window)
        window = new BatchWindow(files, prompts, preferences, &parent);
    window->show();
    window->raise();
    window->activateWindow();
    return *window;
}

} // namespace dyncal
