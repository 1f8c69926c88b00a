// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_watch.h"

#include "core/batch/sensor_place.h"
#include "core/capture/capture_seal.h"

#include <algorithm>
#include <tuple>

namespace dyncal {
namespace {

InputStamp stampOfFile(const std::string &path)
{
    const InputFile now = stampedInput(path, std::string());
    return {now.bytes, now.changed_ns};
}

/// The plan with the stamp that its file had before it was read: a plan that changes meanwhile is
/// read once more the next time.
Result<BatchMoment> planNow(const std::string &path, const BatchMoment &before)
{
    const InputStamp stamp = stampOfFile(path);
    if (before.plan && before.stamp == stamp)
        return BatchMoment{before.plan, stamp, {}};
    Result<BatchPlan> plan = readPlan(path);
    if (!plan)
        return tl::unexpected<Error>(plan.error());
    return BatchMoment{std::make_shared<const BatchPlan>(std::move(*plan)), stamp, {}};
}

SensorNow sensorNow(const std::string &planFolder, const PlannedSensor &sensor)
{
    SensorOutcome record = recordOnDisk(planFolder, sensor);
    const bool mayRun = sensor.obstacle.empty()
        && (record.state == SensorState::Missing || record.state == SensorState::Failed);
    const bool isRunning = mayRun && isBeingComputed(pathOfPlan(planFolder, sensor.output));
    return {{sensor.id, std::move(record)}, isRunning};
}

int rankOf(const SensorNow &sensor)
{
    if (sensor.isRunning)
        return 3;
    switch (sensor.standing.record.state) {
    case SensorState::Failed:
        return 0;
    case SensorState::Blocked:
        return 1;
    case SensorState::Cautions:
        return 2;
    case SensorState::Missing:
        return 4;
    case SensorState::Done:
        break;
    }
    return 5;
}

std::ptrdiff_t countOf(const SensorNow &sensor, Severity severity)
{
    return std::ranges::count(sensor.standing.record.findings, severity, &FindingMark::severity);
}

auto orderOf(const SensorNow &sensor)
{
    return std::tuple(
        rankOf(sensor), -countOf(sensor, Severity::Block), -countOf(sensor, Severity::Caution));
}

} // namespace

Result<BatchMoment> batchNow(
    const std::string &planPath, const BatchMoment &before, const JobControl &control)
{
    Result<BatchMoment> now = planNow(planPath, before);
    if (!now)
        return now;
    const std::string folder = folderOfPlan(planPath);
    now->sensors.reserve(now->plan->size());
    for (const PlannedSensor &sensor : *now->plan) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
        now->sensors.push_back(sensorNow(folder, sensor));
    }
    return now;
}

BatchTally tallyOf(const BatchMoment &moment)
{
    BatchTally tally;
    for (const SensorNow &sensor : moment.sensors)
        tally.add(sensor.standing.record.state);
    return tally;
}

bool isWorse(const SensorNow &a, const SensorNow &b)
{
    return orderOf(a) < orderOf(b);
}

std::optional<FindingMark> worstFinding(const SensorOutcome &record)
{
    const auto worst = std::ranges::max_element(record.findings, {},
        [](const FindingMark &mark) { return static_cast<int>(mark.severity); });
    return worst == record.findings.end() ? std::nullopt : std::optional(*worst);
}

} // namespace dyncal
