// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/core/synthesis/simulated_defect.h"
#include "tests/support/test_program.h"

#include "core/base/number_text.h"
#include "core/synthesis/channel_recorder.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/step_response.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Records and truth are those of a clean run: only what was noted may differ.
void verifyOnlyNotesDiffer(const SimulatedCapture &capture, const SimulatedCapture &clean)
{
    QVERIFY(haveSameCounts(capture, clean));
    for (std::size_t s = 0; s < capture.truth.size(); ++s) {
        for (const auto &[key, value] : clean.truth[s])
            QCOMPARE(capture.truth[s].at(key), value);
    }
}

} // namespace

/// What is noted wrongly, and what the recorder gets wrong: rate, clock, scale and converter.
class TestNotedDefects : public QObject
{
    Q_OBJECT

private slots:
    void distance_notedShort_truthStays();
    void temperature_notedWrong_truthStays();
    void pressure_notedWrong_truthStays();
    void rate_statedTwiceTheTrueOne();
    void scale_statedThousandTimes();
    void levels_namedForEachOther();
    void clock_samplesAtTheTrueTimes();
    void clock_withRate_statedTimesTheNominal();
    void bow_inTheMiddleOfTheRange();
    void bow_record_shiftsTheBaseline();
    void nan_withAWrongRate_inTheSameSamples();
};

void TestNotedDefects::distance_notedShort_truthStays()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"distance"}));
    verifyOnlyNotesDiffer(capture, clean);
    QCOMPARE(capture.set.tube.at("endflange_to_sensor2_m"), std::string("0.785"));
    QCOMPARE(capture.set.tube.at("u_endflange_to_sensor2_m"), std::string("2e-04"));
    QCOMPARE(capture.truth[2].at("noted_distance_error_m"), -0.015);
    const SimulatedCapture far = simulated(withDefects({"distance=0.0123"}));
    QCOMPARE(far.set.tube.at("endflange_to_sensor2_m"), std::string("0.8123"));
}

void TestNotedDefects::temperature_notedWrong_truthStays()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"temperature@2"}));
    verifyOnlyNotesDiffer(capture, clean);
    QCOMPARE(capture.set.shots[0].environment.T1_K, 294.15);
    QCOMPARE(capture.set.shots[1].environment.T1_K, 304.15);
    QCOMPARE(capture.set.shots[1].environment.u_T1_K, 0.3);
    QCOMPARE(capture.set.shots[1].environment.T4_K, 295.35);
    QCOMPARE(capture.truth[1].at("noted_T1_error_K"), 10.0);
}

void TestNotedDefects::pressure_notedWrong_truthStays()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"pressure=-0.05"}));
    verifyOnlyNotesDiffer(capture, clean);
    for (const Shot &shot : capture.set.shots) {
        QVERIFY(std::abs(shot.environment.p1_Pa - 0.95 * 101100.0) < 1e-9);
        QCOMPARE(shot.environment.ambientPressure_Pa, shot.environment.p1_Pa);
        QCOMPARE(shot.environment.u_p1_Pa, 30.0);
    }
    QCOMPARE(capture.truth[0].at("noted_p1_relative_error"), -0.05);
}

void TestNotedDefects::rate_statedTwiceTheTrueOne()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"rate@3"}));
    verifyOnlyNotesDiffer(capture, clean);
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel &wrong = channelOf(capture, 2, c);
        const Channel &right = channelOf(clean, 2, c);
        QCOMPARE(wrong.sampleRate_Hz, 2.0 * right.sampleRate_Hz);
        QCOMPARE(wrong.t0_s, 0.5 * right.t0_s);
        QCOMPARE(channelOf(capture, 1, c).sampleRate_Hz, right.sampleRate_Hz);
    }
    QCOMPARE(capture.truth[2].at("true_sample_rate_Hz"), 20e6);
    QVERIFY(capture.truth[0].count("true_sample_rate_Hz") == 0);
}

void TestNotedDefects::scale_statedThousandTimes()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"scale"}));
    verifyOnlyNotesDiffer(capture, clean);
    for (std::size_t s = 0; s < 3; ++s) {
        QCOMPARE(
            channelOf(capture, s, 0).polynomial[1], 1000.0 * channelOf(clean, s, 0).polynomial[1]);
        QCOMPARE(channelOf(capture, s, 0).unit, std::string("V"));
        QCOMPARE(channelOf(capture, s, 1).polynomial, channelOf(clean, s, 1).polynomial);
        QCOMPARE(capture.truth[s].at("scale_factor"), 1000.0);
    }
    QCOMPARE(capture.set.sensors, clean.set.sensors);
}

void TestNotedDefects::levels_namedForEachOther()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"levels@1"}));
    verifyOnlyNotesDiffer(capture, clean);
    QCOMPARE(capture.set.shots[0].level, ShotLevel::Medium);
    QCOMPARE(capture.set.shots[0].label, std::string("Medium"));
    QCOMPARE(capture.set.shots[1].level, ShotLevel::Low);
    QCOMPARE(capture.set.shots[2].level, ShotLevel::High);
    QCOMPARE(capture.truth[0].at("true_level"), 1.0);
    QCOMPARE(capture.truth[1].at("true_level"), 2.0);
    QVERIFY(capture.truth[2].count("true_level") == 0);
    SimulationSettings settings = withDefects({"levels"});
    QCOMPARE(notedLevels(settings),
        (std::vector<ShotLevel>{ShotLevel::Low, ShotLevel::High, ShotLevel::Medium}));
    settings.shots = {ShotLevel::Low, ShotLevel::High, ShotLevel::High};
    QCOMPARE(notedLevels(settings), // behind the last comes the first again
        (std::vector<ShotLevel>{ShotLevel::High, ShotLevel::Low, ShotLevel::High}));
}

void TestNotedDefects::clock_samplesAtTheTrueTimes()
{
    constexpr double kError = 1e-3;
    const SimulatedCapture capture = simulated(quietWithDefects({"clock=0.001"}, "optic1"));
    const StepResponse step(sensorPreset("optic1").value());
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        const Channel &dut = channelOf(capture, s, 0);
        QCOMPARE(dut.sampleRate_Hz, 20e6); // as stated
        QVERIFY(std::abs(dut.t0_s + 0.6e-3) < 1e-15);
        QVERIFY(std::abs(truth.at("true_sample_rate_Hz") / (20e6 * (1.0 + kError)) - 1.0) < 1e-15);
        const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
        const double end_s = truth.at("arrival_s") + truth.at("plateau_s");
        const double worst = worstDeviation(dut, end_s, [&](double stated_s) {
            return step_V * step.at(stated_s / (1.0 + kError) - truth.at("arrival_s"));
        });
        // Times agree to rounding of the axis, some 1e-18 s; the step's slope is 2e6 of it per s.
        QVERIFY2(worst < 1e-11 * step_V + 0.51 * dut.polynomial[1],
            qPrintable(QString::number(worst / step_V)));
    }
}

void TestNotedDefects::clock_withRate_statedTimesTheNominal()
{
    const SimulatedCapture capture = simulated(withDefects({"clock", "rate=0.5"}));
    QCOMPARE(channelOf(capture, 0, 0).sampleRate_Hz, 10e6);
    QCOMPARE(capture.truth[0].at("true_sample_rate_Hz"), 20e6 * (1.0 + 100e-6));
}

void TestNotedDefects::bow_inTheMiddleOfTheRange()
{
    const Digitizer straight{14, 5.0};
    const Digitizer bowed{14, 5.0, 8.0};
    for (double x = -1.0; x <= 1.0; x += 0.125) {
        const double extra = bowed.position(5.0 * x) - straight.position(5.0 * x);
        QVERIFY(std::abs(extra - 8.0 * (1.0 - x * x)) < 1e-9);
    }
    QCOMPARE(bowed.position(6.0), straight.position(6.0));
    SignalPlan plan;
    plan.sensor = {"unit", 1.0, {{1e6, 0.7, 1.0}}, {}, {}};
    plan.initial_Pa = 2.5; // volts: half of the range, where three quarters of the bow are left
    const auto channel = recordChannel(plan, {0.0, 1e6, 5}, bowed, RandomStream(1, 1, 1), {});
    QCOMPARE(channel->samples.at(0), 4096.0 + 6.0);
}

void TestNotedDefects::bow_record_shiftsTheBaseline()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    const SimulatedCapture capture = simulated(withDefects({"bow@2"}));
    QCOMPARE(capture.truth[1].at("bow_codes"), 4.0);
    const Channel &dut = channelOf(capture, 1, 0);
    const double shift_V = meanOf(dut, -0.5e-3, 0.0) - meanOf(channelOf(clean, 1, 0), -0.5e-3, 0.0);
    QVERIFY(std::abs(shift_V / dut.polynomial[1] - 4.0) < 0.05); // the same noise, rounded anew
    QCOMPARE(channelOf(capture, 1, 1).sha256, channelOf(clean, 1, 1).sha256);
}

void TestNotedDefects::nan_withAWrongRate_inTheSameSamples()
{
    const SimulatedCapture right = simulated(withDefects({"nan@2"}));
    const SimulatedCapture wrong = simulated(withDefects({"nan@2", "rate=4@2"}));
    const Channel &a = channelOf(right, 1, 0);
    const Channel &b = channelOf(wrong, 1, 0);
    for (Index i = 0; i < a.samples.size(); ++i)
        QCOMPARE(std::isnan(b.samples.at(i)), std::isnan(a.samples.at(i)));
}

DYNCAL_TEST(TestNotedDefects)
#include "tst_noted_defects.moc"
