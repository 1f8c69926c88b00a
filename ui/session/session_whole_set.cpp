// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The part of the session that has the rest of the singular triplets computed once the first ones
// are on show.

#include "ui/session/session.h"

namespace dyncal {

Recipe Session::recipeOnShow() const
{
    return m_showsFirstTriplets ? withFirstTriplets(recipe()) : recipe();
}

bool Session::needsWholeSet() const
{
    const Index order = recipe().realization.order.value.value_or(1);
    if (!m_showsFirstTriplets || order <= kFirstTriplets)
        return false;
    const CaptureSet &captures = *m_state.captures;
    const auto stage = static_cast<std::size_t>(StageId::Decomposition);
    return m_keysOfResults[stage] == decompositionKey(captures, withFirstTriplets(recipe()))
        && !(m_hasWholeSet && m_wholeSet == decompositionKey(captures, recipe()));
}

PipelineRequest Session::request() const
{
    return {m_pipeline, m_cache, m_state.captures, m_state.recipe,
        m_hasWholeSet ? m_wholeSet : std::string(),
        !m_showsFirstTriplets && m_run.firstStale > static_cast<int>(StageId::Decomposition),
        false};
}

/// Has the decomposition computed as the recipe wants it. Orders tried meanwhile do not start it
/// anew; after a cancel it waits until it is asked for.
void Session::startWholeSet()
{
    const std::string key = decompositionKey(*m_state.captures, m_state.recipe);
    if (m_wholeSetJob.isRunning() && m_wholeSet == key)
        return;
    if (m_withheldSet == key) {
        m_run.computing = false;
        emit stageStatusChanged();
        return;
    }
    m_wholeSet = key;
    m_hasWholeSet = false;
    m_wholeSetJob.start<PipelineOutcome>(
        [request = request()](const JobControl &control) -> Result<PipelineOutcome> {
            return request.run(StageId::Decomposition, control);
        },
        [this](Result<PipelineOutcome> outcome) {
            if (!outcome)
                outcome = PipelineOutcome{{}, outcome.error(), StageId::Decomposition};
            takeWholeSet(*outcome);
        },
        [this](double done) { emit progress(done); });
}

void Session::takeWholeSet(const PipelineOutcome &outcome)
{
    if (outcome.error) {
        m_jobs.cancel(); // it would go on from the first ones
        take(outcome);
        return;
    }
    m_hasWholeSet = true;
    m_start.stop();
    startComputation();
}

} // namespace dyncal
