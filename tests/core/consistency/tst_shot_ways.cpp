// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const WayComparison *checkOf(
    const MadeComparison &made, Compared of, Way a, const std::string &channel = {})
{
    const auto &list = made.compared->comparisons();
    const auto found = std::ranges::find_if(list, [&](const WayComparison &check) {
        return check.of == of && check.a == a && (channel.empty() || check.channel == channel);
    });
    return found != list.end() ? &*found : nullptr;
}

} // namespace

class TestShotWays : public QObject
{
    Q_OBJECT

private slots:
    void idealTube_allWaysAgreeExactly();
    void everyComparison_isThere();
    void missingReadings_sayWhy();
    void differences_scatterAsTheirU();
    void errorsThatBothWaysShare_cancel();
};

void TestShotWays::idealTube_allWaysAgreeExactly()
{
    const MadeComparison made(std::vector<MadeShot>{{}, {.velocity_m_s = 430.0}});
    int count = 0;
    for (const WayComparison &check : made.compared->comparisons()) {
        if (!check.isMade()) { // no driver pressure is recorded
            QCOMPARE(check.of, Compared::P4);
            continue;
        }
        QVERIFY(std::abs(check.value_a / check.value_b - 1.0) < 1e-8);
        QVERIFY(check.u > 0.0 && check.agrees());
        ++count;
    }
    // Per shot: two arrivals, four Mach numbers, two p2, two p5, the card.
    QCOMPARE(count, 2 * 11);
}

void TestShotWays::everyComparison_isThere()
{
    const MadeComparison made(std::vector<MadeShot>{{.typedVelocity_m_s = 512.0}});
    const WayComparison *typed = checkOf(made, Compared::Velocity, Way::Typed);
    QVERIFY(typed && typed->isMade());
    QCOMPARE(typed->value_a, 512.0);
    QVERIFY(std::abs(typed->value_b - kMadeVelocity_m_s) < 1e-6);
    // u of a typed velocity is assumed: 0.2 %, beside that of the arrivals.
    QVERIFY(typed->u > 0.002 * 512.0 && typed->u < 0.003 * 512.0);
    const WayComparison *mach = checkOf(made, Compared::Mach, Way::VelocityRatio, "side 1");
    QVERIFY(mach && std::abs(mach->value_a / mach->value_b - kMadeVelocity_m_s / 512.0) < 1e-4);
}

void TestShotWays::missingReadings_sayWhy()
{
    ShotEvidence evidence = madeEvidence({.places_m = {0.8}, .card = {}});
    evidence.readings[0].found->back.reset();
    evidence.readings[0].pascals.reset();
    const std::vector<StatedUncertainty> stated;
    const ShotWays ways(evidence, stated);
    QVERIFY(ways.made().empty());
    // Arrival, two Mach numbers, the pressure, driver and card.
    QCOMPARE(ways.missing().size(), std::size_t(6));
    for (const WayComparison &check : ways.missing())
        QVERIFY(check.missing && !english(*check.missing).empty());
}

void TestShotWays::differences_scatterAsTheirU()
{
    // All inputs drawn from their own u: the differences have a standard deviation of u.
    const MadeComparison made(std::vector<MadeShot>(1));
    const ShotWays &ways = *made.ways[0];
    const auto &comparisons = made.compared->comparisons();
    constexpr int kDraws = 400;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(std::ssize(ways.made()));
    for (int draw = 0; draw < kDraws; ++draw) {
        RandomStream random(20261125, draw, 3);
        Eigen::VectorXd x(std::ssize(ways.inputs()));
        for (Index i = 0; i < x.size(); ++i) {
            const UncertainInput &input = ways.inputs()[static_cast<std::size_t>(i)];
            x[i] = input.value + input.u * random.nextNormal();
        }
        const auto values = ways.values(ways.at(x)).value();
        for (Index i = 0; i < squares.size(); ++i) {
            const double z
                = (values[2 * i] - values[2 * i + 1]) / comparisons[static_cast<std::size_t>(i)].u;
            squares[i] += z * z / kDraws;
        }
    }
    // Chi square of 400 over 400: standard deviation 0.071.
    for (const double square : squares)
        QVERIFY(std::abs(square - 1.0) < 0.3);
}

void TestShotWays::errorsThatBothWaysShare_cancel()
{
    // T1 moves both ways to M hardly: the ratio does not depend on it, a1 does. But p1 moves
    // neither, and both pressure rises by the same share.
    ShotEvidence evidence = madeEvidence({});
    evidence.measurement->u_p1_Pa = 5000.0;
    const std::vector<StatedUncertainty> stated;
    std::vector<std::unique_ptr<ShotWays>> ways;
    ways.push_back(std::make_unique<ShotWays>(evidence, stated));
    const ComparedShots uncertain(ways);
    const MadeComparison certain(std::vector<MadeShot>(1));
    for (std::size_t i = 0; i < uncertain.comparisons().size(); ++i) {
        const WayComparison &check = uncertain.comparisons()[i];
        if (!check.isMade())
            continue;
        const double ratio = check.u / certain.compared->comparisons()[i].u;
        if (check.of == Compared::Mach || check.of == Compared::Arrival)
            QVERIFY(std::abs(ratio - 1.0) < 1e-6);
        else
            QVERIFY(ratio > 3.0);
    }
}

DYNCAL_TEST(TestShotWays)
#include "tst_shot_ways.moc"
