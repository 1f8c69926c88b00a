// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/front.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/model_variation.h"
#include "core/uncertainty/reported_value.h"

#include <vector>

namespace dyncal {

/// |c_i| at the onset of each of polesOf(), in their order and in the model's unit, with its lines:
/// "noise", what the refinement's covariance does, wider in the proportion in which this pole's
/// frequency and damping are; and the front, as in modelValues(). Without u where the model was not
/// refined, and of a pole of the step's own.
std::vector<ReportedValue> poleAmplitudes(const SensorModel &model,
    const ModelAssessment &assessment, const std::vector<ModelVariation> &variations,
    const FrontDuration &front);

} // namespace dyncal
