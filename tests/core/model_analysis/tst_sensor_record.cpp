// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_record.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kOnset_s = 0.3e-6; ///< behind the detected start
constexpr double kRounding = 1e-12;
constexpr Index kLead = 40;

const Complex kPole(-9e3, 1.9e5); ///< of the sensor

/// c0 + 2 Re(c e^(s t)) from the onset on, c0 + 2 Re c = 0: second order.
struct Sensor
{
    double gain = 2.0;
    Complex amplitude() const
    {
        // Both y and y' vanish at the onset.
        return -0.5 * gain * Complex(1.0, kPole.real() / kPole.imag());
    }
    double step(double t_s) const
    {
        return gain + 2.0 * (amplitude() * std::exp(kPole * t_s)).real();
    }
    /// Transfer function: c0 + sum c s/(s - s_i), the Laplace transform of the step response by s.
    Complex gainAt(Complex s) const
    {
        const Complex c = amplitude();
        return gain + c * s / (s - kPole) + std::conj(c) * s / (s - std::conj(kPole));
    }
};

/// What a tube mode a e^(s t) of the pressure leaves in the record, transients of the sensor aside.
NuisanceTerm termOf(Complex pole_rad_s, Complex pressure, bool startsWithStep)
{
    // Amplitude G(s) a at the onset, brought back to the detected start.
    const Complex atOnset = Sensor{}.gainAt(pole_rad_s) * pressure;
    return {0, startsWithStep, pole_rad_s, atOnset * std::exp(-pole_rad_s * kOnset_s)};
}

/// `i` counts from the detected start; nothing before the onset.
double truth(Index i)
{
    const double t_s = static_cast<double>(i) / kRate_Hz - kOnset_s;
    return t_s > 0.0 ? Sensor{}.step(t_s) : 0.0;
}

WindowedResponse responseOf(const std::vector<NuisanceTerm> &terms, Index size)
{
    WindowedResponse response;
    response.shot = 4;
    response.sampleRate_Hz = kRate_Hz;
    response.lead = kLead;
    response.length = size;
    response.values.resize(kLead + size + 10);
    for (Index i = 0; i < response.values.size(); ++i) {
        const double t_s = static_cast<double>(i - kLead) / kRate_Hz;
        response.values[i] = truth(i - kLead);
        for (const NuisanceTerm &term : terms)
            if (t_s > kOnset_s || !term.startsWithStep)
                response.values[i] += term.value(t_s);
    }
    return response;
}

SensorModel modelOf(const std::vector<NuisanceTerm> &terms)
{
    SensorModel model;
    for (const Complex &s : {kPole, std::conj(kPole)}) {
        Pole pole;
        pole.s_rad_s = s;
        model.poles.push_back(pole);
    }
    for (const NuisanceTerm &term : terms) {
        NuisanceOfShot other; // of another shot: none of this record's business
        other.shot = 3;
        other.term = {0, true, {-1.0, 1e5}, 1e6};
        NuisanceOfShot own = other;
        own.shot = 4;
        own.term = term;
        NuisanceResult mode;
        mode.perShot = {other, own};
        model.nuisance.push_back(std::move(mode));
    }
    return model;
}

SeriesFit fitOf()
{
    SeriesFit fit;
    fit.shot = 4;
    fit.plateauGain = Sensor{}.gain;
    fit.onset_s = kOnset_s;
    fit.amplitudes.resize(2);
    fit.amplitudes << Sensor{}.amplitude(), std::conj(Sensor{}.amplitude());
    fit.recorded = {Sensor{}.gain, Eigen::VectorXcd(2), fit.amplitudes};
    fit.recorded.poles_rad_s << kPole, std::conj(kPole);
    fit.recorded.amplitudes.array() *= (-fit.recorded.poles_rad_s.array() * kOnset_s).exp();
    return fit;
}

} // namespace

class TestSensorRecord : public QObject
{
    Q_OBJECT

private slots:
    void modes_areTakenOffTheWholeWindow()
    {
        const std::vector<NuisanceTerm> terms{
            termOf({-300.0, 4e4}, {0.03, 0.01}, true), termOf({-100.0, 7e4}, {0.02, 0.0}, false)};
        for (const Index size : {1, 255, 256, 257, 1000}) { // blocks of 256 inside
            const SeriesFit fit = fitOf();
            const SensorRecord record = sensorRecord(responseOf(terms, size), modelOf(terms), &fit);
            QCOMPARE(record.early, kLead);
            QCOMPARE(record.values.size(), kLead + size);
            for (Index i = 0; i < kLead + size; ++i)
                QVERIFY(std::abs(record.values[i] - truth(i - kLead)) < kRounding);
        }
    }

    void withoutModelOfTheShot_recordStays()
    {
        const std::vector<NuisanceTerm> terms{termOf({-300.0, 4e4}, 0.03, true)};
        const WindowedResponse response = responseOf(terms, 300);
        const SensorRecord record = sensorRecord(response, modelOf(terms), nullptr);
        QCOMPARE(record.values, Eigen::VectorXd(response.values.head(kLead + 300)));
        QCOMPARE(record.early, kLead);
        QVERIFY(record.driven.empty());
        QCOMPARE(record.ofStep({1.5, -2.0}, 1e4), Complex(1.5, -2.0));
    }

    void stretchesLeftOut_areTheModels()
    {
        const std::vector<NuisanceTerm> terms{termOf({-300.0, 4e4}, 0.03, true)};
        WindowedResponse response = responseOf(terms, 300);
        response.values.segment(kLead + 50, 20).setConstant(1e9);
        response.values.segment(kLead + 290, 10).setConstant(std::nan(""));
        SeriesFit fit = fitOf();
        fit.leftOut = {{50, 70}, {290, 400}}; // the second reaches beyond the window
        const SensorRecord record = sensorRecord(response, modelOf(terms), &fit);
        for (Index i = 0; i < 300; ++i)
            QVERIFY(std::abs(record.values[kLead + i] - truth(i)) < kRounding);
    }

    void ofTheLead_asMuchIsTakenAsARiseNeeds()
    {
        WindowedResponse response = responseOf({}, 3200);
        const Eigen::VectorXd before = Eigen::VectorXd::Zero(1000);
        response.values
            = (Eigen::VectorXd(1000 + response.values.size()) << before, response.values)
                  .finished();
        response.lead += 1000;
        const SensorRecord record = sensorRecord(response, modelOf({}), nullptr);
        QCOMPARE(record.early, Index(200)); // a sixteenth of the window
        QCOMPARE(record.values.size(), Index(3400));
        response.length = 160;
        QCOMPARE(sensorRecord(response, modelOf({}), nullptr).early, Index(64));
    }

    void onlyModesThatTheStepSetOff_areInput()
    {
        const std::vector<NuisanceTerm> terms{
            termOf({-300.0, 4e4}, {0.03, 0.01}, true), termOf({-100.0, 7e4}, {0.02, 0.0}, false)};
        const SeriesFit fit = fitOf();
        const SensorRecord record = sensorRecord(responseOf(terms, 100), modelOf(terms), &fit);
        QCOMPARE(record.driven.size(), std::size_t(1));
        const SensorRecord::Driven &mode = record.driven[0];
        QCOMPARE(mode.pole_rad_s, Complex(-300.0, 4e4));
        QVERIFY(std::abs(mode.pressure - Complex(0.03, 0.01)) < kRounding);
        QVERIFY(
            std::abs(mode.response - Sensor{}.gainAt(mode.pole_rad_s) * mode.pressure) < kRounding);
    }

    void responseToTheStepAlone_isTheSensorsAtEveryFrequency()
    {
        // Pressure 1 + Re(a e^(s t)) from the onset on gives jw Y(jw) = G(jw) jw P(jw), exactly.
        // ofStep() gets jw Y less the mode's own part and must give back G(jw).
        const Complex s(-300.0, 4e4), a(0.2, -0.15);
        const std::vector<NuisanceTerm> terms{termOf(s, a, true)};
        const SeriesFit fit = fitOf();
        const SensorRecord record = sensorRecord(responseOf(terms, 100), modelOf(terms), &fit);
        for (const double f_Hz : {10.0, 1e3, 6e3, 6.4e3, 3e4, 3e5}) {
            const Complex jw(0.0, 2.0 * M_PI * f_Hz);
            const auto transform = [&](Complex amplitude) { // of Re(amplitude e^(s t)), times jw
                return 0.5 * jw
                    * (amplitude / (jw - s) + std::conj(amplitude) / (jw - std::conj(s)));
            };
            const Complex pressure = 1.0 + transform(a);
            const Complex whole = Sensor{}.gainAt(jw) * pressure;
            const Complex found = record.ofStep(whole - transform(Sensor{}.gainAt(s) * a), f_Hz);
            QVERIFY(std::abs(found - Sensor{}.gainAt(jw)) < 1e-11 * std::abs(whole));
        }
        QCOMPARE(record.ofStep({2.0, 0.0}, 0.0), Complex(2.0, 0.0)); // static: the plateau alone
    }
};

DYNCAL_TEST(TestSensorRecord)
#include "tst_sensor_record.moc"
