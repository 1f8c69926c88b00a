// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/component_result.h"
#include "core/realization/input/input_preparation.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/rate_choice.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

/// A remapped step response at 100 MHz, quiet before time 0.
WindowedResponse response(Index shot, double rate_Hz, double f0_Hz, double zeta, double noise)
{
    testing::Noise source(static_cast<std::uint64_t>(shot));
    WindowedResponse r;
    r.shot = shot;
    r.sampleRate_Hz = rate_Hz;
    r.unit = std::string("V"); // not "V": g++ 12 raises a false -Warray-bounds
    r.lead = 1000;
    r.length = 20000;
    r.values = source.series(r.lead + r.length + 64, noise);
    for (Index k = r.lead; k < r.values.size(); ++k)
        r.values[k] += testing::secondOrderStep(
            f0_Hz, zeta, (static_cast<double>(k - r.lead) + 0.5) / rate_Hz);
    r.noise = source.series(20000, noise);
    r.noiseSd = noise;
    return r;
}

SpectrumResult spectrumWith(double f_Hz, double q)
{
    SpectrumResult spectrum;
    spectrum.resonances.push_back({f_Hz, 40.0, q, {}});
    return spectrum;
}

bool has(const Findings &findings, const char *id)
{
    return std::any_of(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
}

} // namespace

class TestModelInput : public QObject
{
    Q_OBJECT

private slots:
    void autoRate_followsTheResonance_data()
    {
        QTest::addColumn<double>("resonance_Hz");
        QTest::addColumn<double>("q");
        QTest::addColumn<int>("factor");
        QTest::newRow("2.33 MHz") << 2.33e6 << 25.0 << 10;
        QTest::newRow("3.11 MHz") << 3.11e6 << 16.7 << 5;
        QTest::newRow("318 kHz") << 318e3 << 25.0 << 50;
        QTest::newRow("filter longer than the ringing") << 318e3 << 1.0 << 5;
        QTest::newRow("too fast for any reduction") << 30e6 << 25.0 << 1;
    }
    void autoRate_followsTheResonance()
    {
        QFETCH(double, resonance_Hz);
        QFETCH(double, q);
        QFETCH(int, factor);
        const SensorTraits traits = sensorTraits({}, spectrumWith(resonance_Hz, q));
        QCOMPARE(chooseReduction(100e6, traits), Index(factor));
    }

    void autoRate_withoutResonance_followsTheRise()
    {
        SensorTraits traits;
        QCOMPARE(chooseReduction(100e6, traits), Index(1));
        traits.riseTime_s = 0.85e-6;
        QCOMPARE(chooseReduction(100e6, traits), Index(2));
    }

    void input_startsWhereTheFilterSeesNothingOfTheQuiet()
    {
        // Noise-free: if the filter touched a sample before the onset, the input would not be the
        // response times the filter's gain.
        const std::vector<WindowedResponse> responses{response(1, 100e6, 2.33e6, 0.02, 0.0)};
        InputSettings settings;
        settings.sampleRate_Hz = 10e6;
        const auto input = prepareModelInput(responses, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(input.has_value());
        const ModelSeries &series = input->series.front();
        QCOMPARE(series.filter.factor, 10.0);
        QVERIFY(std::abs(input->offset_s - series.filter.span_s() / 2.0) < 1e-12);
        const double w0 = 2.0 * std::numbers::pi * 2.33e6;
        const std::complex<double> s = w0 * std::complex<double>(-0.02, std::sqrt(1.0 - 0.0004));
        const std::complex<double> c = std::conj(s) / (s - std::conj(s));
        double worst = 0.0;
        for (Index k = 0; k < series.y.size(); ++k) {
            const double t = series.first_s + static_cast<double>(k) / 10e6 + 0.5 / 100e6;
            const double expected
                = 1.0 + 2.0 * (c * series.filter.gain(s) * std::exp(s * t)).real();
            worst = std::max(worst, std::abs(series.y[k] - expected));
        }
        QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
        QVERIFY(std::abs(*input->samplesPerPeriod - 4.29185) < 1e-4);
        QVERIFY(*input->lostResponse_percent > 20.0 && *input->lostResponse_percent < 60.0);
    }

    void typedOffsetInsideTheFilter_isSaid()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 10e6;
        settings.offset_s = 0.0;
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.0)}, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(input && has(input->findings, "MIN-006"));
        QCOMPARE(input->offset_s, 0.0);
    }

    void unfilteredInput_startsAtTheStart()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 100e6;
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.0)}, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(input.has_value());
        QCOMPARE(input->offset_s, 0.0);
        QCOMPARE(input->series.front().filter.taps.size(), Index(1));
    }

    void noise_passesTheSameFilter()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 10e6;
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.01)}, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(input.has_value());
        const ModelSeries &series = input->series.front();
        const double expected = 0.01 * series.filter.taps.norm();
        // sd of an sd from 1990 values: 2 %
        QVERIFY(std::abs(series.noiseSd / expected - 1.0) < 0.08);
        QVERIFY(std::abs(series.fullRateNoiseSd / 0.01 - 1.0) < 0.03);
    }

    void tooLowRate_namesTheAlias()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 1e6;
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.0)}, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(!input.has_value());
        QCOMPARE(input.error().findingId, std::string("MIN-001"));
        QVERIFY(english(input.error().message).find("330 kHz") != std::string::npos);
    }

    void fewSamplesPerPeriod_areACaution_thesisRatesPass()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 10e6;
        const auto low = prepareModelInput(
            {response(1, 100e6, 3.11e6, 0.02, 0.0)}, spectrumWith(3.11e6, 25.0), {}, settings);
        QVERIFY(low && has(low->findings, "MIN-002"));
        QCOMPARE(worstSeverity(low->findings), Severity::Caution);
    }

    void rateThatIsNoWholeFraction_givesTheSameResponse()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 7e6;
        const auto input = prepareModelInput(
            {response(1, 100e6, 1.1e6, 0.02, 0.0)}, spectrumWith(1.1e6, 25.0), {}, settings);
        QVERIFY(input.has_value());
        const ModelSeries &series = input->series.front();
        const double w0 = 2.0 * std::numbers::pi * 1.1e6;
        const std::complex<double> s = w0 * std::complex<double>(-0.02, std::sqrt(1.0 - 0.0004));
        const std::complex<double> c = std::conj(s) / (s - std::conj(s));
        double worst = 0.0;
        for (Index k = 0; k < series.y.size(); ++k) {
            const double t = series.first_s + static_cast<double>(k) / 7e6 + 0.5 / 100e6;
            const double expected
                = 1.0 + 2.0 * (c * series.filter.gain(s) * std::exp(s * t)).real();
            worst = std::max(worst, std::abs(series.y[k] - expected));
        }
        QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst)));
    }

    void rateAboveTheRecords_isRefused()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 200e6;
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.0)}, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(!input.has_value());
        QCOMPARE(input.error().kind, ErrorKind::DataBlocked);
    }

    void shotsOfDifferentRate_meetAtTheModelRate()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 10e6;
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.0), response(2, 50e6, 2.33e6, 0.02, 0.0)},
            spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(input.has_value());
        QCOMPARE(input->series[0].filter.factor, 10.0);
        QCOMPARE(input->series[1].filter.factor, 5.0);
        QCOMPARE(input->series[0].y.size(), input->series[1].y.size());
    }

    void tooManySamples_namesWhatThereIs()
    {
        InputSettings settings;
        settings.sampleRate_Hz = 10e6;
        settings.samples = Index(5000);
        const auto input = prepareModelInput(
            {response(1, 100e6, 2.33e6, 0.02, 0.0)}, spectrumWith(2.33e6, 25.0), {}, settings);
        QVERIFY(!input.has_value());
        QVERIFY(english(input.error().message).find("5000") != std::string::npos);
    }

    void average_isTheSourceInThesisMode()
    {
        ComponentResult components;
        components.sampleRate_Hz = 1e6;
        components.average = testing::sampledStep(30e3, 0.05, 1e6, 400);
        InputSettings settings;
        settings.treatment = ResponseTreatment::StepAsImpulse;
        settings.sampleRate_Hz = 1e6;
        settings.samples = Index(400);
        const auto input
            = prepareModelInput({response(1, 1e6, 30e3, 0.05, 0.0)}, {}, components, settings);
        QVERIFY(input.has_value());
        QCOMPARE(input->series.size(), std::size_t(1));
        QCOMPARE(input->series.front().shot, Index(0));
        QCOMPARE(input->series.front().y, components.average);
        QVERIFY(has(input->findings, "MIN-004"));
    }
};

DYNCAL_TEST(TestModelInput)
#include "tst_model_input.moc"
