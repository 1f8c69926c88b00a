// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/kept_message.h"
#include "core/capture/capture_set.h"
#include "core/pipeline/pipeline.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// Where a sensor of a batch stands.
enum class SensorState {
    Done, ///< calibrated, nothing to be seen
    Cautions, ///< calibrated, with findings that somebody must see
    Blocked, ///< its data allow no result (exit code 2 of a run)
    Failed, ///< it could not be planned, read or computed
    Missing, ///< not computed yet, or from other inputs
};
inline constexpr int kSensorStates = 5;

const char *sensorStateName(SensorState state); ///< "done", "cautions", ...

/// A key result: value and U = k u, both in `unit` ("" = a number).
struct StatedResult
{
    std::string quantity; ///< as in results.json: "sensitivity", "f0_hz", ...
    double value = 0.0;
    std::string unit;
    std::optional<double> expanded = {}; ///< U; absent where its budget is not complete
    std::optional<double> k = {};

    bool operator==(const StatedResult &) const = default;
};

/// A finding in brief.
struct FindingMark
{
    std::string id;
    Severity severity = Severity::Info;
    Index shot = 0; ///< from 1; 0 = of none in particular

    bool operator==(const FindingMark &) const = default;
};

/// Size and time of change of an input when it was read: while both are the same, its content need
/// not be read again.
struct InputStamp
{
    std::uintmax_t bytes = 0;
    std::int64_t changed_ns = 0;

    bool operator==(const InputStamp &) const = default;
};

/// What a batch keeps of a sensor: beside its results (kBatchRecord), or alone where there are none
/// (kFailureRecord).
struct SensorOutcome
{
    std::string key; ///< sensorKey() of what it was computed from
    SensorState state = SensorState::Missing;
    std::string reason; ///< in one sentence, of what is blocked or failed
    std::vector<StatedResult> results; ///< none of what may not be published
    std::vector<FindingMark> findings; ///< in the order of results.json
    std::vector<InputStamp> stamps; ///< of the planned files, in their order
    KeptMessage said = {}; ///< the reason as it can be translated; none in older records

    bool operator==(const SensorOutcome &) const = default;
};

/// The record of a run that came to results.json; the stamps are the caller's. Key results are what
/// the certificate states with U: sensitivity and the model's values; U is that of the certificate.
SensorOutcome recordOf(const PipelineOutcome &outcome, const std::string &key);

/// JSON, schema "dyncal-batch-record/1".
std::string recordText(const SensorOutcome &record);

/// Empty if the text is no such record.
std::optional<SensorOutcome> parseRecord(std::string_view text);

} // namespace dyncal
