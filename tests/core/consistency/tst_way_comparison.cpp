// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/way_comparison.h"

#include "core/base/portable_random.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

WayComparison between(double a, double b, double u)
{
    return {.value_a = a, .value_b = b, .u = u};
}

/// Share of comparisons that contradict where one way is `fault` off and the difference scatters
/// normally by u = 0.3.
double shareOfContradictions(double fault, int draws, Index stream)
{
    RandomStream random(20261125, 0, stream);
    int contradictions = 0;
    for (int i = 0; i < draws; ++i)
        if (!between(40.0 + fault + 0.3 * random.nextNormal(), 40.0, 0.3).agrees())
            ++contradictions;
    return static_cast<double>(contradictions) / draws;
}

/// Four standard deviations of a share p seen in n draws.
double fourDeviations(double p, int n)
{
    return 4.0 * std::sqrt(p * (1.0 - p) / n);
}

} // namespace

class TestWayComparison : public QObject
{
    Q_OBJECT

private slots:
    void limits_followFromU();
    void agreement_endsAtTheLimit_inBothDirections();
    void faultOfTheSmallestDetectableSize_isFoundInNineOfTen();
    void nothingWrong_contradictsAsRarelyAsStated();
    void unitOfTheValues_changesNothing();
    void notANumber_isNoAgreement();
    void exactWays_mustBeEqual();
    void missingComparison_contradictsNothing();
    void levels_areJudgedByTheirOrderAlone();
    void wordsOfTheResults_stayAsTheyAre();
};

void TestWayComparison::limits_followFromU()
{
    const WayComparison check = between(103.6, 100.0, 1.0);
    QVERIFY(std::abs(check.difference() - 3.6) < 1e-12);
    QVERIFY(std::abs(check.e_n() - 1.8) < 1e-12); // U = 2 u
    QVERIFY(std::abs(check.smallestDetectable() - 4.8816) < 1e-12);
    QVERIFY(std::abs(between(100.0, 103.6, 1.0).e_n() + 1.8) < 1e-12);
}

void TestWayComparison::agreement_endsAtTheLimit_inBothDirections()
{
    // Powers of two, so that the differences are exact.
    const double limit = kContradiction * 0.25;
    for (const double sign : {-1.0, 1.0}) {
        QVERIFY(between(sign * limit, 0.0, 0.25).agrees());
        QVERIFY(!between(sign * std::nextafter(limit, 2.0), 0.0, 0.25).agrees());
        QVERIFY(between(0.0, sign * limit, 0.25).agrees());
    }
}

void TestWayComparison::faultOfTheSmallestDetectableSize_isFoundInNineOfTen()
{
    constexpr int kDraws = 40000;
    const double size = between(0.0, 0.0, 0.3).smallestDetectable();
    const double tolerance = fourDeviations(0.9, kDraws);
    QVERIFY(std::abs(shareOfContradictions(size, kDraws, 1) - 0.9) < tolerance);
    QVERIFY(std::abs(shareOfContradictions(-size, kDraws, 2) - 0.9) < tolerance);
}

void TestWayComparison::nothingWrong_contradictsAsRarelyAsStated()
{
    constexpr int kDraws = 1000000;
    const double chance = std::erfc(kContradiction / std::numbers::sqrt2);
    QVERIFY(std::abs(1.0 / chance - 3000.0) < 200.0); // "1 of 3000"
    QVERIFY(
        std::abs(shareOfContradictions(0.0, kDraws, 3) - chance) < fourDeviations(chance, kDraws));
}

void TestWayComparison::unitOfTheValues_changesNothing()
{
    for (const double difference : {3.5, 3.7, -5.0}) {
        const WayComparison pascals = between(1e5 + 100.0 * difference, 1e5, 100.0);
        const WayComparison bars = between(1.0 + 1e-3 * difference, 1.0, 1e-3);
        QCOMPARE(pascals.agrees(), bars.agrees());
        QVERIFY(std::abs(pascals.e_n() - bars.e_n()) < 1e-9);
    }
}

void TestWayComparison::notANumber_isNoAgreement()
{
    // Whoever forgets a value must not be told that all is well.
    QVERIFY(!between(kUnknown, 1.0, 1.0).agrees());
    QVERIFY(!between(1.0, kUnknown, 1.0).agrees());
    QVERIFY(!between(1.0, 1.0, kUnknown).agrees());
    QVERIFY(!WayComparison{}.agrees());
    QVERIFY(std::isnan(WayComparison{}.e_n()) && std::isnan(WayComparison{}.smallestDetectable()));
}

void TestWayComparison::exactWays_mustBeEqual()
{
    QVERIFY(between(2.0, 2.0, 0.0).agrees());
    QVERIFY(!between(std::nextafter(2.0, 3.0), 2.0, 0.0).agrees());
}

void TestWayComparison::missingComparison_contradictsNothing()
{
    WayComparison check = between(1e9, 0.0, 1.0);
    check.missing = Message{"no reading", {}};
    QVERIFY(!check.isMade() && check.agrees());
    check.of = Compared::Levels;
    check.isInOrder = false;
    QVERIFY(check.agrees());
}

void TestWayComparison::levels_areJudgedByTheirOrderAlone()
{
    WayComparison check = between(1e9, 0.0, 1.0);
    check.of = Compared::Levels;
    QVERIFY(check.agrees());
    check = {.of = Compared::Levels, .isInOrder = false};
    QVERIFY(check.isMade() && !check.agrees());
}

void TestWayComparison::wordsOfTheResults_stayAsTheyAre()
{
    // results.json, protocols and scripts are read by these.
    const QStringList quantities{"velocity", "arrival", "mach", "p2 rise", "p5 rise", "p4", "step",
        "sensitivity", "shots", "levels"};
    for (int i = 0; i <= static_cast<int>(Compared::Levels); ++i)
        QCOMPARE(QString(comparedName(static_cast<Compared>(i))), quantities.value(i));
    const QStringList ways{"typed", "counters", "arrivals", "this arrival", "other arrivals",
        "velocity over speed of sound", "ratio of steps", "ratio of velocities", "side sensor",
        "computed", "recorded", "sensor card", "this calibration", "one shot", "other shots",
        "names", "steps"};
    for (int i = 0; i <= static_cast<int>(Way::Steps); ++i)
        QCOMPARE(QString(wayName(static_cast<Way>(i))), ways.value(i));
    QCOMPARE(QString(comparedName(Compared::P4)), QString("p4"));
    QCOMPARE(QString(wayName(Way::Card)), QString("sensor card"));
}

DYNCAL_TEST(TestWayComparison)
#include "tst_way_comparison.moc"
