// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/pipeline/pipeline.h"
#include "core/project/recipe.h"

#include <functional>
#include <string>
#include <vector>

namespace dyncal {

/// One calibration from files to a folder of results.
struct CalibrationRun
{
    std::vector<std::string> files;
    Recipe recipe; ///< that names its template's file by where it is (locateTemplate)
    std::vector<std::string> settings; ///< paths of the recipe and profile that were given
    std::string output;
    std::string createdUtc;
    /// Asked once the recordings are read; an error ends the run before anything is computed.
    std::function<Result<void>(const CaptureSet &)> accept = {};
    /// What a batch keeps beside the results (RunFiles::record).
    std::function<std::string(const PipelineOutcome &)> record = {};
};

struct FinishedRun
{
    PipelineOutcome outcome; ///< with an error where the data allow no result; it is written too
    std::vector<std::string> paths; ///< of the files to show
};

/// Reads, computes and writes as one transaction: what `dyncal run` and every sensor of a batch do.
/// Fails as drawableTemplate, readForCalibration, `accept`, FolderWrite and the stages do, unless
/// the data are at fault: that is written down as a result. After a failure the folder is as it
/// was.
Result<FinishedRun> calibrateInto(const CalibrationRun &run);

} // namespace dyncal
