// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/model_stages.h"

#include "core/pipeline/nuisance_stage.h"
#include "core/pipeline/shock_stage.h"
#include "core/pipeline/tube_mode_poles.h"
#include "core/realization/model/model_fit.h"
#include "core/shock/peak_tracking.h"
#include "core/uncertainty/capability.h"
#include "core/uncertainty/known_values.h"

#include <algorithm>
#include <iterator>

namespace dyncal {
namespace {

/// That of the run, or a new one: the comparison of orders starts from an earlier result.
Result<std::shared_ptr<const ReferenceStageResult>> referenceOf(
    const CalibrationResults &results, const Recipe &recipe, const ShockConditionsSet &shock)
{
    if (results.reference)
        return results.reference;
    return referenceStage(results.captures->set, *results.window, shock, recipe)
        .map([](ReferenceStageResult made) {
            return std::make_shared<const ReferenceStageResult>(std::move(made));
        });
}

} // namespace

Index orderOf(const CalibrationResults &results, const Recipe &recipe)
{
    return recipe.realization.order.value.value_or(results.decomposition->suggestion.order);
}

Result<SensorModel> modelStage(
    const CalibrationResults &results, const Recipe &recipe, Index order, const JobControl &control)
{
    const SpectrumResult spectrum = sensorSpectrum(results, recipe);
    auto model = fitModel(*results.input, results.decomposition->hankel, order, recipe.realization,
        spectrum, control);
    if (model) {
        const ShockConditionsSet &shock = results.expected->conditions;
        judgeTubeModes(followPeaks(spectrum, *results.window, shock), shock, *model);
    }
    return model;
}

Result<ShockConditionsSet> shockOfModel(
    const CalibrationResults &results, const Recipe &recipe, const SensorModel &model)
{
    return shockStage(results.captures->set, results.expected->conditions, *results.window,
        *results.spectrum, model, recipe);
}

Result<ResponseResult> responseStage(const CalibrationResults &results, const Recipe &recipe,
    const SensorModel &model, const ShockConditionsSet &shock)
{
    const std::vector<WindowedResponse> &responses = results.window->responses;
    const auto ended = recordsBefore(results.input->echoes, responses);
    const auto reference = referenceOf(results, recipe, shock);
    if (!reference)
        return tl::unexpected(reference.error());
    return computeResponse(ended ? *ended : responses, *results.input, model,
        stepsUsed(**reference, shock, recipe.response), recipe.response, (*reference)->transducer(),
        (*reference)->chainRelative());
}

UncertaintyReport uncertaintyOfResponse(
    const CalibrationResults &results, const Recipe &recipe, const ResponseResult &response)
{
    UncertaintyReport report
        = reportUncertainty(*results.input, *results.model, *results.assessment, response,
            stepsUsed(*results.reference, *results.shock, recipe.response),
            uncertaintyRequest(recipe.uncertainty).stated);
    holdToCapability(recipe.uncertainty.cmc, response, report);
    report.known = compareKnown(
        recipe.response.known, response, report, {*results.model, results.input->treatment});
    std::ranges::move(judgeKnown(report.known), std::back_inserter(report.findings));
    return report;
}

Result<ChainMonteCarlo> drawnChain(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control)
{
    const ShockConditionsSet steps = stepsUsed(*results.reference, *results.shock, recipe.response);
    const auto stated = uncertaintyRequest(recipe.uncertainty).stated;
    const SpectrumResult spectrum = sensorSpectrum(results, recipe);
    const FitAgain fitAgain = [&](const ModelInput &input, const JobControl &ofRefit) {
        return fitModel(input, results.decomposition->hankel, results.model->order,
            recipe.realization, spectrum, ofRefit);
    };
    return chainMonteCarlo({*results.input, *results.model, *results.assessment, *results.response,
                               steps, *results.uncertainty, stated},
        recipe.uncertainty, fitAgain, control);
}

} // namespace dyncal
