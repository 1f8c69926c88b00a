// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// Stages before the model that are put together from several steps. `results` must hold all
/// earlier results.
Result<PreparedCaptures> prepareCaptures(const CaptureSet &captures, const Recipe &recipe);
Result<WindowResult> windowStage(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control);
Result<DecompositionResult> decompositionStage(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control);

} // namespace dyncal
