// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/gas_defects.h"
#include "tests/support/test_program.h"

#include "core/shock/moist_air.h"
#include "core/shock/shock_relations.h"
#include "core/synthesis/laboratory.h"
#include "core/synthesis/sensor_defects.h"
#include "tests/core/synthesis/simulated_defect.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kDriven_m = 0.97;

/// The integral of dx/(W (1 + a x)) from 0 to x by Simpson's rule.
double travelBySimpson_s(double velocity_m_s, double attenuation_per_m, double distance_m)
{
    constexpr int kIntervals = 200;
    double sum = 0.0;
    for (int i = 0; i <= kIntervals; ++i) {
        const double weight = i == 0 || i == kIntervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight / (velocity_m_s * (1.0 + attenuation_per_m * distance_m * i / kIntervals));
    }
    return sum * distance_m / kIntervals / 3.0;
}

/// When a channel first passes half of the way between two levels.
double halfPassing_s(const Channel &channel, double from_s, double level)
{
    for (Index i = static_cast<Index>((from_s - channel.t0_s) * channel.sampleRate_Hz);
         i + 1 < channel.samples.size(); ++i) {
        const double a = physicalValue(channel, channel.samples.at(i));
        const double b = physicalValue(channel, channel.samples.at(i + 1));
        if (a < level && b >= level)
            return channel.timeOf_s(i) + (level - a) / (b - a) / channel.sampleRate_Hz;
    }
    return std::nan("");
}

void verifyStatesOf(const Gas &gas, const ShotTruth &truth)
{
    const auto states
        = shockStates(gas, truth.at("p1_Pa"), truth.at("T1_K"), truth.at("velocity_m_s"));
    QVERIFY(
        std::abs(truth.at("step_Pa") / (states->reflected.pressure_Pa - truth.at("p1_Pa")) - 1.0)
        < 1e-12);
    QVERIFY(std::abs(truth.at("p2_Pa") / states->shocked.pressure_Pa - 1.0) < 1e-12);
    QVERIFY(std::abs(truth.at("mach") / states->mach - 1.0) < 1e-12);
    QVERIFY(std::abs(truth.at("a5_m_s") / states->reflected.soundSpeed_m_s - 1.0) < 1e-12);
    QVERIFY(std::abs(truth.at("plateau_s") / plateauTime_s(*states, kDriven_m) - 1.0) < 1e-12);
}

} // namespace

/// Attenuation, late side sensors, other gases and humidity.
class TestWaveDefects : public QObject
{
    Q_OBJECT

private slots:
    void travelTime_isTheIntegral();
    void attenuation_arrivalByTheIntegral_stepOfTheWall();
    void attenuation_sideSensor_showsItsOwnPressure();
    void delay_sideSensorLaterByItsRiseTime();
    void gas_nitrogen_truthAndNotes();
    void gas_mixture_heatCapacitiesAndMassesAddUp();
    void humidity_soundSpeedAsCramersFormulaHasIt();
    void humidity_truthAndNotes();
};

void TestWaveDefects::travelTime_isTheIntegral()
{
    for (const double attenuation : {-0.05, -1e-3, 1e-9, 0.01, 0.05}) {
        for (const double distance_m : {0.05, 0.8, 0.97}) {
            const double expected_s = travelBySimpson_s(470.0, attenuation, distance_m);
            QVERIFY(
                std::abs(travelTime_s(470.0, attenuation, distance_m) / expected_s - 1.0) < 1e-13);
        }
    }
    QCOMPARE(travelTime_s(470.0, 0.0, 0.8), 0.8 / 470.0);
}

void TestWaveDefects::attenuation_arrivalByTheIntegral_stepOfTheWall()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"attenuation=0.02"}));
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        QCOMPARE(truth.at("attenuation_per_m"), 0.02);
        // Velocity and step are those at the end wall, and as without attenuation.
        for (const char *key : {"velocity_m_s", "step_Pa", "p5_Pa", "plateau_s", "distance_m"})
            QCOMPARE(truth.at(key), clean.truth[s].at(key));
        const double travel_s = truth.at("arrival_s") - truth.at("side_arrival_s");
        const double expected_s
            = travelBySimpson_s(truth.at("velocity_m_s"), 0.02, truth.at("distance_m"));
        QVERIFY(std::abs(travel_s / expected_s - 1.0) < 1e-12);
        // The mean velocity, which an operator computes, is too high by about a x / 2.
        const double apparent = truth.at("distance_m") / travel_s / truth.at("velocity_m_s") - 1.0;
        QVERIFY(std::abs(apparent - 0.5 * 0.02 * 0.8) < 1e-4);
    }
}

void TestWaveDefects::attenuation_sideSensor_showsItsOwnPressure()
{
    const SimulatedCapture capture = simulated(quietWithDefects({"attenuation=0.05"}));
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        const auto local = shockStates(Gas{}, truth.at("p1_Pa"), truth.at("T1_K"),
            truth.at("velocity_m_s") * (1.0 + 0.05 * truth.at("distance_m")));
        QVERIFY(std::abs(truth.at("side_p2_Pa") / local->shocked.pressure_Pa - 1.0) < 1e-12);
        const Channel &side = channelOf(capture, s, 1);
        const double begin_s = truth.at("side_arrival_s") + 0.2e-3;
        const double mean_Pa = meanOf(side, begin_s, begin_s + 1e-3);
        const double noise_Pa = 150.0 / std::sqrt(1e-3 * side.sampleRate_Hz);
        QVERIFY(std::abs(mean_Pa - local->shocked.pressure_Pa + truth.at("p1_Pa"))
            < kSigmas * noise_Pa);
        // Behind the reflected shock both are at the end wall's pressure.
        const double after_s
            = truth.at("arrival_s") + truth.at("distance_m") / 300.0 + 0.2e-3; // it is faster
        QVERIFY(
            std::abs(meanOf(side, after_s, after_s + 0.2e-3) / truth.at("step_Pa") - 1.0) < 0.2);
    }
}

void TestWaveDefects::delay_sideSensorLaterByItsRiseTime()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"delay=1.7@1"}));
    const double expected_s = 1.7 * riseTime_s(sideSensor());
    QCOMPARE(capture.truth[0].at("side_delay_s"), expected_s);
    QVERIFY(expected_s > 1e-6 && expected_s < 1.4e-6);
    QVERIFY(capture.truth[1].count("side_delay_s") == 0);
    // The shock passes when it did; only the reading is late.
    QCOMPARE(capture.truth[0].at("side_arrival_s"), clean.truth[0].at("side_arrival_s"));
    const double half_Pa = 0.5 * (capture.truth[0].at("p2_Pa") - capture.truth[0].at("p1_Pa"));
    const double before_s = capture.truth[0].at("side_arrival_s") - 1e-6;
    const double late_s = halfPassing_s(channelOf(capture, 0, 1), before_s, half_Pa)
        - halfPassing_s(channelOf(clean, 0, 1), before_s, half_Pa);
    QVERIFY2(std::abs(late_s - expected_s) < 10e-9, qPrintable(QString::number(late_s)));
    QCOMPARE(channelOf(capture, 0, 0).sha256, channelOf(clean, 0, 0).sha256);
    QCOMPARE(channelOf(capture, 1, 1).sha256, channelOf(clean, 1, 1).sha256);
}

void TestWaveDefects::gas_nitrogen_truthAndNotes()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"gas"}));
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        QCOMPARE(truth.at("nitrogen_share"), 1.0);
        verifyStatesOf(Gas{1.4, 0.028014}, truth);
        QCOMPARE(truth.at("velocity_m_s"), clean.truth[s].at("velocity_m_s"));
        // Table of issue 15: air taken for nitrogen is wrong by 7 to 11 %.
        const double ratio = truth.at("step_Pa") / clean.truth[s].at("step_Pa");
        QVERIFY2(ratio > 0.88 && ratio < 0.94, qPrintable(QString::number(ratio)));
    }
    QCOMPARE(capture.set.tube, clean.set.tube); // air, its gamma and molar mass
    const auto p4_Pa
        = driverPressure_Pa(shockStates(Gas{1.4, 0.028014}, capture.truth[2].at("p1_Pa"),
                                capture.truth[2].at("T1_K"), capture.truth[2].at("velocity_m_s"))
                                .value(),
            Gas{1.4, 0.028014}, Gas{}, 295.35);
    QVERIFY(std::abs(capture.truth[2].at("p4_Pa") - *p4_Pa) <= 50.0 + 1e-6);
    const SimulatedCapture one = simulated(withDefects({"gas=0.5@2"}));
    QCOMPARE(one.truth[0], clean.truth[0]);
    QCOMPARE(channelOf(one, 2, 0).sha256, channelOf(clean, 2, 0).sha256);
    QVERIFY(one.truth[1].at("step_Pa") < clean.truth[1].at("step_Pa"));
}

void TestWaveDefects::gas_mixture_heatCapacitiesAndMassesAddUp()
{
    for (const double share : {0.1, 0.5, 0.9}) {
        SimulationSettings settings = smallSettings();
        settings.defects = {{DefectKind::OtherGas, 0, share}};
        const Gas gas = drivenGasOf(settings, 1, 101100.0, 294.15);
        const double cp = (1.0 - share) * 1.402 / 0.402 + share * 3.5;
        QVERIFY(std::abs(gas.gamma - cp / (cp - 1.0)) < 1e-14);
        const double mass = (1.0 - share) * 0.028966 + share * 0.028014;
        QVERIFY(std::abs(gas.molarMass_kg_mol - mass) < 1e-16);
    }
}

void TestWaveDefects::humidity_soundSpeedAsCramersFormulaHasIt()
{
    // Humid over dry air, by an ideal mixture here and by Cramer's fit to measurements there.
    for (const double humidity : {0.1, 0.5, 1.0}) {
        SimulationSettings settings = smallSettings();
        settings.defects = {{DefectKind::Humidity, 0, humidity}};
        const double here = soundSpeed_m_s(drivenGasOf(settings, 1, 101100.0, 294.15), 294.15)
            / soundSpeed_m_s(Gas{}, 294.15);
        const double there = moistAir(101100.0, 294.15, humidity, 4e-4)->soundSpeed_m_s
            / moistAir(101100.0, 294.15, 0.0, 4e-4)->soundSpeed_m_s;
        QVERIFY2(std::abs(here - there) < 2e-4 * humidity + 1e-6,
            qPrintable(QString("%1 against %2").arg(here).arg(there)));
    }
}

void TestWaveDefects::humidity_truthAndNotes()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"humidity"}));
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        QCOMPARE(truth.at("relative_humidity"), 0.5);
        QCOMPARE(capture.set.shots[s].environment.relativeHumidity, 0.0); // as was recorded
        verifyStatesOf(Gas{truth.at("gamma"), truth.at("molar_mass_kg_mol")}, truth);
        // Issue 15: -0.9 to -1.3 % in the step.
        const double ratio = truth.at("step_Pa") / clean.truth[s].at("step_Pa") - 1.0;
        QVERIFY2(ratio < -0.008 && ratio > -0.014, qPrintable(QString::number(ratio)));
    }
}

DYNCAL_TEST(TestWaveDefects)
#include "tst_wave_defects.moc"
