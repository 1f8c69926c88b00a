// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/first_triplets.h"

#include <functional>
#include <memory>
#include <string>

namespace dyncal {

/// The function that computes: runPipeline, or a stand-in of tests.
using PipelineFunction = std::function<PipelineOutcome(const std::shared_ptr<const CaptureSet> &,
    const Recipe &, ResultCache &, StageId last, const JobControl &)>;

/// The results of one run, and whether they are of the first triplets only.
struct RunPart
{
    PipelineOutcome outcome;
    bool isFirstTriplets = false;
    /// The model's own curve, where its response comes in a later part.
    std::shared_ptr<const ResponseResult> modelCurve = {};
};

/// The part, or an outcome with its error: a request to stop, or no memory. Runs of the pipeline
/// throw nothing.
RunPart runPartOf(Result<RunPart> part);

/// All that the session's background jobs need for their runs of the pipeline, as values.
struct PipelineRequest
{
    PipelineFunction pipeline;
    std::shared_ptr<ResultCache> cache;
    std::shared_ptr<const CaptureSet> captures;
    Recipe recipe;
    std::string wholeSet; ///< of the whole decomposition made last, even if not in the cache
    bool hasWholeSet = false; ///< the results on show come from the recipe's decomposition
    bool isFirstTriplets = false;
    std::shared_ptr<const ResponseResult> response = {}; ///< on show, perhaps of an earlier run
    std::string responseKey = {}; ///< its own

    PipelineOutcome run(StageId upTo, const JobControl &control) const;

    /// Whether a run up to `upTo` should begin with the first triplets. Runs the stages before the
    /// decomposition, which tell how long the model input is.
    bool wantsFirstTriplets(StageId upTo, const JobControl &control) const;

    /// The curve of the model in `part`, over the range of the response on show, which is of
    /// another model; null if it is not needed, or if the data for it are missing.
    std::shared_ptr<const ResponseResult> modelCurve(const CalibrationResults &part) const;
};

/// The key of the decomposition of a recipe.
std::string decompositionKey(const CaptureSet &captures, const Recipe &recipe);

} // namespace dyncal
