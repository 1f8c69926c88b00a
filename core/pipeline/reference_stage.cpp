// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/reference_stage.h"

#include "core/model_analysis/transducer_steps.h"

#include <utility>

namespace dyncal {
namespace {

Result<void> checkAsked(const Recipe &recipe)
{
    if (!recipe.comparison.enabled && recipe.response.isByTransducer())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "response.reference is \"transducer\", but comparison.enabled is false; switch the comparison on and say what the reference transducer is."),
                {}});
    if (recipe.comparison.enabled && !isStepTreatment(recipe.input.treatment))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "A comparison with a reference transducer needs the response to a step; with input.treatment \"impulse\" switch comparison.enabled off."),
                {}});
    return {};
}

} // namespace

Result<ReferenceStageResult> referenceStage(const CaptureSet &set, const WindowResult &window,
    const ShockConditionsSet &shock, const Recipe &recipe)
{
    if (const Result<void> asked = checkAsked(recipe); !asked)
        return tl::unexpected(asked.error());
    ReferenceStageResult result;
    Result<std::optional<ChainResponse>> chain = chainResponse(recipe.chain);
    if (!chain)
        return tl::unexpected(chain.error());
    result.chain = std::move(*chain);
    if (!recipe.comparison.enabled)
        return result;
    Result<ReferenceRecords> records
        = referenceRecords(set, window.responses, recipe.comparison, recipe.checks);
    if (!records)
        return tl::unexpected(records.error());
    result.steps
        = stepsByTransducer(*records, shock, uncertaintyRequest(recipe.uncertainty).stated);
    result.records = std::move(*records);
    return result;
}

const ShockConditionsSet &stepsUsed(const ReferenceStageResult &reference,
    const ShockConditionsSet &shock, const ResponseSettings &settings)
{
    return settings.isByTransducer() && reference.records ? reference.steps : shock;
}

} // namespace dyncal
