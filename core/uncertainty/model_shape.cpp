// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/model_shape.h"

namespace dyncal {

SensorModel withAmplitudes(const SensorModel &model,
    const std::function<std::complex<double>(std::complex<double> s_rad_s)> &factor)
{
    SensorModel changed;
    changed.order = model.order;
    changed.poles = model.poles;
    changed.slowPoles = model.slowPoles;
    changed.plateauGain = model.plateauGain;
    changed.stepLevel = model.stepLevel;
    changed.amplitudes = model.amplitudes;
    changed.sensorStep = model.sensorStep;
    for (Index i = 0; i < changed.amplitudes.size(); ++i)
        changed.amplitudes[i] *= factor(model.poles[static_cast<std::size_t>(i)].s_rad_s);
    for (Index i = 0; i < changed.sensorStep.amplitudes.size(); ++i)
        changed.sensorStep.amplitudes[i] *= factor(model.sensorStep.poles_rad_s[i]);
    return changed;
}

SensorModel withMounting(const SensorModel &model, double mounting)
{
    return withAmplitudes(
        model, [=](std::complex<double>) { return std::complex<double>(1.0 / (1.0 + mounting)); });
}

} // namespace dyncal
