// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/session.h"

#include "core/capture/capture_seal.h"
#include "core/pipeline/results_json.h"
#include "ui/session/order_candidates.h"
#include "ui/text/shown_text.h"

#include <QUndoCommand>

#include <algorithm>

namespace dyncal {

namespace {

/// A hand that rests this long within a drag wants to see everything.
constexpr int kRest_ms = 150;
/// A run younger than this is let finish although a newer request waits: otherwise a drag whose
/// steps come faster than results would never show one.
constexpr qint64 kGrace_ms = 700;
constexpr int kUndoSteps = 500;

/// Runs of the pipeline throw nothing: without a part there was a request to stop, or no memory.
RunPart partOf(Result<RunPart> part)
{
    return part ? std::move(*part) : RunPart{{{}, part.error(), StageId::Captures}, false};
}

} // namespace

/// The only undo command: the whole state before and after (cheap, recordings are shared).
class ReplaceState : public QUndoCommand
{
public:
    ReplaceState(Session &session, ProjectState after, const QString &label, QString mergeKey)
        : QUndoCommand(withoutMnemonic(label)) // it becomes a part of the menu's text
        , m_session(session)
        , m_before(session.state())
        , m_after(std::move(after))
        , m_mergeKey(std::move(mergeKey))
        , m_epoch(session.m_mergeEpoch)
    {
    }

    void undo() override { m_session.setState(m_before); }
    void redo() override { m_session.setState(m_after); }
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = static_cast<const ReplaceState *>(other);
        if (m_mergeKey.isEmpty() || next->m_mergeKey != m_mergeKey || next->m_epoch != m_epoch)
            return false;
        m_after = next->m_after;
        setText(next->text());
        setObsolete(m_after == m_before);
        return true;
    }

private:
    Session &m_session;
    ProjectState m_before;
    ProjectState m_after;
    QString m_mergeKey;
    int m_epoch;
};

Session::Session(Pipeline pipeline, QObject *parent)
    : QObject(parent)
    , m_pipeline(std::move(pipeline))
    , m_sealing(this)
    , m_candidates(std::make_unique<OrderCandidates>(*this))
    , m_wholeSetJob(this, 2)
    , m_jobs(this, 2)
{
    m_undo.setUndoLimit(kUndoSteps);
    m_start.setSingleShot(true);
    m_rest.setSingleShot(true);
    connect(&m_start, &QTimer::timeout, this, &Session::startComputation);
    connect(&m_rest, &QTimer::timeout, this, &Session::startRest);
}

Session::~Session() = default;

Findings Session::findings() const
{
    CalibrationResults results = m_run.results;
    if (!isOfThisRun(StageId::Model))
        results.model = nullptr;
    if (!isOfThisRun(StageId::Shock))
        results.shock = nullptr;
    if (!isOfThisRun(StageId::Response))
        results.response = nullptr;
    if (!isOfThisRun(StageId::Evidence))
        results.evidence = nullptr;
    if (!isOfThisRun(StageId::MonteCarlo))
        results.monteCarlo = nullptr;
    Findings all = allFindings({results, m_run.error, m_run.failedStage});
    // The list of results.json leaves out errors that are not of the catalogue; people see them.
    if (m_run.error && m_run.error->findingId.empty()
        && m_run.error->kind != ErrorKind::Cancelled) {
        Finding block;
        block.severity = Severity::Block;
        block.shot = m_run.error->shot;
        block.message = m_run.error->message;
        all.insert(all.begin(), block);
    }
    return all;
}

void Session::apply(const Recipe &next, const QString &label, const QString &mergeKey)
{
    if (next == m_state.recipe)
        return;
    m_isMerging = !mergeKey.isEmpty();
    m_undo.push(new ReplaceState(*this, {m_state.captures, next}, label, mergeKey));
}

void Session::endMerge()
{
    ++m_mergeEpoch;
    m_isMerging = false;
    if (m_rest.isActive())
        m_rest.start(0);
}

bool Session::isOfThisRun(StageId stage) const
{
    const auto position = static_cast<std::size_t>(stage);
    return m_keysOfResults[position] == m_run.results.keys[position];
}

void Session::applyState(const ProjectState &next, const QString &label)
{
    if (next == m_state)
        return;
    m_undo.push(new ReplaceState(*this, next, label, {}));
}

void Session::reset(const ProjectState &state)
{
    m_jobs.cancel();
    m_wholeSetJob.cancel();
    m_showsFirstTriplets = m_hasWholeSet = false;
    m_withheldSet.clear();
    m_sealing.cancel();
    m_sealed.clear();
    m_rest.stop();
    m_isMerging = false;
    m_run = {};
    m_keysOfResults = {};
    m_state = {};
    setState(state);
    m_undo.clear();
    if (state.hasShots())
        return;
    m_run.firstStale = kStageCount;
    emit capturesChanged();
    emit recipeChanged();
    emit resultsChanged();
    emit stageStatusChanged();
}

void Session::setState(const ProjectState &wanted)
{
    ProjectState state = wanted;
    if (const auto sealed = m_sealed.find(state.captures); sealed != m_sealed.end())
        state.captures = sealed->second;
    const bool otherCaptures = state.captures != m_state.captures;
    const auto affected = otherCaptures ? std::optional(StageId::Captures)
                                        : firstAffectedStage(m_state.recipe, state.recipe);
    m_state = state;
    if (otherCaptures)
        emit capturesChanged();
    emit recipeChanged();
    if (affected)
        markStaleFrom(*affected);
}

void Session::markStaleFrom(StageId stage)
{
    m_run.firstStale = std::min(m_run.firstStale, static_cast<int>(stage));
    m_run.computing = m_state.hasShots();
    if (stage <= StageId::Decomposition)
        m_wholeSetJob.cancel(); // it would be of something else
    if (!m_state.hasShots()) {
        m_jobs.cancel();
        m_sealing.cancel();
        m_start.stop();
        m_rest.stop();
        m_run = {};
        m_keysOfResults = {};
        emit resultsChanged();
    } else if (!m_start.isActive()) {
        m_start.start(0); // after everything that happens at once
    }
    emit stageStatusChanged();
}

void Session::recompute()
{
    m_withheldSet.clear();
    markStaleFrom(StageId::Captures);
}

void Session::cancelComputation()
{
    m_start.stop();
    m_rest.stop();
    m_jobs.cancel();
    m_sealing.cancel();
    m_wholeSetJob.cancel();
    if (m_showsFirstTriplets)
        m_withheldSet = decompositionKey(*m_state.captures, m_state.recipe);
    m_run.computing = false;
    emit stageStatusChanged();
}

bool Session::isSealed() const
{
    return std::ranges::none_of(m_state.captures->inputs,
        [](const InputFile &input) { return input.bytes > 0 && input.sha256.empty(); });
}

void Session::seal()
{
    m_jobs.cancel();
    const auto opened = m_beingSealed = m_state.captures;
    m_sealing.start<CaptureSet>(
        [opened](const JobControl &control) { return sealCaptures(*opened, control); },
        [this, opened](Result<CaptureSet> sealed) { takeSealed(opened, std::move(sealed)); },
        [this](double done) { emit progress(done); });
}

void Session::takeSealed(const std::shared_ptr<const CaptureSet> &opened, Result<CaptureSet> sealed)
{
    if (!sealed) {
        take({{}, sealed.error(), StageId::Captures});
        return;
    }
    m_sealed[opened] = std::make_shared<const CaptureSet>(std::move(*sealed));
    if (m_state.captures == opened) {
        m_state.captures = m_sealed[opened];
        emit capturesChanged();
    }
    startComputation();
}

void Session::startComputation()
{
    if (!isSealed()) {
        if (!m_sealing.isRunning() || m_beingSealed != m_state.captures)
            seal();
        return;
    }
    if (m_jobs.isRunning() && !m_isRest && m_jobs.age_ms() < kGrace_ms) {
        m_start.start(static_cast<int>(kGrace_ms - m_jobs.age_ms())); // or when it is done
        return;
    }
    m_rest.stop();
    m_isRest = false;
    if (needsWholeSet()) {
        m_jobs.cancel();
        m_withheldSet.clear();
        startWholeSet();
        return;
    }
    const StageId focus = m_focusOfRun = std::min(m_focus, StageId::Response);
    PipelineRequest request = this->request();
    const auto job = [request, focus](const JobControl &control) mutable {
        request.isFirstTriplets = request.wantsFirstTriplets(focus, control);
        return Result<RunPart>({request.run(focus, control), request.isFirstTriplets});
    };
    const auto deliver = [this, focus](Result<RunPart> delivered) {
        const RunPart part = partOf(std::move(delivered));
        if (!part.outcome.error)
            takePart(part.outcome.results, focus, part.isFirstTriplets);
        else if (part.isFirstTriplets)
            startWholeSet();
        else
            take(part.outcome);
    };
    m_jobs.start<RunPart>(job, deliver, [this](double done) { emit progress(done); });
}

/// The stages behind the focus, of the recipe whose first part was delivered last.
void Session::startRest()
{
    m_isRest = true;
    PipelineRequest request = this->request();
    const auto job = [this, request, focus = m_focusOfRun](
                         const JobControl &control) mutable -> Result<RunPart> {
        const bool isFirst = request.isFirstTriplets
            = request.wantsFirstTriplets(kLastStage, control);
        for (const StageId upTo : {StageId::Response, StageId::Assessment, StageId::Evidence}) {
            if (upTo == focus)
                continue;
            const PipelineOutcome part = request.run(upTo, control);
            if (part.error || (isFirst && upTo == StageId::Evidence))
                return RunPart{part, isFirst};
            const auto &next = part.results.keys[static_cast<std::size_t>(upTo) + 1];
            if (!request.cache->find<void>(next)) // else it is here at once
                JobRunner::post(
                    this, control.stop, [=, this] { takePart(part.results, upTo, isFirst); });
        }
        return RunPart{request.run(kLastStage, control), false};
    };
    const auto deliver = [this](Result<RunPart> delivered) {
        const RunPart part = partOf(std::move(delivered));
        if (!part.isFirstTriplets) {
            take(part.outcome);
            return;
        }
        if (!part.outcome.error)
            takePart(part.outcome.results, StageId::Evidence, true);
        startWholeSet();
    };
    m_jobs.start<RunPart>(job, deliver, [this](double done) { emit progress(done); });
}

/// Starts what waits before anybody draws: drawing and the next run then share the time.
bool Session::startNewer()
{
    if (!m_start.isActive())
        return false;
    m_start.stop();
    startComputation();
    return true;
}

void Session::take(const PipelineOutcome &outcome)
{
    const bool newerWaits = startNewer();
    m_run.results = outcome.results;
    m_showsFirstTriplets = false;
    m_run.error = outcome.error;
    m_run.failedStage = outcome.failedStage;
    m_keysOfResults = outcome.results.keys;
    m_run.computing = newerWaits;
    if (!newerWaits)
        m_run.firstStale = kStageCount;
    emit resultsChanged();
    emit stageStatusChanged();
    if (outcome.error && outcome.error->kind != ErrorKind::Cancelled)
        emit failed(*outcome.error);
}

/// The stages up to `upTo` came first: later ones keep their old results, marked stale.
void Session::takePart(const CalibrationResults &part, StageId upTo, bool isFirstTriplets)
{
    const bool newerWaits = startNewer();
    if (upTo >= StageId::Decomposition)
        m_showsFirstTriplets = isFirstTriplets;
    if (!newerWaits && !m_isRest)
        m_rest.start(m_isMerging ? kRest_ms : 0);
    std::copy_n(part.keys.begin(), static_cast<std::size_t>(upTo) + 1, m_keysOfResults.begin());
    const auto assessed = static_cast<std::size_t>(StageId::Assessment);
    if (part.model) // of this recipe, and perhaps assessed in an earlier run
        m_keysOfResults[assessed] = part.model->isAssessed ? part.keys[assessed] : std::string();
    CalibrationResults merged = part;
    const CalibrationResults &old = m_run.results;
    const auto keep = [](auto &now, const auto &before) {
        if (!now)
            now = before;
    };
    keep(merged.starts, old.starts);
    keep(merged.expected, old.expected);
    keep(merged.window, old.window);
    keep(merged.spectrum, old.spectrum);
    keep(merged.components, old.components);
    keep(merged.input, old.input);
    keep(merged.decomposition, old.decomposition);
    keep(merged.model, old.model);
    keep(merged.shock, old.shock);
    keep(merged.response, old.response);
    keep(merged.evidence, old.evidence);
    keep(merged.monteCarlo, old.monteCarlo);
    m_run.results = std::move(merged);
    if (m_run.error && m_run.failedStage <= upTo)
        m_run.error.reset();
    if (!newerWaits)
        m_run.firstStale = std::max(m_run.firstStale,
            isFirstTriplets ? static_cast<int>(StageId::Decomposition)
                            : static_cast<int>(upTo) + 1);
    emit resultsChanged();
    emit stageStatusChanged();
}

} // namespace dyncal
