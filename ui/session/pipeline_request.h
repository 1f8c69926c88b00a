// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/first_triplets.h"

#include <functional>
#include <memory>
#include <string>

namespace dyncal {

/// What computes: runPipeline, or a stand-in of tests.
using PipelineFunction = std::function<PipelineOutcome(const std::shared_ptr<const CaptureSet> &,
    const Recipe &, ResultCache &, StageId last, const JobControl &)>;

/// What one run has given, and whether of the first triplets only.
struct RunPart
{
    PipelineOutcome outcome;
    bool isFirstTriplets = false;
    /// The model's own curve, where its response comes in a later part.
    std::shared_ptr<const ResponseResult> modelCurve = {};
};

/// Runs of the pipeline throw nothing: without a part there was a request to stop, or no memory.
RunPart runPartOf(Result<RunPart> part);

/// All that the session's background jobs need for their runs of the pipeline, as values.
struct PipelineRequest
{
    PipelineFunction pipeline;
    std::shared_ptr<ResultCache> cache;
    std::shared_ptr<const CaptureSet> captures;
    Recipe recipe;
    std::string wholeSet; ///< key of a whole decomposition made, were it no longer in the cache
    bool hasWholeSet = false; ///< the results on show are of the recipe's decomposition
    bool isFirstTriplets = false;
    std::shared_ptr<const ResponseResult> response = {}; ///< on show, perhaps of an earlier run
    std::string responseKey = {}; ///< its own

    PipelineOutcome run(StageId upTo, const JobControl &control) const;

    /// Whether a run up to `upTo` had better be of the first triplets. Runs the stages before the
    /// decomposition, which tell how long the model input is.
    bool wantsFirstTriplets(StageId upTo, const JobControl &control) const;

    /// The curve of the model in `part`, over the range of the response on show, which is of
    /// another model; null where there is no need of it or not enough for it.
    std::shared_ptr<const ResponseResult> modelCurve(const CalibrationResults &part) const;
};

/// The key of the decomposition of a recipe.
std::string decompositionKey(const CaptureSet &captures, const Recipe &recipe);

} // namespace dyncal
