// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/event_search.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kRate_Hz = 1e6;

BlockScan scanned(const Eigen::VectorXd &values)
{
    return scanBlocks(testing::doubleChannel(values, kRate_Hz), {}).value();
}

/// Rest, then `f(samples behind the event)`.
template <typename Behind>
Eigen::VectorXd record(Index size, Index event, double noiseSd, const Behind &behind)
{
    testing::Gaussian noise(3);
    return Eigen::VectorXd::NullaryExpr(size, [&](Index i) {
        return (i >= event ? behind(static_cast<double>(i - event)) : 0.0) + noiseSd * noise();
    });
}

double step(double)
{
    return 1.0;
}

double ringing(double i)
{
    return std::exp(-i / 2000.0) * std::sin(0.3 * i);
}

} // namespace

class TestEventSearch : public QObject
{
    Q_OBJECT

private slots:
    void medianOfThree_everyOrder()
    {
        std::array<double, 3> values{-2.0, 1.0, 7.0};
        do {
            const Eigen::VectorXd middle
                = withoutSpikes(Eigen::Vector3d(values[0], values[1], values[2]));
            QCOMPARE(middle.size(), Index(1));
            QCOMPARE(middle[0], 1.0);
        } while (std::next_permutation(values.begin(), values.end()));
        QCOMPARE(withoutSpikes(Eigen::Vector3d(4.0, 4.0, 9.0))[0], 4.0);
    }

    void loneSpikes_vanishAndEdgesStay()
    {
        Eigen::VectorXd values(9);
        values << 0, 0, 99, 0, 0, 5, 5, 5, 5;
        Eigen::VectorXd expected(7);
        expected << 0, 0, 0, 0, 5, 5, 5;
        QCOMPARE(withoutSpikes(values), expected);
        QCOMPARE(withoutSpikes(-values), Eigen::VectorXd(-expected));
    }

    void invalidAndShort_areNothing()
    {
        for (const Index size : {0, 1, 2})
            QCOMPARE(withoutSpikes(Eigen::VectorXd::Ones(size)).size(), Index(0));
        QCOMPARE(withoutSpikes(Eigen::VectorXd::Constant(50, kNaN)).size(), Index(0));
        Eigen::VectorXd values(5);
        values << 1.0, kNaN, 2.0, std::numeric_limits<double>::infinity(), 3.0;
        QCOMPARE(withoutSpikes(values), Eigen::VectorXd(Eigen::VectorXd::Constant(1, 2.0)));
        QCOMPARE(largestDistance(Eigen::VectorXd(), 5.0), 0.0);
        QCOMPARE(largestDistance(Eigen::Vector3d(1.0, -4.0, 2.0), 1.0), 5.0);
    }

    void blocks_haveTheirMeanAndTheirExcursionFromTwoBefore()
    {
        // 16 samples each: levels 0, 0, 2, 2, 2 with one block holding a bump of two samples.
        Eigen::VectorXd values = Eigen::VectorXd::Zero(80);
        values.tail(48).setConstant(2.0);
        values.segment(68, 2).setConstant(7.0);
        const BlockScan scan = scanned(values);
        QCOMPARE(scan.blockSize, Index(16));
        QCOMPARE(scan.level.size(), Index(5));
        QCOMPARE(scan.level[1], 0.0);
        QCOMPARE(scan.level[3], 2.0);
        QVERIFY(std::abs(scan.level[4] - (12 * 2.0 + 2 * 7.0) / 14.0) < 1e-12); // 14 medians
        Eigen::VectorXd excursion(5);
        excursion << 0.0, 0.0, 2.0, 2.0, 5.0;
        QCOMPARE(scan.excursion, excursion);
    }

    void invalidBlocks_takeANeighboursLevel()
    {
        Eigen::VectorXd values = Eigen::VectorXd::Constant(96, 3.0);
        values.head(32).setConstant(kNaN);
        values.segment(64, 16).setConstant(kNaN);
        values.tail(16).setConstant(4.0);
        const BlockScan scan = scanned(values);
        Eigen::VectorXd level(6);
        level << 3, 3, 3, 3, 3, 4; // an invalid begin is no change of level
        QCOMPARE(scan.level, level);
        QVERIFY(scanned(Eigen::VectorXd::Constant(64, kNaN)).level.isZero());
    }

    void unitAndOffset_moveNoBlock()
    {
        for (const auto &behind : {step, ringing}) {
            const Eigen::VectorXd values = record(20000, 7777, 0.01, behind);
            const Event plain = findEvent(scanned(values));
            for (const double factor : {1e6, -1.0, 1e-9}) {
                const Event other
                    = findEvent(scanned((factor * (values.array() + 3.0)).matrix().eval()));
                QCOMPARE(other.block, plain.block);
                QCOMPARE(other.isSignificant, plain.isSignificant);
            }
        }
    }

    void step_isFoundWhereverItIs()
    {
        for (const double noise : {0.0, 0.02, 0.2}) {
            for (Index event = 400; event < 19600; event += 617) {
                const BlockScan scan = scanned(record(20000, event, noise, step));
                const Event found = findEvent(scan);
                QVERIFY(found.isSignificant);
                const Index place = event / scan.blockSize; // in it, or at the begin of the next
                QVERIFY2(std::abs(found.block - place) <= 1,
                    qPrintable(
                        QString("%1 in block %2, not %3").arg(event).arg(place).arg(found.block)));
            }
        }
    }

    void decay_isAnExcursionWithoutChangeOfLevel()
    {
        const BlockScan scan = scanned(record(40000, 9000, 0.01, ringing));
        const Event found = findEvent(scan);
        QVERIFY(!found.isSignificant);
        QVERIFY(std::abs(found.block - 9000 / scan.blockSize) <= 1);
    }

    void incidentShock_comesBeforeTheReflectedOne()
    {
        const auto side = [](double i) { return i < 3000.0 ? 1.0 : 3.5; }; // 0.4 of the larger
        const BlockScan scan = scanned(record(20000, 5000, 0.02, side));
        QVERIFY(std::abs(findEvent(scan).block - 5000 / scan.blockSize) <= 1);
    }

    void burstHigherThanTheStep_isNotTheEvent()
    {
        Eigen::VectorXd values = record(20000, 12000, 0.01, step);
        for (Index i = 0; i < 40; ++i)
            values[4000 + i] += i % 2 == 0 ? 3.0 : -3.0;
        const BlockScan scan = scanned(values);
        const Event found = findEvent(scan);
        QVERIFY(found.isSignificant);
        QVERIFY(std::abs(found.block - 12000 / scan.blockSize) <= 1);
    }

    void noiseAlone_isNotSignificant()
    {
        for (const double sd : {0.0, 1.0}) {
            const Event found = findEvent(scanned(record(50000, 50000, sd, step)));
            QVERIFY(!found.isSignificant);
        }
    }

    void longRecord_isLookedAtInAboutFourThousandBlocks()
    {
        const BlockScan scan = scanned(record(1000000, 654321, 0.05, step));
        QCOMPARE(scan.blockSize, Index(1000000 / 4096));
        QVERIFY(std::abs(findEvent(scan).block - 654321 / scan.blockSize) <= 1);
        QCOMPARE(scanned(Eigen::VectorXd::Zero(32)).level.size(), Index(2)); // the shortest
    }

    void stopped_isCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const auto scan = scanBlocks(
            testing::doubleChannel(Eigen::VectorXd::Zero(64), kRate_Hz), {source.get_token(), {}});
        QVERIFY(!scan && scan.error().kind == ErrorKind::Cancelled);
    }
};

DYNCAL_TEST(TestEventSearch)
#include "tst_event_search.moc"
