// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Step and reference transducer in one plot, from values written down.

#include "tests/support/made_comparison.h"
#include "tests/support/test_program.h"
#include "ui/plot/curves/comparison_curves.h"

#include <QtTest>

using namespace dyncal;

namespace {

const PlotCurve *curveNamed(const PlotContent &content, const QString &name)
{
    for (const PlotCurve &curve : content.curves)
        if (curve.name == name)
            return &curve;
    return nullptr;
}

} // namespace

class TestComparisonCurves : public QObject
{
    Q_OBJECT

private:
    const ComparisonResult m_comparison
        = testing::comparisonOf({2.0, 2.1, 2.2}, {2.02, 2.3, 2.2}, {0.4, 1.5, kUnknown});

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void both_haveTheirValuesAndU()
    {
        const PlotContent content = comparedMagnitudeCurves(m_comparison);
        const PlotCurve *step = curveNamed(content, "Pressure step");
        const PlotCurve *transducer = curveNamed(content, "Reference transducer");
        QVERIFY(step && transducer);
        QCOMPARE(step->y, (std::vector<double>{2.02, 2.3, 2.2}));
        QCOMPARE(transducer->y, (std::vector<double>{2.0, 2.1, 2.2}));
        const PlotCurve *bars = curveNamed(content, "Reference transducer, ± U");
        QCOMPARE(bars->x, (std::vector<double>{1e3, 1e3, 1e3, 1e4, 1e4, 1e4, 1e5, 1e5, 1e5}));
        QVERIFY(std::abs(bars->y[1] - bars->y[0] - 2.0 * 2.0 * 0.005 * 2.0) < 1e-9);
        QVERIFY(step->role != transducer->role);
        QCOMPARE(content.yAxis.unit, QString("V/Pa"));
        QVERIFY(content.xAxis.logarithmic);
        QVERIFY2(content.summary.contains("differ by 1.0"), qPrintable(content.summary));
    }

    void deviations_areInPercentOfTheMean()
    {
        const PlotContent content = comparedDeviationCurves(m_comparison);
        const PlotCurve *step = curveNamed(content, "Pressure step");
        const PlotCurve *transducer = curveNamed(content, "Reference transducer");
        QVERIFY(step && transducer);
        QVERIFY(std::abs(step->y[0] - 1.0 / 2.01) < 1e-9);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs(step->y[i] + transducer->y[i]) < 1e-9);
        const PlotCurve *bars = curveNamed(content, "Reference transducer, ± U");
        const double U = 2.0 * 0.005 * 2.0; // k u S
        QVERIFY(std::abs(bars->y[1] - bars->y[0] - 2.0 * 100.0 * U / 2.01) < 1e-6);
        QCOMPARE(content.yAxis.unit, QString("%"));
        QVERIFY(!content.yAxis.logarithmic);
        QVERIFY(!curveNamed(content, "Model"));
    }

    void deviations_whereOneIsUnknown_areNone()
    {
        ComparisonResult gap = m_comparison;
        gap.byStep->response.magnitude[1] = kUnknown;
        const PlotContent content = comparedDeviationCurves(gap);
        QCOMPARE(curveNamed(content, "Reference transducer")->x, (std::vector<double>{1e3, 1e5}));
    }

    void unknownStep_leavesTheTransducerAlone()
    {
        ComparisonResult alone = m_comparison;
        alone.byStep->response.unit = "1";
        alone.againstStep.reset();
        const PlotContent content = comparedMagnitudeCurves(alone);
        QVERIFY(!curveNamed(content, "Pressure step"));
        QVERIFY(!curveNamed(content, "Pressure step, ± U"));
        QVERIFY(curveNamed(content, "Reference transducer"));
        QVERIFY(content.summary.contains("not known"));
    }

    void withoutU_noBars()
    {
        ComparisonResult bare = m_comparison;
        bare.byStep->report.rows.u_common_relative = kUnknown;
        const PlotContent content = comparedMagnitudeCurves(bare);
        QVERIFY(curveNamed(content, "Pressure step"));
        QVERIFY(!curveNamed(content, "Pressure step, ± U"));
    }

    void normalisedError_showsItsLimits()
    {
        const PlotContent content = normalisedErrorCurves(m_comparison);
        QCOMPARE(content.curves.size(), std::size_t(1));
        QCOMPARE(content.curves[0].x, (std::vector<double>{1e3, 1e4})); // the unknown one is none
        QCOMPARE(content.levels.size(), std::size_t(2));
        QVERIFY(*content.yMax > 1.5 && *content.yMin < -1.5);
        QVERIFY2(content.summary.contains("1 of 2"), qPrintable(content.summary));
    }

    void normalisedError_ofNothing_hasItsLimits()
    {
        ComparisonResult none = m_comparison;
        none.againstStep.reset();
        const PlotContent content = normalisedErrorCurves(none);
        QVERIFY(content.curves.empty());
        QVERIFY(*content.yMax > 1.0);
    }
};

DYNCAL_TEST(TestComparisonCurves)
#include "tst_comparison_curves.moc"
