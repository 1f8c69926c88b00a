// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/realization_settings.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// How good a fitted model is: uncertainties and remaining flags of its poles, the fits to each
/// shot and level with the test whether the shots share their poles, the effect of the nuisance
/// modes, the second-order sensor (docs/method/model.md). `fitted` must be the result of fitModel()
/// for this input and these settings. Fails only when cancelled.
Result<ModelAssessment> assessModel(const ModelInput &input, const SensorModel &fitted,
    const RealizationSettings &settings, const JobControl &control = {});

} // namespace dyncal
