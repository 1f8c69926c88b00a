// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/selftest.h"
#include "ui/session/current_utc.h"
#include "ui/session/job_runner.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace dyncal {

class Preferences;
class Prompts;
class ValueTable;

/// Help > Self-test: what this installation computes against what is known, in the background, with
/// the verdict of every check, and the report as PDF and JSON for the quality system.
class SelfTestDialog : public QDialog
{
    Q_OBJECT

public:
    SelfTestDialog(CurrentUtc currentUtc, Prompts &prompts, Preferences &preferences,
        QString language, QWidget *parent);

    /// Begins at once; a test that still runs is given up. `calibrations`: of the coverage study.
    void start(Index calibrations = SelfTestSettings{}.calibrations);
    bool isRunning() const { return m_job.isRunning(); }

    void reject() override; ///< stops the test where it runs, else closes

private:
    void showRunning(bool isRunning);
    void showOutcome(Result<SelfTestReport> outcome);
    void showTable();
    void save();
    Result<void> writeReport(const QString &folder) const;

    CurrentUtc m_currentUtc;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QString m_language; ///< of the report
    std::string m_createdUtc; ///< of the test that is shown
    std::optional<SelfTestReport> m_report;
    QLabel *m_verdict;
    QProgressBar *m_progress;
    ValueTable *m_table;
    QPushButton *m_again;
    QPushButton *m_save;
    QPushButton *m_close;
    JobRunner m_job;
};

} // namespace dyncal
