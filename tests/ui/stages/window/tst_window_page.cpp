// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/kept_bench.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/window/window_page.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

using Bench = PageBench<WindowPage>;

constexpr double kSample_s = 1e-7;

const WindowedResponse &responseAt(const Bench &bench, std::size_t i)
{
    return bench.session.results().window->responses.at(i);
}

std::vector<double> startsOf(const Bench &bench)
{
    std::vector<double> starts_s;
    for (const WindowedResponse &response : bench.session.results().window->responses)
        starts_s.push_back(response.start_s);
    return starts_s;
}

void drag(Bench &bench, const QString &line, std::initializer_list<double> way_s)
{
    auto *plot = bench.control<PlotWidget>("windowPlot");
    for (const double *at = way_s.begin(); at != way_s.end(); ++at)
        emit plot->lineMoved(line, *at, at + 1 == way_s.end());
    waitComputed(bench.session);
}

void undo(Bench &bench)
{
    bench.session.undoStack().undo();
    waitComputed(bench.session);
}

void exclude(Bench &bench, Index shot)
{
    Recipe recipe = bench.recipe();
    recipe.import.exclude = {{shot, "tore late"}};
    bench.session.apply(recipe, "exclude");
    waitComputed(bench.session);
}

} // namespace

/// Start, window and bands by hand, over the real pipeline.
class TestWindowPage : public QObject
{
    Q_OBJECT

private:
    Bench &fresh()
    {
        Bench &bench = m_kept.fresh(m_set);
        bench.choose("startShot", 0);
        return bench;
    }
    std::shared_ptr<const CaptureSet> m_set;
    test::KeptBench<WindowPage> m_kept;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(1e7, 0.004); }
    void end_dragged_isOneStep_andTheReadoutsAgree();
    void end_behindThePlateauOfOthers_namesThem();
    void end_ofEachShot_draggedByMouse_movesThatShotAlone();
    void end_ofEachShot_goesNoFurtherThanItsOwnRecord();
    void end_ofEachShot_andBack_toOneForAll();
    void end_draggedBeforeTheStart_isNotTaken();
    void end_typedWhileAtPlateau_leavesThePlateau();
    void start_dragged_movesEveryShotByTheSame_onReleaseOnly();
    void start_typed_isOfTheChosenShotAlone();
    void start_typedInSwedish_takesTheComma();
    void start_detectedAgain_givesTheSame();
    void settleBand_dragged_isOneStep();
    void stretchBand_doesNotMoveTheBaseline();
    void shotExcluded_choiceStaysWithItsShot();
    void remapOff_showsTheRecordsUnit();
    void nonsense_changesNothing();
    void table_stepIsSettledLessBaseline();
    void s18_baselineOverTheStep_saysSoWhileDragging_andEscRestores();
    void blocked_keepsTheLastCurves_paleWithTheReason_andOneWayBack();
};

void TestWindowPage::s18_baselineOverTheStep_saysSoWhileDragging_andEscRestores()
{
    Bench &bench = fresh();
    auto *plot = bench.control<PlotWidget>("windowPlot");
    const Interval view = plot->xRange();
    const double y = 0.5 * (plot->yRange().begin + plot->yRange().end);
    const Recipe before = bench.recipe();
    const double edge_s = responseAt(bench, 0).baseline_s.end;
    QTest::mousePress(plot, Qt::LeftButton, {}, plot->pixelOf(edge_s, y) - QPoint(2, 0));
    QTest::mouseMove(plot, plot->pixelOf(2e-4, y));
    waitComputed(bench.session);
    QVERIFY(bench.session.error());
    QCOMPARE(bench.session.error()->findingId, std::string("WIN-002"));
    QVERIFY(!plot->content().curves.empty() && plot->isDimmed());
    QVERIFY2(plot->notice().contains("overlaps"), qPrintable(plot->notice()));
    QCOMPARE(plot->xRange(), view);
    const auto edge = std::ranges::find(plot->handles(), QString("baseline"), &HandleState::id);
    QVERIFY(std::abs(edge->x.end - 2e-4) < 1e-5); // where the hand is
    QTest::keyClick(plot, Qt::Key_Escape);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, plot->pixelOf(2e-4, y));
    QVERIFY(bench.recipe() == before);
    QVERIFY(bench.control<QCheckBox>("baselineAuto")->isChecked());
    waitComputed(bench.session);
    QVERIFY(!bench.session.error() && !plot->isDimmed() && plot->notice().isEmpty());
    QCOMPARE(bench.session.undoStack().count(), 0);
}

void TestWindowPage::blocked_keepsTheLastCurves_paleWithTheReason_andOneWayBack()
{
    Bench &bench = fresh();
    const auto before = bench.session.results().window;
    auto *table = bench.control<ValueTable>("windowTable");
    Recipe recipe = bench.recipe();
    recipe.window.baseline_s = Interval{-1e-4, 1e-4};
    bench.session.apply(recipe, "Change the baseline");
    waitComputed(bench.session);
    QVERIFY(!bench.session.results().window);
    QCOMPARE(bench.session.resultsOnShow().window, before);
    for (const char *name : {"windowPlot", "windowDetailPlot"}) {
        auto *plot = bench.control<PlotWidget>(name);
        QVERIFY(!plot->content().curves.empty() && plot->isDimmed() && !plot->notice().isEmpty());
    }
    QVERIFY(!table->isEnabled() && table->rowCount() == 3);
    QVERIFY(!bench.control<QLabel>("windowLength")->isEnabled());
    auto *back = bench.control<QPushButton>("pageWayBack");
    QVERIFY(back->isVisible());
    QCOMPARE(back->text(), QString("Undo: Change the baseline"));
    QTest::mouseClick(back, Qt::LeftButton);
    waitComputed(bench.session);
    QCOMPARE(bench.session.results().window, before);
    QVERIFY(table->isEnabled() && !back->isVisible());
}

void TestWindowPage::end_dragged_isOneStep_andTheReadoutsAgree()
{
    Bench &bench = fresh();
    drag(bench, "end", {4e-4, 3e-4, 2e-4});
    QCOMPARE(bench.session.undoStack().count(), 1);
    QCOMPARE(*bench.recipe().window.end_s.value, 2e-4);
    QVERIFY(!bench.control<QCheckBox>("windowEndAuto")->isChecked());
    QCOMPARE(bench.control<QuantityEdit>("windowEndValue")->si(), 2e-4);
    // 200 us at 10 MHz; 1 / 200 us.
    QVERIFY(std::abs(responseAt(bench, 0).length - 2000) <= 1);
    QVERIFY2(bench.control<QLabel>("windowLength")->text().startsWith("200 µs, "),
        qPrintable(bench.control<QLabel>("windowLength")->text()));
    QVERIFY(bench.control<QLabel>("windowResolution")->text().startsWith("5 kHz"));
    const auto *whose = bench.control<QLabel>("windowEndCommon");
    QVERIFY2(whose->text().contains("common to all shots"), qPrintable(whose->text()));
    undo(bench);
    QVERIFY2(whose->text().contains("each shot has an end of its own"), qPrintable(whose->text()));
    QVERIFY(bench.recipe().window.end_s.isAuto());
    QVERIFY(bench.control<QCheckBox>("windowEndAuto")->isChecked());
}

void TestWindowPage::end_behindThePlateauOfOthers_namesThem()
{
    Bench &bench = fresh();
    // Between the plateaus: the slower the shock, the longer it lasts.
    std::vector<double> plateaus_s;
    for (const ShockConditions &shot : bench.session.results().expected->conditions.shots)
        plateaus_s.push_back(shot.plateau_s.value());
    std::ranges::sort(plateaus_s);
    const double end_s = 0.5 * (plateaus_s[1] + plateaus_s[2]);
    auto *field = bench.control<QuantityEdit>("windowEndValue");
    field->selectAll();
    QTest::keyClicks(field, QString::number(1e3 * end_s, 'f', 6) + " ms");
    QTest::keyClick(field, Qt::Key_Return);
    waitComputed(bench.session);
    QVERIFY(std::abs(*bench.recipe().window.end_s.value - end_s) < 1e-9);
    const QString said = bench.control<QLabel>("windowEndCommon")->text();
    for (const ShockConditions &shot : bench.session.results().expected->conditions.shots) {
        const QString named
            = QString("%1 (%2)").arg(shot.shot).arg(shownQuantity(*shot.plateau_s, "s", 3));
        QCOMPARE(said.contains(named), *shot.plateau_s < end_s);
    }
}

void TestWindowPage::end_ofEachShot_draggedByMouse_movesThatShotAlone()
{
    Bench &bench = fresh();
    const auto ends = [&] {
        std::vector<double> ends_s;
        for (std::size_t i = 0; i < 3; ++i)
            ends_s.push_back(responseAt(bench, i).end_s);
        return ends_s;
    };
    const std::vector<double> before_s = ends();
    auto *whose = bench.control<QComboBox>("windowEndFor");
    QCOMPARE(whose->currentText(), QString("all shots"));
    whose->setFocus();
    QTest::keyClick(whose, Qt::Key_Down);
    waitComputed(bench.session);
    QCOMPARE(whose->currentText(), QString("each shot by itself"));
    QCOMPARE(ends(), before_s); // nothing has moved yet
    bench.choose("startShot", 2);
    const ShockConditions *high = bench.session.results().expected->conditions.ofShot(3);
    const double target_s = 1.02 * high->plateau_s.value(); // a little after its plateau
    auto *plot = bench.control<PlotWidget>("windowPlot");
    plot->setXRange({-1e-4, 1.2 * target_s});
    const double y = 0.5 * (plot->yRange().begin + plot->yRange().end);
    const auto line = [&] {
        const auto end = std::ranges::find(plot->handles(), QString("end"), &HandleState::id);
        return end->x.begin;
    };
    QTest::mousePress(plot, Qt::LeftButton, {}, plot->pixelOf(line(), y));
    QTest::mouseMove(plot, plot->pixelOf(0.5 * (line() + target_s), y));
    QTest::mouseMove(plot, plot->pixelOf(target_s, y));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, plot->pixelOf(target_s, y));
    waitComputed(bench.session);
    QVERIFY(std::abs(ends()[2] - target_s) < 0.01 * target_s);
    QCOMPARE(ends()[0], before_s[0]);
    QCOMPARE(ends()[1], before_s[1]);
    QCOMPARE(bench.recipe().window.ownEnds_s.size(), std::size_t(3));
    QVERIFY(bench.recipe().window.ownEnds_s[1].isAuto());
    QVERIFY(bench.recipe().window.end_s.isAuto());
    std::vector<Index> late; // of which shots WIN-001 is told
    for (const Finding &finding : bench.session.results().window->findings)
        if (finding.id == "WIN-001")
            late.push_back(finding.shot);
    QCOMPARE(late, std::vector<Index>{3});
    const QString said = bench.control<QLabel>("windowEndCommon")->text();
    QVERIFY2(said.contains("the end of shot 3 alone"), qPrintable(said));
    bench.choose("startShot", 0);
    QVERIFY(bench.control<QCheckBox>("windowEndAuto")->isChecked());
    QVERIFY(std::abs(bench.control<QuantityEdit>("windowEndValue")->si() - before_s[0]) < 1e-9);
    QCOMPARE(bench.session.undoStack().count(), 2);
    undo(bench);
    QCOMPARE(ends(), before_s);
    undo(bench);
    QCOMPARE(whose->currentText(), QString("all shots"));
}

void TestWindowPage::end_ofEachShot_goesNoFurtherThanItsOwnRecord()
{
    Bench &bench = fresh();
    bench.choose("windowEndFor", 1);
    bench.choose("startShot", 1);
    drag(bench, "end", {1.0}); // far behind every record
    QVERIFY2(!bench.session.error(), "the end left the record");
    const auto at = static_cast<std::size_t>(responseAt(bench, 1).shot - 1);
    const Channel *dut
        = bench.session.results().captures->set.shots[at].channelWithRole(ChannelRole::Dut);
    const double last_s = dut->t0_s + dut->duration_s() - responseAt(bench, 1).start_s;
    QVERIFY(std::abs(responseAt(bench, 1).end_s - last_s) < 2.0 * kSample_s);
    const QString said = bench.control<QLabel>("windowEndCommon")->text();
    QVERIFY2(said.contains("The record of shot 2 ends here"), qPrintable(said));
}

void TestWindowPage::end_ofEachShot_andBack_toOneForAll()
{
    Bench &bench = fresh();
    const auto typeEnd = [&](const char *text) {
        auto *field = bench.control<QuantityEdit>("windowEndValue");
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    };
    typeEnd("200");
    bench.choose("windowEndFor", 1);
    waitComputed(bench.session);
    for (const Auto<double> &end_s : bench.recipe().window.ownEnds_s)
        QCOMPARE(*end_s.value, 2e-4); // what held goes on to hold
    bench.choose("startShot", 1);
    typeEnd("300");
    waitComputed(bench.session);
    QVERIFY(std::abs(responseAt(bench, 0).end_s - 2e-4) < 2.0 * kSample_s);
    QVERIFY(std::abs(responseAt(bench, 1).end_s - 3e-4) < 2.0 * kSample_s);
    bench.choose("windowEndFor", 0);
    waitComputed(bench.session);
    QVERIFY(bench.recipe().window.ownEnds_s.empty());
    QCOMPARE(*bench.recipe().window.end_s.value, 3e-4); // that of the shot on show
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(std::abs(responseAt(bench, i).end_s - 3e-4) < 2.0 * kSample_s);
    bench.control<QCheckBox>("endAtPlateau")->click();
    waitComputed(bench.session);
    QVERIFY(!bench.control<QComboBox>("windowEndFor")->isEnabled());
}

void TestWindowPage::end_draggedBeforeTheStart_isNotTaken()
{
    Bench &bench = fresh();
    drag(bench, "end", {-1e-5, -5e-5});
    QVERIFY(bench.recipe().window.end_s.isAuto());
    QCOMPARE(bench.session.undoStack().count(), 0);
    QVERIFY(!bench.session.error());
}

void TestWindowPage::end_typedWhileAtPlateau_leavesThePlateau()
{
    Bench &bench = fresh();
    bench.control<QCheckBox>("endAtPlateau")->click();
    waitComputed(bench.session);
    QVERIFY(bench.recipe().window.endAtPlateau);
    const double plateau_s = responseAt(bench, 2).end_s;
    bench.choose("startShot", 2);
    QVERIFY(std::abs(bench.control<QuantityEdit>("windowEndValue")->si() - plateau_s) < 1e-9);
    drag(bench, "end", {3e-4});
    QVERIFY(!bench.recipe().window.endAtPlateau);
    QVERIFY(!bench.control<QCheckBox>("endAtPlateau")->isChecked());
    undo(bench);
    QVERIFY(bench.recipe().window.endAtPlateau);
    QCOMPARE(responseAt(bench, 2).end_s, plateau_s);
}

void TestWindowPage::start_dragged_movesEveryShotByTheSame_onReleaseOnly()
{
    Bench &bench = fresh();
    const std::vector<double> before_s = startsOf(bench);
    emit bench.control<PlotWidget>("windowPlot")->lineMoved("start", 1e-6, false);
    QVERIFY(bench.recipe().window.start_s.empty()); // the axis itself would move under the hand
    drag(bench, "start", {2e-6, 3e-6});
    QCOMPARE(bench.session.undoStack().count(), 1);
    const std::vector<double> after_s = startsOf(bench);
    for (std::size_t i = 0; i < before_s.size(); ++i)
        QVERIFY(std::abs(after_s[i] - before_s[i] - 3e-6) <= kSample_s);
    undo(bench);
    QCOMPARE(startsOf(bench), before_s);
}

void TestWindowPage::start_typed_isOfTheChosenShotAlone()
{
    Bench &bench = fresh();
    const std::vector<double> before_s = startsOf(bench);
    bench.control<QCheckBox>("startAuto")->click();
    waitComputed(bench.session);
    QCOMPARE(startsOf(bench), before_s); // what was used is what is typed
    bench.choose("startShot", 1);
    auto *field = bench.control<QuantityEdit>("startValue");
    QVERIFY(std::abs(field->si() - before_s[1]) < 1e-11);
    field->setValue(field->value() + 4.0);
    waitComputed(bench.session);
    const std::vector<double> after_s = startsOf(bench);
    QCOMPARE(after_s[0], before_s[0]);
    QVERIFY(std::abs(after_s[1] - before_s[1] - 4e-6) <= kSample_s);
    QCOMPARE(after_s[2], before_s[2]);
    bench.choose("startShot", 0);
    QVERIFY(std::abs(field->si() - before_s[0]) < 1e-11);
}

void TestWindowPage::start_typedInSwedish_takesTheComma()
{
    const test::InSwedish swedish;
    Bench bench(m_set);
    bench.control<QCheckBox>("windowEndAuto")->click();
    auto *field = bench.control<QuantityEdit>("windowEndValue");
    field->selectAll();
    QTest::keyClicks(field, "250,5");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(std::abs(*bench.recipe().window.end_s.value - 250.5e-6) < 1e-15);
    QVERIFY2(field->text().startsWith("250,5"), qPrintable(field->text()));
    field->selectAll();
    QTest::keyClicks(field, "1.000,5"); // no number in any language: not one either
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(std::abs(*bench.recipe().window.end_s.value - 250.5e-6) < 1e-15);
    waitComputed(bench.session);
}

void TestWindowPage::start_detectedAgain_givesTheSame()
{
    Bench &bench = fresh();
    const std::vector<double> before_s = startsOf(bench);
    drag(bench, "start", {5e-6});
    bench.control<QCheckBox>("startAuto")->click(); // back to the program's rule
    waitComputed(bench.session);
    QVERIFY(bench.recipe().window.start_s.empty());
    QCOMPARE(startsOf(bench), before_s);
}

void TestWindowPage::settleBand_dragged_isOneStep()
{
    Bench &bench = fresh();
    auto *plot = bench.control<PlotWidget>("windowPlot");
    emit plot->bandMoved("settle", {1e-4, 2e-4}, false);
    emit plot->bandMoved("settle", {1.5e-4, 2.5e-4}, true);
    waitComputed(bench.session);
    QCOMPARE(bench.session.undoStack().count(), 1);
    QCOMPARE(bench.recipe().window.settle_s.value->begin, 1.5e-4);
    QCOMPARE(bench.control<QuantityEdit>("settleEnd")->si(), 2.5e-4);
    // A second drag is a step of its own.
    emit plot->bandMoved("settle", {1e-4, 2e-4}, true);
    waitComputed(bench.session);
    QCOMPARE(bench.session.undoStack().count(), 2);
    undo(bench);
    QCOMPARE(bench.recipe().window.settle_s.value->begin, 1.5e-4);
}

void TestWindowPage::stretchBand_doesNotMoveTheBaseline()
{
    Bench &bench = fresh();
    emit bench.control<PlotWidget>("windowPlot")->bandMoved("stretch0", {1e-5, 2e-5}, true);
    emit bench.control<PlotWidget>("windowPlot")->bandMoved("guard", {1e-5, 2e-5}, true);
    QVERIFY(bench.recipe().window.baseline_s.isAuto());
    QVERIFY(bench.recipe().window.settle_s.isAuto());
    QCOMPARE(bench.session.undoStack().count(), 0);
}

void TestWindowPage::shotExcluded_choiceStaysWithItsShot()
{
    Bench &bench = fresh();
    bench.choose("startShot", 1);
    exclude(bench, 1);
    auto *shots = bench.control<QComboBox>("startShot");
    QCOMPARE(shots->count(), 2);
    // What is typed next is of the shot that was looked at.
    QVERIFY2(shots->currentText().startsWith("Shot 2"), qPrintable(shots->currentText()));
    undo(bench);
    QVERIFY2(shots->currentText().startsWith("Shot 2"), qPrintable(shots->currentText()));
}

void TestWindowPage::remapOff_showsTheRecordsUnit()
{
    Bench &bench = fresh();
    const auto *plot = bench.control<PlotWidget>("windowPlot"); // its content is another each time
    QVERIFY(plot->content().yAxis.unit.isEmpty());
    const double step = responseAt(bench, 0).step;
    bench.control<QCheckBox>("remap")->click();
    waitComputed(bench.session);
    QCOMPARE(plot->content().yAxis.unit, QString::fromStdString(responseAt(bench, 0).unit));
    QVERIFY(!plot->content().yAxis.unit.isEmpty());
    QVERIFY(std::abs(responseAt(bench, 0).step - step) < 1e-9 * std::abs(step));
}

void TestWindowPage::nonsense_changesNothing()
{
    Bench &bench = fresh();
    for (const char *box : {"baselineAuto", "windowEndAuto", "settleAuto"})
        bench.control<QCheckBox>(box)->click();
    waitComputed(bench.session);
    const Recipe before = bench.recipe();
    for (const char *name : {"baselineBegin", "baselineEnd", "windowEndValue", "settleBegin"})
        for (const char *typed : {"", "abc", "1e99", "-", "--3", "1,2,3"}) {
            auto *field = bench.control<QuantityEdit>(name);
            field->selectAll();
            QTest::keyClick(field, Qt::Key_Delete);
            QTest::keyClicks(field, typed);
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY2(bench.recipe() == before,
                qPrintable(QString("%1: '%2'").arg(QString(name), QString(typed))));
        }
}

void TestWindowPage::table_stepIsSettledLessBaseline()
{
    Bench &bench = fresh();
    auto *table = bench.control<ValueTable>("windowTable");
    QCOMPARE(table->rowCount(), 3);
    const auto number = [&](int row, int column) {
        return table->item(row, column)->text().section(' ', 0, 0).toDouble();
    };
    for (int row = 0; row < 3; ++row) {
        const WindowedResponse &response = responseAt(bench, static_cast<std::size_t>(row));
        QVERIFY(std::abs(response.settled - response.baseline - response.step)
            < 1e-12 * std::abs(response.step));
        QVERIFY(std::abs(number(row, 6) - response.snr_dB) < 0.5);
    }
    exclude(bench, 2);
    QCOMPARE(table->rowCount(), 2);
    QVERIFY(table->item(1, 0)->text().startsWith("3 "));
}

DYNCAL_TEST(TestWindowPage)
#include "tst_window_page.moc"
