// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/plot/widget/plot_bench.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <ctime>

using namespace dyncal;
using namespace dyncal::test;

/// What leaves a plot (pictures, numbers), and how long curves are drawn.
class TestPlotOutput : public QObject
{
    Q_OBJECT

private slots:
    void file_allFormats();
    void file_unknownFormat_isNone();
    void file_svg_isVectorAndDeterministic();
    void swedishAxes_haveTheMinusOfTables();
    void paste_tabsAndTheDecimalMarkOfTheLanguage();
    void csv_sharedAndOwnX_fullPrecision();
    void paint_intoPdf_staysVector();
    void largeCurve_spikeOfOneSample_isDrawn();
    void noise_inEveryStyle_takesAboutTheSameTime();
    void longRecord_csv_isOfTheView();
};

void TestPlotOutput::file_allFormats()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    plot.setBand("b", "Band", {2e-4, 4e-4});
    show(plot);
    const QImage image = QImage::fromData(plot.fileBytes("png").value(), "PNG");
    QVERIFY(image.width() > 1000);
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
    QVERIFY(inkedPixels(image) > 1000);
    QVERIFY(plot.fileBytes("svg").value().contains("<svg"));
    QVERIFY(plot.fileBytes("pdf").value().startsWith("%PDF-"));
    QCOMPARE(plot.fileBytes("csv").value(), plot.csv().toUtf8());
    const QImage small = QImage::fromData(plot.fileBytes("png", {300, 200}).value());
    QCOMPARE(small.size(), QSize(600, 400)); // two pixels for each of the screen
}

void TestPlotOutput::file_unknownFormat_isNone()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    QVERIFY(!plot.fileBytes("gif"));
    QVERIFY(!plot.fileBytes(""));
}

void TestPlotOutput::file_svg_isVectorAndDeterministic()
{
    PlotWidget plot;
    plot.setContent(timeContent());
    show(plot);
    const QByteArray svg = plot.fileBytes("svg").value();
    QCOMPARE(svg, plot.fileBytes("svg").value());
    QVERIFY(!svg.contains("<image"));
    QVERIFY(svg.contains("<text"));
    QVERIFY(svg.contains("Time / ms"));
    QVERIFY(svg.contains("One response that settles at 1."));
}

void TestPlotOutput::swedishAxes_haveTheMinusOfTables()
{
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Swedish));
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    content.curves.push_back(
        {"a", CurveRole::Measured, CurveStyle::Line, {-1.0, 1.0}, {-0.5, 0.5}, true});
    PlotWidget plot;
    plot.setContent(content);
    show(plot);
    QStringList texts;
    for (const PlotText &text : plot.texts())
        texts << text.text;
    QLocale::setDefault(before);
    QVERIFY2(texts.contains("-1,0") || texts.contains("-0,5"), qPrintable(texts.join('|')));
    QVERIFY(!texts.join(' ').contains(QChar(0x2212)));
}

void TestPlotOutput::paste_tabsAndTheDecimalMarkOfTheLanguage()
{
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    content.curves.push_back(
        {"=1+1", CurveRole::Measured, CurveStyle::Line, {0.0, 0.1}, {1.0 / 3.0, kNan}, true});
    PlotWidget plot;
    plot.setContent(content);
    QCOMPARE(plot.dataToPaste(), QString("Time / s\t'=1+1 / V\n0\t0.3333333333333333\n0.1\t\n"));
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Swedish));
    const QString swedish = plot.dataToPaste();
    QLocale::setDefault(before);
    QCOMPARE(swedish, QString("Time / s\t'=1+1 / V\n0\t0,3333333333333333\n0,1\t\n"));
}

void TestPlotOutput::csv_sharedAndOwnX_fullPrecision()
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

void TestPlotOutput::paint_intoPdf_staysVector()
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

void TestPlotOutput::largeCurve_spikeOfOneSample_isDrawn()
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

void TestPlotOutput::noise_inEveryStyle_takesAboutTheSameTime()
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

void TestPlotOutput::longRecord_csv_isOfTheView()
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

DYNCAL_TEST(TestPlotOutput)
#include "tst_plot_output.moc"
