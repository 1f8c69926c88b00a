// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/whole_set_run.h"

namespace dyncal {

WholeSetRun::WholeSetRun(QObject *receiver, Deliver deliver, ProgressSink progress)
    : m_deliver(std::move(deliver))
    , m_progress(std::move(progress))
    , m_jobs(receiver, 2)
{
}

bool WholeSetRun::start(const PipelineRequest &request)
{
    const std::string key = decompositionKey(*request.captures, request.recipe);
    if (m_jobs.isRunning() && m_making == key)
        return true;
    if (m_withheld == key)
        return false;
    m_making = key;
    m_made.clear();
    m_jobs.start<PipelineOutcome>(
        [request](const JobControl &control) -> Result<PipelineOutcome> {
            return request.run(StageId::Decomposition, control);
        },
        [this](Result<PipelineOutcome> outcome) {
            if (!outcome)
                outcome = PipelineOutcome{{}, outcome.error(), StageId::Decomposition};
            if (!outcome->error)
                m_made = m_making;
            m_deliver(*outcome);
        },
        m_progress);
    return true;
}

void WholeSetRun::forget()
{
    m_jobs.cancel();
    m_made.clear();
    m_withheld.clear();
}

} // namespace dyncal
