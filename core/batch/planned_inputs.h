// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/batch/batch_plan.h"
#include "core/batch/sensor_outcome.h"
#include "core/capture/capture_set.h"
#include "core/project/recipe.h"

#include <string>
#include <vector>

namespace dyncal {

/// The paths of the sensor's files, in their order. Fails (FileUnreadable) if its source does not
/// hold the planned files and no others: it changed since.
Result<std::vector<std::string>> plannedPaths(
    const std::string &planFolder, const PlannedSensor &sensor);

/// The stamps of the files as they were read into `set` (sealed). Fails (FileUnreadable) if one,
/// read or left out, is not the planned one.
Result<std::vector<InputStamp>> checkReadInputs(
    const CaptureSet &set, const std::vector<std::string> &paths, const PlannedSensor &sensor);

/// Fails (FileUnreadable) if a file is not the planned one. Content is read only where size or time
/// of change are not those of `known` (in the order of the files).
Result<void> checkKnownInputs(const std::vector<InputStamp> &known,
    const std::vector<std::string> &paths, const PlannedSensor &sensor);

/// The recipe of the sensor, for a program that runs in the plan's folder; a template's file is
/// named by where it is (locateTemplate). Fails as readRecipeFiles and hashOfRecipe, and
/// (FileUnreadable) if it, or its template, is not the planned one.
Result<Recipe> plannedRecipe(const PlannedSensor &sensor);

} // namespace dyncal
