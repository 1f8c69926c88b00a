// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/shot_levels.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kLargestLevelUncertainty
    = 0.1; ///< relative: a level known no better is not stated, nor what is divided by it

/// The step in the unit of the values: 1 where they are remapped.
double stepOf(const WindowedResponse &response)
{
    return response.step / response.valueScale;
}

/// The budget of a shot's step; null where there is none.
const StepUncertainty *stepUncertainty(const ShockConditions *conditions)
{
    return conditions && conditions->uncertainty ? &*conditions->uncertainty : nullptr;
}

ShotSensitivity sensitivityOfShot(const WindowedResponse &response,
    const std::vector<WindowedResponse> &responses, const SensorModel &model,
    const ShockConditions *conditions)
{
    ShotSensitivity shot;
    shot.shot = response.shot;
    shot.unit = response.unit + "/Pa";
    shot.level = response.level;
    const SeriesFit *fit = fitOfShot(model, response.shot);
    if (!fit || model.diverges)
        return shot;
    // The level has its noise whether anybody knows the step or not.
    shot.uLevel_relative = std::abs(fit->u_level() / fit->level());
    if (!conditions || !conditions->step_Pa)
        return shot;
    shot.step_Pa = conditions->step_Pa;
    if (shot.uLevel_relative > kLargestLevelUncertainty)
        return shot;
    shot.sensitivity
        = levelOf(*fit, response, responses) * response.valueScale / *conditions->step_Pa;
    if (const StepUncertainty *step = stepUncertainty(conditions))
        addUncertainty(step, model.draft.noise.dof, shot);
    return shot;
}

} // namespace

const SeriesFit *fitOfShot(const SensorModel &model, Index shot)
{
    for (const SeriesFit &fit : model.series) {
        if (fit.shot == shot || fit.shot == 0)
            return &fit;
    }
    return nullptr;
}

bool shareOneUnit(const std::vector<WindowedResponse> &responses)
{
    return std::all_of(responses.begin(), responses.end(),
        [&](const WindowedResponse &response) { return response.unit == responses.front().unit; });
}

double plateauOf(const SeriesFit &fit, const WindowedResponse &response,
    const std::vector<WindowedResponse> &responses)
{
    if (fit.shot != 0)
        return fit.plateauGain;
    double mean = 0.0;
    for (const WindowedResponse &other : responses)
        mean += stepOf(other) / static_cast<double>(responses.size());
    return fit.plateauGain * stepOf(response) / mean;
}

double levelOf(const SeriesFit &fit, const WindowedResponse &response,
    const std::vector<WindowedResponse> &responses)
{
    if (fit.shot != 0)
        return fit.level();
    if (fit.level() == fit.plateauGain)
        return plateauOf(fit, response, responses);
    return fit.level() / fit.plateauGain * plateauOf(fit, response, responses);
}

bool isLevelKnown(const SensorModel &model)
{
    return std::ranges::none_of(model.series, [](const SeriesFit &fit) {
        return fit.u_level() > kLargestLevelUncertainty * std::abs(fit.level());
    });
}

ShotSensitivities describeShots(const std::vector<WindowedResponse> &responses,
    const SensorModel &model, const ShockConditionsSet &shock)
{
    ShotSensitivities result;
    std::vector<const StepUncertainty *> steps;
    for (const WindowedResponse &response : responses) {
        const ShockConditions *conditions = shock.ofShot(response.shot);
        steps.push_back(stepUncertainty(conditions));
        result.shots.push_back(sensitivityOfShot(response, responses, model, conditions));
    }
    if (!shareOneUnit(responses)) {
        result.findings.push_back({.id = "CAP-023",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "The shots are recorded in different units, so their sensitivities are not averaged; give one unit for all (import.unit)."),
                {}}});
        return result;
    }
    result.summary = summarise(result.shots, steps);
    result.findings = result.summary.findings;
    return result;
}

} // namespace dyncal
