// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/signal_curves.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>
#include <complex>
#include <ctime>
#include <limits>

using dyncal::CurveRole;
using dyncal::CurveStyle;
using dyncal::Index;
using dyncal::Interval;
using dyncal::PlotContent;
using dyncal::PlotCurve;
using dyncal::PlotWidget;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PlotCurve ringing(const QString &name, CurveRole role, Index count, double duration_s)
{
    PlotCurve curve{name, role, CurveStyle::Line, {}, {}, true};
    for (Index i = 0; i < count; ++i) {
        const double t = duration_s * static_cast<double>(i) / static_cast<double>(count - 1);
        curve.x.push_back(t);
        curve.y.push_back(
            1.0 - std::exp(-t / (0.2 * duration_s)) * std::cos(60.0 * t / duration_s));
    }
    return curve;
}

PlotContent timeContent(Index count = 500)
{
    PlotContent content;
    content.title = "Response";
    content.summary = "One response that settles at 1.";
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    content.curves.push_back(ringing("Shot 1", CurveRole::ShotLow, count, 1e-3));
    return content;
}

PlotContent singularValues()
{
    PlotContent content;
    content.title = "Singular values";
    content.xAxis = {"Order", "", false, true};
    content.yAxis = {"Singular value", "", true};
    content.curves.push_back({"values", CurveRole::Measured, CurveStyle::Markers,
        {1, 2, 3, 4, 5, 6, 7, 8}, {100, 90, 10, 0.5, 0.4, 0.3, 0.0, -1.0}, true});
    return content;
}

constexpr Index kSpike = 1'234'567;

/// Three million zeros at 1 MS/s with one sample of 1 V, drawn through its envelope.
PlotContent longRecord()
{
    std::vector<std::int16_t> counts(3'000'000);
    counts[kSpike] = 1;
    dyncal::Channel channel;
    channel.role = dyncal::ChannelRole::Dut;
    channel.samples = dyncal::RawSamples(std::move(counts));
    channel.sampleRate_Hz = 1e6;
    dyncal::CaptureSet set;
    set.shots.emplace_back().channels.push_back(channel);
    return rawCurves(set, dyncal::ChannelRole::Dut, [](const dyncal::Channel &each) {
        return std::make_shared<const dyncal::ChannelEnvelope>(
            *dyncal::ChannelEnvelope::build(each));
    });
}

void show(PlotWidget &plot)
{
    plot.resize(640, 400);
    plot.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    QApplication::processEvents();
}

void wheel(PlotWidget &plot, QPoint at, int notches, Qt::KeyboardModifiers modifiers = {})
{
    QWheelEvent event(at, plot.mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton,
        modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&plot, &event);
}

/// Number of pixels of an image that are far from white.
int inkedPixels(const QImage &image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += qGray(image.pixel(x, y)) < 128;
    return count;
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Half a pixel of the axes, in x.
double pixelWidth(const PlotWidget &plot)
{
    const double span
        = plot.pixelOf(plot.xRange().end, 0).x() - plot.pixelOf(plot.xRange().begin, 0).x();
    return plot.xRange().length() / span;
}

} // namespace

class TestPlotWidget : public QObject
{
    Q_OBJECT

private slots:
    void content_growing_isFittedUntilTheViewIsMoved();
    void decorationsAlone_areMovedToWhereANewPlotHasThem();
    void noise_inEveryStyle_takesAboutTheSameTime();
    void longRecord_click_picksTheSpikesOwnSample();
    void longRecord_csv_isOfTheView();
    void init_contentOfOneCurve_fitsIt();
    void setContent_afterZoom_keepsView();
    void setContent_otherQuantity_fitsThatAxis();
    void setContent_emptyFirst_fitsWhenDataCome();
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
    void level_withABand_isFilled();
    void dampingGrid_isDrawn_andToggledByG();
    void cursors_twoPlaced_showDifference();
    void logAxis_zeroAndNegative_areDropped();
    void nanGap_inCurve_isNoTrouble();
    void twoPoints_and_onePoint_fit();
    void poleZeroMap_anySize_hasEqualScales();
    void export_allFormats_writeFiles();
    void export_unknownSuffix_fails();
    void export_svg_isVectorAndDeterministic();
    void csv_sharedAndOwnX_fullPrecision();
    void paint_intoPdf_staysVector();
    void palette_dark_changesBackground();
    void accessibility_namesComeFromContent();
    void largeCurve_spikeOfOneSample_isDrawn();
    void keys_prefixOfAxis_followsRange();
};

void TestPlotWidget::init_contentOfOneCurve_fitsIt()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    QCOMPARE(plot.xRange(), (Interval{0.0, 1e-3}));
    QVERIFY(plot.yRange().begin < 0.0 && plot.yRange().end > 1.5);
    PlotContent limited = timeContent();
    limited.xMax = 0.5e-3;
    limited.yMin = -3.0;
    PlotWidget other;
    other.setContent(limited);
    QCOMPARE(other.xRange(), (Interval{0.0, 0.5e-3}));
    QCOMPARE(other.yRange().begin, -3.0);
}

void TestPlotWidget::setContent_afterZoom_keepsView()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    wheel(plot, plot.pixelOf(2e-4, 1.0), 3);
    const Interval x = plot.xRange();
    const Interval y = plot.yRange();
    QVERIFY(x.length() < 0.7e-3);
    plot.setContent(timeContent(900));
    QCOMPARE(plot.xRange(), x);
    QCOMPARE(plot.yRange(), y);
    plot.fit();
    QCOMPARE(plot.xRange(), (Interval{0.0, 1e-3}));
}

void TestPlotWidget::setContent_otherQuantity_fitsThatAxis()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    wheel(plot, plot.pixelOf(2e-4, 1.0), 3);
    const Interval x = plot.xRange();
    PlotContent pressure = timeContent();
    pressure.yAxis = {"Pressure", "Pa"};
    for (double &y : pressure.curves[0].y)
        y *= 1e6;
    plot.setContent(pressure);
    QCOMPARE(plot.xRange(), x);
    QVERIFY(plot.yRange().end > 1e6);
}

void TestPlotWidget::setContent_emptyFirst_fitsWhenDataCome()
{
    PlotWidget plot;
    plot.setContent({});
    show(plot);
    QVERIFY(plot.csv().size() <= 1);
    plot.setContent(timeContent());
    QCOMPARE(plot.xRange(), (Interval{0.0, 1e-3}));
    plot.setContent({});
    QApplication::processEvents();
    plot.grab();
}

void TestPlotWidget::wheel_overPlot_zoomsAtPointer()
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

void TestPlotWidget::wheel_withControlAndShift_zoomsYAndPans()
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

void TestPlotWidget::drag_emptyArea_pans()
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

void TestPlotWidget::drag_rightButton_zoomsBox()
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

void TestPlotWidget::doubleClick_afterZoom_fits()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    wheel(plot, plot.pixelOf(3e-4, 1.0), 4);
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, plot.rect().center());
    QCOMPARE(plot.xRange(), (Interval{0.0, 1e-3}));
}

void TestPlotWidget::drag_bandEdge_movesOnlyThatEdge()
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

void TestPlotWidget::drag_bandEdgePastOther_stopsThere()
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

void TestPlotWidget::drag_escape_restoresBand()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("b", "", {4e-4, 6e-4});
    show(plot);
    QSignalSpy spy(&plot, &PlotWidget::bandMoved);
    QTest::mousePress(&plot, Qt::LeftButton, {}, plot.pixelOf(6e-4, 0.5));
    QTest::mouseMove(&plot, plot.pixelOf(8e-4, 0.5));
    QTest::keyClick(&plot, Qt::Key_Escape);
    QCOMPARE(spy.last().at(1).value<Interval>(), (Interval{4e-4, 6e-4}));
    QCOMPARE(spy.last().at(2).toBool(), true);
    const auto count = spy.count();
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, plot.pixelOf(8e-4, 0.5));
    QCOMPARE(spy.count(), count);
}

void TestPlotWidget::drag_immovableBand_pansInstead()
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

void TestPlotWidget::drag_cutLine_stopsBetweenIntegers()
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

void TestPlotWidget::keyboard_tabAndArrows_moveFocusedHandle()
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

void TestPlotWidget::keyboard_fitAndBack_changeView()
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

void TestPlotWidget::click_nearPoint_picksIt()
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

void TestPlotWidget::level_withABand_isFilled()
{
    PlotContent content = singularValues();
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    const QPoint inBand = plot.pixelOf(6.5, 55.0);
    const QRgb empty = plot.grab().toImage().pixel(inBand);
    content.levels.push_back({90.0, QString(), CurveRole::Noise, 40.0});
    plot.setContent(content);
    QTest::qWait(50);
    QVERIFY(plot.grab().toImage().pixel(inBand) != empty);
    content.levels.back().from.reset();
    plot.setContent(content);
    QTest::qWait(50);
    QCOMPARE(plot.grab().toImage().pixel(inBand), empty);
}

void TestPlotWidget::dampingGrid_isDrawn_andToggledByG()
{
    PlotContent content;
    content.equalAspect = content.unitCircle = true;
    content.xAxis.quantity = "Re";
    content.yAxis.quantity = "Im";
    content.curves.push_back(
        {"Poles", CurveRole::Pole, CurveStyle::Markers, {0.1, 0.1}, {0.9, -0.9}, true});
    content.xMin = content.yMin = -1.1;
    content.xMax = content.yMax = 1.1;
    content.dampingGridRate_Hz = 10e6;
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    const QRgb background = qRgb(255, 255, 255);
    // Where a spiral and an arc meet: w0 T = pi / 5, zeta = 0.5.
    const std::complex<double> z
        = std::exp(M_PI / 5.0 * std::complex<double>(-0.5, std::sqrt(0.75)));
    const auto inkNear = [&](std::complex<double> at) {
        const QImage image = plot.grab().toImage();
        int ink = 0;
        for (int dx = -2; dx <= 2; ++dx)
            for (int dy = -2; dy <= 2; ++dy)
                ink += image.pixel(plot.pixelOf(at.real(), at.imag()) + QPoint(dx, dy))
                    != background;
        return ink;
    };
    const Interval before = plot.xRange();
    QVERIFY(inkNear(z) > 0);
    QVERIFY(inkNear(std::conj(z)) > 0);
    QTest::keyClick(&plot, Qt::Key_G);
    QApplication::processEvents();
    QCOMPARE(inkNear(z), 0);
    plot.setContent(content); // a new result does not bring it back
    QApplication::processEvents();
    QCOMPARE(inkNear(z), 0);
    QTest::keyClick(&plot, Qt::Key_G);
    QApplication::processEvents();
    QVERIFY(inkNear(z) > 0);
    QCOMPARE(plot.xRange(), before); // it is no data to be fitted
}

void TestPlotWidget::click_legend_hidesCurve()
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

void TestPlotWidget::cursors_twoPlaced_showDifference()
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

void TestPlotWidget::logAxis_zeroAndNegative_areDropped()
{
    PlotWidget plot;
    plot.setContent(singularValues());
    show(plot);
    QVERIFY(plot.yRange().begin > 0.1 && plot.yRange().begin < 0.3);
    QVERIFY(plot.yRange().end >= 100.0);
    PlotContent both = singularValues();
    both.xAxis.logarithmic = true;
    both.xAxis.integers = false;
    both.curves[0].x[0] = 0.0;
    both.curves[0].x[1] = -2.0;
    PlotWidget other;
    other.setContent(both);
    show(other);
    QVERIFY(other.xRange().begin > 2.0);
    PlotContent none = both;
    none.curves[0].y.assign(8, 0.0);
    other.setContent(none);
    other.fit();
    QVERIFY(other.yRange().begin > 0.0);
    other.grab();
}

void TestPlotWidget::nanGap_inCurve_isNoTrouble()
{
    PlotContent content = timeContent(30000);
    for (std::size_t i = 1000; i < 20000; ++i)
        content.curves[0].y[i] = kNan;
    content.curves[0].y[5] = std::numeric_limits<double>::infinity();
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    QVERIFY(std::isfinite(plot.yRange().begin) && std::isfinite(plot.yRange().end));
    wheel(plot, plot.rect().center(), 20);
    QApplication::processEvents();
    plot.grab();
}

void TestPlotWidget::twoPoints_and_onePoint_fit()
{
    PlotContent content = timeContent(2);
    content.curves[0].x = {1.0, 2.0};
    content.curves[0].y = {5.0, 5.0};
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    QCOMPARE(plot.xRange(), (Interval{1.0, 2.0}));
    QVERIFY(plot.yRange().contains(5.0) && plot.yRange().length() > 0.5);
    content.curves[0].x = {1.0};
    content.curves[0].y = {0.0};
    PlotWidget single;
    single.setContent(content);
    show(single);
    QVERIFY(single.xRange().contains(1.0) && single.xRange().length() > 0.1);
    QVERIFY(single.yRange().contains(0.0) && single.yRange().length() > 0.1);
}

void TestPlotWidget::poleZeroMap_anySize_hasEqualScales()
{
    PlotContent content;
    content.title = "Poles and zeros";
    content.xAxis = {"Real part", ""};
    content.yAxis = {"Imaginary part", ""};
    content.equalAspect = true;
    content.unitCircle = true;
    content.curves.push_back(
        {"Poles", CurveRole::Pole, CurveStyle::Markers, {0.9, 0.9}, {0.3, -0.3}, true});
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    for (const QSize size : {QSize(640, 300), QSize(300, 500)}) {
        plot.resize(size);
        QApplication::processEvents();
        const QPoint origin = plot.pixelOf(0, 0);
        const int right = plot.pixelOf(1, 0).x() - origin.x();
        const int up = origin.y() - plot.pixelOf(0, 1).y();
        QVERIFY2(std::abs(right - up) <= 2, qPrintable(QString("%1 %2").arg(right).arg(up)));
        QVERIFY(plot.rect().contains(plot.pixelOf(1, 0)));
        QVERIFY(plot.rect().contains(plot.pixelOf(0, -1)));
    }
}

void TestPlotWidget::export_allFormats_writeFiles()
{
    QTemporaryDir folder;
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("b", "Band", {2e-4, 4e-4});
    show(plot);
    QVERIFY(plot.exportImage(folder.filePath("a.png")));
    const QImage image(folder.filePath("a.png"));
    QVERIFY(image.width() > 1000);
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
    QVERIFY(inkedPixels(image) > 1000);
    QVERIFY(plot.exportImage(folder.filePath("a.svg")));
    QVERIFY(bytesOf(folder.filePath("a.svg")).contains("<svg"));
    QVERIFY(plot.exportImage(folder.filePath("a.pdf")));
    QVERIFY(bytesOf(folder.filePath("a.pdf")).startsWith("%PDF-"));
}

void TestPlotWidget::export_unknownSuffix_fails()
{
    QTemporaryDir folder;
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    QVERIFY(!plot.exportImage(folder.filePath("a.gif")));
    QVERIFY(!QFile::exists(folder.filePath("a.gif")));
    QVERIFY(!plot.exportImage(folder.filePath("missing/a.png")));
}

void TestPlotWidget::export_svg_isVectorAndDeterministic()
{
    QTemporaryDir folder;
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    QVERIFY(plot.exportImage(folder.filePath("a.svg")));
    QVERIFY(plot.exportImage(folder.filePath("b.svg")));
    const QByteArray svg = bytesOf(folder.filePath("a.svg"));
    QCOMPARE(svg, bytesOf(folder.filePath("b.svg")));
    QVERIFY(!svg.contains("<image"));
    QVERIFY(svg.contains("<text"));
    QVERIFY(svg.contains("Time / ms"));
    QVERIFY(svg.contains("One response that settles at 1."));
}

void TestPlotWidget::csv_sharedAndOwnX_fullPrecision()
{
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    content.curves.push_back(
        {"a", CurveRole::Measured, CurveStyle::Line, {0.0, 0.1}, {1.0 / 3.0, kNan}, true});
    content.curves.push_back(
        {"b, \"x\"", CurveRole::Model, CurveStyle::Line, {0.0, 0.1}, {2e-7, 1e22}, true});
    PlotWidget plot;
    plot.setContent(content);
    QCOMPARE(plot.csv(),
        QString("Time / s,a / V,\"b, \"\"x\"\" / V\"\n"
                "0,0.3333333333333333,2e-07\n"
                "0.1,,1e+22\n"));
    content.curves[1].x = {5.0};
    content.curves[1].y = {6.0};
    plot.setContent(content);
    QCOMPARE(plot.csv(),
        QString("Time a / s,a / V,\"Time b, \"\"x\"\" / s\",\"b, \"\"x\"\" / V\"\n"
                "0,0.3333333333333333,5,6\n"
                "0.1,,,\n"));
}

void TestPlotWidget::paint_intoPdf_staysVector()
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(96);
    QPainter painter(&writer);
    PlotContent content = timeContent(200000);
    PlotWidget::paint(painter, QRectF(20, 30, 600, 300), content);
    painter.end();
    QVERIFY(!bytes.contains("/Subtype /Image"));
    QVERIFY2(bytes.size() < 400000, qPrintable(QString::number(bytes.size())));
    QVERIFY(!bytes.contains("/ca 0"));
}

void TestPlotWidget::palette_dark_changesBackground()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    QCOMPARE(plot.grab().toImage().pixelColor(10, 200), QColor(Qt::white));
    QPalette dark;
    dark.setColor(QPalette::Window, QColor("#202020"));
    plot.setPalette(dark);
    QApplication::processEvents();
    QVERIFY(plot.grab().toImage().pixelColor(10, 200).lightness() < 60);
    QTemporaryDir folder;
    QVERIFY(plot.exportImage(folder.filePath("a.png")));
    QCOMPARE(QImage(folder.filePath("a.png")).pixelColor(2, 2), QColor(Qt::white));
}

void TestPlotWidget::accessibility_namesComeFromContent()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    QCOMPARE(plot.accessibleName(), QString("Response"));
    QCOMPARE(plot.accessibleDescription(), QString("One response that settles at 1."));
    QCOMPARE(plot.focusPolicy(), Qt::StrongFocus);
}

void TestPlotWidget::largeCurve_spikeOfOneSample_isDrawn()
{
    PlotContent content = timeContent(0);
    for (Index i = 0; i < 1000000; ++i) {
        content.curves[0].x.push_back(1e-9 * static_cast<double>(i));
        content.curves[0].y.push_back(i == 400001 ? 1.0 : 0.0);
    }
    content.yMax = 1.2;
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    const QImage image = plot.grab().toImage();
    const QPoint spike = plot.pixelOf(400001e-9, 0.5);
    bool inked = false;
    for (int dx = -2; dx <= 2; ++dx)
        inked = inked || image.pixelColor(spike + QPoint(dx, 0)).lightness() < 200;
    QVERIFY(inked);
}

void TestPlotWidget::keys_prefixOfAxis_followsRange()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    QTemporaryDir folder;
    wheel(plot, plot.pixelOf(0.0, 1.0), 20);
    QVERIFY(plot.xRange().end < 1e-4);
    QVERIFY(plot.exportImage(folder.filePath("a.svg")));
    QVERIFY(bytesOf(folder.filePath("a.svg")).contains(QByteArray("Time / µs")));
}

void TestPlotWidget::content_growing_isFittedUntilTheViewIsMoved()
{
    PlotWidget plot;
    PlotContent content = timeContent();
    content.growing = true;
    content.xMin = 0.0;
    content.xMax = 2e-3;
    const PlotCurve first = content.curves.front();
    content.curves.front().x.clear();
    content.curves.front().y.clear();
    plot.setContent(content); // the axis is there before the first point
    QCOMPARE(plot.xRange(), (Interval{0.0, 2e-3}));
    content.curves.front() = first;
    plot.setContent(content);
    QVERIFY(plot.yRange().end > 1.0 && plot.yRange().end < 5.0);
    PlotCurve higher = first;
    for (double &y : higher.y)
        y *= 10.0;
    content.curves.push_back(higher);
    plot.setContent(content);
    QVERIFY(plot.yRange().end > 10.0);

    plot.setXRange({0.5e-3, 0.6e-3}); // the operator looks closer: that stays, y still grows
    const double top = plot.yRange().end;
    for (double &y : higher.y)
        y *= 2.0;
    content.curves.push_back(higher);
    content.growing = false;
    plot.setContent(content);
    QCOMPARE(plot.xRange(), (Interval{0.5e-3, 0.6e-3}));
    QVERIFY(plot.yRange().end > 1.5 * top);

    const Interval y = plot.yRange();
    content.curves.resize(1); // complete: from now on nothing moves
    plot.setContent(content);
    QCOMPARE(plot.xRange(), (Interval{0.5e-3, 0.6e-3}));
    QCOMPARE(plot.yRange(), y);
}

void TestPlotWidget::decorationsAlone_areMovedToWhereANewPlotHasThem()
{
    PlotContent content = timeContent();
    content.curves.front().y[100] = kNan; // a gap equals itself
    content.yMin = 0.0;
    content.yMax = 2.0;
    content.levels = {{0.5, "order 2", CurveRole::Model}};
    content.marks = {{2e-4, "A", CurveRole::Reference}, {2.1e-4, "B", CurveRole::Reference}};
    PlotWidget plot;
    plot.setFocusPolicy(Qt::NoFocus); // its ring is not compared
    plot.setContent(content);
    show(plot);
    QSignalSpy replotted(&plot, &PlotWidget::replotted);
    QSignalSpy changed(&plot, &PlotWidget::contentChanged);
    content.levels = {{1.5, "order 3", CurveRole::Candidate1}};
    content.marks.front().x = 8e-4;
    content.summary = "moved";
    plot.setContent(content);
    QCOMPARE(replotted.count(), 1); // at once, and not once more
    QApplication::processEvents();
    QCOMPARE(replotted.count(), 1);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(plot.accessibleDescription(), QString("moved"));
    QCOMPARE(plot.content().levels.front().y, 1.5);
    const auto isAsNew = [&plot](const PlotContent &shown) {
        PlotWidget fresh;
        fresh.setFocusPolicy(Qt::NoFocus);
        fresh.setContent(shown);
        show(fresh);
        return plot.grab().toImage() == fresh.grab().toImage();
    };
    QVERIFY(isAsNew(content));

    content.curves.front().y[200] += 0.5; // the rest is drawn again as soon as it differs
    replotted.clear();
    plot.setContent(content);
    QApplication::processEvents();
    QCOMPARE(replotted.count(), 1);
    QVERIFY(isAsNew(content));
    content.levels.push_back({1.8, "", CurveRole::Reference}); // or is one more
    replotted.clear();
    plot.setContent(content);
    QApplication::processEvents();
    QCOMPARE(replotted.count(), 1);
    QVERIFY(isAsNew(content));
}

void TestPlotWidget::noise_inEveryStyle_takesAboutTheSameTime()
{
    constexpr double kMost = 12.0; // measured 4; dashes took 50 times as long, wide pens too
    PlotContent content = timeContent(15000);
    for (std::size_t i = 0; i < content.curves[0].y.size(); ++i)
        content.curves[0].y[i] = std::sin(1.7 * static_cast<double>(i * i));
    PlotWidget plot;
    show(plot);
    std::vector<double> times;
    for (int role = 0; role <= static_cast<int>(CurveRole::Suggestion); ++role) {
        content.curves[0].role = static_cast<CurveRole>(role);
        plot.setContent(content);
        QApplication::processEvents();
        const std::clock_t before = std::clock(); // of the processor: others do not count
        for (int i = 0; i < 3; ++i) {
            plot.setXRange({1e-9 * i, 1e-3});
            QApplication::processEvents();
        }
        times.push_back(static_cast<double>(std::clock() - before));
    }
    const auto [least, most] = std::minmax_element(times.begin(), times.end());
    QVERIFY2(*most < kMost * *least, qPrintable(QString::number(*most / *least)));
}

void TestPlotWidget::longRecord_click_picksTheSpikesOwnSample()
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

void TestPlotWidget::longRecord_csv_isOfTheView()
{
    PlotWidget plot;
    plot.setContent(longRecord());
    show(plot);
    const auto rows = [&] { return plot.csv().split('\n', Qt::SkipEmptyParts); };
    QVERIFY(rows().size() > 500 && rows().size() < 2000); // extremes of pixel columns
    const double x = static_cast<double>(kSpike) * 1e-6;
    plot.setXRange({x - 4.5e-6, x + 4.5e-6});
    QTRY_COMPARE(rows().size(), 1 + 11); // heading, nine samples, a neighbour at either side
    QCOMPARE(rows()[6], QString("1.234567,1"));
}

DYNCAL_TEST(TestPlotWidget)
#include "tst_plot_widget.moc"
