// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"
#include "core/project/recipe.h"
#include "tests/support/test_program.h"
#include "ui/session/example.h"
#include "ui/session/order_candidates.h"
#include "ui/session/session.h"

#include <QSignalSpy>
#include <QThread>
#include <QtTest>

#include <atomic>
#include <thread>

using namespace dyncal;

namespace {

constexpr double kDuration_s = 0.006; ///< of the records: 1 ms of response of every shot
constexpr double kModelRate_Hz = 10e6;
constexpr Index kSamples = 4100; ///< three series of these are a long input
constexpr Index kWholeSet = 60;
constexpr int kPatience_ms = 120'000;
/// A residual of 1e-8 of a pair leaves its value 1e-16 off; what remains is rounding.
constexpr double kSameValue = 1e-10;

/// The pipeline, with the whole decomposition behind a gate.
struct GatedPipeline
{
    struct Gate
    {
        std::atomic<bool> open = false;
        std::atomic<int> wholeSets = 0; ///< asked for
        std::atomic<int> stopped = 0;
    };
    std::shared_ptr<Gate> gate = std::make_shared<Gate>();

    PipelineOutcome operator()(const std::shared_ptr<const CaptureSet> &captures,
        const Recipe &recipe, ResultCache &cache, StageId last, const JobControl &control) const
    {
        const bool isWhole = recipe.realization.maxOrder > kFirstTriplets;
        if (isWhole && last >= StageId::Decomposition) {
            ++gate->wholeSets;
            while (!gate->open && !control.stopRequested())
                QThread::msleep(1);
            if (control.stopRequested()) {
                ++gate->stopped;
                return {{}, Error{ErrorKind::Cancelled, {}, {}, 0}, StageId::Decomposition};
            }
        }
        return runPipeline(captures, recipe, cache, last, control);
    }
};

Recipe longInput(Index samples = kSamples)
{
    Recipe recipe;
    recipe.input.sampleRate_Hz = kModelRate_Hz;
    recipe.input.samples = samples;
    recipe.realization.maxOrder = kWholeSet;
    recipe.realization.order = 2;
    recipe.uncertainty.monteCarloTrials = 100; // nothing here asks for its values
    return recipe;
}

Index values(const Session &session)
{
    const auto &decomposition = session.results().decomposition;
    return decomposition ? decomposition->hankel.singularValues.size() : 0;
}

Index order(const Session &session)
{
    return session.results().model ? session.results().model->order : 0;
}

} // namespace

/// Of a long model input the first singular values, their evidence and the model are there before
/// the whole set is; what is final is what a run without a window gives.
class TestFirstTriplets : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void longInput_firstOnes_precedeTheWholeSet();
    void shortInput_isComputedAtOnce();
    void fewOrdersOffered_areComputedAtOnce();
    void wholeSet_equalsARunWithoutTheWindow();
    void wholeSet_known_isNotLeftAgain();
    void cancel_keepsTheFirstOnes_untilAskedAgain();
    void cancelled_orderAmongTheFirst_followsWithoutTheRest();
    void orderAmongTheFirst_doesNotStartTheRestAnew();
    void orderBeyond_waitsForTheWholeSet();
    void orderBeyond_inTheRecipe_isComputedAtOnce();
    void window_changed_stopsTheWholeSet();
    void pinnedOrders_comeFromTheFirstOnes();
    void failure_ofThePreview_isThatOfTheWholeSet();
    void runs_stoppedAtAnyMoment_leaveNothingHalfDoneInTheCache();

private:
    void choose(Index next)
    {
        Recipe recipe = m_session->recipe();
        recipe.realization.order = next;
        m_session->apply(recipe, "order");
    }
    bool isIdle() const { return !m_session->isComputing(); }
    /// The first ones are on show with all that belongs to them; the whole set is asked for.
    void openWithTheFirst()
    {
        m_session->reset({m_captures, longInput()});
        QTRY_VERIFY_WITH_TIMEOUT(m_gate->wholeSets > 0, kPatience_ms);
        QVERIFY(m_session->showsFirstTriplets());
    }

    std::shared_ptr<const CaptureSet> m_captures;
    std::shared_ptr<GatedPipeline::Gate> m_gate;
    std::unique_ptr<Session> m_session;
};

void TestFirstTriplets::initTestCase()
{
    const auto captures = exampleCaptures({}, kDuration_s);
    QVERIFY(captures);
    m_captures = std::make_shared<const CaptureSet>(*captures);
}

void TestFirstTriplets::init()
{
    GatedPipeline pipeline;
    m_gate = pipeline.gate;
    m_session = std::make_unique<Session>(pipeline);
    m_session->setFocus(StageId::Shock);
}

void TestFirstTriplets::longInput_firstOnes_precedeTheWholeSet()
{
    openWithTheFirst();
    QVERIFY(m_session->isComputing());
    QVERIFY(!m_session->isUpToDate());
    QCOMPARE(values(*m_session), kFirstTriplets);
    QCOMPARE(order(*m_session), Index(2));
    QCOMPARE(m_session->recipeOnShow().realization.maxOrder, kFirstTriplets);
    QCOMPARE(m_session->recipe().realization.maxOrder, kWholeSet);
    // Evidence and response are of the same set as the values.
    QVERIFY(m_session->results().evidence);
    QCOMPARE(m_session->results().evidence->fit_percent.size(), kFirstTriplets);
    for (const StageId stage :
        {StageId::Decomposition, StageId::Model, StageId::Response, StageId::Evidence}) {
        QVERIFY(m_session->isOfThisRun(stage));
        QCOMPARE(m_session->status(stage), StageStatus::Stale);
    }
    QCOMPARE(m_session->status(StageId::ModelInput), StageStatus::Done);
    QVERIFY(!m_session->results().monteCarlo);

    const Eigen::VectorXd first = m_session->results().decomposition->hankel.singularValues;
    m_gate->open = true;
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QVERIFY(m_session->isUpToDate());
    QVERIFY(!m_session->showsFirstTriplets());
    QCOMPARE(values(*m_session), kWholeSet);
    const Eigen::VectorXd &all = m_session->results().decomposition->hankel.singularValues;
    QVERIFY((first - all.head(kFirstTriplets)).cwiseAbs().maxCoeff() < kSameValue * all[0]);
}

void TestFirstTriplets::shortInput_isComputedAtOnce()
{
    m_gate->open = true;
    QSignalSpy results(m_session.get(), &Session::resultsChanged);
    bool showedFirst = false;
    connect(m_session.get(), &Session::resultsChanged, this,
        [&] { showedFirst = showedFirst || m_session->showsFirstTriplets(); });
    m_session->reset({m_captures, longInput(1000)});
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QVERIFY(!showedFirst);
    QCOMPARE(values(*m_session), kWholeSet);
}

void TestFirstTriplets::fewOrdersOffered_areComputedAtOnce()
{
    Recipe recipe = longInput();
    recipe.realization.maxOrder = kFirstTriplets;
    m_session->reset({m_captures, recipe});
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QVERIFY(m_session->isUpToDate());
    QVERIFY(!m_session->showsFirstTriplets());
    QCOMPARE(m_gate->wholeSets.load(), 0);
}

void TestFirstTriplets::wholeSet_equalsARunWithoutTheWindow()
{
    m_gate->open = true;
    m_session->reset({m_captures, longInput()});
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    ResultCache cache;
    const PipelineOutcome direct
        = runPipeline(m_session->state().captures, m_session->recipe(), cache);
    QVERIFY(!direct.error);
    const CalibrationResults &shown = m_session->results();
    QCOMPARE(shown.keys, direct.results.keys);
    QVERIFY(shown.decomposition->hankel.singularValues
        == direct.results.decomposition->hankel.singularValues);
    QCOMPARE(shown.model->fit_percent, direct.results.model->fit_percent);
    QVERIFY(shown.evidence->fit_percent == direct.results.evidence->fit_percent);
    QCOMPARE(shown.evidence->poles.size(), direct.results.evidence->poles.size());
    QVERIFY(shown.monteCarlo != nullptr);
}

void TestFirstTriplets::wholeSet_known_isNotLeftAgain()
{
    m_gate->open = true;
    m_session->reset({m_captures, longInput()});
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    bool showedFirst = false;
    connect(m_session.get(), &Session::resultsChanged, this,
        [&] { showedFirst = showedFirst || m_session->showsFirstTriplets(); });
    choose(50);
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(order(*m_session), Index(50));
    choose(4);
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    // A shorter input and back again: the cache has it.
    Recipe other = m_session->recipe();
    other.input.samples = 1000;
    m_session->apply(other, "short");
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    m_session->undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(values(*m_session), kWholeSet);
    QCOMPARE(m_session->results().input->samples, kSamples);
    QVERIFY(!showedFirst);
}

void TestFirstTriplets::cancel_keepsTheFirstOnes_untilAskedAgain()
{
    openWithTheFirst();
    m_session->cancelComputation();
    QVERIFY(isIdle());
    QVERIFY(!m_session->isUpToDate());
    QTRY_COMPARE(m_gate->stopped.load(), 1);
    QCOMPARE(values(*m_session), kFirstTriplets);
    QCOMPARE(order(*m_session), Index(2));
    QVERIFY(m_session->results().evidence);
    QCOMPARE(m_session->status(StageId::Decomposition), StageStatus::Stale);
    m_gate->open = true;
    m_session->recompute();
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QVERIFY(m_session->isUpToDate());
    QCOMPARE(values(*m_session), kWholeSet);
}

void TestFirstTriplets::cancelled_orderAmongTheFirst_followsWithoutTheRest()
{
    openWithTheFirst();
    m_session->cancelComputation();
    const int before = m_gate->wholeSets;
    choose(4);
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(order(*m_session), Index(4));
    QVERIFY(m_session->showsFirstTriplets());
    QVERIFY(!m_session->isUpToDate());
    QCOMPARE(m_gate->wholeSets.load(), before);
}

void TestFirstTriplets::orderAmongTheFirst_doesNotStartTheRestAnew()
{
    openWithTheFirst();
    for (const Index next : {3, 4, 5}) {
        choose(next);
        QTRY_COMPARE_WITH_TIMEOUT(order(*m_session), next, kPatience_ms);
        QTest::qWait(50);
    }
    QCOMPARE(m_gate->wholeSets.load(), 1);
    QCOMPARE(m_gate->stopped.load(), 0);
    m_gate->open = true;
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(order(*m_session), Index(5));
    QCOMPARE(values(*m_session), kWholeSet);
    QVERIFY(m_session->isUpToDate());
}

void TestFirstTriplets::orderBeyond_waitsForTheWholeSet()
{
    openWithTheFirst();
    QVERIFY(!m_session->needsWholeSet());
    choose(kFirstTriplets + 5);
    QVERIFY(m_session->needsWholeSet());
    QTest::qWait(100);
    QVERIFY(m_session->isComputing());
    QCOMPARE(order(*m_session), Index(2)); // still that of the first ones
    QCOMPARE(m_gate->wholeSets.load(), 1); // the one under way
    m_session->cancelComputation();
    QVERIFY(isIdle());
    QCOMPARE(values(*m_session), kFirstTriplets);
    m_gate->open = true;
    choose(kFirstTriplets + 6); // asks for it again
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(order(*m_session), kFirstTriplets + 6);
    QVERIFY(!m_session->needsWholeSet());
    QVERIFY(m_session->isUpToDate());
}

void TestFirstTriplets::orderBeyond_inTheRecipe_isComputedAtOnce()
{
    m_gate->open = true;
    Recipe recipe = longInput();
    recipe.realization.order = kFirstTriplets + 5;
    m_session->reset({m_captures, recipe});
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(order(*m_session), kFirstTriplets + 5);
    QVERIFY(m_session->isUpToDate());
}

void TestFirstTriplets::window_changed_stopsTheWholeSet()
{
    openWithTheFirst();
    m_gate->open = false;
    Recipe other = m_session->recipe();
    other.input.samples = kSamples + 100;
    m_session->apply(other, "longer");
    QTRY_COMPARE_WITH_TIMEOUT(m_gate->stopped.load(), 1, kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(m_gate->wholeSets.load(), 2, kPatience_ms);
    QCOMPARE(m_session->results().input->samples, kSamples + 100);
    QVERIFY(m_session->showsFirstTriplets());
    m_gate->open = true;
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QCOMPARE(values(*m_session), kWholeSet);
    QVERIFY(m_session->isUpToDate());
}

void TestFirstTriplets::pinnedOrders_comeFromTheFirstOnes()
{
    openWithTheFirst();
    Recipe recipe = m_session->recipe();
    recipe.realization.candidates = {3, kFirstTriplets + 5};
    m_session->apply(recipe, "pin");
    QTRY_VERIFY_WITH_TIMEOUT(m_session->candidates().find(3), kPatience_ms);
    QVERIFY(m_session->candidates().waitsForWholeSet(kFirstTriplets + 5));
    QVERIFY(!m_session->candidates().find(kFirstTriplets + 5));
    m_gate->open = true;
    QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->candidates().find(kFirstTriplets + 5), kPatience_ms);
    QVERIFY(!m_session->candidates().find(kFirstTriplets + 5)->error);
    QVERIFY(!m_session->candidates().waitsForWholeSet(kFirstTriplets + 5));
}

/// What fails with the first ones is never shown as the recipe's failure: the whole set decides.
void TestFirstTriplets::failure_ofThePreview_isThatOfTheWholeSet()
{
    Session session([](const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
                        ResultCache &cache, StageId last, const JobControl &control) {
        if (recipe.realization.maxOrder <= kFirstTriplets) {
            PipelineOutcome failed;
            failed.error = Error{ErrorKind::Internal, {"preview", {}}, {}, 0};
            failed.failedStage = StageId::Decomposition;
            return failed;
        }
        return runPipeline(captures, recipe, cache, last, control);
    });
    session.setFocus(StageId::Shock);
    QSignalSpy failures(&session, &Session::failed);
    session.reset({m_captures, longInput()});
    QTRY_VERIFY_WITH_TIMEOUT(!session.isComputing(), kPatience_ms);
    QCOMPARE(failures.count(), 0);
    QVERIFY(session.isUpToDate());
    QCOMPARE(values(session), kWholeSet);
}

void TestFirstTriplets::runs_stoppedAtAnyMoment_leaveNothingHalfDoneInTheCache()
{
    constexpr int kMoments = 12;
    const Recipe recipe = longInput(1000);
    ResultCache fresh;
    const CalibrationResults whole = runPipeline(m_captures, recipe, fresh).results;
    ResultCache cache;
    int stopped = 0;
    for (int moment = 0; moment < kMoments; ++moment) {
        std::stop_source source;
        std::jthread clock([&] {
            QThread::msleep(static_cast<unsigned long>(5 + 11 * moment));
            source.request_stop();
        });
        stopped += runPipeline(m_captures, recipe, cache, kLastStage,
            {source.get_token(),
                {}}).error.has_value();
    }
    QVERIFY(stopped > 0);
    const PipelineOutcome last = runPipeline(m_captures, recipe, cache);
    QVERIFY(!last.error);
    QCOMPARE(last.results.model->fit_percent, whole.model->fit_percent);
    QCOMPARE(last.results.model->findings.size(), whole.model->findings.size());
    const ModelAssessment &assessment = *last.results.assessment;
    QCOMPARE(assessment.findings.size(), whole.assessment->findings.size());
    QCOMPARE(assessment.secondOrder.has_value(), whole.assessment->secondOrder.has_value());
    QVERIFY(last.results.decomposition->suggestion.bic == whole.decomposition->suggestion.bic);
    QVERIFY(last.results.evidence->crossShot_percent == whole.evidence->crossShot_percent);
    QCOMPARE(allFindings(last.results).size(), allFindings(whole).size());
}

DYNCAL_TEST(TestFirstTriplets)
#include "tst_first_triplets.moc"
