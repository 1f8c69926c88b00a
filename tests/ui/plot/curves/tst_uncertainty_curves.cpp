// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// |S(f)| with its expanded uncertainty, from budgets written down.

#include "tests/support/test_program.h"
#include "ui/plot/curves/uncertainty_curves.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

Budget budgetAt(
    double frequency_Hz, double value, std::optional<double> u, BudgetOf kind = BudgetOf::Magnitude)
{
    Budget budget{kind, ShotLevel::None, frequency_Hz, 3, {"magnitude", value, "V/Pa"}};
    if (u) {
        budget.reported.lines = {directLine("noise", *u)};
        combineLines(budget.reported);
    }
    return budget;
}

const PlotCurve *curveCalled(const PlotContent &content, const QString &name)
{
    for (const PlotCurve &curve : content.curves)
        if (curve.name == name)
            return &curve;
    return nullptr;
}

} // namespace

class TestUncertaintyCurves : public QObject
{
    Q_OBJECT

private:
    ResponseResult m_response;
    const std::vector<Budget> m_budgets{budgetAt(1e3, 5.0, 0.1), budgetAt(1e4, 4.0, 0.2),
        budgetAt(1e5, 3.0, {}), budgetAt(1e3, 30.0, 1.0, BudgetOf::Phase)};

private slots:
    void initTestCase()
    {
        m_response.unit = "V/Pa";
        m_response.modelCurve.frequency_Hz = Eigen::Vector2d(1e3, 1e5);
        m_response.modelCurve.magnitude = Eigen::Vector2d(5.0, 3.0);
    }

    void bars_areU_ofKnownMagnitudes()
    {
        const PlotContent content = expandedMagnitudeCurves(m_response, m_budgets);
        const PlotCurve *bars = curveCalled(content, "± U");
        QVERIFY(bars);
        QCOMPARE(bars->x, (std::vector<double>{1e3, 1e3, 1e3, 1e4, 1e4, 1e4}));
        QVERIFY(std::abs(bars->y[1] - bars->y[0] - 0.4) < 1e-12); // 2 U
        QVERIFY(std::isnan(bars->y[2]));
        QCOMPARE(curveCalled(content, "Non-parametric")->y, (std::vector<double>{5.0, 4.0, 3.0}));
        QVERIFY(content.xAxis.logarithmic && content.yAxis.logarithmic);
        QCOMPARE(content.yAxis.unit, QString("V/Pa"));
        QVERIFY(content.marks.empty());
    }

    void relativeU_isInPercent_atTheRight()
    {
        const PlotContent content = expandedMagnitudeCurves(m_response, m_budgets);
        const PlotCurve *relative = curveCalled(content, "U, relative");
        QVERIFY(relative && relative->onSecondAxis);
        QVERIFY(std::abs(relative->y[0] - 4.0) < 1e-9 && std::abs(relative->y[1] - 10.0) < 1e-9);
        QCOMPARE(content.yAxis2->unit, QString("%"));
        QVERIFY2(content.summary.contains("4"), qPrintable(content.summary));
        QVERIFY(!curveCalled(content, "U, what if"));
    }

    void tried_isACurveOfItsOwn()
    {
        const std::vector<Budget> tried{budgetAt(1e3, 5.0, 0.05)};
        const PlotContent content = expandedMagnitudeCurves(m_response, m_budgets, tried, 1e4);
        QVERIFY(std::abs(curveCalled(content, "U, what if")->y[0] - 2.0) < 1e-9);
        QCOMPARE(content.marks.size(), std::size_t(1));
        QCOMPARE(content.marks[0].x, 1e4);
    }

    void withoutU_onlyValuesAreDrawn()
    {
        const PlotContent content = expandedMagnitudeCurves(m_response, {budgetAt(1e3, 5.0, {})});
        QVERIFY(!curveCalled(content, "± U") && !content.yAxis2);
        QVERIFY(content.summary.contains("not known"));
        m_response.unit = "1";
        QVERIFY(expandedMagnitudeCurves(m_response, {}).yAxis.unit.isEmpty());
    }
};

DYNCAL_TEST(TestUncertaintyCurves)
#include "tst_uncertainty_curves.moc"
