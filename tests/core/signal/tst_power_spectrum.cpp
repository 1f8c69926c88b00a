// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/power_spectrum.h"
#include "core/signal/resonance_search.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"
#include "tests/support/measured_data.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <stop_token>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kExact = 1e-12; // sums of 10^3..10^5 rounded terms

double totalPower(const PowerSpectrum &spectrum)
{
    return spectrum.psd.sum() * spectrum.frequency_Hz[1];
}

/// A response as the window stage cuts it.
WindowedResponse responseOf(const Eigen::VectorXd &values, double rate_Hz, Index shot = 1)
{
    WindowedResponse response;
    response.shot = shot;
    response.sampleRate_Hz = rate_Hz;
    response.values = values;
    response.length = values.size();
    return response;
}

/// Window of a remapped step: begins with the arrival.
WindowedResponse stepResponse(
    SecondOrder sensor, double noise, std::uint64_t seed, double duration_s = 1.5e-3)
{
    StepRecord record;
    record.sensor = sensor;
    record.rate_Hz = 100e6;
    record.arrival_s = 0.0;
    record.duration_s = duration_s;
    record.noiseSd = noise;
    record.seed = seed;
    return responseOf(record.values(), record.rate_Hz, static_cast<Index>(seed));
}

Eigen::VectorXd cosine(Index n, double cyclesPerSample, double amplitude)
{
    return Eigen::VectorXd::NullaryExpr(n, [&](Index i) {
        return amplitude
            * std::cos(2.0 * std::numbers::pi * cyclesPerSample * static_cast<double>(i) + 0.4);
    });
}

void describe(const SpectrumResult &result)
{
    for (const Resonance &r : result.resonances)
        qInfo("resonance %g Hz, %g dB, Q %g", r.frequency_Hz, r.prominence_dB, r.q);
}

} // namespace

class TestPowerSpectrum : public QObject
{
    Q_OBJECT

private slots:
    void periodogram_anyLengthAndTaper_obeysParseval_data();
    void periodogram_anyLengthAndTaper_obeysParseval();
    void periodogram_cosineOnBin_holdsHalfSquare();
    void periodogram_whiteNoise_hasItsLevel();
    void periodogram_scale_isPerHertz();
    void welch_segments_obeyParsevalAndSettings();
    void detrend_removesWhatItSays();
    void badInput_isRefused();
    void resonance_lightlyDamped_isTheOnlyOne_data();
    void resonance_lightlyDamped_isTheOnlyOne();
    void resonance_q_followsDamping();
    void resonance_wellDamped_isNone_data();
    void resonance_wellDamped_isNone();
    void resonance_pureNoise_isNone();
    void resonance_rampsAndSteps_areNone();
    void resonance_twoModes_areBothFound();
    void resonance_shortRecord_isFound();
    void resonance_hann_andWelch_findTheSame();
    void resonance_undampedTone_isInterpolated();
    void resonance_band_limitsTheSearch();
    void shots_shareResonances();
    void shots_spread_isAFinding();
    void operatorList_isMatchedToMaxima();
    void searchOff_findsNothingAndSaysNothing();
    void analyse_stopAndErrors();
    void analyse_threeLongShots_isFast();
    void measured_impact_showsItsPlateMode();
};

void TestPowerSpectrum::periodogram_anyLengthAndTaper_obeysParseval_data()
{
    QTest::addColumn<int>("length");
    QTest::addColumn<bool>("hann");
    for (const int length : {8, 9, 100, 1001, 4096, 30011}) {
        QTest::addRow("%d", length) << length << false;
        QTest::addRow("%d Hann", length) << length << true;
    }
}

void TestPowerSpectrum::periodogram_anyLengthAndTaper_obeysParseval()
{
    QFETCH(int, length);
    QFETCH(bool, hann);
    SpectrumSettings settings;
    settings.taper = hann ? Taper::Hann : Taper::Rectangular;
    const Eigen::VectorXd x = Gaussian(1).vector(length, 2.0).array() + 5.0;
    const auto spectrum = computePowerSpectrum(x, 1e6, settings);
    QVERIFY(spectrum.has_value());
    QCOMPARE(spectrum->psd.size(), Index(length / 2 + 1));
    QCOMPARE(spectrum->frequency_Hz[0], 0.0);
    QVERIFY(std::abs(spectrum->frequency_Hz[1] - 1e6 / length) < 1e-9);

    Eigen::ArrayXd weight = Eigen::ArrayXd::Ones(length);
    for (Index i = 0; hann && i < length; ++i)
        weight[i] = std::pow(std::sin(std::numbers::pi * static_cast<double>(i) / length), 2);
    const double expected
        = (weight * (x.array() - x.mean())).square().sum() / weight.square().sum();
    QVERIFY(std::abs(totalPower(*spectrum) / expected - 1.0) < kExact);
}

void TestPowerSpectrum::periodogram_cosineOnBin_holdsHalfSquare()
{
    for (const Index n : {1000, 1001}) {
        const double bin = 17.0;
        const auto spectrum
            = computePowerSpectrum(cosine(n, bin / static_cast<double>(n), 3.0), 500.0, {});
        Index peak = 0;
        spectrum->psd.maxCoeff(&peak);
        QCOMPARE(peak, Index(17));
        QVERIFY(std::abs(spectrum->psd[17] * spectrum->frequency_Hz[1] - 4.5) < kExact * 10);
        QVERIFY(totalPower(*spectrum) - 4.5 < kExact * 10);
    }
    // the last bin of an even length has no partner either
    const auto nyquist = computePowerSpectrum(cosine(100, 0.5, 1.0), 1.0, {});
    QVERIFY(std::abs(nyquist->psd[50] * 0.01 - std::pow(std::cos(0.4), 2)) < kExact);
}

void TestPowerSpectrum::periodogram_whiteNoise_hasItsLevel()
{
    constexpr double kSd = 0.3, kRate_Hz = 2e6;
    const auto spectrum = computePowerSpectrum(Gaussian(2).vector(100'000, kSd), kRate_Hz, {});
    const double expected = 2.0 * kSd * kSd / kRate_Hz; // one-sided
    QVERIFY(std::abs(spectrum->psd.mean() / expected - 1.0) < 5.0 / std::sqrt(50'000.0));
}

void TestPowerSpectrum::periodogram_scale_isPerHertz()
{
    const Eigen::VectorXd x = Gaussian(3).vector(512, 1.0);
    const auto slow = computePowerSpectrum(x, 1.0, {}), fast = computePowerSpectrum(x, 1e8, {});
    QVERIFY((slow->psd - 1e8 * fast->psd).cwiseAbs().maxCoeff() < kExact * slow->psd.maxCoeff());
}

void TestPowerSpectrum::welch_segments_obeyParsevalAndSettings()
{
    SpectrumSettings settings;
    settings.method = SpectrumMethod::Welch;
    settings.segment = 256;
    settings.detrend = Detrend::None;
    const Eigen::VectorXd x = Gaussian(4).vector(1000, 1.0);
    const auto spectrum = computePowerSpectrum(x, 1.0, settings);
    QCOMPARE(spectrum->psd.size(), Index(129));
    double expected = 0.0; // 256 long, half overlapping: begins 0, 128, .. 640 and 1000 - 256 < 768
    for (Index begin = 0; begin <= 640; begin += 128)
        expected += x.segment(begin, 256).squaredNorm() / 256.0 / 6.0;
    QVERIFY(std::abs(totalPower(*spectrum) / expected - 1.0) < kExact);
    settings.segment.reset(); // an eighth
    QCOMPARE(computePowerSpectrum(x, 1.0, settings)->psd.size(), Index(63));
    settings.segment = 1'000'000; // no longer than the series
    QCOMPARE(computePowerSpectrum(x, 1.0, settings)->psd.size(), Index(501));
    settings.segment = -5;
    QCOMPARE(computePowerSpectrum(x, 1.0, settings)->psd.size(), Index(5));
}

void TestPowerSpectrum::detrend_removesWhatItSays()
{
    const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(100, 3.0, 9.0);
    SpectrumSettings settings;
    settings.detrend = Detrend::None;
    QVERIFY(std::abs(
                totalPower(*computePowerSpectrum(ramp, 1.0, settings)) - ramp.squaredNorm() / 100.0)
        < 1e-10);
    settings.detrend = Detrend::Mean;
    QVERIFY(computePowerSpectrum(ramp, 1.0, settings)->psd[0] < 1e-25);
    QVERIFY(totalPower(*computePowerSpectrum(ramp, 1.0, settings)) > 1.0);
    settings.detrend = Detrend::Linear;
    QVERIFY(totalPower(*computePowerSpectrum(ramp, 1.0, settings)) < 1e-25);
}

void TestPowerSpectrum::badInput_isRefused()
{
    Eigen::VectorXd x = Gaussian(5).vector(100, 1.0);
    QVERIFY(!computePowerSpectrum(x.head(7), 1.0, {}));
    QVERIFY(computePowerSpectrum(x.head(8), 1.0, {}).has_value());
    QVERIFY(!computePowerSpectrum(x, 0.0, {}));
    QVERIFY(!computePowerSpectrum(x, std::nan(""), {}));
    QVERIFY(!computePowerSpectrum(Eigen::VectorXd(), 1.0, {}));
    QVERIFY(!computePowerSpectrum(1e200 * x, 1.0, {})); // its square is no number
    x[50] = std::numeric_limits<double>::infinity();
    const auto refused = computePowerSpectrum(x, 1.0, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, ErrorKind::DataBlocked);
}

void TestPowerSpectrum::resonance_lightlyDamped_isTheOnlyOne_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("tolerance"); ///< of the frequency
    for (const double noise : {0.0, 0.002, 0.01}) {
        for (const double f0_Hz : {30e3, 318e3, 2.33e6, 7e6}) {
            QTest::addRow("%g Hz, 0.005, noise %g", f0_Hz, noise)
                << f0_Hz << 0.005 << noise << 2e-3;
            QTest::addRow("%g Hz, 0.02, noise %g", f0_Hz, noise) << f0_Hz << 0.02 << noise << 2e-3;
            QTest::addRow("%g Hz, 0.1, noise %g", f0_Hz, noise) << f0_Hz << 0.1 << noise << 1.5e-2;
        }
    }
}

void TestPowerSpectrum::resonance_lightlyDamped_isTheOnlyOne()
{
    QFETCH(double, f0_Hz);
    QFETCH(double, zeta);
    QFETCH(double, noise);
    QFETCH(double, tolerance);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const auto result = analyseSpectra({stepResponse({f0_Hz, zeta}, noise, seed)}, {});
        QVERIFY(result.has_value());
        if (result->resonances.size() != 1)
            describe(*result);
        QCOMPARE(result->resonances.size(), std::size_t(1));
        const Resonance &found = result->resonances[0];
        const double off = found.frequency_Hz / f0_Hz - 1.0;
        QVERIFY2(std::abs(off) <= tolerance, qPrintable(QString::number(off)));
        QVERIFY(found.prominence_dB >= 6.0);
        QCOMPARE(found.perShot_Hz.size(), std::size_t(1));
        QCOMPARE(*found.perShot_Hz[0], found.frequency_Hz);
        QVERIFY(result->findings.empty());
    }
}

void TestPowerSpectrum::resonance_q_followsDamping()
{
    for (const double zeta : {0.01, 0.02, 0.05}) {
        const auto result = analyseSpectra({stepResponse({2.33e6, zeta}, 0.001, 3)}, {});
        QCOMPARE(result->resonances.size(), std::size_t(1));
        const double relative = result->resonances[0].q * 2.0 * zeta; // Q = 1/(2 zeta)
        QVERIFY2(std::abs(relative - 1.0) < 0.1, qPrintable(QString::number(relative)));
    }
}

void TestPowerSpectrum::resonance_wellDamped_isNone_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("noise");
    for (const double zeta : {0.6, 0.7, 0.9}) {
        for (const double f0_Hz : {30e3, 318e3, 2.33e6}) {
            for (const double noise : {0.0, 0.001, 0.01, 0.1})
                QTest::addRow("%g Hz, %g, noise %g", f0_Hz, zeta, noise) << f0_Hz << zeta << noise;
        }
    }
}

void TestPowerSpectrum::resonance_wellDamped_isNone()
{
    QFETCH(double, f0_Hz);
    QFETCH(double, zeta);
    QFETCH(double, noise);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const auto result = analyseSpectra({stepResponse({f0_Hz, zeta}, noise, seed)}, {});
        describe(*result);
        QVERIFY(result->resonances.empty());
        QVERIFY(hasFinding(result->findings, "SPC-001"));
        QCOMPARE(result->findings[0].severity, Severity::Info);
    }
}

void TestPowerSpectrum::resonance_pureNoise_isNone()
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const Index length = seed % 3 == 0 ? 20'000 : seed % 3 == 1 ? 2000 : 300;
        const auto noise = responseOf(Gaussian(seed).vector(length, 1.0), 1e6);
        found += analyseSpectra({noise}, {})->resonances.empty() ? 0 : 1;
    }
    QVERIFY2(found <= 2, qPrintable(QString::number(found))); // 1e-3 per spectrum
}

void TestPowerSpectrum::resonance_rampsAndSteps_areNone()
{
    const Index n = 20'000;
    const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(n, 0.0, 1.0);
    Eigen::VectorXd step = Eigen::VectorXd::Ones(n);
    step.head(n / 3).setZero();
    Eigen::VectorXd walk = Gaussian(7).vector(n, 1.0);
    for (Index i = 1; i < n; ++i)
        walk[i] += walk[i - 1];
    const Eigen::VectorXd creep = Eigen::VectorXd::NullaryExpr(
        n, [](Index i) { return std::exp(-static_cast<double>(i) / 700.0); });
    for (const Eigen::VectorXd &values :
        {ramp, creep, walk, Eigen::VectorXd(step + Gaussian(8).vector(n, 0.01))}) {
        const auto result = analyseSpectra({responseOf(values, 1e6)}, {});
        describe(*result);
        QVERIFY(result->resonances.empty());
    }
}

void TestPowerSpectrum::resonance_twoModes_areBothFound()
{
    WindowedResponse both = stepResponse({318e3, 0.02}, 0.002, 1);
    both.values += 0.2 * stepResponse({900e3, 0.01}, 0.0, 2).values;
    const auto result = analyseSpectra({both}, {});
    describe(*result);
    QCOMPARE(result->resonances.size(), std::size_t(2));
    QVERIFY(result->resonances[0].prominence_dB >= result->resonances[1].prominence_dB);
    const double low
        = std::min(result->resonances[0].frequency_Hz, result->resonances[1].frequency_Hz);
    const double high
        = std::max(result->resonances[0].frequency_Hz, result->resonances[1].frequency_Hz);
    QVERIFY(std::abs(low / 318e3 - 1.0) < 3e-3);
    QVERIFY(std::abs(high / 900e3 - 1.0) < 3e-3);
}

void TestPowerSpectrum::resonance_shortRecord_isFound()
{
    // the oracle series of the identification: 400 samples at 1 MS/s
    const SecondOrder sensor{318e3, 0.02};
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(
        400, [&](Index i) { return sensor.step(static_cast<double>(i + 1) * 1e-6); });
    const auto result = analyseSpectra({responseOf(values, 1e6)}, {});
    describe(*result);
    QCOMPARE(result->resonances.size(), std::size_t(1));
    QVERIFY(std::abs(result->resonances[0].frequency_Hz / 318e3 - 1.0) < 0.01);
}

void TestPowerSpectrum::resonance_hann_andWelch_findTheSame()
{
    // A taper that is 0 at the onset suppresses a short ringing; a long one it shows.
    SpectrumSettings welch;
    welch.method = SpectrumMethod::Welch;
    const auto response = stepResponse({318e3, 0.001}, 0.002, 4);
    for (const Taper taper : {Taper::Rectangular, Taper::Hann}) {
        welch.taper = taper;
        const auto result = analyseSpectra({response}, welch);
        QCOMPARE(result->resonances.size(), std::size_t(1));
        QVERIFY(std::abs(result->resonances[0].frequency_Hz / 318e3 - 1.0) < 3e-3);
    }
}

void TestPowerSpectrum::resonance_undampedTone_isInterpolated()
{
    for (const double bin : {40.0, 40.25, 40.5, 333.4}) {
        for (const Taper taper : {Taper::Rectangular, Taper::Hann}) {
            SpectrumSettings settings;
            settings.taper = taper;
            const Eigen::VectorXd x
                = cosine(4000, bin / 4000.0, 1.0) + Gaussian(6).vector(4000, 0.1);
            const auto result = analyseSpectra({responseOf(x, 4000.0)}, settings); // 1 Hz per bin
            describe(*result);
            QCOMPARE(result->resonances.size(), std::size_t(1));
            const double off = result->resonances[0].frequency_Hz - bin;
            QVERIFY2(std::abs(off) < 0.03, qPrintable(QString::number(off)));
        }
    }
}

void TestPowerSpectrum::resonance_band_limitsTheSearch()
{
    WindowedResponse both = stepResponse({318e3, 0.02}, 0.002, 1);
    both.values += 0.2 * stepResponse({900e3, 0.01}, 0.0, 2).values;
    SpectrumSettings settings;
    settings.resonanceBand_Hz = Interval{600e3, 2e6};
    const auto result = analyseSpectra({both}, settings);
    QCOMPARE(result->resonances.size(), std::size_t(1));
    QVERIFY(std::abs(result->resonances[0].frequency_Hz / 900e3 - 1.0) < 3e-3);
}

void TestPowerSpectrum::shots_shareResonances()
{
    std::vector<WindowedResponse> shots{stepResponse({2.33e6, 0.02}, 0.01, 1),
        stepResponse({2.34e6, 0.02}, 0.01, 2), stepResponse({2.33e6, 0.02}, 0.01, 3)};
    shots[2].values += 0.3 * stepResponse({400e3, 0.02}, 0.0, 9).values; // one shot's own
    const auto result = analyseSpectra(shots, {});
    describe(*result);
    QCOMPARE(result->perShot.size(), std::size_t(3));
    QCOMPARE(result->resonances.size(), std::size_t(1));
    const Resonance &r = result->resonances[0];
    QCOMPARE(r.perShot_Hz.size(), std::size_t(3));
    const double mean = (*r.perShot_Hz[0] + *r.perShot_Hz[1] + *r.perShot_Hz[2]) / 3.0;
    QVERIFY(std::abs(r.frequency_Hz - mean) < 1e-6);
    QVERIFY(*r.perShot_Hz[1] > *r.perShot_Hz[0]);
    QVERIFY(result->findings.empty());
}

void TestPowerSpectrum::shots_spread_isAFinding()
{
    const auto result = analyseSpectra(
        {stepResponse({2.33e6, 0.02}, 0.01, 1), stepResponse({2.33e6, 0.02}, 0.01, 2),
            stepResponse({2.41e6, 0.02}, 0.01, 3)},
        {});
    QCOMPARE(result->resonances.size(), std::size_t(1));
    QVERIFY(hasFinding(result->findings, "SPC-002"));
    const Finding &finding = result->findings[0];
    QCOMPARE(finding.severity, Severity::Caution);
    QVERIFY(std::abs(*finding.value - 100.0 * 0.08 / 2.3567) < 0.3);
    QCOMPARE(*finding.limit, 2.0);
}

void TestPowerSpectrum::operatorList_isMatchedToMaxima()
{
    SpectrumSettings settings;
    settings.searchResonance = false;
    settings.resonances_Hz = {2.2e6, 20.0};
    const auto result = analyseSpectra(
        {stepResponse({2.33e6, 0.02}, 0.0, 1), stepResponse({2.33e6, 0.02}, 0.0, 2)}, settings);
    describe(*result);
    QCOMPARE(result->resonances.size(), std::size_t(2));
    QVERIFY(std::abs(result->resonances[0].frequency_Hz / 2.33e6 - 1.0) < 2e-3);
    QVERIFY(result->resonances[0].perShot_Hz[1].has_value());
    QCOMPARE(result->resonances[1].frequency_Hz, 20.0); // below the first bin: kept as given
    QVERIFY(!result->resonances[1].perShot_Hz[0] && !result->resonances[1].perShot_Hz[1]);
    QVERIFY(result->findings.empty());
}

void TestPowerSpectrum::searchOff_findsNothingAndSaysNothing()
{
    SpectrumSettings settings;
    settings.searchResonance = false;
    const auto result = analyseSpectra({stepResponse({2.33e6, 0.02}, 0.0, 1)}, settings);
    QVERIFY(result->resonances.empty());
    QVERIFY(result->findings.empty());
    QCOMPARE(result->perShot.size(), std::size_t(1));
}

void TestPowerSpectrum::analyse_stopAndErrors()
{
    std::stop_source source;
    source.request_stop();
    const auto stopped
        = analyseSpectra({stepResponse({2.33e6, 0.02}, 0.0, 1)}, {}, {source.get_token(), {}});
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().kind, ErrorKind::Cancelled);
    const auto bad = analyseSpectra({responseOf(Eigen::VectorXd::Ones(4), 1.0, 7)}, {});
    QVERIFY(!bad);
    QCOMPARE(bad.error().shot, Index(7));
    QVERIFY(analyseSpectra({}, {}).has_value());
    // a flat spectrum of zeros must not make resonances
    QVERIFY(analyseSpectra({responseOf(Eigen::VectorXd::Zero(1000), 1.0)}, {})->resonances.empty());
}

void TestPowerSpectrum::analyse_threeLongShots_isFast()
{
    const std::vector<WindowedResponse> shots{stepResponse({2.33e6, 0.02}, 0.01, 1),
        stepResponse({2.33e6, 0.02}, 0.01, 2), stepResponse({2.33e6, 0.02}, 0.01, 3)};
    QElapsedTimer timer;
    timer.start();
    QVERIFY(analyseSpectra(shots, {}).has_value());
    const auto elapsed_ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    qInfo("3 x 150000 samples: %.1f ms (target 100)", elapsed_ms);
    QVERIFY(elapsed_ms < 300.0);
}

void TestPowerSpectrum::measured_impact_showsItsPlateMode()
{
    const auto values = textColumn(dataFolder()
            / "highrate_ds5_impact/data/dataset-1/data-1/PCB_repeated_shock_trials/acc_pcb_a0.txt",
        1);
    if (!values)
        DYNCAL_SKIP_WITHOUT_DATA("Measured data are missing: set DYNCAL_DATA");
    const Eigen::VectorXd window = values->segment(1250, 2000).array() - values->tail(1000).mean();
    const auto result = analyseSpectra({responseOf(window, 50e3)}, {});
    describe(*result);
    QVERIFY(!result->resonances.empty());
    // independent ERA: 803.737 Hz; a bin is 25 Hz
    QVERIFY(std::abs(result->resonances[0].frequency_Hz - 803.737) < 0.8);
}

DYNCAL_TEST(TestPowerSpectrum)
#include "tst_power_spectrum.moc"
