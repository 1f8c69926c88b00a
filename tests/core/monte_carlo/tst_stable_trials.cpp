// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"
#include "core/monte_carlo/stable_trials.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

DrawnQuantity drawn(double mean, double u)
{
    DrawnQuantity one;
    one.mean = mean;
    one.u = u;
    one.low = mean - 2.0 * u;
    one.high = mean + 2.0 * u;
    return one;
}

using Batches = std::vector<std::vector<DrawnQuantity>>;

} // namespace

class TestStableTrials : public QObject
{
    Q_OBJECT

private slots:
    void oneBatch_neverIs()
    {
        QVERIFY(!areStable({}, 2));
        QVERIFY(!areStable({{drawn(0.0, 1.0)}}, 2));
    }

    /// Of u = 1.2 two digits are known to 0.05: twice the spread of the mean over the batches, here
    /// half their distance, may be that.
    void spread_isHeldAgainstTheLastDigit()
    {
        const auto apart = [](double distance) {
            return Batches{{drawn(0.0, 1.2)}, {drawn(distance, 1.2)}};
        };
        QVERIFY(areStable(apart(0.049), 2));
        QVERIFY(!areStable(apart(0.051), 2));
        QVERIFY(areStable(apart(0.49), 1));
        QVERIFY(!areStable(apart(0.51), 1));
    }

    void everyQuantity_mustBe()
    {
        QVERIFY(!areStable(
            {{drawn(0.0, 1.2), drawn(0.0, 1.2)}, {drawn(0.0, 1.2), drawn(1.0, 1.2)}}, 2));
        QVERIFY(
            areStable({{drawn(0.0, 1.2), DrawnQuantity()}, {drawn(0.0, 1.2), DrawnQuantity()}}, 2));
    }

    /// u of three degrees of freedom scatters without end: the interval tells, of which u is a
    /// quarter.
    void fewDegreesOfFreedom_goByTheirInterval()
    {
        const auto batches = [](double dof, double u, double high) {
            Batches two{{drawn(0.0, 1.2)}, {drawn(0.0, u)}};
            for (auto &batch : two)
                batch[0].leastDof = dof;
            two[1][0].low = -2.4;
            two[1][0].high = high;
            return two;
        };
        QVERIFY(areStable(batches(3.0, 9.0, 2.4), 2));
        QVERIFY(areStable(batches(2.0, kUnknown, 2.4), 2));
        QVERIFY(!areStable(batches(3.0, 1.2, 2.6), 2));
        QVERIFY(!areStable(batches(2.0, kUnknown, 2.6), 2));
        QVERIFY(!areStable(batches(5.0, 9.0, 2.4), 2));
    }

    /// Batches of normal numbers: the more there are, the closer their mean.
    void manyBatches_become()
    {
        Batches batches;
        while (!areStable(batches, 1) && batches.size() < 100) {
            Eigen::VectorXd values(1000);
            RandomStream stream(1, std::ssize(batches), 1);
            for (double &one : values)
                one = 9.0 * stream.nextNormal(); // 9: half a unit is 6 % of u
            batches.push_back({drawnQuantity(values, 0.0, 0.95)});
        }
        QVERIFY2(
            batches.size() > 2 && batches.size() < 60, qPrintable(QString::number(batches.size())));
    }
};

DYNCAL_TEST(TestStableTrials)
#include "tst_stable_trials.moc"
