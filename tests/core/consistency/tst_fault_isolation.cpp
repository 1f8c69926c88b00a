// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/consistency_findings.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using C = FindingCause;

/// Three shots of one fault.
std::vector<MadeShot> shotsWith(const std::function<void(MadeShot &)> &fault)
{
    std::vector<MadeShot> shots;
    for (const double velocity : {420.0, 470.0, 512.8}) {
        MadeShot shot;
        shot.velocity_m_s = velocity;
        fault(shot);
        shots.push_back(shot);
    }
    return shots;
}

std::vector<C> causesOf(const std::vector<MadeShot> &shots)
{
    const MadeComparison made(shots);
    std::vector<C> causes;
    for (const ExplainedBy &explained : explanations(*made.compared))
        causes.push_back(explained.cause);
    return causes;
}

bool has(const std::vector<C> &causes, C cause)
{
    return std::ranges::find(causes, cause) != causes.end();
}

Findings findingsOf(const std::vector<MadeShot> &shots, const ShockSettings &settings = {})
{
    const MadeComparison made(shots);
    return judgeConsistency(*made.compared, made.compared->comparisons(), settings);
}

} // namespace

class TestFaultIsolation : public QObject
{
    Q_OBJECT

private slots:
    void nothingWrong_noFinding();
    void rateDoubled_rateIsNamed_andNotPressure();
    void temperature_isNamed_besideWhatActsAlike();
    void pressure_isTold_fromTheScales();
    void scaleOfTheDut_isAlone();
    void gainOfTheSideSensors_isAlone();
    void distanceOfOneOfTwo_isNamed();
    void oneVelocityForAll_isTyped_andBlocks();
    void severalFindings_oneOfEachQuantityAndShot();
};

void TestFaultIsolation::nothingWrong_noFinding()
{
    QVERIFY(findingsOf(shotsWith([](MadeShot &) {})).empty());
}

void TestFaultIsolation::rateDoubled_rateIsNamed_andNotPressure()
{
    const auto causes = causesOf(shotsWith([](MadeShot &shot) { shot.timeFactor = 0.5; }));
    QVERIFY(has(causes, C::Rate));
    QVERIFY(!has(causes, C::Pressure) && !has(causes, C::Scale) && !has(causes, C::Temperature));
    QVERIFY(!has(causes, C::Distance)); // of one sensor of two: the other one says no
}

void TestFaultIsolation::temperature_isNamed_besideWhatActsAlike()
{
    const auto causes = causesOf(shotsWith([](MadeShot &shot) { shot.trueT1_K += 12.0; }));
    QVERIFY(has(causes, C::Temperature));
    QVERIFY(has(causes, C::Gas) || has(causes, C::Rate));
    QVERIFY(!has(causes, C::Pressure) && !has(causes, C::Scale));
}

void TestFaultIsolation::pressure_isTold_fromTheScales()
{
    const auto causes = causesOf(shotsWith([](MadeShot &shot) { shot.trueP1_Pa *= 1.1; }));
    QCOMPARE(causes.front(), C::Pressure);
    QVERIFY(!has(causes, C::Scale) && !has(causes, C::Rate));
}

void TestFaultIsolation::scaleOfTheDut_isAlone()
{
    QCOMPARE(causesOf(shotsWith([](MadeShot &shot) { shot.dutGain = 1000.0; })),
        std::vector<C>{C::Scale});
}

void TestFaultIsolation::gainOfTheSideSensors_isAlone()
{
    QCOMPARE(
        causesOf(shotsWith([](MadeShot &shot) { shot.sideGain = 1.2; })), std::vector<C>{C::Scale});
}

void TestFaultIsolation::distanceOfOneOfTwo_isNamed()
{
    const auto causes = causesOf(shotsWith([](MadeShot &shot) { shot.distanceShift_m = -0.015; }));
    QCOMPARE(causes.front(), C::Distance);
    QVERIFY(!has(causes, C::Rate) && !has(causes, C::Gas));
}

void TestFaultIsolation::oneVelocityForAll_isTyped_andBlocks()
{
    const auto shots = shotsWith([](MadeShot &shot) { shot.typedVelocity_m_s = 512.8; });
    QCOMPARE(causesOf(shots).front(), C::Typed);
    ShockSettings settings;
    settings.velocity_m_s = 512.8;
    const Findings once = findingsOf(shots, settings);
    const auto blocks = std::ranges::count_if(once, [](const Finding &finding) {
        return finding.id == "CHK-002" && finding.severity == Severity::Block;
    });
    QCOMPARE(blocks, 2); // the first two shots; the third is right
    settings.velocity_m_s = PerShot({512.8, 512.8, 512.8});
    for (const Finding &finding : findingsOf(shots, settings))
        QVERIFY(finding.severity == Severity::Caution);
}

void TestFaultIsolation::severalFindings_oneOfEachQuantityAndShot()
{
    const Findings findings = findingsOf(shotsWith([](MadeShot &shot) { shot.timeFactor = 0.8; }));
    for (const Finding &one : findings) {
        QCOMPARE(std::ranges::count_if(findings,
                     [&](const Finding &f) { return f.id == one.id && f.shot == one.shot; }),
            1);
        QVERIFY(!one.causes.empty() && one.shot > 0);
    }
    QCOMPARE(std::ranges::count(findings, std::string("CHK-001"), &Finding::id), 3);
}

DYNCAL_TEST(TestFaultIsolation)
#include "tst_fault_isolation.moc"
