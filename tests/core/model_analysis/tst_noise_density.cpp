// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/noise_density.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e7;

WindowedResponse responseOf(const Eigen::VectorXd &noise, double noiseSd = 0.0)
{
    WindowedResponse response;
    response.sampleRate_Hz = kRate_Hz;
    response.noise = noise;
    response.noiseSd = noiseSd;
    return response;
}

/// x_k = 0.9 x_(k-1) + e_k with unit e.
Eigen::VectorXd autoregressive(Index count, testing::Noise &noise)
{
    Eigen::VectorXd x = noise.series(count + 200, 1.0);
    for (Index k = 1; k < x.size(); ++k)
        x[k] += 0.9 * x[k - 1];
    return x.tail(count);
}

double densityOfAutoregressive(double f_Hz)
{
    return 1.0 / std::norm(1.0 - std::polar(0.9, -2.0 * M_PI * f_Hz / kRate_Hz));
}

/// Mean ratio of found to true density over 40 records.
template <typename Make>
double meanRatio(Make make, double truth, double f_Hz)
{
    double sum = 0.0;
    for (int trial = 0; trial < 40; ++trial)
        sum += NoiseDensity(responseOf(make())).at(f_Hz).variance / truth / 40.0;
    return sum;
}

} // namespace

class TestNoiseDensity : public QObject
{
    Q_OBJECT

private slots:
    void withoutARecord_noiseIsWhite_andKnown()
    {
        const NoiseDensity density(responseOf({}, 0.02));
        for (const double f_Hz : {1.0, 1e3, 4e6}) {
            QVERIFY(std::abs(density.at(f_Hz).variance - 4e-4) < 1e-15);
            QVERIFY(std::isinf(density.at(f_Hz).dof));
        }
        QVERIFY(std::abs(density.ofMean(100, 1000) - 4e-6) < 1e-17);
        QCOMPARE(density.ofMean(0, 10), 0.0);
        QCOMPARE(density.ofBaseline(), 0.0); // nothing is known of it
        QCOMPARE(NoiseDensity(responseOf({})).at(1e3).variance, 0.0);
    }

    void whiteNoise_isWhite()
    {
        testing::Noise noise(1);
        for (const double f_Hz : {1e3, 3e4, 1e6, 4e6}) {
            const double ratio = meanRatio([&] { return noise.series(20000, 0.3); }, 0.09, f_Hz);
            QVERIFY2(std::abs(ratio - 1.0) < 0.05, qPrintable(QString::number(ratio)));
        }
    }

    void autoregressiveNoise_hasItsDensity()
    {
        testing::Noise noise(2);
        for (const double f_Hz : {2e3, 3e4, 3e5, 1e6, 4e6}) {
            const double ratio = meanRatio(
                [&] { return autoregressive(20000, noise); }, densityOfAutoregressive(f_Hz), f_Hz);
            QVERIFY2(std::abs(ratio - 1.0) < 0.1, qPrintable(QString::number(ratio)));
        }
    }

    void slowNoise_isSeenAtLowFrequencies()
    {
        // A pole at 10 kHz beside white noise: a thousandth of the rate, which no model of few
        // coefficients resolves at full rate.
        testing::Noise noise(3);
        const double a = std::exp(-2.0 * M_PI * 1e4 / kRate_Hz);
        const auto make = [&] {
            Eigen::VectorXd slow = noise.series(60000, 1.0);
            for (Index k = 1; k < slow.size(); ++k)
                slow[k] += a * slow[k - 1];
            return Eigen::VectorXd(slow.tail(40000) + noise.series(40000, 20.0));
        };
        for (const double f_Hz : {5e3, 2e4, 1e5, 1e6}) {
            const double truth
                = 400.0 + 1.0 / std::norm(1.0 - std::polar(a, -2.0 * M_PI * f_Hz / kRate_Hz));
            const double ratio = meanRatio(make, truth, f_Hz);
            QVERIFY2(std::abs(ratio - 1.0) < 0.25, qPrintable(QString::number(ratio)));
        }
    }

    void flickerNoise_risesDownToTheLastBin()
    {
        // Sum of relaxations spread evenly in log f: 1/f between 300 Hz and 3 MHz.
        testing::Noise noise(8);
        const auto make = [&] {
            Eigen::VectorXd sum = Eigen::VectorXd::Zero(20000);
            for (double f_Hz = 300.0; f_Hz < 3e6; f_Hz *= 2.0) {
                const double a = std::exp(-2.0 * M_PI * f_Hz / kRate_Hz);
                double x = noise.next();
                for (Index k = 0; k < sum.size(); ++k) {
                    x = a * x + std::sqrt(1.0 - a * a) * noise.next();
                    sum[k] += x;
                }
            }
            return sum;
        };
        const auto truth = [](double at_Hz) {
            double density = 0.0;
            for (double f_Hz = 300.0; f_Hz < 3e6; f_Hz *= 2.0) {
                const double a = std::exp(-2.0 * M_PI * f_Hz / kRate_Hz);
                density += (1.0 - a * a)
                    / std::norm(1.0 - std::polar(a, -2.0 * M_PI * at_Hz / kRate_Hz));
            }
            return density;
        };
        for (const double f_Hz : {1e3, 3e3, 1e4, 4e4, 1e5, 1e6}) {
            const double ratio = meanRatio(make, truth(f_Hz), f_Hz);
            qInfo("%g Hz: ratio %.2f", f_Hz, ratio);
            QVERIFY2(ratio > 0.75 && ratio < 1.45, qPrintable(QString::number(ratio)));
        }
    }

    void meansOfSamples_scatterAsStated()
    {
        testing::Noise noise(4);
        const NoiseDensity density(responseOf(autoregressive(20000, noise)));
        double squares = 0.0;
        for (int trial = 0; trial < 300; ++trial)
            squares += std::pow(autoregressive(500, noise).mean(), 2) / 300.0;
        QVERIFY(std::abs(density.ofMean(500, 20000) / squares - 1.0) < 0.25);
        QVERIFY(std::abs(density.ofBaseline() / density.ofMean(20000, 20000) - 1.0) < 1e-12);
    }

    void rounding_isAdded()
    {
        testing::Noise noise(5);
        WindowedResponse response = responseOf(noise.series(5000, 1e-3), 2e-3);
        response.valueScale = 0.5; // noiseSd is in the unit of the recording
        response.roundingSd = 1e-4;
        const NoiseDensity density(response);
        QVERIFY(std::abs(density.at(1e6).variance / 16e-6 - 1.0) < 0.01);
        QVERIFY(std::abs((density.ofBaseline() - 1e-8) / density.ofMean(5000, 5000) - 1.0) < 1e-9);
    }

    void degreesOfFreedom_areThoseOfTheValuesThatTheModelIsOf()
    {
        testing::Noise noise(6);
        const NoiseDensity white(responseOf(noise.series(20000, 1.0)));
        for (const double f_Hz : {1e3, 1e5, 4e6})
            QVERIFY(white.at(f_Hz).dof > 900.0); // at most 20 coefficients
        Eigen::VectorXd slow = noise.series(20000, 1.0);
        for (Index k = 1; k < slow.size(); ++k)
            slow[k] += 0.998 * slow[k - 1];
        slow += noise.series(slow.size(), 30.0);
        const NoiseDensity density(responseOf(slow));
        QVERIFY(density.at(4e6).dof > 900.0);
        QVERIFY(density.at(1e3).dof < 30.0); // few bins of 500 Hz
        QVERIFY(density.at(1e3).dof > 1.0);
        QVERIFY(density.at(2e4).dof > density.at(2e3).dof);
    }

    void shortRecords_giveSomething()
    {
        testing::Noise noise(7);
        for (const Index count : {1, 2, 10, 99}) {
            const double variance
                = NoiseDensity(responseOf(noise.series(count, 1.0), 1.0)).at(1e3).variance;
            QVERIFY(std::isfinite(variance) && variance > 0.0);
        }
    }
};

DYNCAL_TEST(TestNoiseDensity)
#include "tst_noise_density.moc"
