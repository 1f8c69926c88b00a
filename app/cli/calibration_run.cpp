// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/calibration_run.h"

#include "app/cli/calibration.h"
#include "app/cli/run_output.h"

#include "ui/report/report_logo.h"

namespace dyncal {
namespace {

/// Whether an error leaves results that are worth keeping: the data were at fault, not the call.
bool keepsResults(const Error &error)
{
    return error.kind == ErrorKind::DataBlocked;
}

Result<CaptureSet> acceptedCaptures(const CalibrationRun &run)
{
    Result<CaptureSet> set = readForCalibration(run.files, run.recipe);
    if (!set || !run.accept)
        return set;
    if (const Result<void> accepted = run.accept(*set); !accepted)
        return tl::unexpected<Error>(accepted.error());
    return set;
}

} // namespace

Result<FinishedRun> calibrateInto(const CalibrationRun &run)
{
    const Result<ChosenTemplate> chosen = drawableTemplate(run.recipe.certificate.templateName);
    if (!chosen)
        return tl::unexpected<Error>(chosen.error());
    const Result<CaptureSet> set = acceptedCaptures(run);
    if (!set)
        return tl::unexpected<Error>(set.error());
    Result<FolderWrite> folder = FolderWrite::begin(runFolder(run.output, *set, run.settings));
    if (!folder)
        return tl::unexpected<Error>(folder.error());
    PipelineOutcome outcome = calibrate(*set, run.recipe);
    if (outcome.error && !keepsResults(*outcome.error))
        return tl::unexpected<Error>(*outcome.error);
    const std::string record = run.record ? run.record(outcome) : std::string();
    Result<std::vector<std::string>> paths
        = writeRun(outcome, run.recipe, run.createdUtc, *chosen, *folder, record);
    if (!paths)
        return tl::unexpected<Error>(paths.error());
    return FinishedRun{std::move(outcome), std::move(*paths)};
}

} // namespace dyncal
