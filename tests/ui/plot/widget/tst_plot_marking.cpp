// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/widget/plot_widget.h"

#include <QSignalSpy>
#include <QtTest>

using namespace dyncal;

namespace {

PlotContent ramp()
{
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Voltage", "V"};
    content.curves.push_back(
        {"ramp", CurveRole::Measured, CurveStyle::Line, {0.0, 1e-3}, {0.0, 1.0}});
    return content;
}

void dragFromTo(PlotWidget &plot, double from, double to, Qt::KeyboardModifiers keys = {})
{
    QTest::mousePress(&plot, Qt::LeftButton, keys, plot.pixelOf(from, 0.3));
    QTest::mouseMove(&plot, plot.pixelOf(0.5 * (from + to), 0.4));
    QTest::mouseMove(&plot, plot.pixelOf(to, 0.5));
    QTest::mouseRelease(&plot, Qt::LeftButton, keys, plot.pixelOf(to, 0.5));
}

} // namespace

/// Marking a span of x with the mouse.
class TestPlotMarking : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_plot = std::make_unique<PlotWidget>();
        m_plot->setContent(ramp());
        m_plot->resize(640, 400);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_marked = std::make_unique<QSignalSpy>(m_plot.get(), &PlotWidget::spanMarked);
        m_view = m_plot->xRange();
        m_pixel = m_view.length() / m_plot->axesRect().width();
    }

    void shiftDrag_whereItMay_marks()
    {
        m_plot->setMarkable(true);
        dragFromTo(*m_plot, 2e-4, 4e-4, Qt::ShiftModifier);
        QCOMPARE(m_marked->count(), 1);
        const auto span = m_marked->last().at(0).value<Interval>();
        QVERIFY(std::abs(span.begin - 2e-4) < 2.0 * m_pixel);
        QVERIFY(std::abs(span.end - 4e-4) < 2.0 * m_pixel);
        QCOMPARE(m_plot->xRange(), m_view); // nothing panned
    }

    void shiftDrag_elsewhere_pans()
    {
        dragFromTo(*m_plot, 2e-4, 4e-4, Qt::ShiftModifier);
        QCOMPARE(m_marked->count(), 0);
        QVERIFY(m_plot->xRange().begin < m_view.begin);
    }

    void markingMode_takesOneDrag_alsoOverAHandle_fromTheRight()
    {
        m_plot->setBand("band", "", {2e-4, 4e-4});
        QSignalSpy moved(m_plot.get(), &PlotWidget::bandMoved);
        QSignalSpy mode(m_plot.get(), &PlotWidget::markingChanged);
        m_plot->setMarking(true);
        dragFromTo(*m_plot, 4e-4, 1e-4);
        QCOMPARE(m_marked->count(), 1);
        const auto span = m_marked->last().at(0).value<Interval>();
        QVERIFY(span.begin < span.end && std::abs(span.begin - 1e-4) < 2.0 * m_pixel);
        QCOMPARE(moved.count(), 0);
        QCOMPARE(mode.count(), 2);
        QCOMPARE(mode.last().at(0).toBool(), false);
        dragFromTo(*m_plot, 6e-4, 7e-4); // the mode is over: this pans
        QCOMPARE(m_marked->count(), 1);
    }

    void drag_pastTheAxes_endsAtThem()
    {
        m_plot->setMarking(true);
        dragFromTo(*m_plot, 8e-4, 5e-3);
        const auto span = m_marked->last().at(0).value<Interval>();
        QVERIFY(std::abs(span.end - m_view.end) < 2.0 * m_pixel);
    }

    void escape_marksNothing_andEndsTheMode()
    {
        m_plot->setMarking(true);
        QSignalSpy mode(m_plot.get(), &PlotWidget::markingChanged);
        QTest::mousePress(m_plot.get(), Qt::LeftButton, {}, m_plot->pixelOf(2e-4, 0.3));
        QTest::mouseMove(m_plot.get(), m_plot->pixelOf(4e-4, 0.3));
        QTest::keyClick(m_plot.get(), Qt::Key_Escape);
        QTest::mouseRelease(m_plot.get(), Qt::LeftButton, {}, m_plot->pixelOf(4e-4, 0.3));
        QCOMPARE(m_marked->count(), 0);
        QCOMPARE(mode.count(), 1);
        QCOMPARE(m_plot->xRange(), m_view);
    }

    void click_marksNothing_andKeepsTheMode()
    {
        m_plot->setMarking(true);
        QTest::mouseClick(m_plot.get(), Qt::LeftButton, {}, m_plot->pixelOf(5e-4, 0.3));
        QCOMPARE(m_marked->count(), 0);
        dragFromTo(*m_plot, 2e-4, 4e-4);
        QCOMPARE(m_marked->count(), 1);
    }

    void hatchedBand_movesByItsEdges()
    {
        m_plot->setHatchedBand("out", "left out", {2e-4, 4e-4});
        QSignalSpy moved(m_plot.get(), &PlotWidget::bandMoved);
        dragFromTo(*m_plot, 4e-4, 6e-4);
        QVERIFY(moved.count() >= 1);
        const auto band = moved.last().at(1).value<Interval>();
        QCOMPARE(band.begin, 2e-4);
        QVERIFY(std::abs(band.end - 6e-4) < 2.0 * m_pixel);
    }

private:
    std::unique_ptr<PlotWidget> m_plot;
    std::unique_ptr<QSignalSpy> m_marked;
    Interval m_view;
    double m_pixel = 0.0;
};

DYNCAL_TEST(TestPlotMarking)
#include "tst_plot_marking.moc"
