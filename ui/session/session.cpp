// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/session.h"

#include "core/pipeline/stage_keys.h"
#include "ui/session/order_candidates.h"
#include "ui/session/replace_state.h"

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kUndoSteps = 500;

} // namespace

Session::Session(Pipeline pipeline, QObject *parent)
    : QObject(parent)
    , m_pipeline(std::move(pipeline))
    , m_progress([this](double done) { emit progress(done); })
    , m_candidates(std::make_unique<OrderCandidates>())
    , m_sources(this, [this] { emit sourcesChanged(); })
    , m_sealing(
          this, [this](const auto &opened, const auto &sealed) { takeSealed(opened, sealed); },
          m_progress)
    , m_wholeSet(
          this, [this](const PipelineOutcome &outcome) { takeWholeSet(outcome); }, m_progress)
    , m_jobs(this, 2)
    , m_focusRun(m_jobs, [this] { startComputation(); })
    , m_restRun(m_jobs, [this] { startRest(); })
{
    m_undo.setUndoLimit(kUndoSteps);
    connect(this, &Session::resultsChanged, this, &Session::followCandidates);
    connect(this, &Session::recipeChanged, this, &Session::followCandidates);
    connect(this, &Session::capturesChanged, this, [this] { m_sources.watch(m_state.captures); });
}

Session::~Session() = default;

Recipe Session::recipeOnShow() const
{
    return showsFirstTriplets() ? withFirstTriplets(recipe()) : recipe();
}

bool Session::needsWholeSet() const
{
    const Index order = recipe().realization.order.value.value_or(1);
    if (!showsFirstTriplets() || order <= kFirstTriplets)
        return false;
    const CaptureSet &captures = *m_state.captures;
    return m_shown.keyOf(StageId::Decomposition)
        == decompositionKey(captures, withFirstTriplets(recipe()))
        && m_wholeSet.made() != decompositionKey(captures, recipe());
}

Findings Session::findings() const
{
    Findings all;
    for (const ChangedSource &source : changedSources())
        all.push_back(source.finding);
    for (Finding &finding : m_shown.findings())
        all.push_back(std::move(finding));
    return all;
}

void Session::followCandidates()
{
    // While a part of a run is on show, its later results are still those of the run before.
    CalibrationResults basis = results();
    basis.keys = m_shown.keys();
    m_candidates->follow(
        {m_state.captures, recipeOnShow(), std::move(basis), showsFirstTriplets()});
}

void Session::apply(const Recipe &next, const QString &label, const QString &mergeKey)
{
    if (next == m_state.recipe)
        return;
    if (!m_isMerging || mergeKey != m_mergeKey)
        m_beforeMerge = m_state.recipe;
    m_isMerging = !mergeKey.isEmpty();
    m_mergeKey = mergeKey;
    m_undo.push(new ReplaceState([this](const ProjectState &state) { setState(state); }, m_state,
        {m_state.captures, next}, label, mergeKey, m_mergeEpoch));
}

void Session::endMerge()
{
    ++m_mergeEpoch;
    m_isMerging = false;
    m_restRun.hurry();
}

/// Merged with the series, going back to its begin is a step that changes nothing: undo drops it.
void Session::cancelMerge()
{
    if (m_isMerging)
        apply(Recipe(m_beforeMerge), m_undo.undoText(), QString(m_mergeKey));
    endMerge();
}

void Session::applyState(const ProjectState &next, const QString &label)
{
    if (next == m_state)
        return;
    m_undo.push(new ReplaceState([this](const ProjectState &state) { setState(state); }, m_state,
        next, label, {}, m_mergeEpoch));
}

void Session::reset(const ProjectState &state)
{
    m_jobs.cancel();
    m_wholeSet.forget();
    m_sealing.forget();
    m_restRun.withdraw();
    m_isMerging = false;
    m_shown.clear();
    m_state = {};
    setState(state);
    m_undo.clear();
    if (state.hasShots())
        return;
    m_cache = std::make_shared<ResultCache>(); // nothing is open: nor is its memory kept
    emit capturesChanged();
    emit recipeChanged();
    emit resultsChanged();
    emit stageStatusChanged();
}

void Session::setState(const ProjectState &wanted)
{
    ProjectState state = wanted;
    state.captures = m_sealing.latest(state.captures);
    const bool otherCaptures = state.captures != m_state.captures;
    const auto affected = otherCaptures ? std::optional(StageId::Captures)
                                        : firstDifferentStage(m_state.recipe, state.recipe);
    m_state = state;
    if (otherCaptures)
        m_shown.forgetLastGood();
    if (affected)
        markStaleFrom(*affected);
    if (m_isMerging) // a drag: it computes while the window shows the move
        startNewer();
    if (otherCaptures)
        emit capturesChanged();
    emit recipeChanged();
    if (affected && !m_state.hasShots())
        emit resultsChanged();
    emit stageStatusChanged();
}

/// The signals are the caller's.
void Session::markStaleFrom(StageId stage)
{
    if (stage <= StageId::Decomposition)
        m_wholeSet.cancel(); // its input has changed
    if (m_state.hasShots()) {
        m_shown.markStaleFrom(stage);
        m_shown.setComputing(true);
        m_focusRun.ask();
    } else {
        m_jobs.cancel();
        m_sealing.cancel();
        m_focusRun.withdraw();
        m_restRun.withdraw();
        m_shown.clear();
    }
}

void Session::recompute()
{
    m_wholeSet.allow();
    markStaleFrom(StageId::Captures);
    emit stageStatusChanged();
}

void Session::cancelComputation()
{
    m_focusRun.withdraw();
    m_restRun.withdraw();
    m_jobs.cancel();
    m_sealing.cancel();
    m_wholeSet.cancel();
    if (showsFirstTriplets())
        m_wholeSet.withhold(decompositionKey(*m_state.captures, m_state.recipe));
    m_shown.setComputing(false);
    emit stageStatusChanged();
}

PipelineRequest Session::request() const
{
    const bool hasWholeSet = !showsFirstTriplets()
        && m_shown.run().firstStale > static_cast<int>(StageId::Decomposition);
    return {m_pipeline, m_cache, m_state.captures, m_state.recipe, m_wholeSet.made(), hasWholeSet,
        false, results().response, m_shown.keyOf(StageId::Response)};
}

/// One run of the recipe as it is now: sealing, the focus, the rest; or the whole set first.
void Session::startComputation()
{
    if (!isSealed()) {
        if (!m_sealing.isSealing(m_state.captures)) {
            m_jobs.cancel();
            m_sealing.start(m_state.captures);
        }
        return;
    }
    if (!m_focusRun.mayBegin())
        return;
    m_restRun.withdraw();
    if (needsWholeSet()) {
        m_jobs.cancel();
        m_wholeSet.allow();
        startWholeSet();
        return;
    }
    m_focusRun.start(
        request(), std::min(m_focus, StageId::Response),
        [this](const RunPart &part, StageId upTo) { takeFocus(part, upTo); }, m_progress);
}

void Session::startRest()
{
    m_restRun.start(
        this, request(), m_focusRun.focus(),
        [this](const CalibrationResults &part, StageId upTo, bool isFirstTriplets) {
            showPart(part, upTo, isFirstTriplets, startNewer());
        },
        [this](const RunPart &part) { takeRest(part); }, m_progress);
}

void Session::startWholeSet()
{
    if (m_wholeSet.start(request()))
        return;
    m_shown.setComputing(false);
    emit stageStatusChanged();
}

/// Starts a waiting run before anything is drawn, so that it computes while the window draws.
bool Session::startNewer()
{
    if (!m_focusRun.isAsked())
        return false;
    m_focusRun.withdraw();
    startComputation();
    return true;
}

void Session::takeSealed(
    const CaptureSealing::Captures &opened, const Result<CaptureSealing::Captures> &sealed)
{
    if (!sealed) {
        take({{}, sealed.error(), StageId::Captures});
        return;
    }
    if (m_state.captures == opened) {
        m_state.captures = *sealed;
        emit capturesChanged();
    }
    startComputation();
}

void Session::takeFocus(const RunPart &part, StageId upTo)
{
    if (!part.outcome.error) {
        const bool newerWaits = startNewer();
        if (!newerWaits)
            m_restRun.ask(m_isMerging);
        const auto response = static_cast<std::size_t>(StageId::Response);
        m_shown.setModelCurve(part.modelCurve, part.outcome.results.keys[response]);
        showPart(part.outcome.results, upTo, part.isFirstTriplets, newerWaits);
    } else if (part.isFirstTriplets) {
        startWholeSet(); // it decides whether the recipe fails
    } else {
        take(part.outcome);
    }
}

void Session::takeRest(const RunPart &part)
{
    if (!part.isFirstTriplets) {
        take(part.outcome);
        return;
    }
    if (!part.outcome.error)
        showPart(part.outcome.results, StageId::Evidence, true, startNewer());
    startWholeSet();
}

void Session::takeWholeSet(const PipelineOutcome &outcome)
{
    if (outcome.error) {
        m_jobs.cancel(); // a running job would continue with the first triplets
        take(outcome);
        return;
    }
    m_focusRun.withdraw();
    startComputation();
}

void Session::take(const PipelineOutcome &outcome)
{
    const bool newerWaits = startNewer();
    m_shown.take(outcome, newerWaits);
    emit resultsChanged();
    emit stageStatusChanged();
    if (outcome.error && outcome.error->kind != ErrorKind::Cancelled)
        emit failed(*outcome.error);
}

/// The stages up to `upTo`. `newerWaits`: a newer run is under way already.
void Session::showPart(
    const CalibrationResults &part, StageId upTo, bool isFirstTriplets, bool newerWaits)
{
    m_shown.takePart(part, upTo, isFirstTriplets, newerWaits);
    emit resultsChanged();
    emit stageStatusChanged();
}

} // namespace dyncal
