// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/nuisance_stage.h"

#include "core/realization/input/echo_cut.h"
#include "core/realization/input/input_preparation.h"
#include "core/realization/input/left_out.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_separation.h"

#include <algorithm>

namespace dyncal {
namespace {

/// Sound speed behind the reflected shock, per shot of the set where known.
std::vector<std::optional<double>> soundSpeeds_m_s(const CalibrationResults &results)
{
    std::vector<std::optional<double>> speeds(results.captures->set.shots.size());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        const ShockConditions *shot
            = results.expected->conditions.ofShot(static_cast<Index>(i) + 1);
        if (shot && shot->states)
            speeds[i] = shot->states->reflected.soundSpeed_m_s;
    }
    return speeds;
}

/// An end that was set is the operator's answer to what lies behind it.
bool endsAreAutomatic(const std::vector<WindowedResponse> &responses, const Recipe &recipe)
{
    return !recipe.input.samples.value && recipe.input.effectiveCombine() == CombineMethod::Stacked
        && std::ranges::none_of(responses, [&](const WindowedResponse &response) {
               return recipe.window.endOfShot_s(response.shot).value.has_value();
           });
}

Echoes echoesIn(const std::vector<WindowedResponse> &responses, const SpectrumResult &spectrum,
    const Recipe &recipe, const JobControl &control)
{
    if (recipe.input.treatment != ResponseTreatment::StepDeflated
        && recipe.input.treatment != ResponseTreatment::Differenced)
        return {};
    return findEchoes(
        responses, sensorTraits(responses, spectrum), endsAreAutomatic(responses, recipe), control);
}

Result<ModelInput> inputOf(const std::vector<WindowedResponse> &responses,
    const SpectrumResult &spectrum, const CalibrationResults &results, const Recipe &recipe,
    const JobControl &control)
{
    auto input = prepareModelInput(responses, spectrum, *results.components, recipe.input,
        {recipe.shock.frontDuration_s, recipe.shock.u_frontDuration_s}, control);
    if (!input)
        return input;
    if (auto marked = leaveOut(*input, responses, recipe.window.excludeStretches); !marked)
        return tl::unexpected(marked.error());
    separateNuisance(
        *input, responses, recipe.realization.nuisanceModes, soundSpeeds_m_s(results), control);
    return input;
}

} // namespace

std::optional<std::vector<WindowedResponse>> recordsBefore(
    const Echoes &echoes, const std::vector<WindowedResponse> &responses)
{
    if (!echoes.recordsEnd_s)
        return std::nullopt;
    return endingAt(responses, *echoes.recordsEnd_s);
}

SpectrumResult sensorSpectrum(const CalibrationResults &results, const Recipe &recipe)
{
    return withoutNuisancePeaks(*results.spectrum, results.window->responses,
        recipe.realization.nuisanceModes, soundSpeeds_m_s(results));
}

Result<ModelInput> separatedInput(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control)
{
    const SpectrumResult spectrum = sensorSpectrum(results, recipe);
    const std::vector<WindowedResponse> &responses = results.window->responses;
    const Echoes echoes = echoesIn(responses, spectrum, recipe, control);
    const auto ended = recordsBefore(echoes, responses);
    auto input = inputOf(ended ? *ended : responses, spectrum, results, recipe, control);
    if (!input)
        return input;
    const Findings found = judgeEchoes(echoes);
    input->findings.insert(input->findings.end(), found.begin(), found.end());
    input->echoes = echoes;
    return input;
}

} // namespace dyncal
