// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/job_runner.h"
#include "ui/session/pipeline_request.h"

#include <QTimer>

namespace dyncal {

/// The first part of every run: the stages up to the one on show. The newest request wins; but a
/// young run may finish although a newer request waits: otherwise a drag whose steps come faster
/// than results would never show one.
class FocusRun
{
public:
    using Deliver = std::function<void(const RunPart &part, StageId upTo)>;

    /// `jobs` is shared with RestRun: what is started last stops the other. `begin` is called when
    /// it is time for a run.
    FocusRun(JobRunner &jobs, std::function<void()> begin);

    /// Has `begin` called once the events that already wait are handled, a single time for all
    /// requests until then.
    void ask();
    bool isAsked() const { return m_asked.isActive(); }
    void withdraw() { m_asked.stop(); }
    /// To be asked in `begin`. False: a young run goes on, and `begin` is called again later.
    bool mayBegin();

    void start(PipelineRequest request, StageId upTo, Deliver deliver, ProgressSink progress);
    StageId focus() const { return m_focus; } ///< of the run started last

private:
    bool isRunning() const { return m_jobs.isRunning() && m_jobs.number() == m_job; }

    JobRunner &m_jobs;
    QTimer m_asked; ///< active: a newer recipe waits to be computed
    quint64 m_job = 0; ///< the one started last
    StageId m_focus = StageId::Captures;
};

} // namespace dyncal
