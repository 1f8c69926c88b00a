// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/step_response.h"
#include "tests/support/test_program.h"

#include "core/base/constants.h"
#include "core/synthesis/sensor_defects.h"
#include "core/synthesis/sensor_simulator.h"
#include "tests/core/synthesis/simulated_defect.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

SensorSpec heated(SensorSpec sensor, double share, double tau_s)
{
    sensor.heat = HeatSag{share, tau_s};
    return sensor;
}

/// G(s)/S0 of a mode at a real s.
double modeAt(const SensorMode &mode, double s)
{
    const double omega = kTwoPi * mode.f0_Hz;
    return omega * omega / (s * s + 2.0 * mode.zeta * omega * s + omega * omega);
}

double stepVolts(const ShotTruth &truth)
{
    return truth.at("step_Pa") * truth.at("sensitivity");
}

} // namespace

/// Heat, AC coupling, echo and gains: what the sensor under test makes of the step.
class TestResponseDefects : public QObject
{
    Q_OBJECT

private slots:
    void heat_isTheStepLessARelaxation();
    void heat_late_closedForm();
    void heat_ofARelaxation_partialFractions();
    void heat_withTheRelaxationsTime_stillExact();
    void heat_record_sagsAndIsStated();
    void heat_rangeHoldsARise();
    void ac_record_closedForm();
    void ac_withTheRelaxationsTime_finite();
    void echo_isASuperposition();
    void gain_oneShotOff_truthSaysSo();
    void scatter_drawnPerShotWithItsDeviation();
    void severalAtOnce_isTheProductOfTheirSystems();
    void checkSensor_heat_ranges();
    void riseTime_closedForm();
};

void TestResponseDefects::heat_isTheStepLessARelaxation()
{
    for (const SensorSpec &sensor : sensorPresets()) {
        for (const auto &[share, tau_s] : {std::pair(0.02, 0.5e-3), std::pair(-0.3, 1e-5)}) {
            const StepResponse step(sensor);
            const StepResponse relaxed(sensor, tau_s);
            const StepResponse sagging(heated(sensor, share, tau_s));
            for (double t_s = 1e-8; t_s < 1e-2; t_s *= 1.3)
                QVERIFY(std::abs(sagging.at(t_s) - step.at(t_s) + share * relaxed.at(t_s)) < 1e-12);
        }
    }
}

void TestResponseDefects::heat_late_closedForm()
{
    // The sensor has settled: what is left is the constant and the exponential of the heat, each
    // times the sensor's gain at its rate.
    const SensorSpec piezo = sensorPreset("piezo").value();
    constexpr double kShare = 0.02;
    constexpr double kTau_s = 0.5e-3;
    const StepResponse response(heated(piezo, kShare, kTau_s));
    const double gain = modeAt(piezo.modes[0], -1.0 / kTau_s);
    for (const double t_s : {0.7e-3, 1e-3, 2e-3, 5e-3}) {
        const double expected = 1.0 - kShare + kShare * gain * std::exp(-t_s / kTau_s);
        QVERIFY2(std::abs(response.at(t_s) - expected) < 1e-12,
            qPrintable(QString::number(response.at(t_s) - expected)));
    }
}

void TestResponseDefects::heat_ofARelaxation_partialFractions()
{
    // 1 - exp(-t/b) through 1 - h/(1 + s a): 1 - h - (1 + h b/(a - b)) e^(-t/b) + h a/(a - b)
    // e^(-t/a), the sensor being so fast that it follows.
    const double a = 0.5e-3;
    const double b = 0.3e-3;
    const double h = 0.1;
    const SensorSpec fast{"fast", 1e-6, {{50e6, 0.7, 1.0}}, {}, {}, HeatSag{h, a}};
    const StepResponse response(fast, b);
    for (double t_s = 1e-5; t_s < 5e-3; t_s *= 1.4) {
        const double expected = 1.0 - h - (1.0 + h * b / (a - b)) * std::exp(-t_s / b)
            + h * a / (a - b) * std::exp(-t_s / a);
        QVERIFY2(std::abs(response.at(t_s) - expected) < 3e-5,
            qPrintable(QString::number(response.at(t_s) - expected)));
    }
}

void TestResponseDefects::heat_withTheRelaxationsTime_stillExact()
{
    // A double pole: 1 - exp(-t/a) through the heat of the same a is
    // (1 - h) (1 - e^(-t/a)) + h t/a e^(-t/a).
    const double a = 0.3e-3;
    const double h = 0.1;
    const SensorSpec fast{"fast", 1e-6, {{50e6, 0.7, 1.0}}, {}, {}, HeatSag{h, a}};
    const StepResponse response(fast, a);
    for (double t_s = 1e-5; t_s < 5e-3; t_s *= 1.4) {
        const double fade = std::exp(-t_s / a);
        const double expected = (1.0 - h) * (1.0 - fade) + h * t_s / a * fade;
        QVERIFY2(std::abs(response.at(t_s) - expected) < 5e-5,
            qPrintable(QString::number(response.at(t_s) - expected)));
    }
}

void TestResponseDefects::heat_record_sagsAndIsStated()
{
    const SimulatedCapture capture = simulated(quietWithDefects({"heat=0.05:0.0002@2"}));
    const ShotTruth &truth = capture.truth[1];
    QCOMPARE(truth.at("heat_share"), 0.05);
    QCOMPARE(truth.at("heat_tau_s"), 0.0002);
    QCOMPARE(truth.at("sensitivity"), sensorPreset("piezo")->sensitivity_V_Pa); // at the onset
    QVERIFY(capture.truth[0].count("heat_share") == 0);
    const Channel &dut = channelOf(capture, 1, 0);
    const StepResponse response(heated(sensorPreset("piezo").value(), 0.05, 0.0002));
    // The wave from the contact surface takes 15 % of the step with 0.3 ms, through the same sag.
    const StepResponse relaxed(heated(sensorPreset("piezo").value(), 0.05, 0.0002), 0.3e-3);
    const double worst = worstDeviation(dut, 1.0, [&](double t_s) {
        const double since_s = t_s - truth.at("arrival_s");
        return stepVolts(truth)
            * (response.at(since_s) - 0.15 * relaxed.at(since_s - truth.at("plateau_s")));
    });
    QVERIFY2(worst < 1e-11 * stepVolts(truth) + 0.51 * dut.polynomial[1],
        qPrintable(QString::number(worst)));
    const double end_s = dut.timeOf_s(dut.samples.size());
    const double settled = meanOf(dut, end_s - 0.1e-3, end_s) / stepVolts(truth);
    const double sinceWave_s = end_s - 0.1e-3 - truth.at("arrival_s") - truth.at("plateau_s");
    QVERIFY(std::abs(settled - 0.95 * 0.85) < 0.15 * std::exp(-sinceWave_s / 0.3e-3));
}

void TestResponseDefects::heat_rangeHoldsARise()
{
    const SimulatedCapture capture = simulated(withDefects({"heat=-0.5:1e-4", "echo=0.3"}));
    for (std::size_t s = 0; s < 3; ++s) {
        const Channel &dut = channelOf(capture, s, 0);
        for (Index i = 0; i < dut.samples.size(); ++i)
            QVERIFY(dut.samples.at(i) < *dut.adcMax);
    }
}

void TestResponseDefects::ac_record_closedForm()
{
    const SimulatedCapture capture = simulated(quietWithDefects({"ac"}));
    SensorSpec coupled = sensorPreset("piezo").value();
    coupled.acCoupling_s = 5e-3;
    const double gain = modeAt(coupled.modes[0], -1.0 / 5e-3);
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        QCOMPARE(truth.at("ac_tau_s"), 5e-3);
        const Channel &dut = channelOf(capture, s, 0);
        // Settled: e^(-t/tau) times the mode's gain there.
        const double late_s = truth.at("arrival_s") + 0.9e-3;
        const double begin_s = truth.at("arrival_s") + 0.8e-3;
        const double end_s = truth.at("arrival_s") + truth.at("plateau_s");
        QVERIFY(late_s < end_s);
        const double worst = worstDeviation(dut, late_s, [&](double t_s) {
            if (t_s < begin_s)
                return physicalValue(dut,
                    dut.samples.at(
                        static_cast<Index>(std::llround((t_s - dut.t0_s) * dut.sampleRate_Hz))));
            return stepVolts(truth) * gain * std::exp(-(t_s - truth.at("arrival_s")) / 5e-3);
        });
        QVERIFY2(worst < 1e-10 * stepVolts(truth) + 0.51 * dut.polynomial[1],
            qPrintable(QString::number(worst)));
    }
}

void TestResponseDefects::ac_withTheRelaxationsTime_finite()
{
    // t/a e^(-t/a): a relaxation of the coupling's own time constant.
    const SimulatedCapture capture = simulated(quietWithDefects({"ac=0.0003"}));
    const Channel &dut = channelOf(capture, 0, 0);
    const ShotTruth &truth = capture.truth[0];
    const double from_s = truth.at("arrival_s") + truth.at("plateau_s");
    const double mean = meanOf(dut, from_s + 0.29e-3, from_s + 0.31e-3) / stepVolts(truth);
    const double expected
        = std::exp(-(truth.at("plateau_s") + 0.3e-3) / 0.3e-3) - 0.15 * std::exp(-1.0);
    QVERIFY2(std::abs(mean - expected) < 1e-4, qPrintable(QString::number(mean - expected)));
}

void TestResponseDefects::echo_isASuperposition()
{
    const SimulatedCapture clean = simulated(quietWithDefects({}, "optic1"));
    const SimulatedCapture with = simulated(quietWithDefects({"echo=0.04:0.0002@3"}, "optic1"));
    const ShotTruth &truth = with.truth[2];
    QCOMPARE(truth.at("echo_share"), 0.04);
    QCOMPARE(truth.at("echo_delay_s"), 0.0002);
    const StepResponse step(sensorPreset("optic1").value());
    const Channel &a = channelOf(clean, 2, 0);
    const Channel &b = channelOf(with, 2, 0);
    double worst = 0.0;
    for (Index i = 0; i < a.samples.size(); ++i) {
        const double difference
            = physicalValue(b, b.samples.at(i)) - physicalValue(a, a.samples.at(i));
        const double since_s = a.timeOf_s(i) - truth.at("arrival_s") - 0.0002;
        worst = std::max(worst, std::abs(difference - 0.04 * stepVolts(truth) * step.at(since_s)));
    }
    QVERIFY2(worst < 1e-11 * stepVolts(truth) + 0.51 * (a.polynomial[1] + b.polynomial[1]),
        qPrintable(QString::number(worst)));
    QCOMPARE(truth.at("step_Pa"), clean.truth[2].at("step_Pa"));
    QCOMPARE(*defectOf(withDefects({"echo"}), DefectKind::Echo, 1)->size, 0.03);
}

void TestResponseDefects::gain_oneShotOff_truthSaysSo()
{
    const SimulatedCapture clean = simulated(quietWithDefects({}));
    const SimulatedCapture capture = simulated(quietWithDefects({"gain"}));
    const double nominal = sensorPreset("piezo")->sensitivity_V_Pa;
    QCOMPARE(capture.truth[0].at("sensitivity"), nominal);
    QCOMPARE(capture.truth[1].at("sensitivity"), 1.5 * nominal);
    QCOMPARE(capture.truth[2].at("sensitivity"), nominal);
    const double begin_s = clean.truth[1].at("arrival_s") + 0.5e-3;
    const double ratio = meanOf(channelOf(capture, 1, 0), begin_s, begin_s + 0.5e-3)
        / meanOf(channelOf(clean, 1, 0), begin_s, begin_s + 0.5e-3);
    QVERIFY(std::abs(ratio - 1.5) < 1e-6);
    // The card does not know, nor do the other sensors.
    QCOMPARE(capture.set.sensors, clean.set.sensors);
    QCOMPARE(channelOf(capture, 1, 1).sha256, channelOf(clean, 1, 1).sha256);
    QCOMPARE(capture.truth[1].at("step_Pa"), clean.truth[1].at("step_Pa"));
}

void TestResponseDefects::scatter_drawnPerShotWithItsDeviation()
{
    SimulationSettings settings = smallSettings("piezo");
    settings.shots.assign(100, ShotLevel::Medium);
    settings.defects = {parseDefect("scatter=0.03").value()};
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kSeeds = 20;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        settings.seed = static_cast<std::uint64_t>(seed);
        for (Index shot = 1; shot <= 100; ++shot) {
            const double ratio
                = sensorOfShot(settings, shot).sensitivity_V_Pa / settings.sensor.sensitivity_V_Pa
                - 1.0;
            sum += ratio / 0.03;
            squares += ratio * ratio / 9e-4;
        }
    }
    const double count = 100.0 * kSeeds;
    QVERIFY(std::abs(sum / count) < kSigmas / std::sqrt(count));
    QVERIFY(std::abs(squares / count - 1.0) < kSigmas * std::sqrt(2.0 / count));
    const SimulatedCapture capture = simulated(withDefects({"scatter"}));
    QVERIFY(capture.truth[0].at("sensitivity") != capture.truth[1].at("sensitivity"));
    const SimulationSettings one = withDefects({"scatter@3"});
    QCOMPARE(sensorOfShot(one, 1).sensitivity_V_Pa, one.sensor.sensitivity_V_Pa);
    QVERIFY(sensorOfShot(one, 3).sensitivity_V_Pa != one.sensor.sensitivity_V_Pa);
}

void TestResponseDefects::severalAtOnce_isTheProductOfTheirSystems()
{
    // The settled part of s/(s + 1/a) (1 - h/(1 + s b)): two exponentials.
    const double a = 5e-3;
    const double b = 0.5e-3;
    const double h = 0.02;
    const SensorSpec both{"both", 1e-6, {{50e6, 0.7, 1.0}}, {}, a, HeatSag{h, b}};
    const StepResponse response(both);
    for (double t_s = 1e-5; t_s < 2e-2; t_s *= 1.4) {
        // 1/(s + 1/a) (s + (1 - h)/b)/(s + 1/b) by partial fractions.
        const double first = ((1.0 - h) / b - 1.0 / a) / (1.0 / b - 1.0 / a);
        const double expected = first * modeAt(both.modes[0], -1.0 / a) * std::exp(-t_s / a)
            + (1.0 - first) * modeAt(both.modes[0], -1.0 / b) * std::exp(-t_s / b);
        QVERIFY(std::abs(response.at(t_s) - expected) < 1e-12);
    }
}

void TestResponseDefects::checkSensor_heat_ranges()
{
    const SensorSpec piezo = sensorPreset("piezo").value();
    QVERIFY(checkSensor(heated(piezo, 0.02, 0.5e-3)).has_value());
    for (const auto &[share, tau_s] : {std::pair(0.6, 1e-3), std::pair(-0.6, 1e-3),
             std::pair(std::nan(""), 1e-3), std::pair(0.02, 0.0), std::pair(0.02, -1.0)}) {
        const auto checked = checkSensor(heated(piezo, share, tau_s));
        QVERIFY(!checked.has_value());
        QCOMPARE(checked.error().kind, ErrorKind::Usage);
    }
    SensorSpec coincident = heated(piezo, 0.02, 1e-3);
    coincident.acCoupling_s = 1e-3;
    QVERIFY(!checkSensor(coincident).has_value());
}

void TestResponseDefects::riseTime_closedForm()
{
    // A mode far above a real pole: 1 - e^(-t/tau), whose rise time is tau ln 9.
    const SensorSpec lag{"lag", 1e-6, {{1e8, 0.7, 1.0}}, 1e5, {}};
    QVERIFY(std::abs(riseTime_s(lag) / (std::log(9.0) / (kTwoPi * 1e5)) - 1.0) < 1e-5);
    // 10 and 90 % of 1 - e^(-z x) (cos(q x) + z/q sin(q x)), bisected here.
    const double z = 0.7;
    const double q = std::sqrt(1.0 - z * z);
    const auto passing = [&](double level) {
        double low = 0.0;
        double high = 3.0; // before the overshoot
        for (int i = 0; i < 60; ++i) {
            const double x = 0.5 * (low + high);
            const double value
                = 1.0 - std::exp(-z * x) * (std::cos(q * x) + z / q * std::sin(q * x));
            (value < level ? low : high) = x;
        }
        return low;
    };
    const double expected_s = (passing(0.9) - passing(0.1)) / (kTwoPi * 500e3);
    const SensorSpec side{"side", 1e-6, {{500e3, z, 1.0}}, {}, {}};
    QVERIFY(std::abs(riseTime_s(side) / expected_s - 1.0) < 1e-9);
}

DYNCAL_TEST(TestResponseDefects)
#include "tst_response_defects.moc"
