// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/stage_status.h"

#include "core/pipeline/stage_table.h"

namespace dyncal {

StageStatus stageStatus(const RunState &run, StageId stage)
{
    const int position = static_cast<int>(stage);
    const bool stale = position >= run.firstStale;
    if (run.computing && stale)
        return hasResult(run.results, stage) ? StageStatus::Stale : StageStatus::Computing;
    if (run.error && position >= static_cast<int>(run.failedStage))
        return StageStatus::Blocked;
    if (!hasResult(run.results, stage))
        return StageStatus::NotStarted;
    if (stale)
        return StageStatus::Stale;
    switch (worstSeverity(findingsOf(run.results, stage))) {
    case Severity::Block:
        return StageStatus::Blocked;
    case Severity::Caution:
        return StageStatus::DoneWithCautions;
    case Severity::Info:
        break;
    }
    return StageStatus::Done;
}

} // namespace dyncal
