// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/session/job_runner.h"
#include "ui/session/shared_cursors.h"
#include "ui/shell/correction/correction_task.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace dyncal {

class CorrectionForm;
class CorrectionView;
class Preferences;
class Prompts;
class Session;

/// File > Correct a recording: the pressure behind recordings, by the run of the open project or a
/// results.json, as `dyncal correct` computes and writes it. It stands beside the main window; all
/// work is done in the background.
class CorrectionWindow : public QDialog
{
    Q_OBJECT

public:
    CorrectionWindow(Session &session, CurrentUtc currentUtc, Prompts &prompts,
        Preferences &preferences, QWidget *parent);

    bool isRunning() const { return m_job.isRunning(); }
    void reject() override; ///< stops the work where some runs, else closes

protected:
    void changeEvent(QEvent *event) override;

private:
    /// What the line above the buttons is about.
    enum class State { Nothing, Opening, Correcting, Writing, Corrected, Failed, Stopped };

    void buildContents(); ///< everything with words in it; again after a change of language
    QWidget *buildButtons();
    void chooseResults();
    void chooseRecordings();
    void openRecordings();
    void correct();
    void save();
    void begin(State state);
    void end(State state);
    void fail(const Error &error);
    void showReport(CorrectionReport report);
    void setOutdated();
    void showState();
    QString sentence() const;
    ProgressSink progress();

    Session &m_session;
    CurrentUtc m_currentUtc;
    Prompts &m_prompts;
    Preferences &m_preferences;
    SharedCursors m_cursors; ///< of both plots
    State m_state = State::Nothing;
    std::optional<Error> m_error; ///< of State::Failed
    QString m_written; ///< folder that the correction on show was written to
    std::optional<CorrectionReport> m_report; ///< on show
    std::string m_resultsOfReport; ///< path of its calibration; empty: of the project
    bool m_isCurrent = false; ///< it is what the choice gives
    bool m_isRebuilding = false;
    QWidget *m_contents = nullptr;
    CorrectionForm *m_form = nullptr;
    CorrectionView *m_view = nullptr;
    QLabel *m_verdict = nullptr;
    QProgressBar *m_progress = nullptr;
    QPushButton *m_correct = nullptr;
    QPushButton *m_save = nullptr;
    QPushButton *m_close = nullptr;
    JobRunner m_job; ///< last: it stops before what its deliveries use is destroyed
};

} // namespace dyncal
