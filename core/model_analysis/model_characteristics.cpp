// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/model_characteristics.h"

#include "core/model_analysis/band_edges.h"
#include "core/model_analysis/normalised_step.h"
#include "core/model_analysis/step_scan.h"

namespace dyncal {
namespace {

bool hasStepResponse(const SensorModel &model, ResponseTreatment treatment)
{
    if (!isStepTreatment(treatment) || model.diverges || model.level() == 0.0)
        return false;
    const Eigen::VectorXcd poles = normalisedStep(model).poles_rad_s;
    return poles.size() > 0 && (poles.array().real() < 0.0).all();
}

} // namespace

StepCharacteristics stepCharacteristics(const SensorModel &model, ResponseTreatment treatment)
{
    if (!hasStepResponse(model, treatment))
        return {};
    StepCharacteristics result = describedStep(normalisedStep(model), kSettledRange);
    describeBands(model, treatment, result);
    return result;
}

std::optional<double> settlingTime_s(
    const SensorModel &model, ResponseTreatment treatment, double settled)
{
    if (!hasStepResponse(model, treatment))
        return std::nullopt;
    return describedStep(normalisedStep(model), settled).settlingTime_s;
}

} // namespace dyncal
