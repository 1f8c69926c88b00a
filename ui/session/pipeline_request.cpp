// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/pipeline_request.h"

#include "core/pipeline/stage_keys.h"

namespace dyncal {

PipelineOutcome PipelineRequest::run(StageId upTo, const JobControl &control) const
{
    return pipeline(
        captures, isFirstTriplets ? withFirstTriplets(recipe) : recipe, *cache, upTo, control);
}

bool PipelineRequest::wantsFirstTriplets(StageId upTo, const JobControl &control) const
{
    if (hasWholeSet || upTo < StageId::Decomposition)
        return false;
    const std::string key = decompositionKey(*captures, recipe);
    if (key == wholeSet || cache->find<void>(key))
        return false;
    const PipelineOutcome before = pipeline(captures, recipe, *cache, StageId::ModelInput, control);
    return before.results.input
        && firstTripletsComeEarlier(*before.results.input, recipe.realization);
}

std::string decompositionKey(const CaptureSet &captures, const Recipe &recipe)
{
    return stageKeys(captures, recipe)[static_cast<std::size_t>(StageId::Decomposition)];
}

} // namespace dyncal
