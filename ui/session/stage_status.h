// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <optional>

namespace dyncal {

/// How a stage stands; the window shows each as a glyph and a word. Incomplete is the certificate
/// with a required field empty.
enum class StageStatus {
    NotStarted,
    Blocked,
    Computing,
    Stale,
    Incomplete,
    Done,
    DoneWithCautions
};

/// What a run has delivered so far, and what is under way.
struct RunState
{
    CalibrationResults results;
    std::optional<Error> error; ///< of the last run that finished
    StageId failedStage = StageId::Captures; ///< meaningful with an error
    bool computing = false;
    /// The first stage whose result may be out of date; kStageCount = none.
    int firstStale = kStageCount;
};

StageStatus stageStatus(const RunState &run, StageId stage);

} // namespace dyncal
