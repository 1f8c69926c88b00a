// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/coverage_interval.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

/// The values with the probabilities (i + 1/2)/n, in a shuffled order.
template <typename Quantile>
Eigen::VectorXd spread(Index count, const Quantile &quantile)
{
    Eigen::VectorXd values(count);
    for (Index i = 0; i < count; ++i) // 7919 has no factor in common with the counts used
        values[i * 7919 % count]
            = quantile((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    return values;
}

double exponential(double p)
{
    return -std::log(1.0 - p);
}

} // namespace

class TestCoverageInterval : public QObject
{
    Q_OBJECT

private slots:
    void rectangle_hasItsMomentsAndEnds()
    {
        const DrawnQuantity drawn
            = drawnQuantity(spread(10000, [](double p) { return p; }), 0.5, 0.95);
        QCOMPARE(drawn.trials, Index(10000));
        QCOMPARE(drawn.undefined, Index(0));
        QVERIFY(isNear(drawn.mean, 0.5, 1e-12));
        QVERIFY(isNear(drawn.u, 1.0 / std::sqrt(12.0), 1e-4));
        QVERIFY(isNear(drawn.low, 0.025, 1e-9) && isNear(drawn.high, 0.975, 1e-9));
        QVERIFY(isNear(drawn.expanded, 0.475, 1e-3));
    }

    /// The density falls: the shortest interval begins at 0 and ends at -ln(0.05).
    void exponential_hasItsShortestAtTheStart()
    {
        const DrawnQuantity drawn = drawnQuantity(spread(20000, exponential), 0.0, 0.95);
        QVERIFY(drawn.shortestLow < 1e-4);
        QVERIFY(isNear(drawn.shortestHigh, exponential(0.95), 1e-2));
        QVERIFY(isNear(drawn.low, exponential(0.025), 1e-3));
        QVERIFY(isNear(drawn.high, exponential(0.975), 1e-3));
        QVERIFY(isNear(drawn.expanded, exponential(0.95), 1e-3)); // about 0: one-sided
    }

    /// U is about the value that is stated, not about the mean: of a rectangle from 0 to 1 about 1
    /// it reaches 0.95 far.
    void expanded_isAboutTheReportedValue()
    {
        const DrawnQuantity drawn
            = drawnQuantity(spread(10000, [](double p) { return p; }), 1.0, 0.95);
        QVERIFY(isNear(drawn.expanded, 0.95, 1e-3));
        QVERIFY(drawn.leastExpanded < drawn.expanded && drawn.expanded < drawn.mostExpanded);
        const double reach = 1.96 * std::sqrt(0.95 * 0.05 / 10000.0);
        QVERIFY(isNear(drawn.mostExpanded - drawn.leastExpanded, 2.0 * reach, 1e-2));
    }

    /// Few trials leave much open, many little: as one over the root of their number.
    void whatTheTrialsLeaveOpen_shrinksWithTheirNumber()
    {
        const auto width = [](Index count) {
            const DrawnQuantity drawn
                = drawnQuantity(spread(count, [](double p) { return p; }), 0.5, 0.95);
            return drawn.mostExpanded - drawn.leastExpanded;
        };
        QVERIFY(isNear(width(400) / width(40000), 10.0, 0.15));
    }

    void aTrialWithoutAValue_leavesNothing()
    {
        Eigen::VectorXd values = spread(1000, [](double p) { return p; });
        values[17] = kUnknown;
        const DrawnQuantity drawn = drawnQuantity(values, 0.5, 0.95);
        QCOMPARE(drawn.undefined, Index(1));
        for (const double one : {drawn.mean, drawn.u, drawn.low, drawn.high, drawn.shortestLow,
                 drawn.shortestHigh, drawn.expanded, drawn.leastExpanded, drawn.mostExpanded})
            QVERIFY(std::isnan(one));
    }

    /// A hundred values that are looked at together are allowed what one of them seldom needs.
    void manyComparisons_leaveMoreOpen()
    {
        const Eigen::VectorXd values = spread(1000, [](double p) { return p; });
        const auto least = [&](Index comparisons) {
            return drawnQuantity(values, 0.0, 0.95, comparisons).leastExpanded;
        };
        const double deviation = std::sqrt(0.95 * 0.05 / 1000.0);
        QVERIFY(isNear(0.95 - least(1), 1.95996 * deviation, 0.03));
        QVERIFY(isNear(0.95 - least(100), 3.48076 * deviation, 0.03)); // 1 - 0.025/100
        QCOMPARE(drawnQuantity(values, 0.0, 0.95, 100).expanded,
            drawnQuantity(values, 0.0, 0.95).expanded);
    }

    /// JCGM 101, 6.4.9.4.
    void momentsThatDoNotExist_areNotStated()
    {
        for (const double dof : {1.0, 2.0, 3.0}) {
            DrawnQuantity drawn
                = drawnQuantity(spread(1000, [](double p) { return p; }), 0.5, 0.95);
            const DrawnQuantity before = drawn;
            leaveOutMoments(dof, drawn);
            QCOMPARE(std::isfinite(drawn.mean), dof > 1.0);
            QCOMPARE(std::isfinite(drawn.u), dof > 2.0);
            QCOMPARE(drawn.low, before.low);
            QCOMPARE(drawn.shortestHigh, before.shortestHigh);
            QCOMPARE(drawn.expanded, before.expanded);
        }
    }

    void oneTrial_isNone()
    {
        QVERIFY(std::isnan(drawnQuantity(Eigen::VectorXd::Ones(1), 1.0, 0.95).u));
        QVERIFY(std::isnan(drawnQuantity(Eigen::VectorXd(), 1.0, 0.95).mean));
    }

    void equalTrials_haveNoWidth()
    {
        const DrawnQuantity drawn = drawnQuantity(Eigen::VectorXd::Constant(200, 3.0), 3.0, 0.95);
        QCOMPARE(drawn.u, 0.0);
        QCOMPARE(drawn.expanded, 0.0);
        QCOMPARE(drawn.low, 3.0);
        QCOMPARE(drawn.shortestHigh, 3.0);
    }
};

DYNCAL_TEST(TestCoverageInterval)
#include "tst_coverage_interval.moc"
