// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The response against the reference transducer and against the step, whichever of the two the
/// recipe's response is; results.uncertainty and all before it must be there. Nothing unless the
/// comparison is enabled.
Result<ComparisonResult> comparisonStage(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal
