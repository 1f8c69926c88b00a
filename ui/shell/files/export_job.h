// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/report/drawing_steps.h"
#include "ui/session/job_runner.h"

namespace dyncal {

/// Writes results while the window goes on answering: the documents are drawn on the thread of the
/// window, some milliseconds at a time, then everything is written in the background. It writes the
/// results as they were at start(). If it is stopped while drawing, nothing on disk has changed.
class ExportJob : public QObject
{
    Q_OBJECT

public:
    /// Puts the drawn run on disk; called in the background.
    using Write = std::function<Result<void>(const RunFiles &, const JobControl &)>;

    explicit ExportJob(QObject *parent);

    void start(RunFiles run, ReportParts parts, Write write);
    void cancel();
    bool isRunning() const { return m_drawing.isRunning() || m_jobs.isRunning(); }

signals:
    void progress(double fraction);
    void finished(bool isWhole); ///< false: the run may not be published, and nothing was drawn
    void failed(const dyncal::Error &error);

private:
    void write(std::vector<DrawnFile> drawn);
    void giveUp(const Error &error);

    RunFiles m_run;
    Write m_write;
    DrawingSteps m_drawing;
    JobRunner m_jobs;
};

} // namespace dyncal
