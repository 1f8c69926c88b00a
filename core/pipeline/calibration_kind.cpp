// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/calibration_kind.h"

#include <algorithm>

namespace dyncal {
namespace {

CalibrationKind intendedKind(const Recipe &recipe)
{
    if (recipe.shock.step_Pa != ShockSettings().step_Pa)
        return CalibrationKind::TypedStep;
    return recipe.shock.enabled ? CalibrationKind::ComputedStep : CalibrationKind::UnknownStep;
}

} // namespace

const char *calibrationKindName(CalibrationKind kind)
{
    switch (kind) {
    case CalibrationKind::ComputedStep:
        return "computed-step";
    case CalibrationKind::TypedStep:
        return "typed-step";
    case CalibrationKind::Transducer:
        return "reference-transducer";
    case CalibrationKind::UnknownStep:
        return "unknown-step";
    case CalibrationKind::FreeDecay:
        break;
    }
    return "free-decay";
}

CalibrationKind calibrationKind(const CalibrationResults &results, const Recipe &recipe)
{
    const ResponseTreatment treatment
        = results.input ? results.input->treatment : recipe.input.treatment;
    if (!isStepTreatment(treatment))
        return CalibrationKind::FreeDecay;
    if (recipe.comparison.enabled && recipe.response.isByTransducer())
        return CalibrationKind::Transducer;
    if (!results.shock)
        return intendedKind(recipe);
    const auto count
        = [&](auto &&counts) { return std::ranges::count_if(results.shock->shots, counts); };
    const auto known = count([](const ShockConditions &shot) { return shot.step_Pa.has_value(); });
    const auto typed = count(
        [](const ShockConditions &shot) { return shot.step_Pa.has_value() && shot.stepTyped; });
    if (known == 0)
        return CalibrationKind::UnknownStep;
    return typed == known ? CalibrationKind::TypedStep : CalibrationKind::ComputedStep;
}

const ShockConditionsSet *stepsUsed(const CalibrationResults &results, const Recipe &recipe)
{
    return results.reference && results.shock
        ? &stepsUsed(*results.reference, *results.shock, recipe.response)
        : results.shock.get();
}

} // namespace dyncal
