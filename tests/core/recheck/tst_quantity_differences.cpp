// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/quantity_differences.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

QuantityPair quantity(const char *of, double issued, double u, double k, double now)
{
    return {of, {}, "Hz", issued, u, k, now};
}

QuantityDifference only(const QuantityPair &pair)
{
    const QuantityDifferences found = quantityDifferences({pair});
    return found.list.size() == 1 ? found.list.front() : QuantityDifference();
}

std::string orderOf(const std::vector<QuantityPair> &pairs)
{
    std::string names;
    for (const QuantityDifference &one : quantityDifferences(pairs).list)
        names += one.pair.of;
    return names;
}

} // namespace

class TestQuantityDifferences : public QObject
{
    Q_OBJECT

private slots:
    void difference_isOverTheExpandedUAsIssued()
    {
        const QuantityDifference found = only(quantity("a", 100.0, 2.0, 2.5, 92.5));
        QVERIFY(found.fate == QuantityFate::Compared);
        QCOMPARE(found.U, 5.0);
        QCOMPARE(found.k, 2.5);
        QVERIFY(!found.isKAssumed);
        QVERIFY(isNear(found.overU, 1.5));
        QVERIFY(found.isOverU());
        QVERIFY(!only(quantity("a", 100.0, 2.0, 2.5, 95.0)).isOverU()); // exactly U
    }

    void sameValue_isADifferenceOfZero()
    {
        const double value = 0.1 + 0.2;
        QCOMPARE(only(quantity("a", value, 1e-300, 2.0, value)).overU, 0.0);
    }

    void kOfTwo_isAssumedWhereNoneIsStated()
    {
        for (const double k : {kUnknown, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
            const QuantityDifference found = only(quantity("a", 1.0, 0.5, k, 4.0));
            QVERIFY(found.isKAssumed);
            QCOMPARE(found.k, 2.0);
            QVERIFY(isNear(found.overU, 3.0));
        }
    }

    void angle_isComparedOnTheNearestTurn_data()
    {
        QTest::addColumn<double>("issued");
        QTest::addColumn<double>("now");
        QTest::addColumn<double>("difference");
        const double pi = std::numbers::pi;
        QTest::newRow("a turn") << 0.3 << 0.3 + 2.0 * pi << 0.0;
        QTest::newRow("across the cut") << 3.1 << -3.1 << 2.0 * pi - 6.2;
        QTest::newRow("half a turn") << 0.0 << pi << pi;
        QTest::newRow("small") << -0.2 << -0.1 << 0.1;
    }
    void angle_isComparedOnTheNearestTurn()
    {
        QFETCH(double, issued);
        QFETCH(double, now);
        QFETCH(double, difference);
        QuantityPair pair = quantity("phase", issued, 0.5, 2.0, now);
        QVERIFY(isNear(only(pair).overU, std::abs(now - issued)));
        pair.isAngle = true;
        QVERIFY(std::abs(only(pair).overU - difference) < 1e-12);
    }

    void valueThatIsGoneOrNew_isNoNumber()
    {
        const QuantityDifference gone = only(quantity("a", 1.0, 0.5, 2.0, kUnknown));
        QVERIFY(gone.fate == QuantityFate::Withdrawn);
        QVERIFY(std::isnan(gone.overU) && !gone.isOverU());
        QCOMPARE(gone.U, 1.0);
        const QuantityDifference fresh = only(quantity("a", kUnknown, kUnknown, kUnknown, 1.0));
        QVERIFY(fresh.fate == QuantityFate::StatedNow);
        QVERIFY(std::isnan(fresh.U) && std::isnan(fresh.overU));
    }

    void valueWithoutU_thatIsGone_isTold()
    {
        const QuantityDifference gone = only(quantity("a", 1.0, kUnknown, 2.0, kUnknown));
        QVERIFY(gone.fate == QuantityFate::Withdrawn);
        QVERIFY(std::isnan(gone.U) && std::isnan(gone.k) && !gone.isKAssumed);
    }

    /// The numbers of two units say nothing of each other.
    void otherUnit_isADifference_withUOrWithout()
    {
        for (const double u : {0.1, 0.0, kUnknown}) {
            QuantityPair pair = quantity("a", 1.0, u, 2.0, 1.0);
            pair.unitNow = "kHz";
            const QuantityDifference found = only(pair);
            QVERIFY(found.fate == QuantityFate::UnitChanged && found.isGone());
            QVERIFY(std::isnan(found.overU) && !found.isOverU());
            pair.unitNow = pair.unit;
            QVERIFY(!only(pair).isGone());
        }
        QuantityPair gone = quantity("a", 1.0, 0.1, 2.0, kUnknown);
        gone.unitNow = "kHz";
        QVERIFY(only(gone).fate == QuantityFate::Withdrawn);
    }

    /// What is stated as exact then and now, as a typed step is, may not differ at all.
    void valuesWithoutError_differByAnything()
    {
        QuantityPair pair = quantity("a", 1.0, 0.0, 2.0, std::nextafter(1.0, 2.0));
        pair.uNow = 0.0;
        const QuantityDifference found = only(pair);
        QVERIFY(found.fate == QuantityFate::Compared && found.isOverU());
        QCOMPARE(found.U, 0.0);
        QVERIFY(std::isinf(found.overU));
        pair.now = 1.0;
        QCOMPARE(only(pair).overU, 0.0);
        pair.uNow = 0.1; // now it has an error: not the same claim
        pair.now = 5.0;
        QCOMPARE(quantityDifferences({pair}).withoutU, 1);
    }

    void whatCannotBeCompared_isCounted()
    {
        const QuantityDifferences found
            = quantityDifferences({quantity("no u", 1.0, kUnknown, 2.0, 5.0),
                quantity("u of 0", 1.0, 0.0, 2.0, 5.0), quantity("negative u", 1.0, -1.0, 2.0, 5.0),
                quantity("infinite u", 1.0, std::numeric_limits<double>::infinity(), 2.0, 5.0),
                quantity("never known", kUnknown, kUnknown, kUnknown, kUnknown)});
        QVERIFY(found.list.empty());
        QCOMPARE(found.withoutU, 4);
        QCOMPARE(found.compared(), 0);
        QCOMPARE(found.largestWithinU(), 0.0);
    }

    void order_isWithdrawn_worstFirst_statedNow()
    {
        QCOMPARE(orderOf({quantity("n", kUnknown, kUnknown, kUnknown, 1.0),
                     quantity("1", 0.0, 1.0, 1.0, 1.0), quantity("0", 0.0, 1.0, 1.0, 0.0),
                     quantity("3", 0.0, 1.0, 1.0, -3.0), quantity("w", 0.0, 1.0, 1.0, kUnknown),
                     quantity("2", 0.0, 1.0, 1.0, 2.0)}),
            std::string("w3210n"));
        QuantityPair other = quantity("u", 0.0, 1.0, 1.0, 0.0);
        other.unitNow = "kHz";
        QCOMPARE(orderOf({quantity("9", 0.0, 1.0, 1.0, 9.0), other,
                     quantity("w", 0.0, 1.0, 1.0, kUnknown)}),
            std::string("wu9"));
        QCOMPARE(orderOf({quantity("b", 0.0, 1.0, 1.0, 1.0), quantity("a", 0.0, 1.0, 1.0, 1.0)}),
            std::string("ba"));
    }

    void summary_countsAndNamesTheLargestWithinU()
    {
        const QuantityDifferences found = quantityDifferences(
            {quantity("a", 0.0, 1.0, 1.0, 0.4), quantity("b", 0.0, 1.0, 1.0, -0.7),
                quantity("c", 0.0, 1.0, 1.0, 30.0), quantity("d", 0.0, 1.0, 1.0, kUnknown)});
        QCOMPARE(found.compared(), 3);
        QVERIFY(isNear(found.largestWithinU(), 0.7));
    }

    /// Neither the order of the quantities nor their units matter.
    void ratio_hasNoUnit()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> draw(0.1, 10.0);
        for (int i = 0; i < 200; ++i) {
            const double issued = draw(random), u = draw(random), k = draw(random),
                         now = draw(random),
                         scale = std::pow(10.0, 6.0 - 12.0 * draw(random) / 10.0);
            const double ratio = only(quantity("a", issued, u, k, now)).overU;
            QVERIFY(isNear(ratio, std::abs(now - issued) / (k * u)));
            QVERIFY(std::abs(only(quantity("a", issued * scale, u * scale, k, now * scale)).overU
                        - ratio)
                <= 1e-9 * (1.0 + ratio));
        }
    }
};

DYNCAL_TEST(TestQuantityDifferences)
#include "tst_quantity_differences.moc"
