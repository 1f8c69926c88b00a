// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/captures_page.h"
#include "ui/stages/components_page.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/model_input_page.h"
#include "ui/stages/shock/shock_page.h"

#include <QLineEdit>
#include <QThread>
#include <QtTest>

#include <atomic>

using namespace dyncal;
using test::waitComputed;

namespace {

PipelineOutcome failure(const Error &error)
{
    PipelineOutcome outcome;
    outcome.failedStage = StageId::Window;
    outcome.error = error;
    return outcome;
}

/// Formula results that come when the gate is opened, or an error in their place.
struct GatedSample
{
    std::shared_ptr<std::atomic<bool>> open = std::make_shared<std::atomic<bool>>(true);
    std::shared_ptr<std::atomic<bool>> fails = std::make_shared<std::atomic<bool>>(false);

    PipelineOutcome operator()(const std::shared_ptr<const CaptureSet> &captures,
        const Recipe &recipe, ResultCache &cache, StageId last, const JobControl &control) const
    {
        while (!*open && !control.stopRequested())
            QThread::msleep(1);
        if (control.stopRequested())
            return failure({ErrorKind::Cancelled, {}, {}, 0});
        if (*fails)
            return failure({ErrorKind::DataBlocked,
                {"Channel '%1' has no samples.", {"<img src=x>"}}, "CAP-009", 2});
        return test::samplePipeline(captures, recipe, cache, last, control);
    }
};

/// Made before the page, which keeps a reference.
struct ScriptedPrompts
{
    Prompts prompts;
};
struct ScriptedCapturesPage : ScriptedPrompts, CapturesPage
{
    explicit ScriptedCapturesPage(Session &session)
        : CapturesPage(session, prompts)
    {
    }
};

/// Not of the template below: GCC 12 does not survive it there.
struct GatedSession
{
    GatedSample gated;
    Session session{gated};
    void begin()
    {
        session.reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
    }
};

/// A page whose run waits for the gate.
template <typename Page>
struct GatedBench : GatedSession
{
    Page page;
    std::unique_ptr<InspectorForm> inspector;

    GatedBench()
        : page(session)
        , inspector(page.inspector())
    {
        page.show();
        inspector->show();
    }
    QString status() { return page.template findChild<QLabel *>("pageStatus")->text(); }
    template <typename T>
    T *control(const QString &name)
    {
        T *found = inspector->template findChild<T *>(name);
        return found ? found : page.template findChild<T *>(name);
    }
};

void keepComponents(Session &session, Index kept)
{
    Recipe recipe = session.recipe();
    recipe.pca.components = kept;
    session.apply(recipe, "keep");
}

/// Keys go to the field as if its window were in front.
void typeInto(QLineEdit *field, const QString &text)
{
    field->window()->activateWindow();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
}

} // namespace

/// What every page has: head, status, and that nobody's work is lost while results come in.
class TestPageFrame : public QObject
{
    Q_OBJECT

private slots:
    void status_followsTheRun();
    void cancelled_staysOutOfDate_untilComputedAgain();
    void blocked_saysWhy_andUndoTakesItAway();
    void blocked_inSwedish_namesTheChannelAsItIs();
    void hiddenPage_catchesUpWhenShown();
    void pagesSwitchedWhileComputing_bothShowTheResults();
    void halfTypedNumber_survivesResults();
    void halfTypedUnit_survivesResults();
    void nonsense_leavesWhatWasRecorded();
    void rejectedDistance_isNotLeftStanding();
};

void TestPageFrame::status_followsTheRun()
{
    GatedBench<ComponentsPage> bench;
    QVERIFY(bench.status().endsWith("not started")); // glyph and word
    *bench.gated.open = false;
    bench.begin();
    QVERIFY2(bench.status().endsWith("computing"), qPrintable(bench.status()));
    *bench.gated.open = true;
    waitComputed(bench.session);
    QVERIFY(bench.status().endsWith("done"));
    *bench.gated.open = false;
    keepComponents(bench.session, 2); // the old results are still on show, and said to be old
    QVERIFY2(bench.status().endsWith("out of date"), qPrintable(bench.status()));
    QCOMPARE(bench.control<ValueTable>("residualTable")->rowCount(), 3);
    *bench.gated.open = true;
    waitComputed(bench.session);
    QVERIFY(bench.status().endsWith("done"));
}

void TestPageFrame::cancelled_staysOutOfDate_untilComputedAgain()
{
    GatedBench<ComponentsPage> bench;
    bench.begin();
    waitComputed(bench.session);
    *bench.gated.open = false;
    keepComponents(bench.session, 2);
    bench.session.cancelComputation();
    QVERIFY(bench.status().endsWith("out of date"));
    QVERIFY(!bench.session.isUpToDate());
    *bench.gated.open = true;
    bench.session.recompute();
    waitComputed(bench.session);
    QVERIFY(bench.status().endsWith("done"));
}

void TestPageFrame::blocked_saysWhy_andUndoTakesItAway()
{
    GatedBench<ComponentsPage> bench;
    auto *problem = bench.control<QLabel>("pageProblem");
    bench.begin();
    *bench.gated.fails = true;
    keepComponents(bench.session, 2);
    waitComputed(bench.session);
    QVERIFY(bench.status().endsWith("blocked by Captures") && problem->isVisible());
    *bench.gated.fails = false;
    bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(!problem->isVisible());
}

void TestPageFrame::blocked_inSwedish_namesTheChannelAsItIs()
{
    const test::InSwedish swedish;
    GatedBench<ComponentsPage> bench;
    *bench.gated.fails = true;
    bench.begin();
    waitComputed(bench.session);
    QVERIFY2(bench.status().endsWith("blockerat av Registreringar"), qPrintable(bench.status()));
    // As it stands, not as a picture.
    QVERIFY(bench.control<QLabel>("pageProblem")->text().contains("<img src=x>"));
}

void TestPageFrame::hiddenPage_catchesUpWhenShown()
{
    GatedBench<ComponentsPage> bench;
    bench.begin();
    waitComputed(bench.session);
    auto *kept = bench.control<QuantityEdit>("componentsKept");
    bench.page.hide();
    keepComponents(bench.session, 3);
    waitComputed(bench.session);
    QCOMPARE(kept->value(), 1.0); // a hidden page does nothing
    bench.page.show();
    QCOMPARE(kept->value(), 3.0);
    bench.session.undoStack().undo();
    QCOMPARE(kept->value(), 1.0);
    waitComputed(bench.session);
}

void TestPageFrame::pagesSwitchedWhileComputing_bothShowTheResults()
{
    GatedBench<ComponentsPage> bench;
    ModelInputPage next(bench.session);
    const std::unique_ptr<InspectorForm> inspector(next.inspector());
    *bench.gated.open = false;
    bench.begin();
    auto *input = next.findChild<PlotWidget *>("modelInputPlot");
    bench.page.hide();
    next.show();
    QVERIFY(input->content().curves.empty());
    *bench.gated.open = true;
    waitComputed(bench.session);
    QCOMPARE(input->content().curves.size(), std::size_t(6)); // three shots, at both rates
    QVERIFY(bench.control<PlotWidget>("residualPlot")->content().curves.empty());
    next.hide();
    bench.page.show();
    QCOMPARE(bench.control<PlotWidget>("residualPlot")->content().curves.size(), std::size_t(3));
}

void TestPageFrame::halfTypedNumber_survivesResults()
{
    GatedBench<ShockPage> bench;
    bench.begin();
    waitComputed(bench.session);
    *bench.gated.open = false;
    keepComponents(bench.session, 2);
    auto *p1 = bench.control<QLineEdit>("p1Value");
    typeInto(p1, "99,5");
    QTRY_VERIFY(p1->hasFocus());
    *bench.gated.open = true;
    waitComputed(bench.session); // the page is drawn anew
    QCOMPARE(p1->text(), QString("99,5"));
    QTest::keyClick(p1, Qt::Key_Return);
    QCOMPARE(*bench.session.recipe().shock.p1_Pa, 99.5e3);
}

void TestPageFrame::halfTypedUnit_survivesResults()
{
    GatedBench<ScriptedCapturesPage> bench;
    bench.begin();
    waitComputed(bench.session);
    *bench.gated.open = false;
    keepComponents(bench.session, 2);
    auto *unit = bench.control<QLineEdit>("dutUnit");
    typeInto(unit, "mbar ");
    QTRY_VERIFY(unit->hasFocus());
    *bench.gated.open = true;
    waitComputed(bench.session);
    QCOMPARE(unit->text(), QString("mbar "));
    QTest::keyClick(unit, Qt::Key_Return);
    QCOMPARE(*bench.session.recipe().import.unit, std::string("mbar"));
    QCOMPARE(unit->text(), QString("mbar"));
}

void TestPageFrame::nonsense_leavesWhatWasRecorded()
{
    OptionalEdit edit({"kPa", 1e3}, 1.0, 1e9);
    edit.setNames("p1", "p1");
    edit.set({}, 101.1e3);
    auto *text = edit.findChild<QLineEdit *>("p1Value");
    QCOMPARE(text->text(), QString("101.1"));
    for (const char *typed : {"abc", "-5", "1.2.3"}) {
        text->selectAll();
        QTest::keyClicks(text, typed);
        QTest::keyClick(text, Qt::Key_Return);
        QCOMPARE(text->text(), QString("101.1"));
    }
}

void TestPageFrame::rejectedDistance_isNotLeftStanding()
{
    GatedBench<ShockPage> bench;
    bench.begin();
    waitComputed(bench.session);
    // A place needs a distance first: its uncertainty alone is not taken, and not shown either.
    auto *u = bench.control<QLineEdit>("arrivalDistanceUncertaintyValue");
    QTest::keyClicks(u, "0.2");
    QTest::keyClick(u, Qt::Key_Return);
    QVERIFY(bench.session.recipe().shock.arrivalSensors.empty());
    QVERIFY2(u->text().isEmpty(), qPrintable(u->text()));
}

DYNCAL_TEST(TestPageFrame)
#include "tst_page_frame.moc"
