// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/plot/widget/plot_bench.h"

using namespace dyncal;
using namespace dyncal::test;

namespace {

constexpr int kTurns = 400;

PlotContent everyStyle(bool logarithmic)
{
    PlotContent content = timeContent();
    content.curves[0].x.erase(content.curves[0].x.begin()); // no zero on a logarithmic axis
    content.curves[0].y.erase(content.curves[0].y.begin());
    for (const CurveStyle style : {CurveStyle::Markers, CurveStyle::Dots, CurveStyle::Stems})
        content.curves.push_back(
            {"more", CurveRole::Measured, style, content.curves[0].x, content.curves[0].y, true});
    content.curves[0].y[100] = kNan;
    content.xAxis.logarithmic = content.yAxis.logarithmic = logarithmic;
    content.marks.push_back({5e-4, "mark", CurveRole::Reference});
    return content;
}

PlotContent poleMap()
{
    PlotContent content;
    content.title = "Poles";
    content.equalAspect = content.unitCircle = true;
    content.dampingGridRate_Hz = 1e6;
    content.curves.push_back(
        {"poles", CurveRole::Pole, CurveStyle::Markers, {0.9, 0.9, -0.2}, {0.1, -0.1, 0.0}, true});
    return content;
}

} // namespace

/// However far an operator zooms and pans, the plot is drawn and the way back works.
class TestPlotZoomLimits : public QObject
{
    Q_OBJECT

private slots:
    void zoom_withoutEnd_data();
    void zoom_withoutEnd();
    void pan_withoutEnd();
    void usualZoom_isLeftAsItIs();

private:
    int m_turns = 0;

    /// Drawn after every eighth notch in the suite, after each in the long form.
    void turn(PlotWidget &plot, int notches, Qt::KeyboardModifiers modifiers = {})
    {
        const QPointF at = plot.axesRect().center() + QPointF(31.0, 17.0);
        QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
            Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot, &event);
        if (++m_turns % trials::count(8, 1) == 0)
            QApplication::processEvents();
    }
    static bool isDrawable(const Interval &range)
    {
        return std::isfinite(range.begin) && std::isfinite(range.end) && range.end > range.begin
            && std::abs(range.end - range.begin)
            > 1e-13 * std::max(std::abs(range.begin), std::abs(range.end));
    }
};

void TestPlotZoomLimits::zoom_withoutEnd_data()
{
    QTest::addColumn<int>("content");
    QTest::addColumn<int>("modifiers");
    const char *contents[] = {"every style", "logarithmic", "pole map", "long record"};
    for (int i = 0; i < 4; ++i)
        for (const int modifiers : {int(Qt::NoModifier), int(Qt::ControlModifier)})
            QTest::addRow("%s, modifiers %x", contents[i], unsigned(modifiers)) << i << modifiers;
}

void TestPlotZoomLimits::zoom_withoutEnd()
{
    QFETCH(int, content);
    QFETCH(int, modifiers);
    PlotWidget plot;
    plot.setContent(content == 0 ? everyStyle(false)
            : content == 1       ? everyStyle(true)
            : content == 2       ? poleMap()
                                 : longRecord());
    show(plot);
    const auto x = plot.xRange();
    for (const int direction : {1, -1}) {
        for (int i = 0; i < kTurns; ++i) {
            turn(plot, direction, Qt::KeyboardModifiers(modifiers));
            QVERIFY(isDrawable({plot.xRange().begin, plot.xRange().end}));
            QVERIFY(isDrawable({plot.yRange().begin, plot.yRange().end}));
        }
        plot.fit();
        QApplication::processEvents();
        QVERIFY(std::abs(plot.xRange().begin - x.begin) <= 1e-9 * std::abs(x.end - x.begin));
    }
    // A small box in a small box, and so on.
    for (int i = 0; i < 40; ++i) {
        const QPoint at = plot.axesRect().center();
        QTest::mousePress(&plot, Qt::RightButton, {}, at);
        QTest::mouseMove(&plot, at + QPoint(4, 5));
        QTest::mouseMove(&plot, at + QPoint(7, 8));
        QTest::mouseRelease(&plot, Qt::RightButton, {}, at + QPoint(7, 8));
        QApplication::processEvents();
        QVERIFY(isDrawable({plot.xRange().begin, plot.xRange().end}));
        QVERIFY(isDrawable({plot.yRange().begin, plot.yRange().end}));
    }
}

void TestPlotZoomLimits::pan_withoutEnd()
{
    PlotWidget plot;
    plot.setContent(everyStyle(false));
    show(plot);
    for (int i = 0; i < 60; ++i)
        turn(plot, 1);
    for (int i = 0; i < 3000; ++i)
        turn(plot, 1, Qt::ShiftModifier);
    QVERIFY(isDrawable({plot.xRange().begin, plot.xRange().end}));
}

void TestPlotZoomLimits::usualZoom_isLeftAsItIs()
{
    PlotWidget plot;
    plot.setContent(everyStyle(false));
    show(plot);
    const double before = plot.xRange().end - plot.xRange().begin;
    for (int i = 0; i < 60; ++i)
        turn(plot, 1);
    const double after = plot.xRange().end - plot.xRange().begin;
    QVERIFY2(std::abs(after / before / std::pow(0.85, 60) - 1.0) < 1e-6,
        qPrintable(QString::number(after / before)));
}

DYNCAL_TEST(TestPlotZoomLimits)
#include "tst_plot_zoom_limits.moc"
