// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/job_runner.h"
#include "ui/session/pipeline_request.h"

#include <QTimer>

namespace dyncal {

/// The second part of every run: the stages behind the one on show. Within a series of changes that
/// merge (a drag, keys) it waits for a pause of the operator, so that no move waits for what it
/// does not show.
class RestRun
{
public:
    /// Parts may come before the whole.
    using DeliverPart
        = std::function<void(const CalibrationResults &part, StageId upTo, bool isFirstTriplets)>;
    using Deliver = std::function<void(const RunPart &part)>;

    /// `jobs` is shared with FocusRun: what is started last stops the other. `begin` is called when
    /// it is time for a run.
    RestRun(JobRunner &jobs, std::function<void()> begin);

    /// To be called when the first part is there: `begin` follows at once, or within a series at
    /// the next pause.
    void ask(bool isSeries);
    void hurry(); ///< the hand has let go
    void withdraw() { m_asked.stop(); }

    /// `focus`: what the first part has computed. Delivered on the thread of `receiver`. Of the
    /// first singular values, everything is delivered but what needs the whole set.
    void start(QObject *receiver, PipelineRequest request, StageId focus, DeliverPart deliverPart,
        Deliver deliver, ProgressSink progress);

private:
    JobRunner &m_jobs;
    QTimer m_asked; ///< active: the stages behind the focus wait to be computed
};

} // namespace dyncal
