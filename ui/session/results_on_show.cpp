// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/results_on_show.h"

#include "core/pipeline/stage_table.h"
#include "core/results/results_json.h"

#include <algorithm>

namespace dyncal {

namespace {

/// `part`, with what it lacks from `old`.
CalibrationResults merged(CalibrationResults part, const CalibrationResults &old)
{
    if (!part.model) // an assessment belongs to one model only
        part.assessment = old.assessment;
    if (!part.model && !part.response) // a budget to one model and its response
        part.uncertainty = old.uncertainty;
    for (int i = 0; i < kStageCount; ++i) {
        const Stage &stage = stageOf(static_cast<StageId>(i));
        const bool isPaired = stage.id == StageId::Assessment || stage.id == StageId::Uncertainty;
        if (!isPaired && !hasResult(part, stage.id))
            stage.result.put(part, stage.result.get(old));
    }
    return part;
}

/// What the first results show is told at once; of later stages only what belongs to this run.
bool isToldOnlyOfThisRun(StageId stage)
{
    return stage >= StageId::Model && stage != StageId::Assessment; // which goes with its model
}

} // namespace

bool ResultsOnShow::isLastGood(StageId stage) const
{
    return !hasResult(m_run.results, stage) && hasResult(m_withLastGood, stage);
}

bool ResultsOnShow::isOfThisRun(StageId stage) const
{
    return !isLastGood(stage)
        && keyOf(stage) == m_run.results.keys[static_cast<std::size_t>(stage)];
}

const std::string &ResultsOnShow::keyOf(StageId stage) const
{
    return m_keys[static_cast<std::size_t>(stage)];
}

std::shared_ptr<const ResponseResult> ResultsOnShow::response() const
{
    const auto &known = m_withLastGood.response;
    if (!known || isLastGood(StageId::Response) || isOfThisRun(StageId::Response))
        return known;
    const auto stage = static_cast<std::size_t>(StageId::Response);
    return m_keyOfCurve == m_run.results.keys[stage] ? m_modelCurve : nullptr;
}

void ResultsOnShow::setModelCurve(
    std::shared_ptr<const ResponseResult> curve, const std::string &key)
{
    m_modelCurve = std::move(curve);
    m_keyOfCurve = key;
}

Findings ResultsOnShow::findings() const
{
    CalibrationResults results = m_run.results;
    for (int i = 0; i < kStageCount; ++i) {
        const auto stage = static_cast<StageId>(i);
        if (isToldOnlyOfThisRun(stage) && !isOfThisRun(stage))
            stageOf(stage).result.put(results, nullptr);
    }
    Findings all = allFindings({results, m_run.error, m_run.failedStage});
    // The list of results.json leaves out errors that are not of the catalogue; people see them.
    if (m_run.error && m_run.error->findingId.empty()
        && m_run.error->kind != ErrorKind::Cancelled) {
        all.insert(all.begin(),
            {.id = {}, // not in the catalogue
                .severity = Severity::Block,
                .shot = m_run.error->shot,
                .message = m_run.error->message});
    }
    return all;
}

void ResultsOnShow::markStaleFrom(StageId stage)
{
    m_run.firstStale = std::min(m_run.firstStale, static_cast<int>(stage));
}

void ResultsOnShow::take(const PipelineOutcome &outcome, bool newerWaits)
{
    m_run.results = outcome.results;
    m_withLastGood = merged(outcome.results, m_withLastGood);
    m_areFirstTriplets = false;
    m_run.error = outcome.error;
    m_run.failedStage = outcome.failedStage;
    m_keys = outcome.results.keys;
    m_run.computing = newerWaits;
    if (!newerWaits)
        m_run.firstStale = kStageCount;
}

void ResultsOnShow::takePart(
    const CalibrationResults &part, StageId upTo, bool isFirstTriplets, bool newerWaits)
{
    if (upTo >= StageId::Decomposition)
        m_areFirstTriplets = isFirstTriplets;
    for (std::size_t i = 0; i < m_keys.size(); ++i) {
        const auto stage = static_cast<StageId>(i);
        if (stage <= upTo || hasResult(part, stage)) // later results may come from the cache
            m_keys[i] = part.keys[i];
    }
    m_run.results = merged(part, m_run.results);
    m_withLastGood = merged(m_run.results, m_withLastGood);
    if (m_run.error && m_run.failedStage <= upTo)
        m_run.error.reset();
    if (!newerWaits)
        m_run.firstStale = std::max(m_run.firstStale,
            isFirstTriplets ? static_cast<int>(StageId::Decomposition)
                            : static_cast<int>(upTo) + 1);
}

} // namespace dyncal
