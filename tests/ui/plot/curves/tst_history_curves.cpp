// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/curves/history_curves.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

const std::vector<DatedValue> kValues{{2021.2, 5.0, 0.1, false}, {2022.2, 5.1, 0.1, false},
    {2023.2, 5.9, 0.2, true}, {2024.2, 5.0, kUnknown, false}};

} // namespace

/// A quantity of a sensor over the years, from values written down.
class TestHistoryCurves : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyValue_isDrawnWithItsU()
    {
        const PlotContent content = historyCurves("Sensitivity", "V/Pa", kValues, {});
        QCOMPARE(content.curves.size(), std::size_t(4));
        const PlotCurve &bars = content.curves[0], &values = content.curves[1];
        QCOMPARE(values.x, (std::vector<double>{2021.2, 2022.2, 2024.2}));
        QCOMPARE(values.y, (std::vector<double>{5.0, 5.1, 5.0}));
        QCOMPARE(bars.y[0], 4.9);
        QCOMPARE(bars.y[1], 5.1);
        QVERIFY(std::isnan(bars.y[2])); // a bar ends where the next begins
        QVERIFY(std::isnan(bars.y[6])); // none where U is not known
        QCOMPARE(content.curves[3].x, std::vector<double>{2023.2});
        QVERIFY(content.curves[3].role != values.role);
        QCOMPARE(content.yAxis.quantity, QString("Sensitivity"));
        QCOMPARE(content.yAxis.unit, QString("V/Pa"));
        QVERIFY2(content.summary.contains("1 of 4"), qPrintable(content.summary));
    }

    void limits_areLevelsWithinTheView()
    {
        const PlotContent content
            = historyCurves("f0", "Hz", kValues, ControlLimits{.mean = 5.0, .sigma = 0.5});
        std::vector<double> levels;
        for (const PlotLevel &one : content.levels)
            levels.push_back(one.y);
        QCOMPARE(levels, (std::vector<double>{5.0, 4.0, 6.0, 3.5, 6.5}));
        QVERIFY(*content.yMin < 3.5 && *content.yMax > 6.5);
        QVERIFY(*content.xMin < 2021.2 && *content.xMax > 2024.2);
    }

    void singleValue_hasRoom()
    {
        const PlotContent content = historyCurves("f0", "Hz", {{2024.5, 3e5, kUnknown}}, {});
        QVERIFY(*content.xMin < 2024.5 && *content.xMax > 2024.5);
        QVERIFY(*content.yMin < 3e5 && *content.yMax > 3e5);
        QVERIFY(content.levels.empty());
    }

    void none_isAnEmptyPlot()
    {
        const PlotContent content = historyCurves("f0", "Hz", {}, {});
        QVERIFY(content.curves.empty() && !content.yMin);
    }
};

DYNCAL_TEST(TestHistoryCurves)
#include "tst_history_curves.moc"
