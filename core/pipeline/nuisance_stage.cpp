// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/nuisance_stage.h"

#include "core/realization/input/input_preparation.h"
#include "core/realization/input/left_out.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_separation.h"

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

} // namespace

SpectrumResult sensorSpectrum(const CalibrationResults &results, const Recipe &recipe)
{
    return withoutNuisancePeaks(*results.spectrum, results.window->responses,
        recipe.realization.nuisanceModes, soundSpeeds_m_s(results));
}

Result<ModelInput> separatedInput(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control)
{
    const std::vector<WindowedResponse> &responses = results.window->responses;
    auto input = prepareModelInput(responses, sensorSpectrum(results, recipe), *results.components,
        recipe.input, {recipe.shock.frontDuration_s, recipe.shock.u_frontDuration_s}, control);
    if (!input)
        return input;
    if (auto marked = leaveOut(*input, responses, recipe.window.excludeStretches); !marked)
        return tl::unexpected(marked.error());
    separateNuisance(
        *input, responses, recipe.realization.nuisanceModes, soundSpeeds_m_s(results), control);
    return input;
}

} // namespace dyncal
