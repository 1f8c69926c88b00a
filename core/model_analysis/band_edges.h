// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/step_characteristics.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// Puts the band edges of a model into `result`: the lowest frequencies at which |S(f)/S(0)| leaves
/// 1 +- 5 %, 1 +- 10 %, and falls below 1/sqrt(2); empty where it does not. The poles all decay,
/// the treatment is of a step, the plateau is not 0. Looked for at 400 points per decade, from 1e-3
/// of the slowest to 20 times the fastest pole, and at every resonance, which may be narrower than
/// their spacing; then by bisection. The sensor's own part where the model has slow poles.
void describeBands(
    const SensorModel &model, ResponseTreatment treatment, StepCharacteristics &result);

} // namespace dyncal
