// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of other calibrations beside S(f), from values written down.

#include "tests/support/made_comparison.h"
#include "tests/support/made_known.h"
#include "tests/support/test_program.h"
#include "ui/plot/curves/known_curves.h"

#include <QtTest>

using namespace dyncal;

namespace {

const PlotCurve *curveNamed(const PlotContent &content, const QString &name)
{
    const auto found = std::ranges::find(content.curves, name, &PlotCurve::name);
    return found == content.curves.end() ? nullptr : &*found;
}

/// S(f) at 1 and 10 kHz, a static value, one at 400 Hz, and one that is not compared.
UncertainResponse calibration()
{
    UncertainResponse one = testing::answerOf({2.02e-6, 2.1e-6}, 0.005);
    one.response.fLow_Hz = 1e3;
    one.report.sensitivity = testing::voltsPerPascal(2.02e-6, 1e-8);
    one.report.known
        = {testing::madeKnown(0.93), testing::madeKnown(1.4, 400.0), testing::madeUncompared()};
    return one;
}

} // namespace

class TestKnownCurves : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void compared_standBesideTheRows()
    {
        const auto [response, report] = calibration();
        const PlotContent content = knownMagnitudeCurves(response, report);
        QCOMPARE(
            curveNamed(content, "This calibration")->y, (std::vector<double>{2.02e-6, 2.1e-6}));
        const PlotCurve *other = curveNamed(content, "Other calibrations");
        QCOMPARE(other->x, (std::vector<double>{200.0, 400.0})); // static: an octave below
        QCOMPARE(other->y, (std::vector<double>{2e-6, 2e-6}));
        const PlotCurve *bars = curveNamed(content, "Other calibrations, \u00b1 U");
        QVERIFY(std::abs(bars->y[1] - bars->y[0] - 2.0 * 2.0 * 4e-9) < 1e-15);
        QCOMPARE(content.marks.size(), std::size_t(1));
        QCOMPARE(content.marks.front().x, 200.0);
        QVERIFY2(content.summary.contains("1 agree"), qPrintable(content.summary));
    }

    void deviations_areFromTheSensitivity_asFarAsTheyReach()
    {
        const auto [response, report] = calibration();
        const PlotContent content = knownDeviationCurves(response, report);
        const double deviation = 100.0 * (2.0 / 2.02 - 1.0), U = 100.0 * 2.0 * 0.004 / 2.02;
        QVERIFY(std::abs(curveNamed(content, "Other calibrations")->y[0] - deviation) < 1e-9);
        QVERIFY(std::abs(curveNamed(content, "This calibration")->y[0]) < 1e-9);
        QVERIFY(std::abs(*content.yMax - 1.5 * (U - deviation)) < 1e-9 || *content.yMax == 2.0);
        QCOMPARE(*content.yMin, -*content.yMax);
        QCOMPARE(content.yAxis.unit, QString("%"));
    }

    void withoutAStaticValue_nothingIsMarked()
    {
        UncertainResponse one = calibration();
        one.report.known = {testing::madeKnown(0.1, 5e3)};
        const PlotContent content = knownMagnitudeCurves(one.response, one.report);
        QVERIFY(content.marks.empty());
        QCOMPARE(curveNamed(content, "Other calibrations")->x, (std::vector<double>{5e3}));
    }
};

DYNCAL_TEST(TestKnownCurves)
#include "tst_known_curves.moc"
