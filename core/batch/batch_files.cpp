// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_files.h"

#include "core/base/writing/atomic_file.h"
#include "core/base/writing/write_problem.h"
#include "core/batch/batch_planning.h"
#include "core/batch/batch_summary.h"
#include "core/batch/sensor_place.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr const char *kMarkOfPlan = "\"dyncal-batch-plan/1\"";
constexpr const char *kMarkOfSummary = "sensor,state,";
constexpr std::size_t kHead = std::size_t(1) << 16U;

std::string headOfFile(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    std::string head(kHead, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

/// Writes over nothing but an earlier file of the same sort, which is known by a mark in its head.
Result<void> writeOver(const std::string &path, const std::string &text, const char *mark)
{
    std::error_code unknown;
    const bool isThere = fs::exists(fs::symlink_status(path, unknown));
    if (isThere && headOfFile(path).find(mark) == std::string::npos)
        return existsAlready(path);
    return writeFileAtomically(path, text);
}

SensorStanding standingToMerge(const std::string &planFolder, const PlannedSensor &sensor)
{
    SensorOutcome record = recordOnDisk(planFolder, sensor);
    const bool hasResults
        = record.state != SensorState::Failed && record.state != SensorState::Missing;
    if (hasResults && !looksWhole(planFolder, sensor))
        record = {record.key, SensorState::Missing, {}, {}, {}, {}};
    return {sensor.id, std::move(record)};
}

Result<void> checkAllThere(const std::vector<SensorStanding> &standings)
{
    const auto isMissing = [](const SensorStanding &standing) {
        return standing.record.state == SensorState::Missing;
    };
    const auto first = std::ranges::find_if(standings, isMissing);
    if (first == standings.end())
        return {};
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "%1 of %2 sensors are missing, the first is %3; run the batch, or merge what there is with --partial."),
            {std::to_string(std::ranges::count_if(standings, isMissing)),
                std::to_string(standings.size()), first->id}});
}

} // namespace

Result<void> writePlanFile(const std::string &path, const BatchPlan &plan)
{
    return writeOver(path, planText(plan), kMarkOfPlan);
}

std::vector<SensorStanding> standingsOf(const std::string &planFolder, const BatchPlan &plan)
{
    std::vector<SensorStanding> standings;
    for (const PlannedSensor &sensor : plan)
        standings.push_back({sensor.id, recordOnDisk(planFolder, sensor)});
    return standings;
}

Result<std::vector<SensorStanding>> standingsToMerge(
    const std::string &planFolder, const BatchPlan &plan, bool partial)
{
    std::vector<SensorStanding> standings;
    for (const PlannedSensor &sensor : plan)
        standings.push_back(standingToMerge(planFolder, sensor));
    if (const Result<void> all = partial ? Result<void>() : checkAllThere(standings); !all)
        return tl::unexpected<Error>(all.error());
    return standings;
}

Result<void> writeSummaryFile(const std::string &path, const std::vector<SensorStanding> &standings)
{
    return writeOver(path, batchSummaryCsv(standings), kMarkOfSummary);
}

Result<BatchTally> mergeBatch(
    const std::string &planPath, const std::string &summaryPath, bool partial)
{
    const Result<BatchPlan> plan = readPlan(planPath);
    if (!plan)
        return tl::unexpected<Error>(plan.error());
    const Result<std::vector<SensorStanding>> standings
        = standingsToMerge(folderOfPlan(planPath), *plan, partial);
    if (!standings)
        return tl::unexpected<Error>(standings.error());
    if (const Result<void> written = writeSummaryFile(summaryPath, *standings); !written)
        return tl::unexpected<Error>(written.error());
    return tallyOf(*standings);
}

} // namespace dyncal
