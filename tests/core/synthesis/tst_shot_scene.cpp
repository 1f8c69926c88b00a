// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_scene.h"
#include "tests/support/test_program.h"

#include "core/shock/shock_relations.h"
#include "tests/core/synthesis/simulated_shots.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

class TestShotScene : public QObject
{
    Q_OBJECT

private slots:
    void truth_obeysTheShockRelations();
    void truth_levels_haveTheirMachNumbers();
    void scenes_distributions_asDocumented();
    void scenes_triggerJitter_uniform();
};

void TestShotScene::truth_obeysTheShockRelations()
{
    constexpr double kRounding = 1e-12;
    for (const ShotTruth &truth : simulated(smallSettings()).truth) {
        const auto states
            = shockStates(Gas{}, truth.at("p1_Pa"), truth.at("T1_K"), truth.at("velocity_m_s"));
        QVERIFY(states.has_value());
        const auto close = [](double a, double b) { return std::abs(a / b - 1.0) < kRounding; };
        QVERIFY(close(truth.at("p2_Pa"), states->shocked.pressure_Pa));
        QVERIFY(close(truth.at("p5_Pa"), states->reflected.pressure_Pa));
        QVERIFY(close(truth.at("step_Pa"), states->reflected.pressure_Pa - truth.at("p1_Pa")));
        QVERIFY(close(truth.at("mach"), states->mach));
        QVERIFY(close(truth.at("plateau_s"), plateauTime_s(*states, 0.97)));
        QVERIFY(close(truth.at("arrival_s") - truth.at("side_arrival_s"),
            truth.at("distance_m") / truth.at("velocity_m_s")));
        const auto p4_Pa = driverPressure_Pa(*states, Gas{}, Gas{}, 295.35);
        QVERIFY(std::abs(truth.at("p4_Pa") - *p4_Pa) <= 50.0 + 1e-6); // in steps of 100 Pa
    }
}

void TestShotScene::truth_levels_haveTheirMachNumbers()
{
    const double expected[] = {1.25, 1.37, 1.49};
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        SimulationSettings settings = smallSettings();
        settings.seed = seed;
        const auto scenes = drawScenes(settings);
        for (std::size_t i = 0; i < 3; ++i) // spread 0.3 % of W, and T1
            QVERIFY(std::abs((*scenes)[i].states.mach - expected[i]) < kSigmas * 0.003 * 1.5);
    }
}

void TestShotScene::scenes_distributions_asDocumented()
{
    constexpr int kSeeds = 2000;
    SimulationSettings settings = smallSettings();
    settings.shots = {ShotLevel::High};
    double squares[4] = {};
    double sums[4] = {};
    for (int seed = 0; seed < kSeeds; ++seed) {
        settings.seed = static_cast<std::uint64_t>(seed);
        const ShotScene scene = drawScenes(settings)->at(0);
        const double deviations[4] = {(scene.distance_m - 0.8) / 0.2e-3,
            (scene.states.driven.temperature_K - 294.15) / 0.3,
            (scene.states.driven.pressure_Pa - 101100.0) / 30.0,
            (scene.states.velocity_m_s / 512.8 - 1.0) / 0.003};
        for (int i = 0; i < 4; ++i) {
            sums[i] += deviations[i];
            squares[i] += deviations[i] * deviations[i];
        }
    }
    for (int i = 0; i < 4; ++i) {
        QVERIFY(std::abs(sums[i] / kSeeds) < kSigmas / std::sqrt(1.0 * kSeeds));
        QVERIFY(std::abs(squares[i] / kSeeds - 1.0) < kSigmas * std::sqrt(2.0 / kSeeds));
    }
}

void TestShotScene::scenes_triggerJitter_uniform()
{
    SimulationSettings settings = smallSettings();
    settings.shots.assign(100, ShotLevel::Low);
    double lowest_s = 1.0;
    double highest_s = -1.0;
    const auto scenes = drawScenes(settings);
    for (const ShotScene &scene : *scenes) {
        lowest_s = std::min(lowest_s, scene.sideArrival_s);
        highest_s = std::max(highest_s, scene.sideArrival_s);
        QCOMPARE(scene.distance_m, scenes->front().distance_m); // one tube, one day
    }
    QVERIFY(lowest_s >= -20e-6 && lowest_s < -15e-6);
    QVERIFY(highest_s <= 20e-6 && highest_s > 15e-6);
}

DYNCAL_TEST(TestShotScene)
#include "tst_shot_scene.moc"
