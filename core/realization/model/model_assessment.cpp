// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_assessment.h"

namespace dyncal {

const std::vector<Pole> &polesOf(const SensorModel &model, const ModelAssessment *assessment)
{
    return assessment ? assessment->poles : model.poles;
}

const Pole *mainPole(const SensorModel &model, const ModelAssessment *assessment)
{
    return mainPole(polesOf(model, assessment), model.series);
}

std::optional<SensorResonance> sensorResonance(
    const SensorModel *model, const ModelAssessment *assessment)
{
    if (!model)
        return std::nullopt;
    if (model->secondOrder) {
        if (!assessment || !assessment->secondOrder)
            return SensorResonance{model->secondOrder->f0_Hz, kUnknown, model->secondOrder->zeta};
        const SecondOrderModel &sensor = *assessment->secondOrder;
        return SensorResonance{
            sensor.f0_Hz, sensor.u_f0_Hz, sensor.zeta, sensor.u_zeta, sensor.coverageFactor};
    }
    const Pole *pole = mainPole(*model, assessment);
    if (!pole)
        return std::nullopt;
    return SensorResonance{pole->frequency_Hz, pole->u_frequency_Hz, pole->dampingRatio,
        pole->u_dampingRatio, pole->coverageFactor};
}

} // namespace dyncal
