// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_conditions.h"
#include "core/shock/shock_estimate.h"
#include "core/signal/start_detection.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

// Relative sensitivities of the step p5 - p1 at the thesis point (docs/method/shock.md).
constexpr double kStepPerVelocity = 4.65354;
constexpr double kStepPerT1 = -2.32677;
constexpr double kSideDelay_s = 0.45e-6; ///< of the side sensor's 50 % crossing
/// Taken off an unknown delay: half of 0.85 rise times, which are 0.338396/f0 for zeta 0.7.
constexpr double kTakenOff_s = 0.425 * 0.338396 / 500e3;

SimulationSettings settingsWith(std::uint64_t seed, const std::vector<ShotLevel> &shots)
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.sampleRate_Hz = 20e6;
    settings.duration_s = 0.005;
    settings.seed = seed;
    settings.shots = shots;
    return settings;
}

/// Arrival of every included shot as the start detection sees it.
std::vector<DutArrival> detectedArrivals(const CaptureSet &set)
{
    std::vector<DutArrival> arrivals;
    for (Index i = 0; i < std::ssize(set.shots); ++i) {
        const Channel *dut
            = set.shots[static_cast<std::size_t>(i)].channelWithRole(ChannelRole::Dut);
        const auto start = detectStart(*dut);
        if (start)
            arrivals.push_back({i + 1, start->time_s});
    }
    return arrivals;
}

/// The simulated tube slows no shock down.
ShockSettings withoutAttenuation()
{
    ShockSettings settings;
    settings.attenuation = "none";
    return settings;
}

ShockConditionsSet estimated(const SimulatedCapture &capture)
{
    return estimateShockConditions(capture.set, detectedArrivals(capture.set), withoutAttenuation())
        .value();
}

const std::vector<ShotLevel> kThreeLevels{ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};

} // namespace

/// From simulated records to the pressure step, judged by the truth.
class TestSimulatedShock : public QObject
{
    Q_OBJECT

private slots:
    void threeLevels_stepsWithinTheirUncertainty();
    void knownConditions_onlyTheSensorsDelayIsLeft();
    void manySeeds_errorsSpreadAsTheStatedUncertaintiesSay();
    void swappedShot_blocked_othersDetermined();
    void shotWithoutStep_missing_othersDetermined();
    void noShockData_nothingGuessed();
};

void TestSimulatedShock::threeLevels_stepsWithinTheirUncertainty()
{
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
        const SimulatedCapture capture = simulateShots(settingsWith(seed, kThreeLevels)).value();
        const ShockConditionsSet shock = estimated(capture);
        QCOMPARE(shock.shots.size(), std::size_t(3));
        for (std::size_t s = 0; s < 3; ++s) {
            const ShotTruth &truth = capture.truth[s];
            const ShockConditions &found = shock.shots[s];
            QVERIFY(found.states.has_value());
            // 0.025 % distance and up to 0.03 % delay on W, times 5; T1 0.1 % times 2.4: 4 sigma.
            QVERIFY(std::abs(found.states->velocity_m_s / truth.at("velocity_m_s") - 1.0) < 0.0015);
            QVERIFY(std::abs(*found.step_Pa / truth.at("step_Pa") - 1.0) < 0.013);
            QVERIFY(
                std::abs(*found.arrival_s - truth.at("side_arrival_s") - kSideDelay_s + kTakenOff_s)
                < 5e-8);
            QVERIFY(std::abs(*found.plateau_s / truth.at("plateau_s") - 1.0) < 0.01);
            QVERIFY(std::abs(found.driver->pressure_Pa / truth.at("p4_Pa") - 1.0) < 0.02);
        }
        for (const Finding &finding : shock.findings)
            QCOMPARE(finding.id, std::string("SHK-005"));
    }
}

void TestSimulatedShock::knownConditions_onlyTheSensorsDelayIsLeft()
{
    const SimulatedCapture capture = simulateShots(settingsWith(1, kThreeLevels)).value();
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        ShockSettings settings = withoutAttenuation();
        settings.p1_Pa = truth.at("p1_Pa");
        settings.T1_K = truth.at("T1_K");
        settings.arrivalSensors = {{.channel = "driven_side",
            .distanceToEndWall_m = truth.at("distance_m"),
            .delay_s = 0.0}};
        const std::vector<DutArrival> exact{{static_cast<Index>(s) + 1, truth.at("arrival_s")}};
        const auto shock = estimateShockConditions(capture.set, exact, settings);
        const double travel_s = truth.at("arrival_s") - truth.at("side_arrival_s");
        const double expected = travel_s / (travel_s - kSideDelay_s) - 1.0;
        const double found = shock->shots[s].states->velocity_m_s / truth.at("velocity_m_s") - 1.0;
        // What is left is the crossing between samples of 50 ns, and noise: some nanoseconds.
        QVERIFY2(std::abs(found - expected) * travel_s < 8e-9,
            qPrintable(QString::number((found - expected) * travel_s)));
    }
}

void TestSimulatedShock::manySeeds_errorsSpreadAsTheStatedUncertaintiesSay()
{
    constexpr int kSeeds = 100;
    constexpr double kSigmas = 5.0;
    double sum = 0.0;
    double squares = 0.0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        const SimulatedCapture capture
            = simulateShots(settingsWith(static_cast<std::uint64_t>(seed), {ShotLevel::High}))
                  .value();
        const ShockConditionsSet shock = estimated(capture);
        const double error = *shock.shots[0].step_Pa / capture.truth[0].at("step_Pa") - 1.0;
        sum += error;
        squares += error * error;
    }
    const double mean = sum / kSeeds;
    const double deviation = std::sqrt(squares / kSeeds - mean * mean);
    const double expected
        = std::hypot(kStepPerVelocity * 0.0002 / 0.8, kStepPerT1 * 0.3 / 294.15, 30.0 / 101100.0);
    QVERIFY2(std::abs(deviation / expected - 1.0) < kSigmas / std::sqrt(2.0 * kSeeds),
        qPrintable(QString("%1 against %2").arg(deviation).arg(expected)));
    // Bias: side sensor 0.45 us late, part of it taken off, DUT a sample or so; of 1.56 ms.
    const double bias = kStepPerVelocity * (kSideDelay_s - kTakenOff_s) / (0.8 / 512.8);
    QVERIFY2(std::abs(mean - bias) < kSigmas * expected / std::sqrt(1.0 * kSeeds),
        qPrintable(QString("%1 against %2").arg(mean).arg(bias)));
}

void TestSimulatedShock::swappedShot_blocked_othersDetermined()
{
    SimulationSettings settings = settingsWith(1, kThreeLevels);
    settings.defects = {{DefectKind::Swap, 2}};
    const ShockConditionsSet shock = estimated(simulateShots(settings).value());
    QVERIFY(shock.ofShot(1)->step_Pa.has_value());
    QVERIFY(!shock.ofShot(2)->step_Pa.has_value());
    QVERIFY(shock.ofShot(3)->step_Pa.has_value());
    QCOMPARE(worstSeverity(shock.findings), Severity::Block);
    for (const Finding &finding : shock.findings) {
        if (finding.id == "SHK-001") {
            QCOMPARE(finding.shot, Index(2));
            const std::string text = english(finding.message);
            QVERIFY2(text.find("after 'Driven side'") != std::string::npos, text.c_str());
        }
    }
}

void TestSimulatedShock::shotWithoutStep_missing_othersDetermined()
{
    SimulationSettings settings = settingsWith(1, kThreeLevels);
    settings.defects = {{DefectKind::NoStep, 2}};
    const ShockConditionsSet shock = estimated(simulateShots(settings).value());
    QVERIFY(shock.ofShot(1)->step_Pa.has_value());
    QVERIFY(!shock.ofShot(2)->step_Pa.has_value());
    QVERIFY(std::any_of(shock.findings.begin(), shock.findings.end(),
        [](const Finding &f) { return f.id == "SHK-007" && f.shot == 2; }));
}

void TestSimulatedShock::noShockData_nothingGuessed()
{
    SimulatedCapture capture = simulateShots(settingsWith(1, kThreeLevels)).value();
    capture.set.tube.clear();
    for (Shot &shot : capture.set.shots)
        shot.environment = Environment();
    const ShockConditionsSet shock = estimated(capture);
    for (const ShockConditions &conditions : shock.shots) {
        QVERIFY(!conditions.step_Pa.has_value());
        QVERIFY(!conditions.states.has_value());
        QVERIFY(!conditions.plateau_s.has_value());
    }
    QCOMPARE(shock.findings.size(), std::size_t(3)); // p1, T1, distance: each said once
    for (const Finding &finding : shock.findings) {
        QCOMPARE(finding.id, std::string("SHK-007"));
        QCOMPARE(finding.shot, Index(0));
    }
}

DYNCAL_TEST(TestSimulatedShock)
#include "tst_simulated_shock.moc"
