// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/sensor_outcome.h"

#include "core/base/json_text.h"
#include "core/results/publication.h"
#include "core/results/results_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {
namespace {

using RecordJson = nlohmann::json;

constexpr const char *kRecordSchema = "dyncal-batch-record/1";
constexpr std::array<const char *, kSensorStates> kStateNames{
    "done", "cautions", "blocked", "failed", "missing"};
constexpr std::array<Severity, 3> kSeverities{Severity::Info, Severity::Caution, Severity::Block};

void addResult(std::vector<StatedResult> &results, const std::string &quantity,
    std::optional<double> value, const std::string &unit, const ReportedValue *reported)
{
    if (!value || !std::isfinite(*value))
        return;
    StatedResult result{quantity, *value, unit};
    if (reported && reported->u) {
        result.expanded = reported->expanded();
        result.k = reported->factor();
    }
    results.push_back(std::move(result));
}

std::vector<StatedResult> keyResults(const CalibrationResults &results)
{
    std::vector<StatedResult> stated;
    const UncertaintyReport *report = results.uncertainty.get();
    if (results.response)
        addResult(stated, "sensitivity", results.response->sensitivity,
            results.response->sensitivityUnit,
            report && report->sensitivity ? &*report->sensitivity : nullptr);
    for (const ReportedValue &one : report ? report->ofModel : std::vector<ReportedValue>())
        addResult(stated, one.of, one.value, one.unit, &one);
    return stated;
}

SensorState stateOfFindings(const Findings &findings)
{
    switch (worstSeverity(findings)) {
    case Severity::Block:
        return SensorState::Blocked;
    case Severity::Caution:
        return SensorState::Cautions;
    case Severity::Info:
        break;
    }
    return SensorState::Done;
}

RecordJson orNull(const std::optional<double> &value)
{
    return value && std::isfinite(*value) ? RecordJson(*value) : RecordJson();
}

RecordJson resultsJson(const SensorOutcome &record)
{
    RecordJson list = RecordJson::array();
    for (const StatedResult &one : record.results)
        list.push_back({{"quantity", one.quantity}, {"value", one.value}, {"unit", one.unit},
            {"u_expanded", orNull(one.expanded)}, {"k", orNull(one.k)}});
    return list;
}

RecordJson marksJson(const SensorOutcome &record)
{
    RecordJson list = RecordJson::array();
    for (const FindingMark &one : record.findings)
        list.push_back(
            {{"id", one.id}, {"severity", severityName(one.severity)}, {"shot", one.shot}});
    return list;
}

RecordJson stampsJson(const SensorOutcome &record)
{
    RecordJson list = RecordJson::array();
    for (const InputStamp &one : record.stamps)
        list.push_back({{"bytes", one.bytes}, {"changed_ns", one.changed_ns}});
    return list;
}

std::optional<double> numberOrNone(const RecordJson &value)
{
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

/// The entry of `names` that has this name; throws as the JSON library does if there is none.
template <typename Value, std::size_t count>
Value named(const RecordJson &json, const std::array<Value, count> &values, auto nameOf)
{
    const auto name = json.get<std::string>();
    const auto found
        = std::ranges::find_if(values, [&](Value value) { return nameOf(value) == name; });
    if (found == values.end())
        throw RecordJson::other_error::create(501, "no such name", nullptr);
    return *found;
}

SensorState stateNamed(const RecordJson &json)
{
    using enum SensorState;
    constexpr std::array<SensorState, kSensorStates> kStates{
        Done, Cautions, Blocked, Failed, Missing};
    return named(json, kStates, sensorStateName);
}

StatedResult readResult(const RecordJson &json)
{
    return {json.at("quantity"), json.at("value"), json.at("unit"),
        numberOrNone(json.at("u_expanded")), numberOrNone(json.at("k"))};
}

FindingMark readMark(const RecordJson &json)
{
    return {json.at("id"), named(json.at("severity"), kSeverities, severityName), json.at("shot")};
}

InputStamp readStamp(const RecordJson &json)
{
    return {json.at("bytes"), json.at("changed_ns")};
}

template <typename Value>
std::vector<Value> listOf(
    const RecordJson &json, const char *key, Value (*read)(const RecordJson &))
{
    std::vector<Value> list;
    for (const RecordJson &one : json.at(key))
        list.push_back(read(one));
    return list;
}

/// Throws what the JSON library throws where something is missing or of another type.
SensorOutcome readRecord(const RecordJson &json)
{
    return {json.at("key"), stateNamed(json.at("state")), json.at("reason"),
        listOf(json, "results", readResult), listOf(json, "findings", readMark),
        listOf(json, "inputs", readStamp), messageOfJson(json.value("message", RecordJson()))};
}

} // namespace

const char *sensorStateName(SensorState state)
{
    return kStateNames[static_cast<std::size_t>(state)];
}

SensorOutcome recordOf(const PipelineOutcome &outcome, const std::string &key)
{
    SensorOutcome record{key, SensorState::Blocked, {}, {}, {}, {}};
    const Findings findings = allFindings(outcome);
    for (const Finding &finding : findings)
        record.findings.push_back({finding.id, finding.severity, finding.shot});
    if (const std::optional<Error> obstacle = publicationObstacle(outcome)) {
        record.reason = english(obstacle->message);
        record.said = keptMessage(obstacle->message);
        return record;
    }
    record.state = stateOfFindings(findings);
    record.results = keyResults(outcome.results);
    return record;
}

std::string recordText(const SensorOutcome &record)
{
    RecordJson json{{"schema", kRecordSchema}, {"key", record.key},
        {"state", sensorStateName(record.state)}, {"reason", record.reason},
        {"results", resultsJson(record)}, {"findings", marksJson(record)},
        {"inputs", stampsJson(record)}};
    if (!record.said.text.empty())
        json["message"] = messageJson(record.said);
    return jsonText(json);
}

std::optional<SensorOutcome> parseRecord(std::string_view text)
{
    const RecordJson json = RecordJson::parse(text, nullptr, false);
    try {
        if (json.is_object() && json.value("schema", "") == kRecordSchema)
            return readRecord(json);
    } catch (const RecordJson::exception &) { // of another form: no record
    }
    return std::nullopt;
}

} // namespace dyncal
