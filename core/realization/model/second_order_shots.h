// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// compareShots() of a model that is the second-order sensor: shots and levels fitted for
/// themselves by that sensor, and the test
///     Q = sum over shots of (theta_j - m)^T V_j^-1 (theta_j - m),   theta = (ln w0, ln zeta),
/// because near critical damping the poles of one shot are a pair and of another two real ones.
/// `assessment.poles` and `assessment.secondOrder` must be those of the model. Where the test fails
/// the uncertainties of f0 and zeta, and those of a pair, are the scatter between the shots; of two
/// real poles each alone is then unknown.
void compareSecondOrderShots(const ModelInput &input, const SensorModel &model,
    ModelAssessment &assessment, const JobControl &control);

} // namespace dyncal
