// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/batch/batch_plan.h"
#include "ui/session/capture_reading.h"
#include "ui/session/project_state.h"

#include <string>
#include <vector>

namespace dyncal {

/// A sensor of a batch as a job.
struct OpenedSensor
{
    ProjectState state; ///< without shots where no file could be read
    std::vector<std::string> paths; ///< all that were tried
    std::vector<FileProblem> problems;
};

/// Opens the planned recordings with the planned recipe, so that the job computes what the batch
/// does; a file that cannot be read does not stop the others. Recordings are not sealed: sealing
/// finds one whose bytes are not the planned ones (CAP-015). Fails (DataBlocked) if the sensor
/// could not be planned, and as plannedPaths and plannedRecipe.
Result<OpenedSensor> openSensor(
    const std::string &planFolder, const PlannedSensor &sensor, const JobControl &control = {});

} // namespace dyncal
