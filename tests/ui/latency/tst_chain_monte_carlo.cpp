// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The window while the Monte Carlo of the whole chain runs: how long it gives no answer, how soon
// the work has ended after Cancel, and what is left of it then.

#include "core/monte_carlo/chain_monte_carlo.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "ui/shell/files/export_actions.h"

#include <QElapsedTimer>
#include <QPushButton>
#include <QtTest>

#include <atomic>
#include <cstdio>
#include <vector>

using namespace dyncal;

namespace {

constexpr int kPatience_ms = 300'000;
constexpr int kCancels = 5;
constexpr qint64 kBound_ms = 100; ///< of both figures, on a machine that does nothing else

/// How many runs of the pipeline are under way, whatever the session thinks of them.
std::atomic<int> runsUnderWay = 0;

PipelineOutcome countedRun(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId last, const JobControl &control)
{
    ++runsUnderWay;
    PipelineOutcome outcome = runPipeline(captures, recipe, cache, last, control);
    --runsUnderWay;
    return outcome;
}

/// The built-in example in the real window, computed once.
struct ExampleBench : test::WindowBench
{
    ExampleBench()
        : WindowBench(&countedRun)
    {
        window->show();
        window->files().openExample();
        QTRY_VERIFY_WITH_TIMEOUT(session().state().hasShots(), kPatience_ms);
    }
    ~ExampleBench()
    {
        session().cancelComputation();
        QTRY_VERIFY_WITH_TIMEOUT(runsUnderWay == 0, kPatience_ms);
    }
    Session &session() const { return window->session(); }
    bool isDrawing() const
    {
        return session().isComputing() && session().isOfThisRun(StageId::Evidence)
            && session().results().evidence && !session().isOfThisRun(StageId::ChainMonteCarlo);
    }
    void waitDrawing() const { QTRY_VERIFY_WITH_TIMEOUT(isDrawing(), kPatience_ms); }
    void waitComputed() const { QTRY_VERIFY_WITH_TIMEOUT(!session().isComputing(), kPatience_ms); }
    /// Another seed: what is drawn is drawn anew.
    void drawAgain(Index seed) const
    {
        Recipe recipe = session().recipe();
        recipe.uncertainty.seed = seed;
        session().apply(recipe, "seed");
    }
};

} // namespace

class TestChainMonteCarlo : public QObject
{
    Q_OBJECT

private slots:
    void windowAnswers_whileItRuns()
    {
        const ExampleBench bench;
        bench.waitDrawing();
        QElapsedTimer taken;
        taken.start();
        test::EventLoopWatchdog watchdog;
        bench.waitComputed();
        std::printf("Monte Carlo of the example in the window: %.1f s, longest time without an "
                    "answer %lld ms, of it work of the window %lld ms (bound %lld ms)\n",
            1e-3 * static_cast<double>(taken.elapsed()), watchdog.longestGap_ms(),
            watchdog.longestWork_ms(), kBound_ms);
        QVERIFY(bench.session().isUpToDate());
        QVERIFY(bench.session().results().chainMonteCarlo);
    }

    /// After Cancel the run has ended; nothing of it is certified, and a later one is whole.
    void cancelled_leavesNothingHalf()
    {
        const ExampleBench bench;
        bench.waitDrawing();
        QElapsedTimer drawing;
        drawing.start();
        bench.waitComputed();
        const double whole_ms = static_cast<double>(drawing.elapsed());
        const auto whole = bench.session().results().chainMonteCarlo;
        std::vector<qint64> taken_ms;
        for (int i = 0; i < kCancels; ++i) {
            bench.drawAgain(100 + i);
            bench.waitDrawing();
            QTest::qWait(static_cast<int>(0.6 * whole_ms * i / kCancels)); // at several places
            QVERIFY(bench.isDrawing());
            QElapsedTimer taken;
            taken.start();
            bench.find<QPushButton>("cancelButton")->click();
            QVERIFY(!bench.session().isComputing());
            QTRY_VERIFY_WITH_TIMEOUT(runsUnderWay == 0, kPatience_ms);
            taken_ms.push_back(taken.elapsed());
            QVERIFY(!bench.session().isUpToDate());
            QVERIFY(!bench.session().isOfThisRun(StageId::ChainMonteCarlo)
                || bench.session().results().chainMonteCarlo == whole);
            QVERIFY(bench.session().status(StageId::ChainMonteCarlo) != StageStatus::Done);
            QVERIFY(ExportActions::whyNoResults(bench.session()));
        }
        std::printf("Cancel to idle:");
        for (const qint64 one : taken_ms)
            std::printf(" %lld ms", one);
        std::printf(" (bound %lld ms)\n", kBound_ms);
    }

    /// Neither file nor certificate can be written of what was stopped.
    void cancelled_exportsNothing()
    {
        ExampleBench bench;
        bench.waitDrawing();
        bench.find<QPushButton>("cancelButton")->click();
        bench.prompts.setNextFile(bench.folder.filePath("out"));
        bench.window->files().exportResults();
        bench.window->files().exportCertificate();
        QCOMPARE(bench.prompts.shownProblems().size(), 2);
        QVERIFY2(bench.prompts.shownProblems().front().contains("out of date"),
            qPrintable(bench.prompts.shownProblems().front()));
        QVERIFY(!QFileInfo::exists(bench.folder.filePath("out")));
    }

    void recomputed_isWhole()
    {
        const ExampleBench bench;
        bench.waitDrawing();
        bench.find<QPushButton>("cancelButton")->click();
        bench.session().recompute();
        bench.waitComputed();
        const auto drawn = bench.session().results().chainMonteCarlo;
        QVERIFY(drawn && drawn->trials == bench.session().recipe().uncertainty.monteCarloTrials);
        QVERIFY(bench.session().isUpToDate());
    }
};

DYNCAL_TEST(TestChainMonteCarlo)
#include "tst_chain_monte_carlo.moc"
