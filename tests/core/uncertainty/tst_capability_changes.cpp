// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The laboratory's least uncertainty under what is asked of a budget: another u, other shots, a
// wanted U.

#include "core/uncertainty/more_shots.h"
#include "core/uncertainty/wanted_u.h"
#include "core/uncertainty/what_if.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// 100 with u = 1 of the temperature, 0.75 of the noise of three shots, and a least U of 4.
ReportedValue held()
{
    ReportedValue reported{"sensitivity", 100.0, "V/Pa",
        {directLine("t1_k", 1.0), with(OverShots::Own, directLine("noise", 0.75))}};
    reported.leastExpanded = 4.0;
    combineLines(reported);
    return reported;
}

double capabilityOf(const ReportedValue &reported)
{
    for (const UncertaintyLine &line : reported.lines)
        if (line.quantity == kCapability)
            return line.contribution;
    return 0.0;
}

} // namespace

class TestCapabilityChanges : public QObject
{
    Q_OBJECT

private slots:
    void smallerInput_isMadeUpFor()
    {
        QVERIFY(isNear(*held().expanded(), 4.0));
        const ReportedValue tried = withChanges(held(), {{"t1_k", 1.0, 0.1}});
        QVERIFY(isNear(*tried.expanded(), 4.0));
        QVERIFY(isNear(capabilityOf(tried), std::sqrt(4.0 - 0.01 - 0.5625)));
    }

    void largerInput_takesItsPlace()
    {
        const ReportedValue tried = withChanges(held(), {{"t1_k", 1.0, 3.0}});
        QVERIFY(isNear(*tried.u, std::hypot(3.0, 0.75)));
        QCOMPARE(capabilityOf(tried), 0.0);
        const ReportedValue back = withChanges(tried, {{"t1_k", 3.0, 1.0}});
        QVERIFY(isNear(*back.expanded(), 4.0));
    }

    void shots_doNotGetBelow()
    {
        for (const Index shots : {1, 3, 12, 1000})
            QVERIFY(*withShots(held(), 3, shots).expanded() >= 4.0 * (1.0 - 1e-12));
        QVERIFY(isNear(*withEndlessShots(held()).expanded(), 4.0));
        const ReportedValue one = withShots(withChanges(held(), {{"noise", 0.75, 3.0}}), 3, 1);
        QVERIFY(isNear(*one.u, std::hypot(1.0, 3.0 * std::sqrt(3.0))));
    }

    void wantedU_belowIt_noInputIsInTheWay()
    {
        const WayToU way = *wayToU(held(), {.relative = 0.03});
        QVERIFY(way.isBelowCapability && !way.isReached);
        QVERIFY(way.inputs.empty());
        QCOMPARE(way.toRemove, 0U);
    }

    void wantedU_aboveIt_inputsAloneAreNamed()
    {
        ReportedValue large = withChanges(held(), {{"t1_k", 1.0, 3.0}});
        const WayToU way = *wayToU(large, {.relative = 0.05});
        QVERIFY(!way.isBelowCapability && !way.isReached);
        QCOMPARE(way.inputs.size(), 2);
        QCOMPARE(way.inputs.front().quantity, "t1_k");
        QVERIFY(isNear(*way.inputs.front().factor, std::sqrt(6.25 - 0.5625) / 3.0));
        QVERIFY(wayToU(held(), {.relative = 0.041})->isReached);
    }

    /// Few readings widen k; the least U holds whatever k is.
    void factor_isPartOfIt_data()
    {
        QTest::addColumn<double>("dof");
        for (const double dof : {2.0, 4.0, 30.0, kInfinite})
            QTest::addRow("%g", dof) << dof;
    }
    void factor_isPartOfIt()
    {
        QFETCH(double, dof);
        ReportedValue reported{"f0_hz", 10.0, "Hz", {directLine("noise", 0.5, dof)}};
        double before = 0.0;
        for (double least = 0.1; least < 20.0; least *= 1.3) {
            reported.leastExpanded = least;
            combineLines(reported);
            QVERIFY(*reported.expanded() >= least * (1.0 - 1e-12));
            QVERIFY(*reported.expanded() >= before * (1.0 - 1e-12)); // never less for more
            QVERIFY(std::ranges::count(
                        reported.lines, std::string(kCapability), &UncertaintyLine::quantity)
                <= 1);
            before = *reported.expanded();
        }
    }
};

DYNCAL_TEST(TestCapabilityChanges)
#include "tst_capability_changes.moc"
