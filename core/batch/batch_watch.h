// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/batch/batch_plan.h"
#include "core/batch/batch_tally.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A sensor of a batch at one moment.
struct SensorNow
{
    SensorStanding standing;
    bool isRunning = false; ///< some program computes it; asked only of what is missing or failed

    bool operator==(const SensorNow &) const = default;
};

/// A batch at one moment, whoever works on it.
struct BatchMoment
{
    std::shared_ptr<const BatchPlan> plan;
    InputStamp stamp; ///< of the plan's file as it was read
    std::vector<SensorNow> sensors; ///< in the order of the plan
};

/// Reads where all sensors of the plan at `planPath` stand now (recordOnDisk). The plan is that of
/// `before` as long as its file has the same size and time of change, else it is read anew. Fails
/// as readPlan, and (Cancelled) where that is asked for.
Result<BatchMoment> batchNow(
    const std::string &planPath, const BatchMoment &before, const JobControl &control = {});

/// How many sensors stand where; running ones are counted as what their files say.
BatchTally tallyOf(const BatchMoment &moment);

/// Whether `a` needs to be seen before `b`: failed, blocked, cautions, running, missing, done; of
/// those that stand alike, the one with more findings that block, then with more cautions. A strict
/// weak order.
bool isWorse(const SensorNow &a, const SensorNow &b);

/// The first finding of the worst severity; none if there is no finding.
std::optional<FindingMark> worstFinding(const SensorOutcome &record);

} // namespace dyncal
