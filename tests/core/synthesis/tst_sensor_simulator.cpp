// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/synthesis/sensor_simulator.h"
#include "tests/support/sensor_truth.h"
#include "tests/support/test_program.h"

#include "core/base/number_text.h"
#include "core/synthesis/step_response.h"

#include <QFile>
#include <QtTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

SensorSpec single(double f0_Hz, double zeta)
{
    return {"test", 1e-6, {{f0_Hz, zeta, 1.0}}, {}, {}};
}

/// S(f) out of the sampled step response: the transform of the differences, and the factor that
/// turns a sampled step into a step (the remaining error is aliasing).
std::complex<double> responseByTransform(
    const std::vector<double> &step, double rate_Hz, double frequency_Hz)
{
    const double angle = kTwoPi * frequency_Hz / rate_Hz;
    std::complex<double> sum(0.0, 0.0);
    for (std::size_t n = 1; n < step.size(); ++n)
        sum += (step[n] - step[n - 1]) * std::polar(1.0, -angle * static_cast<double>(n));
    const std::complex<double> j(0.0, 1.0);
    return sum * j * angle / (1.0 - std::exp(-j * angle));
}

std::vector<double> sampledStep(const SensorSpec &sensor, double rate_Hz, Index count)
{
    std::vector<double> values(static_cast<std::size_t>(count), 0.0);
    StepResponse(sensor).addTo(values, 0.0, rate_Hz, 1.0);
    return values;
}

/// Sensors of every kind that a specification can describe.
std::vector<SensorSpec> assortment()
{
    std::vector<SensorSpec> sensors = sensorPresets();
    sensors.push_back({"two modes", 1e-6, {{1e6, 0.05, 0.7}, {2.2e6, 0.01, 0.3}}, {}, {}});
    sensors.push_back({"overdamped", 1e-6, {{1e6, 1.7, 1.0}}, {}, {}});
    sensors.push_back({"critical", 1e-6, {{1e6, 1.0, 1.0}}, {}, {}});
    sensors.push_back({"ac coupled", 1e-6, {{1e6, 0.05, 1.0}}, {}, 1e-4});
    sensors.push_back({"everything", 1e-6, {{1e6, 0.05, 1.2}, {3e6, 0.3, -0.2}}, 4e5, 2e-4});
    return sensors;
}

} // namespace

class TestSensorSimulator : public QObject
{
    Q_OBJECT

private slots:
    void closedForms_data();
    void closedForms();
    void stepResponse_transformed_isTheFrequencyResponse();
    void stepResponse_addTo_equalsAt();
    void stepResponse_beforeTheStep_zero();
    void stepResponse_finalValue();
    void stepResponse_initialValueAndSlope_zero();
    void stepResponse_critical_textbook();
    void stepResponse_acCoupled_decaysWithItsTime();
    void relaxed_input_obeysItsDifferentialEquation();
    void frequencyResponse_closedForm();
    void presets_thesisValues();
    void presets_inTheDocument();
    void preset_unknown_namesTheKnown();
    void checkSensor_presetsAndAssortment_pass();
    void checkSensor_nonsense_usage();
};

void TestSensorSimulator::closedForms_data()
{
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("overshoot_percent");
    QTest::addColumn<double>("peakTime"); // times f0
    QTest::addColumn<double>("riseTime"); // 10-90 %, times f0
    QTest::addColumn<double>("peakFrequency"); // over f0
    QTest::addColumn<double>("peakMagnitude");
    QTest::newRow("0.02") << 0.02 << 93.90896 << 0.500100 << 0.164806 << 0.999600 << 25.005002;
    QTest::newRow("0.05") << 0.05 << 85.44679 << 0.500626 << 0.168749 << 0.997497 << 10.012523;
    QTest::newRow("0.10") << 0.10 << 72.92476 << 0.502519 << 0.175739 << 0.989949 << 5.025189;
    QTest::newRow("0.20") << 0.20 << 52.66206 << 0.510310 << 0.191532 << 0.959166 << 2.551552;
    QTest::newRow("0.40") << 0.40 << 25.38267 << 0.545545 << 0.232922 << 0.824621 << 1.363862;
    QTest::newRow("0.50") << 0.50 << 16.30335 << 0.577350 << 0.260628 << 0.707107 << 1.154701;
    QTest::newRow("0.70") << 0.70 << 4.59879 << 0.700140 << 0.338396 << 0.141421 << 1.000200;
}

void TestSensorSimulator::closedForms()
{
    constexpr double kLastDigit = 0.6e-6; // the oracle prints six decimals (overshoot: five)
    QFETCH(double, zeta);
    QFETCH(double, overshoot_percent);
    QFETCH(double, peakTime);
    QFETCH(double, riseTime);
    QFETCH(double, peakFrequency);
    QFETCH(double, peakMagnitude);
    const double f0_Hz = 1e6;
    const SensorSpec sensor = single(f0_Hz, zeta);
    const StepResponse response(sensor);
    const double peak_s = 0.5 / (f0_Hz * std::sqrt(1.0 - zeta * zeta)); // exact
    QVERIFY(std::abs(peak_s * f0_Hz - peakTime) < kLastDigit);
    QVERIFY(std::abs(100.0 * (response.at(peak_s) - 1.0) - overshoot_percent) < 10.0 * kLastDigit);
    QVERIFY(response.at(peak_s) > response.at(0.999 * peak_s));
    QVERIFY(response.at(peak_s) > response.at(1.001 * peak_s));
    const auto crossing_s = [&](double level) { // first crossing, by bisection before the peak
        double low = 0.0;
        double high = peak_s;
        for (int i = 0; i < 60; ++i)
            (response.at(0.5 * (low + high)) < level ? low : high) = 0.5 * (low + high);
        return low;
    };
    QVERIFY(std::abs((crossing_s(0.9) - crossing_s(0.1)) * f0_Hz - riseTime) < kLastDigit);
    QVERIFY(std::abs(std::abs(testing::sensorResponse(sensor, peakFrequency * f0_Hz))
                    / sensor.sensitivity_V_Pa
                - peakMagnitude)
        < kLastDigit * (1.0 + peakMagnitude));
}

void TestSensorSimulator::stepResponse_transformed_isTheFrequencyResponse()
{
    constexpr double kAliasing = 2e-5; // of a second-order roll-off at 200 times f0, and truncation
    for (const SensorSpec &sensor : assortment()) {
        const double f0_Hz = sensor.modes.front().f0_Hz;
        const double rate_Hz = 200.0 * f0_Hz;
        const double slowest_s
            = std::max(1.0 / (kTwoPi * f0_Hz * 0.01), sensor.acCoupling_s.value_or(0.0));
        const Index count = static_cast<Index>(16.0 * slowest_s * rate_Hz);
        const std::vector<double> step = sampledStep(sensor, rate_Hz, count);
        for (const double ratio : {0.03, 0.2, 0.7, 1.0, 1.3, 3.0}) {
            const std::complex<double> expected
                = testing::sensorResponse(sensor, ratio * f0_Hz) / sensor.sensitivity_V_Pa;
            const std::complex<double> found = responseByTransform(step, rate_Hz, ratio * f0_Hz);
            QVERIFY2(std::abs(found - expected) < kAliasing * std::max(1.0, std::abs(expected)),
                qPrintable(QString("%1 at %2 f0: %3")
                               .arg(QString::fromStdString(sensor.name))
                               .arg(ratio)
                               .arg(std::abs(found - expected))));
        }
    }
}

void TestSensorSimulator::stepResponse_addTo_equalsAt()
{
    constexpr double kPromised = 1e-12;
    constexpr double kRate_Hz = 1e8;
    for (const SensorSpec &sensor : assortment()) {
        for (const double relaxation_s : {0.0, 3e-4}) {
            const StepResponse response(sensor, relaxation_s);
            const double first_s = -1.2345678e-6;
            std::vector<double> values(50000, 0.25);
            response.addTo(values, first_s, kRate_Hz, -2.0);
            double worst = 0.0;
            for (std::size_t i = 0; i < values.size(); ++i)
                worst = std::max(worst,
                    std::abs(values[i] - 0.25
                        + 2.0 * response.at(first_s + static_cast<double>(i) / kRate_Hz)));
            QVERIFY2(worst < 2.0 * kPromised, qPrintable(QString::number(worst)));
        }
    }
}

void TestSensorSimulator::stepResponse_beforeTheStep_zero()
{
    const StepResponse response(single(1e6, 0.02));
    QCOMPARE(response.at(-1e-9), 0.0);
    std::vector<double> values(1000, 0.0);
    response.addTo(values, -1.0, 1e6, 1.0); // the step comes after the last sample
    for (const double value : values)
        QCOMPARE(value, 0.0);
    response.addTo({}, 0.0, 1e6, 1.0);
}

void TestSensorSimulator::stepResponse_finalValue()
{
    for (const SensorSpec &sensor : assortment()) {
        const double expected = sensor.acCoupling_s ? 0.0 : 1.0;
        QVERIFY(std::abs(StepResponse(sensor).at(0.1) - expected) < 1e-12);
    }
}

void TestSensorSimulator::stepResponse_initialValueAndSlope_zero()
{
    for (const SensorSpec &sensor : assortment()) {
        const StepResponse response(sensor);
        const double omega0 = kTwoPi * sensor.modes.front().f0_Hz;
        // Residues of the critical sensor cancel to 4 digits less; the others are exact.
        QVERIFY2(std::abs(response.at(0.0)) < 1e-11, sensor.name.c_str());
        QVERIFY2(std::abs(response.at(1e-3 / omega0)) < 2e-5, sensor.name.c_str());
    }
}

void TestSensorSimulator::stepResponse_critical_textbook()
{
    const double f0_Hz = 5e5;
    const double omega0 = kTwoPi * f0_Hz;
    for (const double zeta : {1.0, 1.0 + 1e-10, 1.0 - 1e-10, 1.0 + 1e-6}) {
        const StepResponse response(single(f0_Hz, zeta));
        for (double x = 0.0; x < 20.0; x += 0.1) { // 1 - (1 + w t) exp(-w t)
            const double expected = 1.0 - (1.0 + x) * std::exp(-x);
            QVERIFY(
                std::abs(response.at(x / omega0) - expected) < 2e-8 + 2.0 * std::abs(zeta - 1.0));
        }
    }
}

void TestSensorSimulator::stepResponse_acCoupled_decaysWithItsTime()
{
    const StepResponse response({"ac", 1e-6, {{1e6, 0.7, 1.0}}, {}, 1e-3});
    const double ratio = response.at(2e-3) / response.at(1e-3);
    QVERIFY(std::abs(ratio - std::exp(-1.0)) < 1e-12);
    QVERIFY(std::abs(response.at(1e-4) - std::exp(-0.1)) < 1e-3);
}

void TestSensorSimulator::relaxed_input_obeysItsDifferentialEquation()
{
    // tau r' + r = s, where s answers the step and r the input 1 - exp(-t/tau).
    constexpr double kTau_s = 3e-4;
    constexpr double kDifference_s = 1e-9;
    for (const SensorSpec &sensor : assortment()) {
        const StepResponse plain(sensor);
        const StepResponse relaxed(sensor, kTau_s);
        for (double t_s = 1e-7; t_s < 3e-3; t_s *= 1.3) {
            const double slope = (relaxed.at(t_s + kDifference_s) - relaxed.at(t_s - kDifference_s))
                / (2.0 * kDifference_s);
            const double left = kTau_s * slope + relaxed.at(t_s);
            QVERIFY2(std::abs(left - plain.at(t_s)) < 1e-3,
                qPrintable(QString::number(left - plain.at(t_s))));
        }
    }
}

void TestSensorSimulator::frequencyResponse_closedForm()
{
    const SensorSpec sensor = single(1e6, 0.1);
    for (const double x : {0.0, 0.3, 1.0, 2.0}) { // thesis 3.16, 3.17
        const std::complex<double> expected
            = 1e-6 / std::complex<double>(1.0 - x * x, 2.0 * 0.1 * x);
        QVERIFY(std::abs(testing::sensorResponse(sensor, x * 1e6) - expected) < 1e-20);
    }
    const SensorSpec third{"third", 2e-6, {{1e8, 0.7, 1.0}}, 250e3, {}};
    const double corner = std::abs(testing::sensorResponse(third, 250e3)) / 2e-6;
    QVERIFY(std::abs(corner - std::sqrt(0.5)) < 1e-5); // the mode is 400 times farther up
    const SensorSpec coupled{"coupled", 2e-6, {{1e8, 0.7, 1.0}}, {}, 1e-3};
    QCOMPARE(std::abs(testing::sensorResponse(coupled, 0.0)), 0.0);
    QVERIFY(std::abs(std::abs(testing::sensorResponse(coupled, 1.0 / (kTwoPi * 1e-3))) / 2e-6
                - std::sqrt(0.5))
        < 1e-9);
}

void TestSensorSimulator::presets_thesisValues()
{
    QCOMPARE(sensorPresets().size(), std::size_t(5));
    const auto f0_Hz = [](const char *name) { return sensorPreset(name)->modes.at(0).f0_Hz; };
    const auto zeta = [](const char *name) { return sensorPreset(name)->modes.at(0).zeta; };
    QCOMPARE(f0_Hz("piezo"), 318e3);
    QCOMPARE(zeta("piezo"), 0.02);
    QCOMPARE(f0_Hz("optic1"), 400e3);
    QCOMPARE(zeta("optic1"), 0.7);
    QCOMPARE(f0_Hz("optic2"), 3.11e6);
    QCOMPARE(f0_Hz("optic3"), 2.33e6);
    QCOMPARE(zeta("optic3"), 0.02);
    QCOMPARE(f0_Hz("optic4"), 2.78e6);
    QCOMPARE(*sensorPreset("optic4")->realPole_Hz, 250e3);
    for (const SensorSpec &preset : sensorPresets())
        QCOMPARE(preset.realPole_Hz.has_value(), preset.name == "optic4");
}

void TestSensorSimulator::presets_inTheDocument()
{
    const QString folder = qEnvironmentVariable("DYNCAL_SOURCE_DIR", ".");
    QFile document(folder + "/docs/simulator.md");
    if (!document.open(QIODevice::ReadOnly))
        QSKIP("docs/simulator.md not found: set DYNCAL_SOURCE_DIR");
    const QStringList lines = QString::fromUtf8(document.readAll()).split('\n');
    for (const SensorSpec &preset : sensorPresets()) {
        const QString start = QString("| `%1` |").arg(QString::fromStdString(preset.name));
        const QStringList rows = lines.filter(start);
        QVERIFY2(rows.size() == 1, qPrintable(start));
        const QStringList cells = rows[0].split('|');
        QCOMPARE(cells.at(2).trimmed().toDouble() * 1e3, preset.modes[0].f0_Hz);
        QCOMPARE(cells.at(3).trimmed().toDouble(), preset.modes[0].zeta);
        QCOMPARE(cells.at(4).trimmed().toDouble() * 1e3, preset.realPole_Hz.value_or(0.0));
        QCOMPARE(cells.at(5).trimmed().toDouble() * 1e-6, preset.sensitivity_V_Pa);
    }
}

void TestSensorSimulator::preset_unknown_namesTheKnown()
{
    const auto preset = sensorPreset("optic5");
    QVERIFY(!preset.has_value());
    QCOMPARE(preset.error().kind, ErrorKind::Usage);
    QCOMPARE(english(preset.error().message),
        std::string(
            "There is no sensor preset 'optic5'; choose one of piezo, optic1, optic2, optic3, optic4."));
    QVERIFY(!sensorPreset("").has_value());
    QVERIFY(!sensorPreset("Piezo").has_value());
}

void TestSensorSimulator::checkSensor_presetsAndAssortment_pass()
{
    for (const SensorSpec &sensor : assortment())
        QVERIFY2(checkSensor(sensor).has_value(), sensor.name.c_str());
    SensorSpec inverted = sensorPresets()[0];
    inverted.sensitivity_V_Pa *= -1.0;
    QVERIFY(checkSensor(inverted).has_value());
}

void TestSensorSimulator::checkSensor_nonsense_usage()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<SensorSpec> wrong{single(0.0, 0.1), single(nan, 0.1), single(1e6, 0.0),
        single(1e6, -0.1), single(1e6, nan), single(1e6, 11.0), single(-1e6, 0.1)};
    wrong.push_back({"no mode", 1e-6, {}, {}, {}});
    wrong.push_back(
        {"many modes", 1e-6, std::vector<SensorMode>(17, {1e6, 0.1, 1.0 / 17}), {}, {}});
    wrong.push_back({"weights", 1e-6, {{1e6, 0.1, 0.7}, {2e6, 0.1, 0.7}}, {}, {}});
    wrong.push_back({"weight", 1e-6, {{1e6, 0.1, nan}}, {}, {}});
    wrong.push_back({"zero", 0.0, {{1e6, 0.1, 1.0}}, {}, {}});
    wrong.push_back({"real pole", 1e-6, {{1e6, 0.1, 1.0}}, -250e3, {}});
    wrong.push_back({"coupling", 1e-6, {{1e6, 0.1, 1.0}}, {}, 0.0});
    wrong.push_back({"coincident", 1e-6, {{1e6, 0.1, 1.0}}, 1e4, 1.0 / (kTwoPi * 1e4)});
    for (const SensorSpec &sensor : wrong) {
        const auto checked = checkSensor(sensor);
        QVERIFY2(!checked.has_value(), sensor.name.c_str());
        QCOMPARE(checked.error().kind, ErrorKind::Usage);
    }
    QCOMPARE(english(checkSensor(single(1e6, 11.0)).error().message),
        std::string("The simulated sensor 'test' has zeta = 11; it must lie in 1e-04 .. 10."));
}

DYNCAL_TEST(TestSensorSimulator)
#include "tst_sensor_simulator.moc"
