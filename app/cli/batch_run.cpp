// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/batch_run.h"

#include "app/base/child_jobs.h"
#include "app/base/interrupt.h"
#include "app/cli/batch_sensor.h"
#include "app/cli/console.h"
#include "app/cli/spoken.h"

#include "core/base/foreign_text.h"
#include "core/batch/batch_planning.h"
#include "core/batch/sensor_place.h"

#include <iostream>

namespace dyncal {
namespace {

void say(const std::string &id, const std::string &sentence)
{
    std::cerr << presentableInBrief(id) << ": " << presentable(sentence) << '\n';
}

KeptMessage crashReason(int signal)
{
    return keptMessage(
        {DYNCAL_TEXT("core",
             "The process that computed it was ended by signal %1: it crashed, or the system ended it for want of memory."),
            {std::to_string(signal)}});
}

/// Follows the processes and keeps what has to be kept of those that fail.
class BatchFollower
{
public:
    explicit BatchFollower(const BatchRun &run)
        : m_run(run)
    {
        for (std::size_t i = 0; i < run.plan.size(); ++i)
            if (run.shard.holds(i))
                (run.plan[i].obstacle.empty() ? m_jobs : m_unplanned).push_back(i);
    }

    Result<BatchOutcome> follow()
    {
        for (const std::size_t i : m_unplanned)
            count(m_run.plan[i]);
        const ChildJobs jobs{m_jobs.size(), m_run.jobs,
            [this](std::size_t job) { return computeSensor(sensor(job), m_run.planFolder); },
            [this](std::size_t job, const ChildEnd &end) { take(sensor(job), end); }};
        const bool couldStart = runChildJobs(jobs, interruptToken());
        if (m_problem)
            return tl::unexpected<Error>(*m_problem);
        if (interruptToken().stop_requested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
        if (!couldStart)
            return fail(ErrorKind::Internal,
                {DYNCAL_TEXT("core",
                     "The system could start no process for a sensor; close other programs or raise the limit of processes. What was computed is kept."),
                    {}});
        return m_outcome;
    }

private:
    const PlannedSensor &sensor(std::size_t job) const { return m_run.plan[m_jobs[job]]; }

    void take(const PlannedSensor &sensor, const ChildEnd &end)
    {
        const SensorAnswer answer = end.signal == 0
            ? parseAnswer(end.answer)
            : SensorAnswer{SensorAnswer::Failed, crashReason(end.signal)};
        m_outcome.computed += answer.how == SensorAnswer::Computed ? 1 : 0;
        m_outcome.kept += answer.how == SensorAnswer::Kept ? 1 : 0;
        if (answer.how == SensorAnswer::Failed)
            remember(keepFailure(m_run.planFolder, sensor, answer.said));
        else if (answer.how == SensorAnswer::Computed || answer.how == SensorAnswer::Kept)
            forgetFailure(m_run.planFolder, sensor);
        if (answer.how != SensorAnswer::Failed && !answer.said.text.empty())
            say(sensor.id, spoken(answer.said.message()));
        if (answer.how != SensorAnswer::Stopped)
            count(sensor);
        m_progress(++m_ended);
    }

    void count(const PlannedSensor &sensor)
    {
        const SensorOutcome record = recordOnDisk(m_run.planFolder, sensor);
        m_outcome.tally.add(record.state);
        if (!record.reason.empty())
            say(sensor.id,
                std::string(sensorStateName(record.state)) + ": "
                    + spoken(record.said, record.reason));
    }

    void remember(const Result<void> &kept)
    {
        if (!kept && !m_problem)
            m_problem = kept.error();
    }

    const BatchRun &m_run;
    std::vector<std::size_t> m_jobs; ///< positions in the plan
    std::vector<std::size_t> m_unplanned;
    BatchOutcome m_outcome;
    std::optional<Error> m_problem;
    std::size_t m_ended = 0;
    ProgressLine m_line{"Computing"};
    std::function<void(std::size_t)> m_progress = [this, sink = m_line.sink()](std::size_t ended) {
        if (sink)
            sink(static_cast<double>(ended) / static_cast<double>(m_jobs.size()));
    };
};

} // namespace

Result<BatchOutcome> runBatch(const BatchRun &run)
{
    if (const Result<void> methods = checkMethods(run.plan); !methods)
        return tl::unexpected<Error>(methods.error());
    return BatchFollower(run).follow();
}

} // namespace dyncal
