// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/consistency.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Shots of these levels and velocities, without any record.
struct Bench
{
    CaptureSet set;
    ShockConditionsSet shock;
    ResponseResult response;

    void add(ShotLevel level, double velocity_m_s)
    {
        const ShotEvidence made = madeEvidence({.velocity_m_s = velocity_m_s});
        Shot shot;
        shot.level = level;
        set.shots.push_back(shot);
        ShockConditions c;
        c.shot = std::ssize(set.shots);
        c.measurement = made.measurement;
        c.step_Pa = made.step_Pa;
        shock.shots.push_back(c);
    }

    ConsistencyResult compared(const ShockSettings &settings = {}) const
    {
        return compareWays(set, settings, shock, response, {});
    }
};

const WayComparison &checkOf(const ConsistencyResult &result, Compared of)
{
    return *std::ranges::find(result.checks, of, &WayComparison::of);
}

} // namespace

class TestConsistency : public QObject
{
    Q_OBJECT

private slots:
    void levels_inOrder_data();
    void levels_inOrder();
    void oneLevel_cannotBeCompared();
    void farthestShot_isAComparison();
    void cardInAnotherUnit_isSaidOnce();
    void disabled_comparesNothing();
};

void TestConsistency::levels_inOrder_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<bool>("agree");
    QTest::newRow("as named") << 420.0 << 512.8 << true;
    QTest::newRow("exchanged") << 512.8 << 420.0 << false;
}

void TestConsistency::levels_inOrder()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(bool, agree);
    Bench bench;
    bench.add(ShotLevel::Low, low);
    bench.add(ShotLevel::Medium, 470.0);
    bench.add(ShotLevel::High, high);
    const ConsistencyResult result = bench.compared();
    QVERIFY(checkOf(result, Compared::Levels).isMade());
    QCOMPARE(checkOf(result, Compared::Levels).agrees(), agree);
    const auto said = std::ranges::find(result.findings, std::string("CHK-004"), &Finding::id);
    QCOMPARE(said != result.findings.end(), !agree);
    if (!agree)
        QCOMPARE(said->causes, std::vector<FindingCause>{FindingCause::Order});
}

void TestConsistency::oneLevel_cannotBeCompared()
{
    Bench bench;
    bench.add(ShotLevel::Low, 420.0);
    bench.add(ShotLevel::None, 512.8);
    const ConsistencyResult result = bench.compared();
    QVERIFY(!checkOf(result, Compared::Levels).isMade());
    QVERIFY(checkOf(result, Compared::Levels).agrees());
    QVERIFY(!checkOf(result, Compared::Shots).isMade());
    QVERIFY(result.findings.empty());
}

void TestConsistency::cardInAnotherUnit_isSaidOnce()
{
    Bench bench;
    Channel dut;
    dut.role = ChannelRole::Dut;
    dut.sensorId = "dut";
    bench.set.sensors["dut"] = {{"sensitivity", "12.5e-9"}, {"sensitivity_unit", "V/Pa"}};
    for (const double velocity : {470.0, 512.8}) {
        bench.add(ShotLevel::None, velocity);
        bench.set.shots.back().channels = {dut};
        ShotSensitivity shot;
        shot.shot = std::ssize(bench.set.shots);
        shot.sensitivity = 12.5e-9;
        shot.uLevel_relative = 1e-3;
        shot.unit = "A/Pa";
        bench.response.shots.push_back(shot);
    }
    const ConsistencyResult other = bench.compared();
    QCOMPARE(std::ranges::count(other.findings, std::string("CHK-006"), &Finding::id), 1);
    QVERIFY(english(other.findings.back().message).find("V/Pa") != std::string::npos);
    QVERIFY(!checkOf(other, Compared::Sensitivity).isMade());
    for (ShotSensitivity &shot : bench.response.shots)
        shot.unit = "V/Pa";
    QVERIFY(bench.compared().findings.empty());
}

void TestConsistency::farthestShot_isAComparison()
{
    Bench bench;
    bench.add(ShotLevel::None, 500.0);
    bench.add(ShotLevel::None, 505.0);
    bench.response.summary.farthest = FarthestShot{2, 12.8e-9, 12.5e-9, 1e-10};
    const ConsistencyResult result = bench.compared();
    const WayComparison &check = checkOf(result, Compared::Shots);
    QCOMPARE(check.shot, Index(2));
    QVERIFY(std::abs(check.e_n() - 1.5) < 1e-9 && check.agrees()); // 3 u
    bench.response.summary.farthest->value = 12.9e-9;
    QVERIFY(!checkOf(bench.compared(), Compared::Shots).agrees()); // 4 u
    QVERIFY(bench.compared().findings.empty()); // RSP-002 says it
}

void TestConsistency::disabled_comparesNothing()
{
    Bench bench;
    bench.add(ShotLevel::Low, 420.0);
    ShockSettings off;
    off.enabled = false;
    QVERIFY(bench.compared(off).checks.empty());
}

DYNCAL_TEST(TestConsistency)
#include "tst_consistency.moc"
