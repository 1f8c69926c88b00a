// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/plot/widget/plot_bench.h"

#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <complex>
#include <limits>

using namespace dyncal;
using namespace dyncal::test;

/// Contents, views and looks.
class TestPlotWidget : public QObject
{
    Q_OBJECT

private slots:
    void init_contentOfOneCurve_fitsIt();
    void setContent_afterZoom_keepsView();
    void setContent_otherQuantity_fitsThatAxis();
    void setContent_emptyFirst_fitsWhenDataCome();
    void level_withABand_isFilled();
    void dampingGrid_isDrawn_andToggledByG();
    void logAxis_zeroAndNegative_areDropped();
    void nanGap_inCurve_isNoTrouble();
    void twoPoints_and_onePoint_fit();
    void poleZeroMap_anySize_hasEqualScales();
    void palette_dark_changesBackground();
    void accessibility_namesComeFromContent();
    void keys_prefixOfAxis_followsRange();
    void content_growing_isFittedUntilTheViewIsMoved();
    void decorationsAlone_areMovedToWhereANewPlotHasThem();
    void notice_standsInTheAxes_andDimsTheCurves();
    void leastHeight_fewerNames_staysUntilTheWidthChanges();
};

void TestPlotWidget::leastHeight_fewerNames_staysUntilTheWidthChanges()
{
    PlotContent manyNames = timeContent();
    for (int i = 2; i <= 24; ++i)
        manyNames.curves.push_back(
            ringing(QString("Shot %1 of the series").arg(i), CurveRole::ShotLow, 50, 1e-3));
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    const int low = plot.minimumSizeHint().height();
    plot.setContent(manyNames);
    QTRY_VERIFY(plot.minimumSizeHint().height() > low);
    const int high = plot.minimumSizeHint().height();
    plot.setContent(timeContent());
    QTest::qWait(50);
    QCOMPARE(plot.minimumSizeHint().height(), high);
    plot.resize(700, 400);
    QTRY_COMPARE(plot.minimumSizeHint().height(), low);
}

void TestPlotWidget::notice_standsInTheAxes_andDimsTheCurves()
{
    PlotWidget plot;
    plot.resize(500, 300);
    plot.setContent(timeContent());
    plot.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    const QImage bright = plot.grab().toImage();
    plot.setNotice("The baseline overlaps the response, which begins at 0; move it.", true);
    QTest::qWait(50);
    QVERIFY(plot.isDimmed());
    const auto *label = plot.findChild<QLabel *>("plotNotice");
    QVERIFY(label && label->isVisible());
    QVERIFY(plot.axesRect().contains(label->geometry()));
    QVERIFY(label->height() > 2 * label->fontMetrics().height()); // with its margins
    plot.setNotice("Why there are none.", false);
    QVERIFY(!plot.isDimmed());
    QCOMPARE(plot.notice(), QString("Why there are none."));
    plot.setNotice({}, false);
    QVERIFY(plot.notice().isEmpty() && label->isHidden());
    QTest::qWait(50);
    QCOMPARE(plot.grab().toImage(), bright);
}

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
    QCOMPARE(QImage::fromData(plot.fileBytes("png").value()).pixelColor(2, 2), QColor(Qt::white));
}

void TestPlotWidget::accessibility_namesComeFromContent()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    QCOMPARE(plot.accessibleName(), QString("Response"));
    QCOMPARE(plot.accessibleDescription(), QString("One response that settles at 1."));
    QCOMPARE(plot.focusPolicy(), Qt::StrongFocus);
}

void TestPlotWidget::keys_prefixOfAxis_followsRange()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    wheel(plot, plot.pixelOf(0.0, 1.0), 20);
    QVERIFY(plot.xRange().end < 1e-4);
    QVERIFY(plot.fileBytes("svg").value().contains(QByteArray("Time / µs")));
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
    plot.setContent(content); // the same again draws nothing
    QApplication::processEvents();
    QCOMPARE(replotted.count(), 1);
    content.levels.front().label = "order 4"; // words and colours count as places do
    plot.setContent(content);
    content.marks.back().role = CurveRole::Model;
    plot.setContent(content);
    QCOMPARE(replotted.count(), 3);
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

DYNCAL_TEST(TestPlotWidget)
#include "tst_plot_widget.moc"
