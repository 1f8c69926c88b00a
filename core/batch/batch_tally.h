// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/sensor_outcome.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace dyncal {

/// How many sensors of a batch stand where.
struct BatchTally
{
    std::array<std::size_t, kSensorStates> ofState{}; ///< by SensorState

    void add(SensorState state) { ++ofState[static_cast<std::size_t>(state)]; }
    std::size_t count(SensorState state) const { return ofState[static_cast<std::size_t>(state)]; }
    std::size_t total() const;
};

/// "7 sensors: 5 done, 1 with cautions, 1 blocked, 0 failed, 0 missing".
std::string tallyText(const BatchTally &tally);

/// A sensor of a batch and where it stands.
struct SensorStanding
{
    std::string id;
    SensorOutcome record;

    bool operator==(const SensorStanding &) const = default;
};

BatchTally tallyOf(const std::vector<SensorStanding> &standings);

/// JSON, schema "dyncal-batch-status/1": the counts, and id, state and reason of every sensor that
/// is not done, in the order of the plan.
std::string statusJson(const std::vector<SensorStanding> &standings);

} // namespace dyncal
