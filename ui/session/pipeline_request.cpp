// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/pipeline_request.h"

#include "core/model_analysis/sensor_response.h"
#include "core/pipeline/calibration_kind.h"
#include "core/pipeline/stage_keys.h"

namespace dyncal {

RunPart runPartOf(Result<RunPart> part)
{
    return part ? std::move(*part) : RunPart{{{}, part.error(), StageId::Captures}, false};
}

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

std::shared_ptr<const ResponseResult> PipelineRequest::modelCurve(
    const CalibrationResults &part) const
{
    if (!response || part.response || !part.model || !part.input || !part.window || !part.shock
        || responseKey == part.keys[static_cast<std::size_t>(StageId::Response)])
        return nullptr;
    return std::make_shared<const ResponseResult>(computeModelResponse(part.window->responses,
        *part.input, *part.model, *stepsUsed(part, recipe), recipe.response, response->fLow_Hz,
        response->fHigh_Hz, part.reference ? part.reference->chainRelative() : nullptr));
}

std::string decompositionKey(const CaptureSet &captures, const Recipe &recipe)
{
    return stageKeys(captures, recipe)[static_cast<std::size_t>(StageId::Decomposition)];
}

} // namespace dyncal
