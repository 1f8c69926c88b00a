// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/capture_sealing.h"
#include "ui/session/envelope_store.h"
#include "ui/session/focus_run.h"
#include "ui/session/job_runner.h"
#include "ui/session/pipeline_request.h"
#include "ui/session/project_state.h"
#include "ui/session/rest_run.h"
#include "ui/session/results_on_show.h"
#include "ui/session/shared_cursors.h"
#include "ui/session/source_watch.h"
#include "ui/session/stage_status.h"
#include "ui/session/whole_set_run.h"

#include <QObject>
#include <QUndoStack>

#include <memory>

namespace dyncal {

class OrderCandidates;

/// One open calibration job: what was decided (recipe), the recordings, undo, and the results that
/// follow from them, computed in the background. Views read results and apply changed recipes; the
/// session knows no views.
///
/// It only decides what follows what. How each background job begins, waits and ends is up to the
/// objects that run them: CaptureSealing, FocusRun, RestRun, WholeSetRun; their results are in
/// ResultsOnShow.
class Session : public QObject
{
    Q_OBJECT

public:
    using Pipeline = PipelineFunction;

    explicit Session(Pipeline pipeline, QObject *parent = nullptr);
    ~Session() override;

    const ProjectState &state() const { return m_state; }
    const Recipe &recipe() const { return m_state.recipe; }
    const CalibrationResults &results() const { return m_shown.run().results; }
    /// With the last good results of stages that the last run could not reach: for the screen only.
    const CalibrationResults &resultsOnShow() const { return m_shown.withLastGood(); }
    /// Whether what is on show of a stage is its last good result, of an older recipe.
    bool isLastGood(StageId stage) const { return m_shown.isLastGood(stage); }
    /// Why the last run ended early, if it did.
    const std::optional<Error> &error() const { return m_shown.run().error; }
    StageId failedStage() const { return m_shown.run().failedStage; }
    bool isComputing() const { return m_shown.run().computing; }
    /// False for recordings that are opened but whose files have no hash yet: they can be shown,
    /// not saved. Before anything is computed from them they are sealed, in the background.
    bool isSealed() const { return dyncal::isSealed(*m_state.captures); }
    /// Whether the results belong to the recipe on the screen: false while computing, and after a
    /// cancelled computation. Only results that do may leave the program.
    bool isUpToDate() const { return m_shown.areUpToDate(); }
    StageStatus status(StageId stage) const { return m_shown.status(stage); }
    /// The response to show: that of this run, or the model's own curve until it is there.
    std::shared_ptr<const ResponseResult> responseOnShow() const { return m_shown.response(); }
    /// Whether decomposition and model on show are of the first singular values only, while the
    /// whole set is computed or after that was cancelled. They are never up to date.
    bool showsFirstTriplets() const { return m_shown.areFirstTriplets(); }
    /// The recipe that the results on show are computed from: with the first singular values, or as
    /// is.
    Recipe recipeOnShow() const;
    /// Whether the order chosen is beyond the first singular values, which are all that is there.
    bool needsWholeSet() const;
    /// Findings of all stages, the error of a failed stage as a finding that blocks, and before
    /// them what has happened to the files of the recordings.
    Findings findings() const;
    /// Nothing may leave the program while there are such.
    const std::vector<ChangedSource> &changedSources() const { return m_sources.changes(); }

    QUndoStack &undoStack() { return m_undo; }
    /// Replaces the recipe as one undo step. Changes with the same non-empty `mergeKey` become one
    /// step until endMerge(): a drag, or a run of key presses.
    void apply(const Recipe &next, const QString &label, const QString &mergeKey = {});
    void endMerge();
    /// Takes a series of changes that merge back: the recipe is that before it, and undo does not
    /// know of the series. Then as endMerge().
    void cancelMerge();
    /// Adds or removes recordings (and adjusts the recipe with them), as one undo step.
    void applyState(const ProjectState &next, const QString &label);

    /// Minima and maxima of the records on the screen.
    EnvelopeStore &envelopes() { return m_envelopes; }

    SharedCursors &cursors(CursorAxis axis) { return m_cursors[static_cast<std::size_t>(axis)]; }
    /// Models of the orders pinned for comparison.
    OrderCandidates &candidates() { return *m_candidates; }
    const OrderCandidates &candidates() const { return *m_candidates; }

    /// Starts over with another job: nothing to undo, nothing to save.
    void reset(const ProjectState &state);

    /// Whether the result of a stage is of the same recipe as those before it. While a run is under
    /// way, later stages keep what an earlier run gave: good for their own pages, which say that it
    /// is stale, and not to be shown beside newer numbers.
    bool isOfThisRun(StageId stage) const { return m_shown.isOfThisRun(stage); }

    /// As isOfThisRun(), or the last good one of a stage that the run could not reach.
    bool isShowable(StageId stage) const { return isOfThisRun(stage) || isLastGood(stage); }

    /// The stage on show is computed and delivered first. The rest follows at once, or within a
    /// series of changes that merge (a drag, keys) at the next pause or when endMerge() is
    /// called: moves never wait for what they do not show.
    void setFocus(StageId stage) { m_focus = stage; }
    void cancelComputation();
    /// Computes again after a cancel, or when a caller wants to be sure.
    void recompute();

signals:
    void recipeChanged(); ///< stageStatusChanged() follows
    void capturesChanged();
    void resultsChanged(); ///< stageStatusChanged() follows
    void stageStatusChanged();
    void sourcesChanged(); ///< changedSources() are others
    void failed(const dyncal::Error &error);
    void progress(double fraction);

private:
    void setState(const ProjectState &state);
    void markStaleFrom(StageId stage);
    void startComputation();
    void startRest();
    void startWholeSet();
    bool startNewer();
    void takeSealed(
        const CaptureSealing::Captures &opened, const Result<CaptureSealing::Captures> &sealed);
    void take(const PipelineOutcome &outcome);
    void showPart(
        const CalibrationResults &part, StageId upTo, bool isFirstTriplets, bool newerWaits);
    void takeFocus(const RunPart &part, StageId upTo);
    void takeRest(const RunPart &part);
    void takeWholeSet(const PipelineOutcome &outcome);
    PipelineRequest request() const;
    void followCandidates();

    Pipeline m_pipeline;
    ProgressSink m_progress; ///< of every job
    ProjectState m_state;
    ResultsOnShow m_shown;
    StageId m_focus = StageId::Captures;
    QUndoStack m_undo;
    int m_mergeEpoch = 0;
    bool m_isMerging = false; ///< the last change may be one of a series
    Recipe m_beforeMerge;
    QString m_mergeKey;
    EnvelopeStore m_envelopes;
    std::array<SharedCursors, kCursorAxes> m_cursors;
    std::shared_ptr<ResultCache> m_cache = std::make_shared<ResultCache>();
    std::unique_ptr<OrderCandidates> m_candidates;
    SourceWatch m_sources;
    CaptureSealing m_sealing;
    WholeSetRun m_wholeSet;
    JobRunner m_jobs; ///< of the two members below; its jobs hold values only
    FocusRun m_focusRun;
    RestRun m_restRun;
};

} // namespace dyncal
