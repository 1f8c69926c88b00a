// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_tally.h"

#include "core/base/json_text.h"

#include <numeric>

namespace dyncal {
namespace {

using StatusJson = nlohmann::json;

StatusJson standingJson(const SensorStanding &standing)
{
    StatusJson json{{"sensor", standing.id}, {"state", sensorStateName(standing.record.state)}};
    if (!standing.record.reason.empty())
        json["reason"] = standing.record.reason;
    return json;
}

} // namespace

std::size_t BatchTally::total() const
{
    return std::accumulate(ofState.begin(), ofState.end(), std::size_t(0));
}

std::string tallyText(const BatchTally &tally)
{
    const auto counted = [&tally](SensorState state, const char *word) {
        return std::to_string(tally.count(state)).append(word);
    };
    const std::size_t total = tally.total();
    return std::to_string(total) + (total == 1 ? " sensor: " : " sensors: ")
        + counted(SensorState::Done, " done, ") + counted(SensorState::Cautions, " with cautions, ")
        + counted(SensorState::Blocked, " blocked, ") + counted(SensorState::Failed, " failed, ")
        + counted(SensorState::Missing, " missing");
}

BatchTally tallyOf(const std::vector<SensorStanding> &standings)
{
    BatchTally tally;
    for (const SensorStanding &standing : standings)
        tally.add(standing.record.state);
    return tally;
}

std::string statusJson(const std::vector<SensorStanding> &standings)
{
    const BatchTally tally = tallyOf(standings);
    StatusJson others = StatusJson::array();
    for (const SensorStanding &standing : standings)
        if (standing.record.state != SensorState::Done)
            others.push_back(standingJson(standing));
    StatusJson json{{"schema", "dyncal-batch-status/1"}, {"sensors", tally.total()},
        {"not_done", std::move(others)}};
    for (int i = 0; i < kSensorStates; ++i)
        json[sensorStateName(static_cast<SensorState>(i))]
            = tally.count(static_cast<SensorState>(i));
    return jsonText(json);
}

} // namespace dyncal
