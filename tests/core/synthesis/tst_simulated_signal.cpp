// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What stands in the records of a simulated shot.

#include "core/shock/shock_relations.h"
#include "core/synthesis/channel_recorder.h"
#include "core/synthesis/shot_generator.h"
#include "core/synthesis/step_response.h"
#include "tests/core/synthesis/simulated_shots.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Mean of the physical values at record times [begin_s, end_s).
double meanBetween(const Channel &channel, double begin_s, double end_s)
{
    const Index begin = static_cast<Index>((begin_s - channel.t0_s) * channel.sampleRate_Hz);
    const Index count = static_cast<Index>((end_s - begin_s) * channel.sampleRate_Hz);
    return physicalValues(channel, begin, count).mean();
}

double deviationBetween(const Channel &channel, double begin_s, double end_s)
{
    const Index begin = static_cast<Index>((begin_s - channel.t0_s) * channel.sampleRate_Hz);
    const Index count = static_cast<Index>((end_s - begin_s) * channel.sampleRate_Hz);
    const Eigen::VectorXd values = physicalValues(channel, begin, count);
    return std::sqrt(
        (values.array() - values.mean()).square().sum() / static_cast<double>(count - 1));
}

/// Sum of squares of the record minus the closed form for an assumed arrival.
double misfit(
    const Channel &channel, const ShotTruth &truth, const StepResponse &response, double arrival_s)
{
    const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
    const Index begin
        = static_cast<Index>((arrival_s - 2e-6 - channel.t0_s) * channel.sampleRate_Hz);
    double sum = 0.0;
    for (Index i = begin; i < begin + 400; ++i) {
        const double expected = step_V * response.at(channel.timeOf_s(i) - arrival_s);
        const double found = physicalValue(channel, channel.samples.at(i));
        sum += (found - expected) * (found - expected);
    }
    return sum;
}

/// Arrival that fits best, by golden section within +-2 samples.
double fittedArrival_s(const Channel &channel, const ShotTruth &truth, const SensorSpec &sensor)
{
    const StepResponse response(sensor);
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    double low = truth.at("arrival_s") - 2.0 / channel.sampleRate_Hz;
    double high = truth.at("arrival_s") + 1.7 / channel.sampleRate_Hz;
    for (int i = 0; i < 60; ++i) {
        const double a = high - ratio * (high - low);
        const double b = low + ratio * (high - low);
        (misfit(channel, truth, response, a) < misfit(channel, truth, response, b) ? high : low)
            = misfit(channel, truth, response, a) < misfit(channel, truth, response, b) ? b : a;
    }
    return 0.5 * (low + high);
}

} // namespace

class TestSimulatedSignal : public QObject
{
    Q_OBJECT

private slots:
    void noiseFree_record_isTheClosedForm_data();
    void noiseFree_record_isTheClosedForm();
    void overshootAndSettledValue_closedForm();
    void arrival_fitted_recoversTruthBelowASample();
    void plateau_ends_visibly();
    void sideChannel_showsBothShocks();
    void driverChannel_fallsFromItsPressure();
    void noise_beforeTheStep_hasTheStatedDeviation();
    void noise_isNormal_andWhite();
    void quantisation_halfToEven_cutAtTheRails();
    void quantisation_bits_chooseIntegers();
};

void TestSimulatedSignal::noiseFree_record_isTheClosedForm_data()
{
    QTest::addColumn<QString>("preset");
    for (const SensorSpec &preset : sensorPresets())
        QTest::newRow(preset.name.c_str()) << QString::fromStdString(preset.name);
}

void TestSimulatedSignal::noiseFree_record_isTheClosedForm()
{
    QFETCH(QString, preset);
    SimulationSettings settings = smallSettings(preset.toUtf8().constData());
    settings.noise = 0.0;
    settings.bits = 28;
    settings.shots = {ShotLevel::High};
    const SimulatedCapture capture = simulated(settings);
    const Channel &dut = capture.set.shots[0].channels[0];
    const ShotTruth &truth = capture.truth[0];
    const double lsb_V = dut.polynomial[1];
    QVERIFY(std::abs(lsb_V - truth.at("input_range_V") / std::exp2(27)) < 1e-20);
    const StepResponse step(settings.sensor);
    const StepResponse relaxed(settings.sensor, 0.3e-3);
    const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
    double worst = 0.0;
    for (Index i = 0; i < dut.samples.size(); ++i) {
        const double sinceStep_s = dut.timeOf_s(i) - truth.at("arrival_s");
        const double expected = step_V
            * (step.at(sinceStep_s) - 0.15 * relaxed.at(sinceStep_s - truth.at("plateau_s")));
        worst = std::max(worst, std::abs(physicalValue(dut, dut.samples.at(i)) - expected));
    }
    // Half a code; the time axis of 6 ms in doubles moves a 3 MHz ringing by 1e-11.
    QVERIFY2(worst < 0.5 * lsb_V + 1e-10 * step_V, qPrintable(QString::number(worst / lsb_V)));
}

void TestSimulatedSignal::overshootAndSettledValue_closedForm()
{
    for (const double zeta : {0.02, 0.05, 0.1, 0.2, 0.4, 0.5, 0.7}) {
        SimulationSettings settings = smallSettings();
        settings.sensor.modes = {{100e3, zeta, 1.0}}; // 200 samples per period
        settings.noise = 0.0;
        settings.bits = 24;
        settings.shots = {ShotLevel::Medium};
        const SimulatedCapture capture = simulated(settings);
        const Channel &dut = capture.set.shots[0].channels[0];
        const ShotTruth &truth = capture.truth[0];
        const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
        const double arrival_s = truth.at("arrival_s");
        const double plateau_s = truth.at("plateau_s");
        const Index begin = static_cast<Index>((arrival_s - dut.t0_s) * dut.sampleRate_Hz);
        const Eigen::VectorXd values = physicalValues(dut, begin, 2000);
        Index peak = 0;
        const double highest = values.maxCoeff(&peak) / step_V - 1.0;
        const double root = std::sqrt(1.0 - zeta * zeta);
        // Between two samples the peak is lower by at most (w dt)^2/8 = 1.2e-4 of the excursion.
        QVERIFY(std::abs(highest - std::exp(-zeta * 3.141592653589793 / root)) < 2.5e-4);
        QVERIFY(std::abs(dut.timeOf_s(begin + peak) - arrival_s - 0.5 / (100e3 * root))
            < 1.01 / dut.sampleRate_Hz);
        const double settled
            = meanBetween(dut, arrival_s + 0.6 * plateau_s, arrival_s + 0.99 * plateau_s) / step_V;
        QVERIFY2(std::abs(settled - 1.0) < 1e-5, qPrintable(QString::number(settled)));
    }
}

void TestSimulatedSignal::arrival_fitted_recoversTruthBelowASample()
{
    SimulationSettings settings = smallSettings("piezo");
    settings.noise = 0.0;
    for (const int bits : {14, 24}) {
        settings.bits = bits;
        const SimulatedCapture capture = simulated(settings);
        for (std::size_t s = 0; s < 3; ++s) {
            const Channel &dut = capture.set.shots[s].channels[0];
            const double found_s = fittedArrival_s(dut, capture.truth[s], settings.sensor);
            const double error = (found_s - capture.truth[s].at("arrival_s")) * dut.sampleRate_Hz;
            // 14 bit: 0.3 codes of 2000..7000 on 400 samples, slope up to 0.1 of the step/sample.
            QVERIFY2(std::abs(error) < (bits == 14 ? 2e-3 : 2e-5),
                qPrintable(QString("%1 samples at %2 bit").arg(error).arg(bits)));
        }
    }
    // And the arrivals do lie between samples.
    const SimulatedCapture capture = simulated(settings);
    const double position
        = (capture.truth[0].at("arrival_s") - capture.set.shots[0].channels[0].t0_s)
        * settings.sampleRate_Hz;
    QVERIFY(std::abs(position - std::round(position)) > 1e-3);
}

void TestSimulatedSignal::plateau_ends_visibly()
{
    SimulationSettings settings = smallSettings();
    const SimulatedCapture capture = simulated(settings);
    for (std::size_t s = 0; s < 3; ++s) {
        const Channel &dut = capture.set.shots[s].channels[0];
        const ShotTruth &truth = capture.truth[s];
        const double step_V = truth.at("step_Pa") * truth.at("sensitivity");
        const double end_s = truth.at("arrival_s") + truth.at("plateau_s");
        QVERIFY(truth.at("plateau_s") > 1.4e-3 && truth.at("plateau_s") < 3.0e-3);
        // A thousand samples of noise 0.2 %: their mean is good to 1e-4.
        QVERIFY(std::abs(meanBetween(dut, end_s - 2e-4, end_s) / step_V - 1.0) < 5e-4);
        const double after = meanBetween(dut, end_s + 2.95e-4, end_s + 3.05e-4) / step_V;
        QVERIFY2(std::abs(after - (1.0 - 0.15 * (1.0 - std::exp(-1.0)))) < 2e-3,
            qPrintable(QString::number(after)));
    }
}

void TestSimulatedSignal::sideChannel_showsBothShocks()
{
    const SimulatedCapture capture = simulated(smallSettings());
    for (std::size_t s = 0; s < 3; ++s) {
        const Channel &side = capture.set.shots[s].channels[1];
        const ShotTruth &truth = capture.truth[s];
        QCOMPARE(side.reference, PressureReference::Gauge);
        const double first_s = truth.at("side_arrival_s");
        QVERIFY(std::abs(first_s) <= 20e-6);
        QVERIFY(std::abs(meanBetween(side, side.t0_s, first_s)) < 20.0);
        const double incident_Pa = truth.at("p2_Pa") - truth.at("p1_Pa");
        QVERIFY(
            std::abs(meanBetween(side, first_s + 1e-5, truth.at("arrival_s")) / incident_Pa - 1.0)
            < 1e-3);
        const auto states
            = shockStates(Gas{}, truth.at("p1_Pa"), truth.at("T1_K"), truth.at("velocity_m_s"));
        const double second_s
            = truth.at("arrival_s") + truth.at("distance_m") / states->reflectedVelocity_m_s;
        QVERIFY(std::abs(meanBetween(side, second_s - 1e-4, second_s) / incident_Pa - 1.0) < 1e-3);
        const double both_Pa = truth.at("step_Pa");
        QVERIFY(
            std::abs(meanBetween(side, second_s + 1e-5, second_s + 1e-4) / both_Pa - 1.0) < 1e-3);
        QVERIFY(std::abs(deviationBetween(side, side.t0_s, first_s) / 150.0 - 1.0) < 0.1);
    }
}

void TestSimulatedSignal::driverChannel_fallsFromItsPressure()
{
    const SimulatedCapture capture = simulated(smallSettings());
    for (std::size_t s = 0; s < 3; ++s) {
        const Channel &driver = capture.set.shots[s].channels[2];
        const ShotTruth &truth = capture.truth[s];
        const double gauge_Pa = truth.at("p4_Pa") - truth.at("p1_Pa");
        QVERIFY(std::abs(meanBetween(driver, driver.t0_s, 0.0) / gauge_Pa - 1.0) < 1e-3);
        double before_Pa = gauge_Pa;
        for (double t_s = 2e-3; t_s < 5e-3; t_s += 1e-3) {
            const double now_Pa = meanBetween(driver, t_s, t_s + 1e-4);
            QVERIFY(now_Pa < before_Pa);
            before_Pa = now_Pa;
        }
        QVERIFY(before_Pa > truth.at("p2_Pa") - truth.at("p1_Pa"));
    }
}

void TestSimulatedSignal::noise_beforeTheStep_hasTheStatedDeviation()
{
    for (const double noise : {0.0005, 0.002, 0.01, 0.2}) {
        SimulationSettings settings = smallSettings();
        settings.noise = noise;
        const SimulatedCapture capture = simulated(settings);
        for (std::size_t s = 0; s < 3; ++s) {
            const Channel &dut = capture.set.shots[s].channels[0];
            const ShotTruth &truth = capture.truth[s];
            const double stated_V = truth.at("noise_sd_V");
            QVERIFY(
                std::abs(stated_V / (noise * truth.at("step_Pa") * truth.at("sensitivity")) - 1.0)
                < 1e-12);
            const double count = (truth.at("arrival_s") - dut.t0_s) * dut.sampleRate_Hz;
            const double lsb_V = dut.polynomial[1];
            const double expected_V = std::sqrt(stated_V * stated_V + lsb_V * lsb_V / 12.0);
            const double found_V = deviationBetween(dut, dut.t0_s, truth.at("arrival_s") - 1e-6);
            QVERIFY2(std::abs(found_V / expected_V - 1.0) < kSigmas / std::sqrt(2.0 * count) + 1e-3,
                qPrintable(QString("%1 of %2").arg(found_V).arg(expected_V)));
        }
    }
}

void TestSimulatedSignal::noise_isNormal_andWhite()
{
    SimulationSettings settings = smallSettings();
    settings.noise = 0.05; // far above a code
    const SimulatedCapture capture = simulated(settings);
    const Channel &dut = capture.set.shots[2].channels[0];
    const Index count = 40000;
    Eigen::VectorXd values = physicalValues(dut, 0, count);
    values /= capture.truth[2].at("noise_sd_V");
    const double n = static_cast<double>(count);
    QVERIFY(std::abs(values.mean()) < kSigmas / std::sqrt(n));
    QVERIFY(std::abs(values.array().cube().mean()) < kSigmas * std::sqrt(15.0 / n));
    QVERIFY(std::abs(values.array().pow(4).mean() - 3.0) < kSigmas * std::sqrt(96.0 / n));
    for (const Index lag : {1, 2, 10, 1000}) {
        const double correlation = values.head(count - lag).dot(values.tail(count - lag)) / n;
        QVERIFY(std::abs(correlation) < kSigmas / std::sqrt(n));
    }
}

void TestSimulatedSignal::quantisation_halfToEven_cutAtTheRails()
{
    // 1 mV per code: 8 bits over +-128 mV. The plan is a constant, so every sample shows it.
    const Digitizer digitizer{8, 0.128};
    const std::pair<double, double> pairs[] = {{0.0, 0.0}, {0.4999e-3, 0.0}, {0.5e-3, 0.0},
        {0.5001e-3, 1.0}, {1.5e-3, 2.0}, {2.5e-3, 2.0}, {-0.5e-3, 0.0}, {-1.5e-3, -2.0},
        {-2.5e-3, -2.0}, {0.1269, 127.0}, {0.5, 127.0}, {-0.1281, -128.0}, {-5.0, -128.0}};
    for (const auto &[volts, expected] : pairs) {
        SignalPlan plan;
        plan.sensor = {"unit", 1.0, {{1e6, 0.7, 1.0}}, {}, {}};
        plan.initial_Pa = volts;
        const auto channel
            = recordChannel(plan, {0.0, 1e6, 5}, digitizer, RandomStream(1, 1, 1), {});
        QVERIFY(channel.has_value());
        QCOMPARE(channel->samples.size(), Index(5));
        for (Index i = 0; i < 5; ++i)
            QCOMPARE(channel->samples.at(i), expected);
    }
}

void TestSimulatedSignal::quantisation_bits_chooseIntegers()
{
    for (const int bits : {8, 14, 16, 17, 24, 28}) {
        SimulationSettings settings = smallSettings();
        settings.bits = bits;
        settings.shots = {ShotLevel::Low};
        const SimulatedCapture capture = simulated(settings);
        const Channel &dut = capture.set.shots[0].channels[0];
        QCOMPARE(dut.samples.type() == SampleType::Int16, bits <= 16);
        QCOMPARE(*dut.adcMin, -std::exp2(bits - 1));
        QCOMPARE(*dut.adcMax, std::exp2(bits - 1) - 1.0);
        QVERIFY(std::abs(dut.polynomial[1] * std::exp2(bits)
                        / (2.0 * capture.truth[0].at("input_range_V"))
                    - 1.0)
            < 1e-12);
    }
}

DYNCAL_TEST(TestSimulatedSignal)
#include "tst_simulated_signal.moc"
