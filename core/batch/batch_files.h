// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/batch/batch_plan.h"
#include "core/batch/batch_tally.h"

#include <string>
#include <vector>

namespace dyncal {

/// Writes the plan. A file of this name is replaced only if it is a plan. Fails (Usage) if it is
/// something else, and as writeFileAtomically.
Result<void> writePlanFile(const std::string &path, const BatchPlan &plan);

/// Where all sensors of the plan stand, in its order (recordOnDisk).
std::vector<SensorStanding> standingsOf(const std::string &planFolder, const BatchPlan &plan);

/// The standings for a summary: results of which files are gone count as missing (looksWhole). With
/// `partial` missing ones are listed, else they are an error (DataBlocked), which names the first.
Result<std::vector<SensorStanding>> standingsToMerge(
    const std::string &planFolder, const BatchPlan &plan, bool partial);

/// Writes batchSummaryCsv(). A file of this name is replaced only if it is such a summary. Fails as
/// writePlanFile.
Result<void> writeSummaryFile(
    const std::string &path, const std::vector<SensorStanding> &standings);

/// Writes the summary of the plan at `planPath`: how many sensors stand where in it. Fails as
/// readPlan, standingsToMerge and writeSummaryFile.
Result<BatchTally> mergeBatch(
    const std::string &planPath, const std::string &summaryPath, bool partial);

} // namespace dyncal
