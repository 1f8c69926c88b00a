// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/monte_carlo/chain_monte_carlo.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The stages after the decomposition, for a run and for the comparison of orders. `results` must
/// hold all earlier results.
Result<SensorModel> modelStage(const CalibrationResults &results, const Recipe &recipe, Index order,
    const JobControl &control);
Result<ShockConditionsSet> shockOfModel(
    const CalibrationResults &results, const Recipe &recipe, const SensorModel &model);
Result<ResponseResult> responseStage(const CalibrationResults &results, const Recipe &recipe,
    const SensorModel &model, const ShockConditionsSet &shock);

UncertaintyReport uncertaintyOfResponse(
    const CalibrationResults &results, const Recipe &recipe, const ResponseResult &response);

/// Second propagation of what uncertaintyOfResponse() has reported.
Result<ChainMonteCarlo> drawnChain(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control);

/// The order a run takes: the recipe's, or the suggested one.
Index orderOf(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal
