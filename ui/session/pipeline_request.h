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
};

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

    PipelineOutcome run(StageId upTo, const JobControl &control) const;

    /// Whether a run up to `upTo` had better be of the first triplets. Runs the stages before the
    /// decomposition, which tell how long the model input is.
    bool wantsFirstTriplets(StageId upTo, const JobControl &control) const;
};

/// The key of the decomposition of a recipe.
std::string decompositionKey(const CaptureSet &captures, const Recipe &recipe);

} // namespace dyncal
