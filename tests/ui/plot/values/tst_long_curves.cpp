// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/values/curve_samples.h"
#include "ui/plot/values/long_curves.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace dyncal;

namespace {

constexpr Index kPoints = 50'000;
constexpr Index kMost = 10'000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A slow sine, 0 .. kPoints - 1 in steps of 1.
PlotCurve sine()
{
    PlotCurve curve;
    curve.name = "Shot 1";
    for (Index i = 0; i < kPoints; ++i) {
        curve.x.push_back(static_cast<double>(i));
        curve.y.push_back(std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 7000.0));
    }
    return curve;
}

PlotContent with(PlotCurve curve)
{
    PlotContent content;
    content.title = "Title";
    content.yMin = -3.0;
    content.curves.push_back(std::move(curve));
    return content;
}

double largest(const std::vector<double> &values)
{
    return *std::ranges::max_element(values);
}

} // namespace

class TestLongCurves : public QObject
{
    Q_OBJECT

private slots:
    void shortCurve_staysAsItIs();
    void longCurve_hasFewPointsAndItsWholeRecord();
    void oneSpike_staysVisible();
    void logarithmicAxes_dropWhatTheyCannotShow();
    void columns_areEvenOnALogarithmicAxis();
    void gaps_stayGaps();
    void whatIsNoLineOverX_staysAsItIs();
    void nothingShowable_leavesNoPoint();
};

void TestLongCurves::shortCurve_staysAsItIs()
{
    const PlotContent content = condensed(with(sine()), kPoints);
    QVERIFY(!content.curves[0].record);
    QCOMPARE(content.curves[0].y, sine().y);
}

void TestLongCurves::longCurve_hasFewPointsAndItsWholeRecord()
{
    const PlotContent content = condensed(with(sine()), kMost);
    QCOMPARE(content.title, QString("Title"));
    QCOMPARE(content.yMin, std::optional(-3.0));
    const PlotCurve &curve = content.curves[0];
    QCOMPARE(curve.name, QString("Shot 1"));
    QVERIFY(std::ssize(curve.x) < kMost);
    QCOMPARE(curve.x.size(), curve.y.size());
    QVERIFY(std::ranges::is_sorted(curve.x));
    QCOMPARE(largest(curve.y), largest(sine().y));
    QVERIFY(curve.record);
    QCOMPARE(curve.record->size(), kPoints);
    const DrawnPoints some = curve.record->samples(12'345, 12'400);
    QVERIFY(std::ranges::equal(some.y, std::span<const double>(sine().y).subspan(12'345, 55)));
    QCOMPARE(some.x.front(), 12'345.0);
}

void TestLongCurves::oneSpike_staysVisible()
{
    for (const std::size_t at : {std::size_t{0}, std::size_t{31'417}, std::size_t{kPoints - 1}}) {
        PlotCurve curve = sine();
        curve.y[at] = 40.0;
        const PlotContent content = condensed(with(curve), kMost);
        QCOMPARE(largest(content.curves[0].y), 40.0);
    }
}

void TestLongCurves::logarithmicAxes_dropWhatTheyCannotShow()
{
    PlotContent content = with(sine());
    content.xAxis.logarithmic = true;
    content.yAxis.logarithmic = true;
    const PlotContent shown = condensed(content, kMost);
    const PlotCurve &curve = shown.curves[0];
    QCOMPARE(curve.record->size(), kPoints - 1); // x = 0 has no place on the axis
    for (const double y : curve.y)
        QVERIFY(std::isnan(y) || y > 0.0);
    QVERIFY(std::isnan(curve.record->samples(5'000, 5'001).y.front())); // the sine is below zero
}

void TestLongCurves::columns_areEvenOnALogarithmicAxis()
{
    PlotContent content = with(sine());
    content.xAxis.logarithmic = true;
    const PlotContent shown = condensed(content, kMost);
    const PlotCurve &curve = shown.curves[0];
    const auto between = [&curve](double from, double to) {
        const auto points
            = std::ranges::upper_bound(curve.x, to) - std::ranges::upper_bound(curve.x, from);
        return static_cast<double>(points) / std::log10(to / from);
    };
    // A decade of x has as much of the plot as another one.
    QVERIFY(std::abs(between(1e4, 4e4) / between(1e3, 1e4) - 1.0) < 0.01);
}

void TestLongCurves::gaps_stayGaps()
{
    PlotCurve curve = sine();
    std::fill(curve.y.begin() + 20'000, curve.y.begin() + 30'000, kNan);
    const PlotContent shown = condensed(with(curve), kMost);
    const PlotCurve &drawn = shown.curves[0];
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        const double x = drawn.x[i];
        if (x > 20'020.0 && x < 29'980.0)
            QVERIFY(std::isnan(drawn.y[i]));
        else if (x < 19'980.0 || x > 30'020.0)
            QVERIFY(std::isfinite(drawn.y[i]));
    }
}

void TestLongCurves::whatIsNoLineOverX_staysAsItIs()
{
    PlotCurve back = sine();
    std::ranges::reverse(back.x);
    QVERIFY(!condensed(with(back), kMost).curves[0].record);
    PlotCurve dots = sine();
    dots.style = CurveStyle::Dots;
    QVERIFY(!condensed(with(dots), kMost).curves[0].record);
    PlotCurve uneven = sine();
    uneven.y.pop_back();
    QVERIFY(!condensed(with(uneven), kMost).curves[0].record);
    const PlotContent twice = condensed(condensed(with(sine()), kMost), 100);
    QCOMPARE(twice.curves[0].record->size(), kPoints);
}

void TestLongCurves::nothingShowable_leavesNoPoint()
{
    PlotCurve curve = sine();
    for (double &x : curve.x)
        x -= static_cast<double>(kPoints);
    PlotContent content = with(curve);
    content.xAxis.logarithmic = true;
    const PlotContent shown = condensed(content, kMost);
    QVERIFY(shown.curves[0].x.empty() && shown.curves[0].y.empty() && !shown.curves[0].record);
}

DYNCAL_TEST(TestLongCurves)
#include "tst_long_curves.moc"
