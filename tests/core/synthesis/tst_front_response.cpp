// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/front_response.h"
#include "tests/support/test_program.h"

#include "core/base/constants.h"
#include "core/synthesis/sensor_simulator.h"
#include "tests/core/synthesis/simulated_defect.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Ringing, damped, overdamped, of third order, AC coupled, heated.
std::vector<SensorSpec> assortment()
{
    std::vector<SensorSpec> sensors = sensorPresets();
    sensors.push_back({"overdamped", 1e-6, {{400e3, 3.0, 1.0}}, {}, {}});
    sensors.push_back({"coupled", 1e-6, {{318e3, 0.02, 1.0}}, {}, 5e-3});
    sensors.push_back({"heated", 1e-6, {{318e3, 0.02, 1.0}}, {}, {}, HeatSag{0.02, 0.5e-3}});
    return sensors;
}

/// The mean of the response over a ramp's time, by Simpson's rule between the kink and the end.
double rampBySimpson(const StepResponse &response, double time_s, double duration_s)
{
    constexpr int kIntervals = 4000;
    const double begin_s = std::max(0.0, time_s - 0.5 * duration_s);
    const double end_s = std::max(0.0, time_s + 0.5 * duration_s);
    const double width_s = (end_s - begin_s) / kIntervals;
    double sum = 0.0;
    for (int i = 0; i <= kIntervals; ++i) {
        const double weight = i == 0 || i == kIntervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * response.at(begin_s + i * width_s);
    }
    return sum * width_s / 3.0 / duration_s;
}

/// The convolution with 2/pi sqrt(1 - x^2) by the midpoint rule in the angle: an error of some
/// 1e-9, as the response has a kink in it.
double tiltByMidpoints(const StepResponse &response, double time_s, double duration_s)
{
    constexpr int kPoints = 40000;
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double theta = std::numbers::pi * (i + 0.5) / kPoints;
        sum += std::sin(theta) * std::sin(theta)
            * response.at(time_s + 0.5 * duration_s * std::cos(theta));
    }
    return 2.0 * sum / kPoints;
}

} // namespace

/// A step that needs time to come: the convolution with the growth of its front.
class TestFrontResponse : public QObject
{
    Q_OBJECT

private slots:
    void ramp_isTheMeanOverItsTime();
    void ramp_slopeIsTheDifferenceOfTwoSteps();
    void tilt_isTheConvolutionWithTheDisc();
    void tilt_ofASlowSensor_lastsAsItsSecondMomentSays();
    void tilt_settled_besselFunction();
    void fronts_short_areSteps();
    void withoutFront_theResponseItself();
    void addTo_agreesWithAt();
    void tiltDuration_closedForm();
    void record_withRamp_isTheClosedForm();
    void record_withTilt_durationFromVelocity();
};

void TestFrontResponse::ramp_isTheMeanOverItsTime()
{
    for (const SensorSpec &sensor : assortment()) {
        const StepResponse response(sensor);
        for (const double duration_s : {20e-9, 200e-9, 5e-6}) {
            const FrontResponse ramp(response, Front{Front::Kind::Ramp, duration_s});
            for (double t = -0.6; t < 3.0; t += 0.13) {
                const double expected = rampBySimpson(response, t * duration_s, duration_s);
                const double found = ramp.at(t * duration_s);
                QVERIFY2(std::abs(found - expected) < 1e-9,
                    qPrintable(QString("%1 at %2: %3")
                                   .arg(sensor.name.c_str())
                                   .arg(t)
                                   .arg(found - expected)));
            }
        }
    }
}

void TestFrontResponse::ramp_slopeIsTheDifferenceOfTwoSteps()
{
    const double duration_s = 200e-9;
    const double half_s = 0.5 * duration_s;
    for (const SensorSpec &sensor : assortment()) {
        const StepResponse step(sensor);
        const FrontResponse ramp(step, Front{Front::Kind::Ramp, duration_s});
        const double omega = kTwoPi * sensor.modes.front().f0_Hz;
        const double apart_s = 1e-4 / omega;
        for (double t_s = 1.1 * half_s; t_s < 3e-6; t_s *= 1.2) {
            const double slope = (ramp.at(t_s + apart_s) - ramp.at(t_s - apart_s)) / (2 * apart_s);
            const double expected = (step.at(t_s + half_s) - step.at(t_s - half_s)) / duration_s;
            QVERIFY(std::abs(slope - expected) < 1e-6 * omega);
        }
    }
}

void TestFrontResponse::tilt_isTheConvolutionWithTheDisc()
{
    for (const SensorSpec &sensor : assortment()) {
        const StepResponse response(sensor);
        for (const double duration_s : {190e-9, 2e-6}) {
            const FrontResponse tilt(response, Front{Front::Kind::Tilt, duration_s});
            for (double t = -0.6; t < 2.0; t += 0.21) {
                const double expected = tiltByMidpoints(response, t * duration_s, duration_s);
                const double found = tilt.at(t * duration_s);
                QVERIFY2(std::abs(found - expected) < 1e-8,
                    qPrintable(QString("%1 at %2: %3")
                                   .arg(sensor.name.c_str())
                                   .arg(t)
                                   .arg(found - expected)));
            }
        }
    }
}

void TestFrontResponse::tilt_ofASlowSensor_lastsAsItsSecondMomentSays()
{
    // A pole s multiplies the settled part by the transform of the growth; for |s| T << 1 that is
    // 1 + s^2 T^2/32 (second moment of the semicircle: T^2/16) after the middle.
    const SensorSpec sensor{"slow", 1e-6, {{20e3, 0.5, 1.0}}, {}, {}};
    const double duration_s = 1e-6;
    const StepResponse step(sensor);
    const FrontResponse tilt(step, Front{Front::Kind::Tilt, duration_s});
    const double omega = kTwoPi * 20e3;
    for (double t_s = 5e-6; t_s < 1e-4; t_s *= 1.5) {
        const double apart_s = 2e-7;
        const double second = (step.at(t_s + apart_s) - 2.0 * step.at(t_s) + step.at(t_s - apart_s))
            / (apart_s * apart_s);
        const double expected = step.at(t_s) + duration_s * duration_s / 32.0 * second;
        QVERIFY(std::abs(tilt.at(t_s) - expected) < 0.01 * std::pow(omega * duration_s, 2) / 32.0);
    }
}

void TestFrontResponse::tilt_settled_besselFunction()
{
    // The transform of the semicircle is 2 I1(x)/x with x = s T/2, real for a real pole. What is
    // left of a real pole far below the mode is 1 - g e^(-w t), g = the mode's gain at -w.
    for (const double corner_Hz : {1e3, 250e3}) {
        const SensorSpec lag{"lag", 1e-6, {{1e8, 0.7, 1.0}}, corner_Hz, {}};
        const double w = kTwoPi * corner_Hz;
        const double ratio = corner_Hz / 1e8;
        const double gain = 1.0 / (1.0 - 1.4 * ratio + ratio * ratio);
        for (const double duration_s : {190e-9, 2e-6, 10e-6}) {
            const FrontResponse tilt(StepResponse{lag}, Front{Front::Kind::Tilt, duration_s});
            const double x = 0.5 * w * duration_s;
            const double transform = 2.0 * std::cyl_bessel_i(1.0, x) / x;
            for (double after_s = 0.1e-6; after_s < 5e-6; after_s *= 2.0) {
                const double t_s = 0.5 * duration_s + after_s;
                const double expected = 1.0 - gain * transform * std::exp(-w * t_s);
                QVERIFY2(std::abs(tilt.at(t_s) - expected) < 1e-12,
                    qPrintable(QString::number(tilt.at(t_s) - expected)));
            }
        }
    }
}

void TestFrontResponse::fronts_short_areSteps()
{
    for (const Front::Kind kind : {Front::Kind::Ramp, Front::Kind::Tilt}) {
        for (const SensorSpec &sensor : assortment()) {
            const StepResponse step(sensor);
            const FrontResponse front(step, Front{kind, 1e-12});
            for (double t_s = 1e-9; t_s < 1e-3; t_s *= 1.7)
                QVERIFY(std::abs(front.at(t_s) - step.at(t_s)) < 1e-9);
        }
    }
}

void TestFrontResponse::withoutFront_theResponseItself()
{
    const StepResponse step(sensorPresets()[0]);
    const FrontResponse same(step, {});
    std::vector<double> expected(5000, 0.5);
    std::vector<double> found = expected;
    step.addTo(expected, -1.3e-5, 20e6, 3.0);
    same.addTo(found, -1.3e-5, 20e6, 3.0);
    QCOMPARE(found, expected);
    QCOMPARE(same.at(1e-6), step.at(1e-6));
    QCOMPARE(same.at(-1e-9), 0.0);
}

void TestFrontResponse::addTo_agreesWithAt()
{
    constexpr double kRate_Hz = 100e6;
    for (const Front::Kind kind : {Front::Kind::Ramp, Front::Kind::Tilt}) {
        for (const double duration_s : {3e-9, 190e-9, 1e-6}) {
            const StepResponse step(sensorPresets()[3]);
            const FrontResponse front(step, Front{kind, duration_s});
            for (const double first_s : {-2.00001e-6, -2e-6, -0.1e-6, 0.05e-6, 3e-6}) {
                std::vector<double> values(3000, 0.25);
                front.addTo(values, first_s, kRate_Hz, -2.0);
                for (std::size_t i = 0; i < values.size(); ++i) {
                    const double t_s = first_s + static_cast<double>(i) / kRate_Hz;
                    QVERIFY(std::abs(values[i] - 0.25 + 2.0 * front.at(t_s)) < 5e-12);
                }
            }
        }
    }
}

void TestFrontResponse::tiltDuration_closedForm()
{
    QVERIFY(std::abs(tiltDuration_s(30.0, 0.01, 500.0) - 1e-5) < 1e-19);
    QVERIFY(std::abs(tiltDuration_s(1.0, 5.5e-3, 512.8) / 187.2e-9 - 1.0) < 1e-3);
}

void TestFrontResponse::record_withRamp_isTheClosedForm()
{
    const SimulatedCapture capture = simulated(quietWithDefects({"front=1e-6"}));
    const StepResponse step(sensorPreset("piezo").value());
    for (std::size_t s = 0; s < 3; ++s) {
        const ShotTruth &truth = capture.truth[s];
        QCOMPARE(truth.at("front_s"), 1e-6);
        const Channel &dut = channelOf(capture, s, 0);
        const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
        const double end_s = truth.at("arrival_s") + 50e-6;
        const double worst = worstDeviation(dut, end_s, [&](double t_s) {
            return t_s < truth.at("arrival_s") - 2e-6
                ? 0.0
                : step_V * rampBySimpson(step, t_s - truth.at("arrival_s"), 1e-6);
        });
        QVERIFY2(worst < 1e-8 * step_V + dut.polynomial[1], qPrintable(QString::number(worst)));
    }
}

void TestFrontResponse::record_withTilt_durationFromVelocity()
{
    const SimulatedCapture capture = simulated(quietWithDefects({"tilt=2@1", "front@1"}));
    const ShotTruth &truth = capture.truth[0];
    QCOMPARE(truth.at("tilt_deg"), 2.0); // a tilt counts where both are asked for
    const double duration_s = truth.at("front_s");
    const double expected_s = 5.5e-3 * std::sin(std::numbers::pi / 90.0) / truth.at("velocity_m_s");
    QVERIFY(std::abs(duration_s / expected_s - 1.0) < 1e-12);
    QVERIFY(capture.truth[1].count("front_s") == 0);
    const StepResponse step(sensorPreset("piezo").value());
    const Channel &dut = channelOf(capture, 0, 0);
    const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
    const double begin_s = truth.at("arrival_s") - 1e-6;
    const double worst = worstDeviation(dut, truth.at("arrival_s") + 10e-6, [&](double t_s) {
        return t_s < begin_s
            ? 0.0
            : step_V * tiltByMidpoints(step, t_s - truth.at("arrival_s"), duration_s);
    });
    QVERIFY2(worst < 1e-7 * step_V + dut.polynomial[1], qPrintable(QString::number(worst)));
}

DYNCAL_TEST(TestFrontResponse)
#include "tst_front_response.moc"
