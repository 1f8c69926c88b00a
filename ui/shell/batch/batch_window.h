// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/batch_planning.h"
#include "ui/session/job_runner.h"
#include "ui/shell/batch/batch_follower.h"
#include "ui/shell/batch/batch_table.h"
#include "ui/shell/program/program_call.h"

#include <QDialog>

#include <cstddef>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace dyncal {

class FileActions;
class Preferences;
class Prompts;

/// File > Batch: many sensors as a table, the worst first, live whoever computes them. It plans,
/// runs, stops and merges as `dyncal batch` does and writes the same files; a sensor that is
/// double-clicked is opened in the main window. A window of its own, beside which work goes on.
class BatchWindow : public QDialog
{
    Q_OBJECT

public:
    /// `parent`: the main window that sensors are opened in.
    BatchWindow(FileActions &files, Prompts &prompts, Preferences &preferences, QWidget *parent);

    void openPlan(const QString &path);
    void makePlan(const BatchRequest &request);
    /// What computes: this very program, unless it is told otherwise.
    void setProgram(const QString &path) { m_process.setProgram(path); }
    bool isBusy() const { return m_process.isRunning() || m_job.isRunning(); }

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QPushButton *addButton(QHBoxLayout &row, const char *name, void (BatchWindow::*act)());
    void addPlanRow(QHBoxLayout &row);
    void addRunRow(QHBoxLayout &row);
    void showWords();
    void askForPlan();
    void askForNewPlan();
    void run();
    void stop();
    void merge();
    void openSelected();
    void openSensor(std::size_t sensor); ///< position in the plan
    void showMoment();
    void showProgress();
    void showWork(); ///< what can be done now
    void showOutcome(const QString &sentence);

    FileActions &m_files;
    Prompts &m_prompts;
    Preferences &m_preferences;
    BatchTable *m_table;
    QLabel *m_plan;
    QLabel *m_outcome;
    QLabel *m_jobsLabel;
    QSpinBox *m_jobs;
    QCheckBox *m_partial;
    QProgressBar *m_progress;
    QPushButton *m_openPlan = nullptr;
    QPushButton *m_newPlan = nullptr;
    QPushButton *m_run = nullptr;
    QPushButton *m_stop = nullptr;
    QPushButton *m_merge = nullptr;
    QPushButton *m_open = nullptr;
    BatchFollower m_follower;
    ProgramCall m_process;
    JobRunner m_job; ///< planning or merging
};

/// Brings the window of batches to the front; it is made at the first call.
BatchWindow &showBatchWindow(
    FileActions &files, Prompts &prompts, Preferences &preferences, QWidget &parent);

} // namespace dyncal
