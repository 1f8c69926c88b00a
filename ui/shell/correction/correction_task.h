// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/correction/correction_run.h"
#include "core/pipeline/pipeline.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Of a stretch of the recording: both ends, or neither.
struct TypedStretch
{
    std::optional<double> begin_s;
    std::optional<double> end_s;
};

/// What the operator has put into the window, as it stands there.
struct CorrectionChoice
{
    bool isOfProject = true; ///< the calibration: the run of the open project, or a file
    QString results; ///< path of a results.json
    QStringList recordings; ///< paths
    QStringList channels; ///< of these recordings, once they were opened
    QString channel; ///< of the sensor; empty: as the recordings say
    bool isReadAsProject = false; ///< with import settings and checks of the open project
    CorrectionSettings filter;
    TypedStretch window;
    TypedStretch quiet;
    std::optional<double> beyond_Pa;
};

/// The run of the open project, and when it became results.
struct ProjectRun
{
    PipelineOutcome outcome;
    Recipe recipe;
    std::string createdUtc;
};

/// What a job needs: values only.
struct CorrectionTask
{
    std::string results; ///< path; empty: those of `run`
    std::optional<ProjectRun> run;
    std::vector<std::string> recordings;
    Recipe recipe; ///< of which import and checks are used
    CorrectionSettings filter;
    RecordOptions record;
};

/// Of recordings that were prepared: `outcome` is null where the findings say that they hold no
/// pressure.
struct CorrectionReport
{
    Findings findings;
    std::shared_ptr<const CaptureSet> captures;
    std::shared_ptr<const CorrectionOutcome> outcome;
};

/// The recipe that recordings are read by: that of the project or none, with the channel chosen.
Recipe readingRecipe(const CorrectionChoice &choice, const Recipe &project);

/// The choice as a task without its run. Fails (Usage) where something is missing or a stretch has
/// one end or ends in the wrong order.
Result<CorrectionTask> taskOf(const CorrectionChoice &choice, const Recipe &project);

/// The names of all channels, each once, in the order of the recordings. Fails as openCaptures().
Result<QStringList> channelsOf(const std::vector<std::string> &recordings,
    const ImportSettings &settings, const JobControl &control);

/// What `dyncal correct` computes. Fails as it does, and where the run may not be published.
Result<CorrectionReport> correctionReport(const CorrectionTask &task, const JobControl &control);

} // namespace dyncal
