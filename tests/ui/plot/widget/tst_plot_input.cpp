// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/plot/widget/plot_bench.h"

#include <QSignalSpy>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::test;

/// Mouse and keyboard on a plot.
class TestPlotInput : public QObject
{
    Q_OBJECT

private slots:
    void wheel_overPlot_zoomsAtPointer();
    void wheel_withControlAndShift_zoomsYAndPans();
    void drag_emptyArea_pans();
    void drag_rightButton_zoomsBox();
    void doubleClick_afterZoom_fits();
    void drag_bandEdge_movesOnlyThatEdge();
    void drag_bandEdgePastOther_stopsThere();
    void drag_escape_restoresBand();
    void drag_immovableBand_pansInstead();
    void drag_cutLine_stopsBetweenIntegers();
    void keyboard_tabAndArrows_moveFocusedHandle();
    void keyboard_fitAndBack_changeView();
    void click_nearPoint_picksIt();
    void click_legend_hidesCurve();
    void cursors_twoPlaced_showDifference();
    void longRecord_click_picksTheSpikesOwnSample();
};

void TestPlotInput::wheel_overPlot_zoomsAtPointer()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    const QPoint at = plot.pixelOf(3e-4, 1.0);
    const Interval before = plot.xRange();
    wheel(plot, at, 2);
    QVERIFY(plot.xRange().length() < 0.8 * before.length());
    QVERIFY(std::abs(plot.pixelOf(3e-4, 1.0).x() - at.x()) <= 1);
    QSignalSpy spy(&plot, &PlotWidget::replotted);
    wheel(plot, at, -2);
    QVERIFY(spy.wait(2000));
    QVERIFY(std::abs(plot.xRange().length() - before.length()) < 1e-9);
}

void TestPlotInput::wheel_withControlAndShift_zoomsYAndPans()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    const Interval x = plot.xRange();
    const Interval y = plot.yRange();
    wheel(plot, plot.pixelOf(3e-4, 1.0), 1, Qt::ControlModifier);
    QCOMPARE(plot.xRange(), x);
    QVERIFY(plot.yRange().length() < y.length());
    wheel(plot, plot.pixelOf(3e-4, 1.0), 1, Qt::ShiftModifier);
    QVERIFY(std::abs(plot.xRange().length() - x.length()) < 1e-12);
    QVERIFY(plot.xRange().begin < x.begin);
}

void TestPlotInput::drag_emptyArea_pans()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    const QPoint from = plot.pixelOf(6e-4, 0.3);
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    QTest::mouseMove(&plot, from + QPoint(40, 0));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, from + QPoint(40, 0));
    QVERIFY(plot.xRange().begin < -2e-5);
    QVERIFY(std::abs(plot.xRange().begin + 40.0 * pixelWidth(plot)) < 2.0 * pixelWidth(plot));
}

void TestPlotInput::drag_rightButton_zoomsBox()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    const QPoint from = plot.pixelOf(2e-4, 1.5);
    const QPoint to = plot.pixelOf(4e-4, 0.5);
    const double tolerance = 2.0 * pixelWidth(plot);
    QTest::mousePress(&plot, Qt::RightButton, {}, from);
    QTest::mouseMove(&plot, to);
    QTest::mouseRelease(&plot, Qt::RightButton, {}, to);
    QVERIFY(std::abs(plot.xRange().begin - 2e-4) < tolerance);
    QVERIFY(std::abs(plot.xRange().end - 4e-4) < tolerance);
    QVERIFY(std::abs(plot.yRange().end - 1.5) < 0.05);
}

void TestPlotInput::doubleClick_afterZoom_fits()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    wheel(plot, plot.pixelOf(3e-4, 1.0), 4);
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, plot.rect().center());
    QCOMPARE(plot.xRange(), (Interval{0.0, 1e-3}));
}

void TestPlotInput::drag_bandEdge_movesOnlyThatEdge()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("settle", "Settle", {4e-4, 8e-4});
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::bandMoved);
    const QPoint from = plot.pixelOf(8e-4, 0.5);
    const QPoint to = plot.pixelOf(9e-4, 0.5);
    // Five pixels beside the edge: within the grab zone, and the edge must not jump.
    QTest::mousePress(&plot, Qt::LeftButton, {}, from + QPoint(5, 0));
    QTest::mouseMove(&plot, to + QPoint(5, 0));
    QVERIFY(spy.count() >= 1);
    QCOMPARE(spy.last().at(2).toBool(), false);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, to + QPoint(5, 0));
    QCOMPARE(spy.last().at(0).toString(), QString("settle"));
    QCOMPARE(spy.last().at(2).toBool(), true);
    const auto band = spy.last().at(1).value<Interval>();
    QCOMPARE(band.begin, 4e-4);
    QVERIFY(std::abs(band.end - 9e-4) < 1.5 * pixelWidth(plot));
    QCOMPARE(plot.xRange(), (Interval{0.0, 1e-3}));
}

void TestPlotInput::drag_bandEdgePastOther_stopsThere()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("b", "", {4e-4, 6e-4});
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::bandMoved);
    QTest::mousePress(&plot, Qt::LeftButton, {}, plot.pixelOf(6e-4, 0.5));
    QTest::mouseMove(&plot, plot.pixelOf(1e-4, 0.5));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, plot.pixelOf(1e-4, 0.5));
    QCOMPARE(spy.last().at(1).value<Interval>(), (Interval{4e-4, 4e-4}));
}

void TestPlotInput::drag_escape_restoresBand()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("b", "", {4e-4, 6e-4});
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::bandMoved);
    QTest::mousePress(&plot, Qt::LeftButton, {}, plot.pixelOf(6e-4, 0.5));
    QTest::mouseMove(&plot, plot.pixelOf(8e-4, 0.5));
    QVERIFY(plot.isHandleDragged());
    const auto count = spy.count();
    QSignalSpy cancelled(&plot, &PlotWidget::dragCancelled);
    QTest::keyClick(&plot, Qt::Key_Escape);
    QCOMPARE(cancelled.size(), 1);
    QCOMPARE(cancelled.last().at(0).toString(), QString("b"));
    QCOMPARE(cancelled.last().at(1).value<Interval>(), (Interval{4e-4, 6e-4}));
    QCOMPARE(plot.handles().front().x, (Interval{4e-4, 6e-4}));
    QVERIFY(!plot.isHandleDragged());
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, plot.pixelOf(8e-4, 0.5));
    QCOMPARE(spy.count(), count);
}

void TestPlotInput::drag_immovableBand_pansInstead()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("guard", "Guard", {4e-4, 6e-4}, false);
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::bandMoved);
    const QPoint from = plot.pixelOf(6e-4, 0.5);
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    QTest::mouseMove(&plot, from + QPoint(30, 0));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, from + QPoint(30, 0));
    QCOMPARE(spy.count(), 0);
    QVERIFY(plot.xRange().begin < 0.0);
}

void TestPlotInput::drag_cutLine_stopsBetweenIntegers()
{
    PlotWidget plot;
    plot.setContent(singularValues());
    plot.setLine("cut", "Cut", 3, true);
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::lineMoved);
    // "Keep 3" stands between the third and the fourth value.
    const QPoint from = plot.pixelOf(3.5, 10.0);
    const QPoint to = plot.pixelOf(5.6, 10.0);
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    QTest::mouseMove(&plot, to);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, to);
    QCOMPARE(spy.last().at(1).toDouble(), 5.0);
    QCOMPARE(spy.last().at(2).toBool(), true);
}

void TestPlotInput::keyboard_tabAndArrows_moveFocusedHandle()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("b", "", {4e-4, 6e-4});
    plot.setLine("t", "", 2e-4);
    show(plot);
    plot.setFocus();
    QSignalSpy bands(&plot, &PlotWidget::bandMoved);
    QSignalSpy lines(&plot, &PlotWidget::lineMoved);
    const double pixel = pixelWidth(plot);
    QTest::keyClick(&plot, Qt::Key_Tab); // begin of the band
    QTest::keyClick(&plot, Qt::Key_Tab); // its end
    QTest::keyClick(&plot, Qt::Key_Right);
    QCOMPARE(bands.count(), 1);
    const auto band = bands.last().at(1).value<Interval>();
    QCOMPARE(band.begin, 4e-4);
    QVERIFY(std::abs(band.end - 6e-4 - pixel) < 0.2 * pixel);
    QTest::keyClick(&plot, Qt::Key_Tab); // the line
    QTest::keyClick(&plot, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(lines.last().at(1).toDouble() - 2e-4 + 10.0 * pixel) < 2.0 * pixel);
}

void TestPlotInput::keyboard_fitAndBack_changeView()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    plot.setFocus();
    const Interval whole = plot.xRange();
    QTest::keyClick(&plot, Qt::Key_Plus);
    const Interval near = plot.xRange();
    QVERIFY(near.length() < whole.length());
    QTest::keyClick(&plot, Qt::Key_F);
    QCOMPARE(plot.xRange(), whole);
    QTest::keyClick(&plot, Qt::Key_Backspace);
    QCOMPARE(plot.xRange(), near);
    QTest::keyClick(&plot, Qt::Key_Backspace, Qt::ShiftModifier);
    QCOMPARE(plot.xRange(), whole);
}

void TestPlotInput::click_nearPoint_picksIt()
{
    PlotWidget plot;
    plot.setContent(singularValues());
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::pointPicked);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.pixelOf(3, 10.0) + QPoint(4, -3));
    QCOMPARE(spy.count(), 1);
    QCOMPARE(spy.last().at(0).toDouble(), 3.0);
    QCOMPARE(spy.last().at(1).toDouble(), 10.0);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.pixelOf(6.5, 90.0));
    QCOMPARE(spy.count(), 1);
}

void TestPlotInput::click_legend_hidesCurve()
{
    PlotContent content = timeContent();
    content.curves.push_back(ringing("Shot 2", CurveRole::ShotMedium, 500, 1e-3));
    for (double &y : content.curves[1].y)
        y *= 10.0;
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    QVERIFY(plot.yRange().end > 10.0);
    // The entries stand in a row under the title; somewhere in it is the second one.
    for (int x = 5; x < plot.width() && plot.yRange().end > 10.0; x += 5) {
        for (int y = 5; y < 45 && plot.yRange().end > 10.0; y += 5) {
            QTest::mouseMove(&plot, {x, y});
            if (plot.cursor().shape() != Qt::PointingHandCursor)
                continue;
            QTest::mouseClick(&plot, Qt::LeftButton, {}, {x, y});
            plot.fit();
            if (plot.yRange().end > 10.0) // that was the first
                QTest::mouseClick(&plot, Qt::LeftButton, {}, {x, y});
        }
    }
    QVERIFY(plot.yRange().end < 5.0);
    plot.setContent(content);
    plot.fit();
    QVERIFY2(plot.yRange().end < 5.0, "a hidden curve stays hidden");
}

void TestPlotInput::cursors_twoPlaced_showDifference()
{
    PlotContent content = timeContent(3);
    content.curves[0].x = {0.0, 5e-4, 1e-3};
    content.curves[0].y = {0.0, 2.0, 1.0};
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    plot.setFocus();
    QTest::mouseMove(&plot, plot.pixelOf(5e-4, 2.0) + QPoint(3, 3));
    QTest::keyClick(&plot, Qt::Key_1);
    QVERIFY(plot.cursorReadout().contains("A: 500.000"));
    QTest::mouseMove(&plot, plot.pixelOf(1e-3, 1.0) + QPoint(-3, 3));
    QTest::keyClick(&plot, Qt::Key_2);
    const QString readout = plot.cursorReadout();
    QVERIFY2(readout.contains(QString::fromUtf8("Δx: 500.000")), qPrintable(readout));
    QVERIFY2(readout.contains("2.00000"), qPrintable(readout)); // 1/dx = 2 kHz
    QVERIFY2(readout.contains(QString::fromUtf8("Δy: -1.00000")), qPrintable(readout));
    QTest::keyClick(&plot, Qt::Key_Escape);
    QVERIFY(plot.cursorReadout().isEmpty());
}

void TestPlotInput::longRecord_click_picksTheSpikesOwnSample()
{
    PlotWidget plot;
    plot.setContent(longRecord());
    show(plot);
    const QSignalSpy picked(&plot, &PlotWidget::pointPicked);
    const double x = static_cast<double>(kSpike) * 1e-6;
    QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.pixelOf(x, 1.0)); // a pixel is 5000 samples
    QCOMPARE(picked.count(), 1);
    QCOMPARE(picked[0][0].toDouble(), x);
    QCOMPARE(picked[0][1].toDouble(), 1.0);
}

DYNCAL_TEST(TestPlotInput)
#include "tst_plot_input.moc"
