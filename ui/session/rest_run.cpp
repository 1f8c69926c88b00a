// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/rest_run.h"

namespace dyncal {

namespace {

/// A pause of this length within a drag: now the rest is computed.
constexpr int kRest_ms = 150;

} // namespace

RestRun::RestRun(JobRunner &jobs, std::function<void()> begin)
    : m_jobs(jobs)
{
    m_asked.setSingleShot(true);
    QObject::connect(&m_asked, &QTimer::timeout, &m_asked, std::move(begin));
}

void RestRun::ask(bool isSeries)
{
    m_asked.start(isSeries ? kRest_ms : 0);
}

void RestRun::hurry()
{
    if (m_asked.isActive())
        m_asked.start(0);
}

void RestRun::start(QObject *receiver, PipelineRequest request, StageId focus,
    DeliverPart deliverPart, Deliver deliver, ProgressSink progress)
{
    const auto job
        = [receiver, request = std::move(request), focus, deliverPart = std::move(deliverPart)](
              const JobControl &control) mutable -> Result<RunPart> {
        const bool isFirst = request.isFirstTriplets
            = request.wantsFirstTriplets(kLastStage, control);
        for (const StageId upTo : {StageId::Response, StageId::Assessment, StageId::Evidence}) {
            if (upTo == focus)
                continue;
            const PipelineOutcome part = request.run(upTo, control);
            if (part.error || (isFirst && upTo == StageId::Evidence))
                return RunPart{part, isFirst};
            const auto &next = part.results.keys[static_cast<std::size_t>(upTo) + 1];
            if (!request.cache->find<void>(next)) // else the next part comes at once
                JobRunner::post(receiver, control.stop,
                    [=, results = part.results] { deliverPart(results, upTo, isFirst); });
        }
        return RunPart{request.run(kLastStage, control), false};
    };
    const auto take = [deliver = std::move(deliver)](
                          Result<RunPart> part) { deliver(runPartOf(std::move(part))); };
    m_jobs.start<RunPart>(job, take, std::move(progress));
}

} // namespace dyncal
