// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/kept_bench.h"
#include "ui/stages/captures_page.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/quantity_edit.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

/// Made before the page, which keeps a reference.
struct ScriptedPrompts
{
    ScriptedPrompts() { prompts.setScripted(); }
    Prompts prompts;
};

struct ScriptedCapturesPage : ScriptedPrompts, CapturesPage
{
    explicit ScriptedCapturesPage(Session &session)
        : CapturesPage(session, prompts)
    {
    }
};

using Bench = PageBench<ScriptedCapturesPage>;

QTableWidgetItem *useOf(Bench &bench, int row)
{
    return bench.control<QTableWidget>("shotTable")->item(row, 0);
}

void tick(Bench &bench, int row, bool use)
{
    useOf(bench, row)->setCheckState(use ? Qt::Checked : Qt::Unchecked);
    waitComputed(bench.session);
}

std::vector<double> stepsOf(const Session &session)
{
    std::vector<double> steps;
    for (const WindowedResponse &response : session.results().window->responses)
        steps.push_back(response.step);
    return steps;
}

std::size_t curvesOf(Bench &bench)
{
    return bench.control<PlotWidget>("rawPlot_dut")->content().curves.size();
}

void undo(Session &session)
{
    session.undoStack().undo();
    waitComputed(session);
}

} // namespace

/// The recordings as a technician sorts them, over the real pipeline.
class TestCapturesPage : public QObject
{
    Q_OBJECT

private:
    Bench &fresh()
    {
        Bench &bench = m_kept.fresh(m_set);
        return bench;
    }
    std::shared_ptr<const CaptureSet> m_set;
    test::KeptBench<ScriptedCapturesPage> m_kept;

private slots:
    void unitsThatDiffer_haveAPlotEach();
    void initTestCase() { m_set = testing::simulatedExample(1e7, 0.004); }
    void unticked_withoutAReason_isTickedAgain();
    void unticked_withAReason_isOutEverywhere_andUndoBringsItBack();
    void lastShotUnticked_saysSoAndGoesBack();
    void tagged_byStepHeight_isTheOrderOfTheSteps();
    void level_picked_isOfThatShotAlone();
    void rate_withoutAReason_isNotTaken();
    void rate_withAReason_isHandedOn();
    void factorAndPolarity_scaleTheSteps();
    void unit_typed_isTrimmedAndEmptiedIsTheRecordings();
    void shot_removed_exclusionsMoveUp_andUndoBringsItBack();
    void role_changed_takesTheChannelOut_andUndoBringsItBack();
    void swedish_reasonAndRolesAreShown();
};

void TestCapturesPage::unticked_withoutAReason_isTickedAgain()
{
    Bench &bench = fresh();
    tick(bench, 1, false); // the question is cancelled
    QVERIFY(bench.recipe().import.exclude.empty());
    QCOMPARE(useOf(bench, 1)->checkState(), Qt::Checked);
}

void TestCapturesPage::unticked_withAReason_isOutEverywhere_andUndoBringsItBack()
{
    Bench &bench = fresh();
    const std::size_t drawn = curvesOf(bench);
    bench.page.prompts.setNextSentence("the diaphragm tore late");
    tick(bench, 1, false);
    const std::vector<ExcludedShot> expected{{2, "the diaphragm tore late"}};
    QVERIFY(bench.recipe().import.exclude == expected);
    QVERIFY(useOf(bench, 1)->toolTip().contains("the diaphragm tore late"));
    QCOMPARE(stepsOf(bench.session).size(), std::size_t(2));
    QCOMPARE(curvesOf(bench), drawn - 1);
    QCOMPARE(bench.session.undoStack().count(), 1);
    undo(bench.session);
    QCOMPARE(useOf(bench, 1)->checkState(), Qt::Checked);
    QCOMPARE(stepsOf(bench.session).size(), std::size_t(3));
    bench.session.undoStack().redo();
    waitComputed(bench.session);
    tick(bench, 1, true); // taken in by hand it needs no reason
    QVERIFY(bench.recipe().import.exclude.empty());
}

void TestCapturesPage::lastShotUnticked_saysSoAndGoesBack()
{
    Bench &bench = fresh();
    for (int row = 0; row < 3; ++row) {
        bench.page.prompts.setNextSentence("wrong sensor");
        tick(bench, row, false);
    }
    // Nothing is left to compute from: a sentence, not a crash, and the shots are still there.
    QVERIFY(bench.session.error());
    QCOMPARE(bench.control<QTableWidget>("shotTable")->rowCount(), 3);
    QVERIFY(bench.control<QLabel>("pageProblem")->isVisible()
        || bench.session.failedStage() != StageId::Captures);
    undo(bench.session);
    QVERIFY(!bench.session.error());
    QVERIFY(!bench.control<QLabel>("pageProblem")->isVisible());
    QCOMPARE(stepsOf(bench.session).size(), std::size_t(1));
}

void TestCapturesPage::tagged_byStepHeight_isTheOrderOfTheSteps()
{
    CaptureSet shuffled = *m_set; // recorded from high to low, and nobody wrote it down
    std::ranges::reverse(shuffled.shots);
    for (Shot &shot : shuffled.shots)
        shot.level = ShotLevel::None;
    Bench bench(std::make_shared<const CaptureSet>(shuffled));
    bench.control<QPushButton>("tagByStepHeight")->click();
    waitComputed(bench.session);
    QCOMPARE(bench.recipe().import.levels, (std::vector<std::string>{"high", "medium", "low"}));
    QCOMPARE(bench.control<QComboBox>("levelOfShot1")->currentText(), QString("High"));
    undo(bench.session);
    QVERIFY(bench.recipe().import.levels.empty());
    QCOMPARE(bench.control<QComboBox>("levelOfShot1")->currentIndex(), 0);
    bench.page.prompts.setNextSentence("tore late"); // one that is out has no level
    tick(bench, 1, false);
    bench.control<QPushButton>("tagByStepHeight")->click();
    waitComputed(bench.session);
    QCOMPARE(bench.recipe().import.levels, (std::vector<std::string>{"high", "", "low"}));
}

void TestCapturesPage::level_picked_isOfThatShotAlone()
{
    Bench &bench = fresh();
    bench.choose("levelOfShot2", 3);
    waitComputed(bench.session);
    QCOMPARE(bench.recipe().import.levels, (std::vector<std::string>{"low", "high", "high"}));
    QCOMPARE(bench.session.results().window->responses[1].level, ShotLevel::High);
    undo(bench.session);
    QCOMPARE(bench.control<QComboBox>("levelOfShot2")->currentIndex(), 2);
}

void TestCapturesPage::rate_withoutAReason_isNotTaken()
{
    Bench &bench = fresh();
    QSignalSpy handed(&bench.page, &CapturesPage::importChanged);
    auto *field = bench.control<QLineEdit>("sampleRateValue");
    QCOMPARE(field->text(), QString("10"));
    bench.type("sampleRateValue", "5");
    QCOMPARE(handed.count(), 0);
    QCOMPARE(field->text(), QString("10"));
    bench.type("sampleRateValue", "fast"); // nonsense asks nothing and takes nothing away
    QCOMPARE(field->text(), QString("10"));
}

void TestCapturesPage::rate_withAReason_isHandedOn()
{
    Bench &bench = fresh();
    QSignalSpy handed(&bench.page, &CapturesPage::importChanged);
    bench.page.prompts.setNextSentence("the clock was divided by two");
    bench.type("sampleRateValue", "5");
    QCOMPARE(handed.count(), 1);
    const auto next = handed.at(0).at(0).value<ImportSettings>();
    QCOMPARE(*next.sampleRate_Hz, 5e6);
    QCOMPARE(next.sampleRateReason, std::string("the clock was divided by two"));
    QVERIFY(!bench.recipe().import.sampleRate_Hz); // the window decides, it may have to read again
}

void TestCapturesPage::factorAndPolarity_scaleTheSteps()
{
    Bench &bench = fresh();
    const std::vector<double> before = stepsOf(bench.session);
    bench.control<QuantityEdit>("dutScale")->setValue(2.5);
    waitComputed(bench.session);
    bench.control<QCheckBox>("dutInverted")->click();
    waitComputed(bench.session);
    const std::vector<double> after = stepsOf(bench.session);
    for (std::size_t i = 0; i < before.size(); ++i)
        QVERIFY(std::abs(after[i] / before[i] + 2.5) < 1e-9);
    undo(bench.session);
    undo(bench.session);
    QCOMPARE(stepsOf(bench.session), before);
    QVERIFY(!bench.control<QCheckBox>("dutInverted")->isChecked());
    QCOMPARE(bench.control<QuantityEdit>("dutScale")->value(), 1.0);
}

void TestCapturesPage::unit_typed_isTrimmedAndEmptiedIsTheRecordings()
{
    Bench &bench = fresh();
    bench.type("dutUnit", "  bar ");
    waitComputed(bench.session);
    QCOMPARE(*bench.recipe().import.unit, std::string("bar"));
    auto *unit = bench.control<QLineEdit>("dutUnit");
    unit->selectAll();
    QTest::keyClick(unit, Qt::Key_Delete);
    QTest::keyClick(unit, Qt::Key_Return);
    waitComputed(bench.session);
    QVERIFY(!bench.recipe().import.unit);
    QCOMPARE(bench.session.undoStack().count(), 2);
    QTest::keyClick(unit, Qt::Key_Return); // nothing was typed: no step
    QCOMPARE(bench.session.undoStack().count(), 2);
}

void TestCapturesPage::shot_removed_exclusionsMoveUp_andUndoBringsItBack()
{
    Bench &bench = fresh();
    bench.page.prompts.setNextSentence("too weak");
    tick(bench, 2, false);
    bench.control<QTableWidget>("shotTable")->setCurrentCell(-1, -1);
    bench.control<QPushButton>("removeShot")->click(); // none selected: none removed
    QCOMPARE(bench.session.state().captures->shots.size(), std::size_t(3));
    bench.control<QTableWidget>("shotTable")->setCurrentCell(0, 0);
    bench.control<QPushButton>("removeShot")->click();
    waitComputed(bench.session);
    QCOMPARE(bench.control<QTableWidget>("shotTable")->rowCount(), 2);
    QCOMPARE(bench.recipe().import.exclude.at(0).shot, Index(2)); // the third became the second
    QCOMPARE(useOf(bench, 1)->checkState(), Qt::Unchecked);
    undo(bench.session);
    QCOMPARE(bench.control<QTableWidget>("shotTable")->rowCount(), 3);
    QCOMPARE(bench.recipe().import.exclude.at(0).shot, Index(3));
    QCOMPARE(useOf(bench, 1)->checkState(), Qt::Checked);
}

void TestCapturesPage::role_changed_takesTheChannelOut_andUndoBringsItBack()
{
    Bench &bench = fresh();
    const Channel *side = m_set->shots[0].channelWithRole(ChannelRole::DrivenSide);
    QVERIFY(side);
    const QString name = "roleOf_" + QString::fromStdString(side->name);
    QVERIFY(bench.control<PlotWidget>("rawPlot_driven_side")->isVisible());
    bench.choose(name, 5); // other
    waitComputed(bench.session);
    QCOMPARE(bench.recipe().import.channels.at(side->name), std::string("other"));
    QVERIFY(!bench.control<PlotWidget>("rawPlot_driven_side")->isVisible());
    undo(bench.session);
    QVERIFY(bench.control<PlotWidget>("rawPlot_driven_side")->isVisible());
    QCOMPARE(bench.control<QComboBox>(name)->currentIndex(), 1);
}

void TestCapturesPage::swedish_reasonAndRolesAreShown()
{
    const test::InSwedish swedish;
    Bench bench(m_set);
    bench.page.prompts.setNextSentence("membranet brast sent <b>&amp;");
    tick(bench, 0, false);
    QCOMPARE(
        useOf(bench, 0)->toolTip(), QString("Uteslutet: membranet brast sent <b>&amp;")); // as is
    QCOMPARE(bench.control<QComboBox>("levelOfShot1")->currentText(), QString("Låg"));
    // Words change, the recipe does not.
    bench.choose("levelOfShot2", 1);
    QCOMPARE(bench.recipe().import.levels.at(1), std::string("low"));
    waitComputed(bench.session);
}

/// Each with its own axis, in its own unit; undo brings the one plot back.
void TestCapturesPage::unitsThatDiffer_haveAPlotEach()
{
    CaptureSet set = *dyncal::testing::simulatedExample(10e6);
    for (Channel &channel : set.shots[1].channels)
        channel.unit = "Pa";
    Bench bench(std::make_shared<const CaptureSet>(set));
    const auto *volts = bench.control<PlotWidget>("rawPlot_dut");
    const auto *pascals = bench.control<PlotWidget>("rawPlot_dut_2");
    QCOMPARE(volts->content().yAxis.unit, QString("V"));
    QCOMPARE(volts->content().curves.size(), std::size_t(2));
    QVERIFY(pascals->isVisible());
    QCOMPARE(pascals->content().yAxis.unit, QString("Pa"));
    Recipe recipe = bench.recipe();
    recipe.import.exclude = {{2, "in another unit"}};
    bench.session.apply(recipe, "Exclude shot 2");
    waitComputed(bench.session);
    QVERIFY(!pascals->isVisible());
    QCOMPARE(volts->content().curves.size(), std::size_t(2));
}

DYNCAL_TEST(TestCapturesPage)
#include "tst_captures_page.moc"
