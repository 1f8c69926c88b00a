// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/envelope_store.h"
#include "ui/session/frequency_cursors.h"
#include "ui/session/job_runner.h"
#include "ui/session/pipeline_request.h"
#include "ui/session/project_state.h"
#include "ui/session/stage_status.h"

#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include <array>
#include <map>
#include <string>

namespace dyncal {

class OrderCandidates;

/// One open calibration job: what was decided (recipe), the recordings, undo, and the results that
/// follow from them, computed in the background. Views read results and apply changed recipes; the
/// session knows no views.
class Session : public QObject
{
    Q_OBJECT

public:
    using Pipeline = PipelineFunction;

    explicit Session(Pipeline pipeline, QObject *parent = nullptr);
    ~Session() override;

    const ProjectState &state() const { return m_state; }
    const Recipe &recipe() const { return m_state.recipe; }
    const CalibrationResults &results() const { return m_run.results; }
    /// Why the last run ended early, if it did.
    const std::optional<Error> &error() const { return m_run.error; }
    StageId failedStage() const { return m_run.failedStage; }
    bool isComputing() const { return m_run.computing; }
    /// False for recordings that are opened but whose files have no hash yet: they can be shown,
    /// not saved. Before anything is computed from them they are sealed, in the background.
    bool isSealed() const;
    /// Whether the results belong to the recipe on the screen: false while computing, and after a
    /// cancelled computation. Only results that do may leave the program.
    bool isUpToDate() const { return !m_run.computing && m_run.firstStale == kStageCount; }
    StageStatus status(StageId stage) const { return stageStatus(m_run, stage); }
    /// Whether decomposition and model on show are of the first singular values only, while the
    /// whole set is computed or after that was cancelled. They are never up to date.
    bool showsFirstTriplets() const { return m_showsFirstTriplets; }
    /// The recipe that what is on show is computed from: with the first singular values, or as is.
    Recipe recipeOnShow() const;
    /// Whether the order chosen is beyond the first singular values, which are all that is there.
    bool needsWholeSet() const;
    /// Findings of all stages, and the error of a failed stage as a finding that blocks.
    Findings findings() const;

    QUndoStack &undoStack() { return m_undo; }
    /// Replaces the recipe as one undo step. Changes with the same non-empty `mergeKey` become one
    /// step until endMerge(): a drag, or a run of key presses.
    void apply(const Recipe &next, const QString &label, const QString &mergeKey = {});
    void endMerge();
    /// Adds or removes recordings (and adjusts the recipe with them), as one undo step.
    void applyState(const ProjectState &next, const QString &label);

    /// Minima and maxima of the records on the screen.
    EnvelopeStore &envelopes() { return m_envelopes; }

    FrequencyCursors &frequencyCursors() { return m_frequencyCursors; }
    /// Models of the orders pinned for comparison.
    OrderCandidates &candidates() { return *m_candidates; }
    const OrderCandidates &candidates() const { return *m_candidates; }

    /// Starts over with another job: no undo across, clean.
    void reset(const ProjectState &state);

    /// Whether the result of a stage is of the same recipe as those before it. While a run is under
    /// way, later stages keep what an earlier run gave: good for their own pages, which say that it
    /// is stale, and not to be shown beside newer numbers.
    bool isOfThisRun(StageId stage) const;

    /// The stage on show is computed and delivered first. The rest follows at once, or within a
    /// series of changes that merge (a drag, keys) as soon as the hand rests or endMerge() is
    /// called: moves never wait for what they do not show.
    void setFocus(StageId stage) { m_focus = stage; }
    void cancelComputation();
    /// Computes again after a cancel, or when a caller wants to be sure.
    void recompute();

signals:
    void recipeChanged();
    void capturesChanged();
    void resultsChanged();
    void stageStatusChanged();
    void failed(const dyncal::Error &error);
    void progress(double fraction);

private:
    friend class ReplaceState;
    void setState(const ProjectState &state);
    void markStaleFrom(StageId stage);
    void startComputation();
    void startRest();
    bool startNewer();
    void seal();
    void takeSealed(const std::shared_ptr<const CaptureSet> &opened, Result<CaptureSet> sealed);
    void take(const PipelineOutcome &outcome);
    void takePart(const CalibrationResults &part, StageId upTo, bool isFirstTriplets);
    void startWholeSet();
    void takeWholeSet(const PipelineOutcome &outcome);
    PipelineRequest request() const;

    Pipeline m_pipeline;
    ProjectState m_state;
    RunState m_run;
    StageId m_focus = StageId::Captures;
    StageId m_focusOfRun = StageId::Captures;
    QUndoStack m_undo;
    int m_mergeEpoch = 0;
    QTimer m_start; ///< active: a newer recipe waits to be computed
    QTimer m_rest; ///< active: the stages behind the focus wait to be computed
    bool m_isMerging = false; ///< the last change may be one of a series
    bool m_isRest = false; ///< what runs is the stages behind the focus
    std::array<std::string, kStageCount> m_keysOfResults; ///< each result's own
    EnvelopeStore m_envelopes;
    FrequencyCursors m_frequencyCursors;
    /// Opened -> sealed: the undo steps made meanwhile know the opened ones.
    std::map<std::shared_ptr<const CaptureSet>, std::shared_ptr<const CaptureSet>> m_sealed;
    std::shared_ptr<ResultCache> m_cache = std::make_shared<ResultCache>();
    std::shared_ptr<const CaptureSet> m_beingSealed;
    JobRunner m_sealing;
    std::unique_ptr<OrderCandidates> m_candidates;
    bool m_showsFirstTriplets = false;
    std::string m_wholeSet; ///< key of the whole decomposition computed last, or being computed
    bool m_hasWholeSet = false; ///< it is computed
    std::string m_withheldSet; ///< key of a whole decomposition that was cancelled
    JobRunner m_wholeSetJob; ///< goes on while orders are tried among the first triplets
    JobRunner m_jobs; ///< last: stops before anything that a delivery touches is gone
};

} // namespace dyncal
