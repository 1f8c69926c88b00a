// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"
#include "ui/session/capture_edit.h"
#include "ui/session/project_file.h"

#include <random>

using namespace dyncal;
using namespace dyncal::test;

namespace {

constexpr int kEdits = 30;

/// A change of the recipe that a person could make on one of stages 1 to 9, and that is valid
/// whatever was done before.
using Edit = std::function<void(Recipe &, std::mt19937 &)>;

double drawn(std::mt19937 &random, double from, double to)
{
    return std::uniform_real_distribution<double>(from, to)(random);
}

Index drawn(std::mt19937 &random, Index from, Index to)
{
    return std::uniform_int_distribution<Index>(from, to)(random);
}

const std::vector<Edit> &edits()
{
    static const std::vector<Edit> all{
        [](Recipe &r, std::mt19937 &random) {
            r.import.exclude.clear();
            if (drawn(random, Index(0), Index(1)) > 0)
                r.import.exclude = {{drawn(random, Index(1), Index(2)), "a loose cable"}};
        },
        [](Recipe &r, std::mt19937 &random) { r.shock.T1_K = drawn(random, 290.0, 300.0); },
        [](Recipe &r, std::mt19937 &random) { r.window.end_s = drawn(random, 0.6e-3, 0.9e-3); },
        [](Recipe &r, std::mt19937 &random) {
            r.spectrum.segment = drawn(random, Index(256), Index(512));
        },
        [](Recipe &r, std::mt19937 &random) {
            r.input.samples = drawn(random, Index(600), Index(1200));
        },
        [](Recipe &r, std::mt19937 &random) {
            r.realization.order = 2 * drawn(random, Index(1), Index(3));
        },
        [](Recipe &r, std::mt19937 &random) {
            r.uncertainty.monteCarloTrials = drawn(random, Index(100), Index(200));
        },
        [](Recipe &r, std::mt19937 &random) {
            r.certificate.fields["remarks"]
                = "remark " + std::to_string(drawn(random, Index(1), Index(1000)));
        },
    };
    return all;
}

/// All of the project: recordings by their hashes, shots and recipe.
QByteArray projectOf(const Session &session)
{
    return frozenProjectBytes(session.state());
}

} // namespace

/// Scenario S26: whatever was done is undone and done again, to the byte, and nothing on show is
/// left behind.
class TestUndoEverything : public QObject
{
    Q_OBJECT

private:
    /// The results on show are those of the recipe on show, computed without a window.
    static void verifyNothingIsStale(const ScenarioBench &bench)
    {
        const Session &session = bench.session();
        QVERIFY(session.isUpToDate() || session.error());
        ResultCache cache;
        const PipelineOutcome fresh
            = quickPipeline()(session.state().captures, session.recipe(), cache, kLastStage, {});
        QCOMPARE(session.error().has_value(), fresh.error.has_value());
        const auto &shown = session.results().model;
        QCOMPARE(bool(shown), bool(fresh.results.model));
        if (shown)
            QVERIFY(shown->poles.front().frequency_Hz
                == fresh.results.model->poles.front().frequency_Hz);
        for (const StagePage *page : bench.window->pages())
            QVERIFY2(!page->isDrawing(), qPrintable(page->objectName()));
    }

private slots:
    void s26_thirtyEdits_areUndoneAndDoneAgain_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1u, 2u})
            QTest::addRow("seed %u", seed) << seed;
    }

    void s26_thirtyEdits_areUndoneAndDoneAgain()
    {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        ScenarioBench bench;
        bench.open({bench.record(threeShots())});
        Session &session = bench.session();
        const QByteArray begin = projectOf(session);
        const ProjectState whole = session.state();
        int made = 0;
        while (made < kEdits) {
            const std::size_t kind
                = std::uniform_int_distribution<std::size_t>(0, edits().size())(random);
            if (kind == edits().size()) { // a shot is removed, or comes back
                ProjectState next = session.state();
                if (next.captures->shots.size() == 3) {
                    next = withoutShot(next, 3);
                } else {
                    next.captures = whole.captures;
                }
                session.applyState(next, "shots");
                ++made;
                continue;
            }
            Recipe next = session.recipe();
            edits()[kind](next, random);
            if (next == session.recipe())
                continue;
            session.apply(next, "edit");
            ++made;
            if (made % 7 == 0)
                bench.settle(); // between others it is still computing
        }
        bench.settle();
        const QByteArray end = projectOf(session);
        QVERIFY(begin != end);
        QCOMPARE(session.undoStack().count(), kEdits);
        verifyNothingIsStale(bench);

        for (int i = 0; i < kEdits; ++i)
            bench.window->session().undoStack().undo();
        bench.settle();
        QCOMPARE(projectOf(session), begin);
        QVERIFY(!session.undoStack().canUndo());
        verifyNothingIsStale(bench);

        for (int i = 0; i < kEdits; ++i)
            bench.window->session().undoStack().redo();
        bench.settle();
        QCOMPARE(projectOf(session), end);
        QVERIFY(!session.undoStack().canRedo());
        verifyNothingIsStale(bench);
    }

    void s26_windowDrag_isOneEntry()
    {
        ScenarioBench bench;
        bench.open({bench.record(threeShots())});
        bench.show(Page::Window);
        bench.settle();
        const QByteArray begin = projectOf(bench.session());
        const int before = bench.session().undoStack().count();
        auto *plot = bench.find<PlotWidget>("windowPlot");
        const auto &handles = plot->handles();
        const auto line = std::ranges::find(handles, QString("end"), &HandleState::id);
        QVERIFY(line != handles.end());
        const double to = line->x.begin * 0.9;
        bench.dragLine(plot, "end", to);
        bench.release(plot, to);
        QVERIFY(projectOf(bench.session()) != begin);
        QCOMPARE(bench.session().undoStack().count(), before + 1);
        bench.undo();
        QCOMPARE(projectOf(bench.session()), begin);
    }
};

DYNCAL_TEST(TestUndoEverything)
#include "tst_undo_everything.moc"
