// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/pipeline_request.h"
#include "ui/session/stage_status.h"

#include <array>
#include <string>

namespace dyncal {

/// What runs have delivered so far: values only. A run is delivered in parts; stages that have not
/// come yet keep the results of an earlier run, and it is known which those are.
class ResultsOnShow
{
public:
    const RunState &run() const { return m_run; }
    /// Those of the run, and for stages that it could not reach the last ones that there were: to
    /// look at, never to be printed or exported.
    const CalibrationResults &withLastGood() const { return m_withLastGood; }
    /// Whether a stage has no result of the run but an older one on show.
    bool isLastGood(StageId stage) const;
    /// Old results are of other recordings.
    void forgetLastGood() { m_withLastGood = m_run.results; }
    StageStatus status(StageId stage) const { return stageStatus(m_run, stage); }
    /// Whether the results belong to the recipe as it is now.
    bool areUpToDate() const { return !m_run.computing && m_run.firstStale == kStageCount; }
    /// Whether the result of a stage is of the same recipe as those before it.
    bool isOfThisRun(StageId stage) const;
    /// What the result of a stage was computed from.
    const std::string &keyOf(StageId stage) const;
    const std::array<std::string, kStageCount> &keys() const { return m_keys; }
    /// Whether decomposition and model are of the first singular values only.
    bool areFirstTriplets() const { return m_areFirstTriplets; }
    /// The response of this run. While that waits: the model's own curve, if there was a response
    /// to replace.
    std::shared_ptr<const ResponseResult> response() const;
    /// The findings of this run, and the error of a failed stage as a finding that blocks.
    Findings findings() const;

    void clear() { *this = {}; }
    void setComputing(bool computing) { m_run.computing = computing; }
    void markStaleFrom(StageId stage);
    /// All that a run gave. `newerWaits`: it is stale already, and the next run is under way.
    void take(const PipelineOutcome &outcome, bool newerWaits);
    /// The stages up to `upTo` came first: later ones keep their old results, marked stale.
    void takePart(
        const CalibrationResults &part, StageId upTo, bool isFirstTriplets, bool newerWaits);
    /// To be called before the part that it belongs to is taken; `key` is that of the response it
    /// stands for.
    void setModelCurve(std::shared_ptr<const ResponseResult> curve, const std::string &key);

private:
    RunState m_run;
    CalibrationResults m_withLastGood;
    std::array<std::string, kStageCount> m_keys; ///< each result's own
    bool m_areFirstTriplets = false;
    std::shared_ptr<const ResponseResult> m_modelCurve;
    std::string m_keyOfCurve; ///< of the response that it stands for
};

} // namespace dyncal
