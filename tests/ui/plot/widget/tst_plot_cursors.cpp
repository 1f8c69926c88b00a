// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/plot/widget/plot_bench.h"

#include <QSignalSpy>

using namespace dyncal;
using namespace dyncal::test;

/// The two cursors under mouse and keys: a curve y = 1000 x in steps of 10 µs, and one of noughts.
class TestPlotCursors : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_plot.reset(); }
    void drag_movesFromSampleToSample_andTellsOthers();
    void drag_ended_byEscape_putsTheCursorBack();
    void drag_besideTheCursor_movesTheView();
    void keys_moveTheLastCursorBySamples();
    void goTo_centresTheView_andBackspaceReturns();
    void values_ofAllVisibleCurves();
    void values_ofAMap_areNone();
    void otherCurves_areReadAgainUnderTheCursor();
    void longRecord_isReadAtItsOwnSamples();

private:
    void drag(QPoint from, QPoint to, bool released = true);
    double at(std::size_t cursor) const { return m_plot->cursorValues().x[cursor].value_or(kNan); }

    PlotContent m_content;
    std::unique_ptr<PlotWidget> m_plot;
};

void TestPlotCursors::init()
{
    m_content = timeContent(101);
    for (std::size_t i = 0; i < 101; ++i) {
        m_content.curves[0].x[i] = 1e-5 * static_cast<double>(i);
        m_content.curves[0].y[i] = 0.01 * static_cast<double>(i);
    }
    m_content.curves.push_back(m_content.curves[0]);
    m_content.curves[1].name = "Noughts";
    std::ranges::fill(m_content.curves[1].y, 0.0);
    m_plot = std::make_unique<PlotWidget>();
    m_plot->setContent(m_content);
    show(*m_plot);
    m_plot->setFocus();
    for (const double x : {1e-4, 3e-4}) // a pointer that comes from somewhere
        QTest::mouseMove(m_plot.get(), m_plot->pixelOf(x, 1e3 * x));
    QTest::keyClick(m_plot.get(), Qt::Key_1);
    QCOMPARE(at(0), 3e-4);
}

void TestPlotCursors::drag(QPoint from, QPoint to, bool released)
{
    QTest::mousePress(m_plot.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(m_plot.get(), (from + to) / 2);
    QTest::mouseMove(m_plot.get(), to);
    if (released)
        QTest::mouseRelease(m_plot.get(), Qt::LeftButton, {}, to);
}

void TestPlotCursors::drag_movesFromSampleToSample_andTellsOthers()
{
    const QSignalSpy placed(m_plot.get(), &PlotWidget::cursorPlaced);
    const Interval view = m_plot->xRange();
    drag(m_plot->pixelOf(3e-4, 0.8) + QPoint(2, 0), m_plot->pixelOf(7e-4, 0.7));
    QCOMPARE(at(0), 7e-4);
    QCOMPARE(m_plot->xRange(), view);
    QCOMPARE(placed.last().value(0).toInt(), 0);
    QCOMPARE(placed.last().value(1).toDouble(), 7e-4);
    drag(m_plot->pixelOf(7e-4, 0.8), m_plot->pixelOf(7e-4, 0.8) + QPoint(4000, 300));
    QCOMPARE(at(0), 1e-3); // the last sample
}

void TestPlotCursors::drag_ended_byEscape_putsTheCursorBack()
{
    drag(m_plot->pixelOf(3e-4, 0.8), m_plot->pixelOf(7e-4, 0.7), false);
    QCOMPARE(at(0), 7e-4);
    const QSignalSpy placed(m_plot.get(), &PlotWidget::cursorPlaced);
    QTest::keyClick(m_plot.get(), Qt::Key_Escape);
    QCOMPARE(at(0), 3e-4);
    QCOMPARE(placed.last().value(1).toDouble(), 3e-4);
    QTest::mouseRelease(m_plot.get(), Qt::LeftButton, {}, m_plot->pixelOf(7e-4, 0.7));
    QCOMPARE(at(0), 3e-4);
}

void TestPlotCursors::drag_besideTheCursor_movesTheView()
{
    const Interval view = m_plot->xRange();
    drag(m_plot->pixelOf(3e-4, 0.8) + QPoint(12, 0), m_plot->pixelOf(7e-4, 0.8));
    QVERIFY(m_plot->xRange().begin < view.begin);
    QCOMPARE(at(0), 3e-4);
}

void TestPlotCursors::keys_moveTheLastCursorBySamples()
{
    QTest::keyClick(m_plot.get(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(at(0), 3.1e-4);
    QTest::keyClick(m_plot.get(), Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(at(0), 2.1e-4);
    for (int i = 0; i < 4; ++i)
        QTest::keyClick(m_plot.get(), Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(at(0), 0.0); // the first sample
    QTest::mouseMove(m_plot.get(), m_plot->pixelOf(5e-4, 0.5));
    QTest::keyClick(m_plot.get(), Qt::Key_2);
    QTest::keyClick(m_plot.get(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(at(0), 0.0);
    QCOMPARE(at(1), 5.1e-4);
    QTest::keyClick(m_plot.get(), Qt::Key_Escape);
    const Interval view = m_plot->xRange();
    QTest::keyClick(m_plot.get(), Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(!m_plot->cursorValues().x[0]);
    QCOMPARE(m_plot->xRange(), view);
}

void TestPlotCursors::goTo_centresTheView_andBackspaceReturns()
{
    wheel(*m_plot, m_plot->pixelOf(1e-4, 0.1), 8);
    const Interval view = m_plot->xRange();
    m_plot->goTo(8.04e-4);
    QCOMPARE(at(0), 8e-4); // the nearest sample
    const Interval there = m_plot->xRange();
    QVERIFY(std::abs(0.5 * (there.begin + there.end) - 8.04e-4) < 2e-3 * there.length());
    QVERIFY(std::abs(there.length() / view.length() - 1.0) < 1e-9);
    QTest::keyClick(m_plot.get(), Qt::Key_Backspace);
    QCOMPARE(m_plot->xRange(), view);
}

void TestPlotCursors::values_ofAllVisibleCurves()
{
    m_plot->followCursor(1, 5.04e-4);
    const CursorValues values = m_plot->cursorValues();
    QCOMPARE(values.unit, QString("s"));
    QCOMPARE(values.rows.size(), 2U);
    QCOMPARE(values.rows[0].curve, QString("Shot 1"));
    QCOMPARE(values.rows[0].unit, QString("V"));
    QCOMPARE(values.rows[0].y[0], std::optional(0.3));
    QCOMPARE(values.rows[0].y[1], std::optional(0.5));
    QCOMPARE(values.rows[1].y[1], std::optional(0.0));
    m_plot->followCursor(1, 5.0);
    QVERIFY(!m_plot->cursorValues().rows[0].y[1]);
}

void TestPlotCursors::values_ofAMap_areNone()
{
    m_content.equalAspect = true;
    m_plot->setContent(m_content);
    QVERIFY(m_plot->cursorValues().rows.empty());
    m_content.equalAspect = false;
    std::swap(m_content.curves[0].x[3], m_content.curves[0].x[40]); // as the poles of all orders
    m_plot->setContent(m_content);
    QCOMPARE(m_plot->cursorValues().rows.size(), 1U);
}

void TestPlotCursors::otherCurves_areReadAgainUnderTheCursor()
{
    QVERIFY(m_plot->cursorReadout().contains("300.000"));
    const QSignalSpy changed(m_plot.get(), &PlotWidget::cursorsChanged);
    m_content.curves[0].y[30] = 0.75;
    m_plot->setContent(m_content);
    QVERIFY2(m_plot->cursorReadout().contains("750.000"), qPrintable(m_plot->cursorReadout()));
    QVERIFY(!changed.isEmpty());
    m_content.curves.clear();
    m_plot->setContent(m_content);
    QVERIFY(!m_plot->cursorReadout().contains("V"));
}

void TestPlotCursors::longRecord_isReadAtItsOwnSamples()
{
    m_plot->setContent(longRecord());
    m_plot->goTo(static_cast<double>(kSpike) * 1e-6);
    QCOMPARE(m_plot->cursorValues().rows.at(0).y[0], std::optional(1.0));
    QTest::keyClick(m_plot.get(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(m_plot->cursorValues().rows.at(0).y[0], std::optional(0.0));
    QTest::keyClick(m_plot.get(), Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(m_plot->cursorValues().rows.at(0).y[0], std::optional(1.0));
}

DYNCAL_TEST(TestPlotCursors)
#include "tst_plot_cursors.moc"
