// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/nuisance_stage.h"

#include "core/realization/nuisance_modes.h"

namespace dyncal {
namespace {

/// Sound speed behind the reflected shock, per shot of the set where known.
std::vector<std::optional<double>> soundSpeeds_m_s(
    const CalibrationResults &results, const Recipe &recipe)
{
    if (results.input)
        return results.input->soundSpeeds_m_s;
    std::vector<std::optional<double>> speeds(results.captures->set.shots.size());
    if (!recipe.shock.enabled || recipe.realization.nuisanceModes.empty())
        return speeds;
    std::vector<DutArrival> arrivals;
    for (const WindowedResponse &response : results.window->responses)
        arrivals.push_back({response.shot, response.start_s});
    const auto shock = estimateShockConditions(results.captures->set, arrivals, recipe.shock);
    for (std::size_t i = 0; shock && i < speeds.size(); ++i) {
        const ShockConditions *shot = shock->ofShot(static_cast<Index>(i) + 1);
        if (shot && shot->states)
            speeds[i] = shot->states->reflected.soundSpeed_m_s;
    }
    return speeds;
}

} // namespace

SpectrumResult sensorSpectrum(const CalibrationResults &results, const Recipe &recipe)
{
    return withoutNuisancePeaks(*results.spectrum, results.window->responses,
        recipe.realization.nuisanceModes, soundSpeeds_m_s(results, recipe));
}

Result<ModelInput> separatedInput(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control)
{
    const std::vector<WindowedResponse> &responses = results.window->responses;
    auto input = prepareModelInput(
        responses, sensorSpectrum(results, recipe), *results.components, recipe.input, control);
    if (input)
        separateNuisance(*input, responses, recipe.realization.nuisanceModes,
            soundSpeeds_m_s(results, recipe), control);
    return input;
}

} // namespace dyncal
