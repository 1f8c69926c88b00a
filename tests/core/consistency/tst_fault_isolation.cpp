// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/consistency_findings.h"
#include "core/shock/counter_fit.h"
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

void withoutFirstSensor(ShotEvidence &evidence)
{
    evidence.readings.erase(evidence.readings.begin());
    VelocityEstimate &arrivals = evidence.measurement->velocity;
    arrivals.sightings.erase(arrivals.sightings.begin());
    arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::None).value();
    arrivals.velocity_m_s = arrivals.fit->velocity_m_s;
    // As in madeEvidence(): what somebody makes of the DUT's level with that velocity.
    const double before_Pa = *evidence.step_Pa;
    const auto used = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, *arrivals.velocity_m_s).value();
    evidence.step_Pa = used.reflected.pressure_Pa - kMadeP1_Pa;
    *evidence.sensitivity *= before_Pa / *evidence.step_Pa;
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
    void typedInOneShotAlone_isNamed();
    void stepsTypedInAnotherUnit_areTyped();
    void counterThatContradicts_isTyped();
    void typedDelay_isTold_fromTheScales();
    void distance_isNamed_whereOneShotMissesTheSensor();
    void delay_isNamed_besideAShotWithoutArrivals();
    void onlyWhatAFaultMoves_isMarked();
    void nothingCompared_nothingExplains();
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

void TestFaultIsolation::typedInOneShotAlone_isNamed()
{
    auto shots = shotsWith([](MadeShot &) {});
    shots[1].typedVelocity_m_s = 1.08 * shots[1].velocity_m_s;
    QCOMPARE(causesOf(shots).front(), C::Typed);
}

void TestFaultIsolation::stepsTypedInAnotherUnit_areTyped()
{
    std::vector<ShotEvidence> evidence;
    for (const MadeShot &shot : shotsWith([](MadeShot &) {})) {
        evidence.push_back(madeEvidence(shot, std::ssize(evidence) + 1));
        ShotEvidence &made = evidence.back();
        const double inKilopascals = 1e-3 * *made.step_Pa;
        *made.sensitivity *= 1e3;
        made.step_Pa = made.typedStep_Pa = made.measurement->typedStep_Pa = inKilopascals;
    }
    const MadeComparison made(std::move(evidence));
    const auto explained = explanations(*made.compared);
    QCOMPARE(explained.size(), std::size_t(1));
    QCOMPARE(explained[0].cause, C::Typed);
}

void TestFaultIsolation::counterThatContradicts_isTyped()
{
    std::vector<ShotEvidence> evidence;
    for (const MadeShot &shot : shotsWith([](MadeShot &s) { s.velocity_m_s = 500.0; })) {
        evidence.push_back(madeEvidence(shot, std::ssize(evidence) + 1));
        StepMeasurement &m = *evidence.back().measurement;
        m.recorded = m.velocity;
        m.counters = {{.far_m = 0.8,
            .near_m = 0.3,
            .time_s = 1.06 * 0.5 / 500.0,
            .u_distance_m = 2e-4,
            .u_time_s = 1e-7}};
        m.velocity = {};
        m.velocity.fit = fitCounters(m.counters, Attenuation::None, {}).value();
        m.velocity.velocity_m_s = m.velocity.fit->velocity_m_s;
        const auto used
            = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, *m.velocity.velocity_m_s).value();
        const double before_Pa = *evidence.back().step_Pa;
        evidence.back().step_Pa = used.reflected.pressure_Pa - kMadeP1_Pa;
        *evidence.back().sensitivity *= before_Pa / *evidence.back().step_Pa;
    }
    const MadeComparison made(std::move(evidence));
    QCOMPARE(explanations(*made.compared).front().cause, C::Typed);
}

void TestFaultIsolation::typedDelay_isTold_fromTheScales()
{
    for (const bool isTyped : {false, true}) {
        std::vector<ShotEvidence> evidence;
        for (const MadeShot &shot : shotsWith([](MadeShot &s) { s.places_m = {0.8}; })) {
            evidence.push_back(madeEvidence(shot, std::ssize(evidence) + 1));
            VelocityEstimate &arrivals = evidence.back().measurement->velocity;
            // 40 us too much is taken off, of the return passage too.
            arrivals.sightings[0].time_s -= 40e-6;
            evidence.back().readings[0].found->back->time_s -= 40e-6;
            evidence.back().readings[0].isDelayTyped = isTyped;
            arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::None).value();
            arrivals.velocity_m_s = arrivals.fit->velocity_m_s;
            const double before_Pa = *evidence.back().step_Pa;
            const auto used
                = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, *arrivals.velocity_m_s).value();
            evidence.back().step_Pa = used.reflected.pressure_Pa - kMadeP1_Pa;
            *evidence.back().sensitivity *= before_Pa / *evidence.back().step_Pa;
        }
        const MadeComparison made(std::move(evidence));
        const auto explained = explanations(*made.compared);
        QCOMPARE(explained.front().cause == C::Delay, isTyped);
        if (isTyped)
            QVERIFY(explained.front().chiSquare < 10.0); // 40 us are not usual, but possible
    }
}

void TestFaultIsolation::distance_isNamed_whereOneShotMissesTheSensor()
{
    // In the third shot the sensor of the wrong distance saw nothing, so that the first place of
    // that shot is another sensor.
    auto shots = shotsWith([](MadeShot &shot) {
        shot.places_m = {0.8, 0.5, 0.3};
        shot.distanceShift_m = -0.015;
    });
    std::vector<ShotEvidence> evidence;
    for (const MadeShot &shot : shots)
        evidence.push_back(madeEvidence(shot, std::ssize(evidence) + 1));
    withoutFirstSensor(evidence[2]);
    const MadeComparison made(std::move(evidence));
    const auto explained = explanations(*made.compared);
    QCOMPARE(explained.front().cause, C::Distance);
    QVERIFY(explained.front().chiSquare < 1.0); // 15 mm is usual, and nothing else is left
}

void TestFaultIsolation::delay_isNamed_besideAShotWithoutArrivals()
{
    auto shots = shotsWith([](MadeShot &) {});
    std::vector<ShotEvidence> evidence;
    for (const MadeShot &shot : shots)
        evidence.push_back(madeEvidence(shot, std::ssize(evidence) + 1));
    // The side sensors answer 15 us late, and their return passages with them.
    for (std::size_t i = 0; i < 2; ++i) {
        VelocityEstimate &arrivals = evidence[i].measurement->velocity;
        for (std::size_t k = 0; k < 2; ++k) {
            arrivals.sightings[k].time_s += 15e-6;
            evidence[i].readings[k].found->back->time_s += 15e-6;
        }
        arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::None).value();
        arrivals.velocity_m_s = arrivals.fit->velocity_m_s;
    }
    evidence[2] = madeOfTypedStep(kMadeSensitivity_V_Pa, 3);
    const MadeComparison made(std::move(evidence));
    const auto explained = explanations(*made.compared);
    QVERIFY(std::ranges::find(explained, C::Delay, &ExplainedBy::cause) != explained.end());
}

void TestFaultIsolation::onlyWhatAFaultMoves_isMarked()
{
    const MadeComparison made(shotsWith([](MadeShot &shot) { shot.dutGain = 1.5; }));
    const auto explained = explanations(*made.compared);
    QCOMPARE(explained.size(), std::size_t(1));
    const ComparedShots &shots = *made.compared;
    QCOMPARE(explained[0].moves.size(), shots.rows().size());
    for (std::size_t row = 0; row < shots.rows().size(); ++row) {
        const auto [shot, way] = shots.rows()[row];
        QCOMPARE(bool(explained[0].moves[row]),
            shots.ways()[shot]->made()[way].of == Compared::Sensitivity);
    }
}

void TestFaultIsolation::nothingCompared_nothingExplains()
{
    const MadeComparison made(std::vector<ShotEvidence>{});
    QVERIFY(explanations(*made.compared).empty());
}

DYNCAL_TEST(TestFaultIsolation)
#include "tst_fault_isolation.moc"
