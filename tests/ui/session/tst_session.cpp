// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_keys.h"
#include "core/pipeline/stage_table.h"
#include "tests/support/test_program.h"
#include "ui/session/capture_edit.h"
#include "ui/session/session.h"

#include <QSignalSpy>
#include <QThread>
#include <QtTest>

#include <atomic>
#include <mutex>

using namespace dyncal;

namespace {

/// A pipeline that notes what it was asked and gives a model of the order in the recipe.
struct FakePipeline
{
    struct Log
    {
        std::atomic<int> runs = 0;
        std::atomic<int> delay_ms = 0;
        std::atomic<bool> fails = false;
    };
    std::shared_ptr<Log> log = std::make_shared<Log>();

    PipelineOutcome operator()(const std::shared_ptr<const CaptureSet> &captures,
        const Recipe &recipe, ResultCache &, StageId last, const JobControl &control) const
    {
        PipelineOutcome outcome;
        auto prepared = std::make_shared<PreparedCaptures>();
        prepared->set = *captures;
        outcome.results.captures = prepared;
        if (last < StageId::Model)
            return outcome;
        if (last < kLastStage) // the evidence behind the response is no run of its own
            ++log->runs;
        for (int i = 0; i < log->delay_ms && !control.stopRequested(); ++i)
            QThread::msleep(1);
        if (log->fails) {
            outcome.failedStage = StageId::Window;
            outcome.error = Error{ErrorKind::DataBlocked, {"No step.", {}}, "CAP-009", 1};
            return outcome;
        }
        auto model = std::make_shared<SensorModel>();
        model->order = recipe.realization.order.value.value_or(2);
        outcome.results.model = model;
        return outcome;
    }
};

ProjectState threeShots()
{
    CaptureSet set;
    set.inputs = {{"a.h5", "a.h5", "00", "test"}, {"b.h5", "b.h5", "11", "test"}};
    for (int i = 0; i < 3; ++i) {
        Shot shot;
        shot.label = "shot " + std::to_string(i + 1);
        shot.input = i == 0 ? 0 : 1;
        set.shots.push_back(shot);
    }
    ProjectState state;
    state.captures = std::make_shared<const CaptureSet>(set);
    return state;
}

Recipe withOrder(Recipe recipe, Index order)
{
    recipe.realization.order = order;
    return recipe;
}

Index shownOrder(const Session &session)
{
    return session.results().model ? session.results().model->order : 0;
}

} // namespace

class TestSession : public QObject
{
    Q_OBJECT

private slots:
    void reset_withShots_computesInTheBackground();
    void reset_toNothing_keepsNoResult();
    void apply_changedOrder_givesNewResultsAndOneUndoStep();
    void apply_sameRecipe_doesNothing();
    void apply_whileDragging_isOneUndoStep();
    void endMerge_separatesTwoDrags();
    void cancelMerge_takesTheSeriesBack_andNothingElse();
    void undoRedo_manySteps_returnsTheSameState();
    void results_whileComputing_stayVisibleAndAreStale();
    void status_afterOrderChange_keepsEarlierStagesDone();
    void failure_blocksTheStageAndIsAFinding();
    void certificateText_computesNothing();
    void burstOfChanges_endsWithTheNewest();
    void drag_slowPipeline_stillShowsResults();
    void drag_move_isComputedWhileItIsShown();
    void drag_rest_waitsForTheHand();
    void cancel_leavesStale();
    void affected_shock_startsAtExpected();
    void removeShot_movesNumbersAndIsUndoable();
    void removeShot_movesStretchesAndModes();
    void findingIds_leadToStages();
};

void TestSession::reset_withShots_computesInTheBackground()
{
    FakePipeline pipeline;
    Session session(pipeline);
    QCOMPARE(session.status(StageId::Model), StageStatus::NotStarted);
    session.reset(threeShots());
    QVERIFY(session.isComputing());
    QCOMPARE(session.status(StageId::Model), StageStatus::Computing);
    QTRY_VERIFY(!session.isComputing());
    QCOMPARE(shownOrder(session), Index(2));
    QVERIFY(session.undoStack().isClean());
    QCOMPARE(session.undoStack().count(), 0);
}

void TestSession::reset_toNothing_keepsNoResult()
{
    std::weak_ptr<const int> kept;
    std::once_flag once;
    Session session(
        [&, pipeline = FakePipeline()](const std::shared_ptr<const CaptureSet> &captures,
            const Recipe &recipe, ResultCache &cache, StageId last, const JobControl &control) {
            std::call_once(once, [&] {
                const auto value = std::make_shared<const int>(1);
                cache.store("value", value);
                kept = value;
            });
            return pipeline(captures, recipe, cache, last, control);
        });
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    QVERIFY(!kept.expired());
    session.reset({});
    QTRY_VERIFY(kept.expired());
}

void TestSession::apply_changedOrder_givesNewResultsAndOneUndoStep()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    session.apply(withOrder(session.recipe(), 5), "Order 5");
    QTRY_COMPARE(shownOrder(session), Index(5));
    QCOMPARE(session.undoStack().count(), 1);
    QCOMPARE(session.undoStack().undoText(), QString("Order 5"));
    session.undoStack().undo();
    QVERIFY(session.recipe().realization.order.isAuto());
    QTRY_COMPARE(shownOrder(session), Index(2));
    session.undoStack().redo();
    QTRY_COMPARE(shownOrder(session), Index(5));
}

void TestSession::apply_sameRecipe_doesNothing()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    QSignalSpy changed(&session, &Session::recipeChanged);
    session.apply(session.recipe(), "nothing");
    QCOMPARE(changed.count(), 0);
    QCOMPARE(session.undoStack().count(), 0);
    QVERIFY(!session.isComputing());
}

void TestSession::apply_whileDragging_isOneUndoStep()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    for (Index order = 3; order < 20; ++order)
        session.apply(withOrder(session.recipe(), order), "Order", "drag");
    QCOMPARE(session.undoStack().count(), 1);
    QCOMPARE(*session.recipe().realization.order.value, Index(19));
    session.undoStack().undo();
    QVERIFY(session.recipe().realization.order.isAuto());
}

void TestSession::endMerge_separatesTwoDrags()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    session.apply(withOrder(session.recipe(), 3), "Order", "drag");
    session.endMerge();
    session.apply(withOrder(session.recipe(), 4), "Order", "drag");
    QCOMPARE(session.undoStack().count(), 2);
    session.undoStack().undo();
    QCOMPARE(*session.recipe().realization.order.value, Index(3));
}

void TestSession::cancelMerge_takesTheSeriesBack_andNothingElse()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    session.cancelMerge(); // no series
    session.apply(withOrder(session.recipe(), 3), "Order 3");
    session.cancelMerge(); // nor now
    QCOMPARE(session.undoStack().count(), 1);
    session.apply(withOrder(session.recipe(), 4), "Order", "drag");
    session.endMerge();
    const Recipe before = session.recipe();
    for (Index order = 5; order < 9; ++order)
        session.apply(withOrder(session.recipe(), order), "Order", "drag");
    session.cancelMerge();
    QVERIFY(session.recipe() == before);
    QCOMPARE(session.undoStack().count(), 2);
    session.apply(withOrder(session.recipe(), 7), "Order", "drag");
    session.apply(before, "Order", "drag"); // a series that has come back by itself
    session.cancelMerge();
    QVERIFY(session.recipe() == before);
    QCOMPARE(session.undoStack().count(), 2);
    session.undoStack().undo();
    QCOMPARE(*session.recipe().realization.order.value, Index(3));
}

void TestSession::undoRedo_manySteps_returnsTheSameState()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    const ProjectState start = session.state();
    Recipe r = session.recipe();
    for (int i = 1; i <= 30; ++i) {
        switch (i % 5) {
        case 0:
            r.pca.components = i;
            break;
        case 1:
            r.window.end_s = 1e-6 * i;
            break;
        case 2:
            r.realization.order = i;
            break;
        case 3:
            r.import.exclude.push_back({1 + i % 3, "because"});
            break;
        default:
            r.certificate.fields["customer"] = std::to_string(i);
        }
        session.apply(r, QString::number(i));
    }
    const ProjectState end = session.state();
    QCOMPARE(session.undoStack().count(), 30);
    while (session.undoStack().canUndo())
        session.undoStack().undo();
    QVERIFY(session.state() == start);
    while (session.undoStack().canRedo())
        session.undoStack().redo();
    QVERIFY(session.state() == end);
    QTRY_VERIFY(!session.isComputing());
    QCOMPARE(shownOrder(session), *end.recipe.realization.order.value);
}

void TestSession::results_whileComputing_stayVisibleAndAreStale()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    pipeline.log->delay_ms = 50;
    session.apply(withOrder(session.recipe(), 7), "Order 7");
    QCOMPARE(shownOrder(session), Index(2)); // the old one, until the new one is there
    QCOMPARE(session.status(StageId::Model), StageStatus::Stale);
    QTRY_COMPARE(shownOrder(session), Index(7));
    QCOMPARE(session.status(StageId::Model), StageStatus::Done);
}

void TestSession::status_afterOrderChange_keepsEarlierStagesDone()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    pipeline.log->delay_ms = 20;
    session.apply(withOrder(session.recipe(), 7), "Order 7");
    QCOMPARE(session.status(StageId::Captures), StageStatus::Done);
    QTRY_VERIFY(!session.isComputing());
}

void TestSession::failure_blocksTheStageAndIsAFinding()
{
    FakePipeline pipeline;
    pipeline.log->fails = true;
    Session session(pipeline);
    QSignalSpy failures(&session, &Session::failed);
    session.reset(threeShots());
    QTRY_COMPARE(failures.count(), 1);
    QCOMPARE(session.status(StageId::Captures), StageStatus::Done);
    QCOMPARE(session.status(StageId::Window), StageStatus::Blocked);
    QCOMPARE(session.status(StageId::Model), StageStatus::Blocked);
    const Findings findings = session.findings();
    QCOMPARE(findings.size(), std::size_t(1));
    QCOMPARE(findings.front().id, std::string("CAP-009"));
    QCOMPARE(findings.front().severity, Severity::Block);
    pipeline.log->fails = false;
    session.recompute();
    QTRY_COMPARE(session.status(StageId::Model), StageStatus::Done);
    QVERIFY(session.findings().empty());
}

void TestSession::certificateText_computesNothing()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    const int runs = pipeline.log->runs;
    Recipe next = session.recipe();
    next.certificate.fields["customer"] = "A";
    QSignalSpy standing(&session, &Session::stageStatusChanged);
    session.apply(next, "Customer");
    QVERIFY(!session.isComputing());
    QCOMPARE(standing.count(), 1); // a page whose fields are filled stands otherwise
    QTest::qWait(40);
    QCOMPARE(pipeline.log->runs.load(), runs);
    QVERIFY(!session.undoStack().isClean());
}

void TestSession::burstOfChanges_endsWithTheNewest()
{
    FakePipeline pipeline;
    pipeline.log->delay_ms = 3;
    Session session(pipeline);
    session.reset(threeShots());
    for (Index order = 1; order <= 60; ++order)
        session.apply(withOrder(session.recipe(), order), "Order", "drag");
    QTRY_VERIFY(!session.isComputing());
    QCOMPARE(shownOrder(session), Index(60));
    QVERIFY(pipeline.log->runs < 10); // not one run for each step
}

void TestSession::drag_slowPipeline_stillShowsResults()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    session.setFocus(StageId::Model);
    pipeline.log->delay_ms = 60; // slower than the steps of the drag
    QSet<Index> seen;
    connect(&session, &Session::resultsChanged, this, [&] { seen << shownOrder(session); });
    for (Index order = 3; order < 43; ++order) {
        session.apply(withOrder(session.recipe(), order), "Order", "drag");
        QTest::qWait(10);
    }
    QTRY_VERIFY(!session.isComputing());
    QCOMPARE(shownOrder(session), Index(42));
    QVERIFY2(seen.size() >= 3, qPrintable(QString::number(seen.size())));
}

/// What a window shows of a move takes some of its time: the run does not wait for it.
void TestSession::drag_move_isComputedWhileItIsShown()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    session.setFocus(StageId::Model);
    QTRY_VERIFY(!session.isComputing());
    const int before = pipeline.log->runs;
    bool wasStale = false;
    bool hasBegun = false;
    connect(&session, &Session::recipeChanged, this, [&] { // no event is handled in here
        wasStale = session.status(StageId::Model) != StageStatus::Done;
        for (int i = 0; i < 5000 && !hasBegun; ++i, QThread::msleep(1))
            hasBegun = pipeline.log->runs > before;
    });
    QSignalSpy standing(&session, &Session::stageStatusChanged);
    session.apply(withOrder(session.recipe(), 5), "Order", "drag");
    QVERIFY(wasStale && hasBegun);
    QCOMPARE(standing.count(), 1);
    QTRY_COMPARE(shownOrder(session), Index(5));
}

void TestSession::drag_rest_waitsForTheHand()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.setFocus(StageId::Model);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    const int before = pipeline.log->runs;
    for (Index order = 3; order < 9; ++order) {
        session.apply(withOrder(session.recipe(), order), "Order", "drag");
        QTRY_COMPARE(shownOrder(session), order);
        QVERIFY(session.isOfThisRun(StageId::Model));
    }
    QCOMPARE(pipeline.log->runs - before, 6); // the focus each time, nothing behind it
    QVERIFY(session.isComputing());
    session.endMerge();
    QTRY_VERIFY(!session.isComputing());
    QVERIFY(session.isUpToDate());
}

/// The automatic end of the window depends on the computed plateau.
void TestSession::affected_shock_startsAtExpected()
{
    const Recipe before;
    Recipe after = before;
    QVERIFY(!dyncal::firstDifferentStage(before, after));
    after.certificate.fields["customer"] = "A";
    QVERIFY(!dyncal::firstDifferentStage(before, after));
    after.response.grid = "linear";
    QCOMPARE(dyncal::firstDifferentStage(before, after).value(), StageId::Response);
    after.response.reference = "unit-step";
    QCOMPARE(dyncal::firstDifferentStage(before, after).value(), StageId::Reference);
    after.shock.enabled = !before.shock.enabled;
    QCOMPARE(dyncal::firstDifferentStage(before, after).value(), StageId::Expected);
}

void TestSession::cancel_leavesStale()
{
    FakePipeline pipeline;
    Session session(pipeline);
    session.reset(threeShots());
    QTRY_VERIFY(!session.isComputing());
    pipeline.log->delay_ms = 2000;
    session.apply(withOrder(session.recipe(), 9), "Order 9");
    QTest::qWait(60);
    session.cancelComputation();
    QVERIFY(!session.isComputing());
    QCOMPARE(session.status(StageId::Model), StageStatus::Stale);
    QCOMPARE(shownOrder(session), Index(2));
    QVERIFY(!session.isUpToDate());
    pipeline.log->delay_ms = 0;
    session.recompute();
    QTRY_VERIFY(session.isUpToDate());
    QCOMPARE(shownOrder(session), Index(9));
}

void TestSession::removeShot_movesNumbersAndIsUndoable()
{
    FakePipeline pipeline;
    Session session(pipeline);
    ProjectState state = threeShots();
    state.recipe.import.exclude = {{1, "first"}, {3, "third"}};
    state.recipe.import.levels = {"low", "medium", "high"};
    state.recipe.window.start_s = {0.1, 0.2, 0.3};
    session.reset(state);
    session.applyState(withoutShot(session.state(), 1), "Remove shot 1");
    QCOMPARE(session.state().captures->shots.size(), std::size_t(2));
    QCOMPARE(session.state().captures->inputs.size(), std::size_t(1));
    QCOMPARE(session.state().captures->shots[0].input, Index(0));
    QCOMPARE(session.recipe().import.exclude.size(), std::size_t(1));
    QCOMPARE(session.recipe().import.exclude[0].shot, Index(2));
    QCOMPARE(session.recipe().import.levels, (std::vector<std::string>{"medium", "high"}));
    QCOMPARE(session.recipe().window.start_s, (std::vector<double>{0.2, 0.3}));
    session.undoStack().undo();
    QVERIFY(session.state() == state);
}

void TestSession::removeShot_movesStretchesAndModes()
{
    ProjectState state = threeShots();
    state.recipe.window.excludeStretches
        = {{1, 0.1, 0.2, "a"}, {2, 0.3, 0.4, "b"}, {3, 0.5, 0.6, "c"}};
    const auto mode = [](std::vector<double> frequency_Hz, Index shot, bool isTube) {
        NuisanceMode made;
        made.frequency_Hz = std::move(frequency_Hz);
        made.shot = shot;
        made.isTube = isTube;
        return made;
    };
    state.recipe.realization.nuisanceModes
        = {mode({1e4}, 0, true), mode({2e4}, 1, true), mode({3e4}, 2, true), mode({4e4}, 2, false),
            mode({5e4}, 3, true), mode({1e3, 2e3, 3e3}, 0, true)};
    state.recipe.window.ownEnds_s = {1e-3, 2e-3, Auto<double>()};
    CaptureSet set = *state.captures;
    for (Shot &shot : set.shots)
        shot.channels.resize(1);
    set.shots[2].channels[0].name = "p";
    state.captures = std::make_shared<const CaptureSet>(set);
    state.recipe.import.shots = {{1, {{"p", "dut"}}}, {2, {{"", "dut"}}}, {3, {{"p", "dut"}}}};
    const Recipe recipe = withoutShot(state, 2).recipe;
    // That of shot 3, now the second; shot 1 has no such channel.
    QVERIFY(recipe.import.shots == (std::vector<ShotImport>{{2, {{"p", "dut"}}}}));
    QVERIFY(recipe.window.ownEnds_s == (std::vector<Auto<double>>{1e-3, Auto<double>()}));
    QVERIFY(recipe.window.excludeStretches
        == (std::vector<ExcludedStretch>{{1, 0.1, 0.2, "a"}, {2, 0.5, 0.6, "c"}}));
    QVERIFY(recipe.realization.nuisanceModes
        == (std::vector<NuisanceMode>{mode({1e4}, 0, true), mode({2e4}, 1, true),
            mode({4e4}, 0, false), mode({5e4}, 2, true), mode({1e3, 3e3}, 0, true)}));
}

void TestSession::findingIds_leadToStages()
{
    QCOMPARE(*stageOfFinding("WIN-001"), StageId::Window);
    QCOMPARE(*stageOfFinding("MOD-003"), StageId::Model);
    QCOMPARE(*stageOfFinding("RSP-001"), StageId::Response);
    QCOMPARE(*stageOfFinding("CAP-006"), StageId::Captures);
    QVERIFY(!stageOfFinding("CER-001"));
    QVERIFY(!stageOfFinding(""));
}

DYNCAL_TEST(TestSession)
#include "tst_session.moc"
