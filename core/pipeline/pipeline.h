// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/pipeline/calibration_results.h"
#include "core/pipeline/result_cache.h"
#include "core/project/recipe.h"

#include <memory>
#include <optional>

namespace dyncal {

/// What a run produced; all results before the failing stage exist.
struct PipelineOutcome
{
    CalibrationResults results;
    std::optional<Error> error;
    StageId failedStage = StageId::Captures; ///< meaningful with an error
};

/// The method: the stages of stage_table.cpp, one after the other. The window and the command line
/// both call this, so their numbers are the same. Results whose inputs have not
/// changed come from the cache. Never throws; a lack of memory is an Error of kind Internal.
PipelineOutcome runPipeline(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId last = kLastStage, const JobControl &control = {});

} // namespace dyncal
