// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/focus_run.h"

namespace dyncal {

namespace {

constexpr qint64 kGrace_ms = 700; ///< a younger run may finish

} // namespace

FocusRun::FocusRun(JobRunner &jobs, std::function<void()> begin)
    : m_jobs(jobs)
{
    m_asked.setSingleShot(true);
    QObject::connect(&m_asked, &QTimer::timeout, &m_asked, std::move(begin));
}

void FocusRun::ask()
{
    if (!m_asked.isActive())
        m_asked.start(0);
}

bool FocusRun::mayBegin()
{
    const qint64 left_ms = kGrace_ms - m_jobs.age_ms();
    if (!isRunning() || left_ms <= 0)
        return true;
    m_asked.start(static_cast<int>(left_ms)); // or earlier, when the run has finished
    return false;
}

void FocusRun::start(PipelineRequest request, StageId upTo, Deliver deliver, ProgressSink progress)
{
    m_focus = upTo;
    const auto job = [request = std::move(request), upTo](const JobControl &control) mutable {
        request.isFirstTriplets = request.wantsFirstTriplets(upTo, control);
        RunPart part{request.run(upTo, control), request.isFirstTriplets};
        part.modelCurve = request.modelCurve(part.outcome.results);
        return Result<RunPart>(std::move(part));
    };
    const auto take = [deliver = std::move(deliver), upTo](
                          Result<RunPart> part) { deliver(runPartOf(std::move(part)), upTo); };
    m_jobs.start<RunPart>(job, take, std::move(progress));
    m_job = m_jobs.number();
}

} // namespace dyncal
