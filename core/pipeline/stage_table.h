// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <memory>
#include <optional>

namespace dyncal {

/// What a stage is computed from; the results hold those of the stages that it follows.
struct StageInputs
{
    const CaptureSet &captures;
    const Recipe &recipe;
    const CalibrationResults &results;
    const JobControl &control;
};

/// How a stage's result is computed, and where it is kept.
struct StageResult
{
    using Any = std::shared_ptr<const void>;
    Result<Any> (*compute)(const StageInputs &inputs);
    Any (*get)(const CalibrationResults &results);
    void (*put)(CalibrationResults &results, const Any &result);
};

/// What the program knows of a stage: one line of the table for each.
struct Stage
{
    StageId id;
    const char *name; ///< in messages and results.json
    int method; ///< raised whenever its numbers change on purpose; docs/accuracy.md names them
    double cost_ms; ///< of the example, roughly: its share of the progress
    const char
        *findings; ///< what the ids of its findings begin with; empty: it has none of its own
    StageId follows; ///< its result depends on all stages up to this, and on itself
    StageId shownWith; ///< the stage on whose page it is seen
    bool awaited; ///< that page is done only with it
    void (*read)(const Recipe &recipe, Recipe &part); ///< copies the sections it reads
    StageResult result;
    Findings (*findingsOf)(const CalibrationResults &results);
};

const Stage &stageOf(StageId id);

const char *stageName(StageId id);

/// The stage whose findings have ids like this one ("WIN-001" -> Window); empty if there is none.
std::optional<StageId> stageOfFinding(const std::string &id);

bool hasResult(const CalibrationResults &results, StageId id);
Findings findingsOf(const CalibrationResults &results, StageId id); ///< none without a result

/// Findings of all stages in their order, without repetitions.
Findings allFindings(const CalibrationResults &results);

/// The share (0 to 1, by the costs of the stages) of a run up to `last` that is done after `id`.
double progressAfter(StageId id, StageId last);

} // namespace dyncal
