// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What becomes of one record on its way to a model: its time, its noise and its rounding.

#include "core/realization/input/series_making.h"
#include "core/realization/input/series_source.h"
#include "tests/support/model_inputs.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr Index kLead = 300, kLength = 4000;

/// A response that is e^(s t) from the start on, with as many samples before it as are asked for.
WindowedResponse decayFrom(double s_rad_s, const Eigen::VectorXd &noise = {})
{
    WindowedResponse response;
    response.shot = 3;
    response.sampleRate_Hz = kRate_Hz;
    response.lead = kLead;
    response.length = kLength;
    response.values = Eigen::VectorXd::NullaryExpr(kLead + kLength + 100,
        [&](Index k) { return std::exp(s_rad_s * static_cast<double>(k - kLead) / kRate_Hz); });
    response.noise = noise;
    return response;
}

SeriesSource sourceOf(const std::vector<WindowedResponse> &responses)
{
    return seriesSources(responses, {}, CombineMethod::Stacked).front();
}

AntiAliasFilter unfiltered()
{
    return designAntiAliasFilter(1.0, kRate_Hz);
}

double sdOf(const Eigen::VectorXd &x)
{
    return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

} // namespace

class TestSeriesMaking : public QObject
{
    Q_OBJECT

private slots:
    /// Wherever the input begins and however it is reduced: a value is that of its own time.
    void everySample_hasTheTimeItIsSaidToHave_data()
    {
        QTest::addColumn<double>("factor");
        QTest::addColumn<int>("first");
        QTest::newRow("as recorded, at the start") << 1.0 << 300;
        QTest::newRow("as recorded, behind it") << 1.0 << 357;
        QTest::newRow("a tenth of the rate") << 10.0 << 420;
        QTest::newRow("a tenth, before the filter is in") << 10.0 << 300;
        QTest::newRow("a fraction") << 2.5 << 401;
    }
    void everySample_hasTheTimeItIsSaidToHave()
    {
        QFETCH(double, factor);
        QFETCH(int, first);
        constexpr double kDecay_rad_s = -2e4;
        const std::vector<WindowedResponse> responses{decayFrom(kDecay_rad_s)};
        const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz);
        const ModelSeries series = makeSeries(sourceOf(responses), filter, first, 50);
        QCOMPARE(series.y.size(), Index(50));
        QVERIFY(std::abs(series.first_s - (first - kLead) / kRate_Hz) < 1e-15);
        const double gain = filter.gain(kDecay_rad_s).real();
        for (Index k = 0; k < 50; ++k) {
            const double t_s = series.first_s + static_cast<double>(k) * factor / kRate_Hz;
            const double tolerance = factor == std::floor(factor) ? 1e-12 : 2e-3;
            QVERIFY(isNear(series.y[k], gain * std::exp(kDecay_rad_s * t_s), tolerance));
        }
    }

    /// The same stretch at the record's own rate: from the start to the last value's sample.
    void fullRate_reachesFromTheStartToTheLastValue()
    {
        const std::vector<WindowedResponse> responses{decayFrom(-1e4)};
        for (const double factor : {1.0, 2.5, 10.0}) {
            const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz);
            const ModelSeries series = makeSeries(sourceOf(responses), filter, 400, 31);
            QCOMPARE(series.fullRate_Hz, kRate_Hz);
            QCOMPARE(series.fullRate[0], responses[0].values[kLead]);
            const auto behind = static_cast<Index>(std::floor(30.0 * factor));
            QCOMPARE(series.fullRate.size(), 400 - kLead + behind + 1);
            QCOMPARE(series.fullRate.tail(1)[0], responses[0].values[400 + behind]);
        }
    }

    /// White noise keeps as much of its power as the squares of the taps sum to.
    void whiteNoise_isReducedByTheFilter()
    {
        testing::Noise noise(4);
        const std::vector<WindowedResponse> responses{decayFrom(-1e4, noise.series(200000, 0.02))};
        const AntiAliasFilter filter = designAntiAliasFilter(10.0, kRate_Hz);
        const ModelSeries series = makeSeries(sourceOf(responses), filter, 420, 40);
        QVERIFY(isNear(series.fullRateNoiseSd, 0.02, 0.01));
        QVERIFY(isNear(series.noiseSd, 0.02 * filter.taps.norm(), 0.02));
        QVERIFY(isNear(sdOf(series.noise), series.noiseSd, 1e-12));
        // Outputs whose filters do not touch the noise's ends.
        QVERIFY(std::abs(static_cast<double>(series.noise.size())
                    - (200000.0 - static_cast<double>(filter.taps.size())) / 10.0)
            <= 1.0);
    }

    /// Too short to be filtered: what the filter would leave of white noise.
    void shortNoise_isTakenForWhite()
    {
        testing::Noise noise(5);
        const std::vector<WindowedResponse> responses{decayFrom(-1e4, noise.series(150, 0.02))};
        const AntiAliasFilter filter = designAntiAliasFilter(10.0, kRate_Hz);
        const ModelSeries series = makeSeries(sourceOf(responses), filter, 420, 40);
        QCOMPARE(series.noise.size(), Index(0));
        QVERIFY(isNear(series.noiseSd, sdOf(responses[0].noise) * filter.taps.norm(), 1e-12));
    }

    void noNoise_isUnknown()
    {
        const std::vector<WindowedResponse> responses{decayFrom(-1e4)};
        const ModelSeries series = makeSeries(sourceOf(responses), unfiltered(), 300, 40);
        QCOMPARE(series.noiseSd, 0.0);
        QCOMPARE(series.fullRateNoiseSd, 0.0);
        QCOMPARE(series.u_baseline, 0.0);
        QCOMPARE(series.fullRateNoise.count, Index(0));
        QVERIFY(!roundingCounts(series));
    }

    /// Of white noise the mean is uncertain by sd/sqrt(n); of noise that remembers, by sd of the
    /// innovation over (1 - a) sqrt(n).
    void baseline_isUncertainByTheNoisesMean()
    {
        testing::Noise noise(6);
        const Eigen::VectorXd white = noise.series(40000, 0.01);
        Eigen::VectorXd red(white.size());
        red[0] = white[0];
        for (Index k = 1; k < red.size(); ++k)
            red[k] = 0.8 * red[k - 1] + white[k];
        const auto uOf = [](const Eigen::VectorXd &of) {
            const std::vector<WindowedResponse> responses{decayFrom(-1e4, of)};
            return makeSeries(sourceOf(responses), unfiltered(), 300, 40).u_baseline;
        };
        QVERIFY(isNear(uOf(white), 0.01 / 200.0, 0.05));
        QVERIFY(isNear(uOf(red), 0.01 / 200.0 / 0.2, 0.1));
    }

    /// A converter's step of q has the standard deviation q/sqrt(12), which no quiet record hides.
    void rounding_isTheLeastNoise()
    {
        testing::Noise noise(7);
        WindowedResponse response = decayFrom(-1e4, noise.series(5000, 1e-6));
        response.resolution = 0.12;
        response.valueScale = -4.0; // remapped, of a step downwards
        response.roundingSd = 0.002;
        const std::vector<WindowedResponse> responses{response};
        const SeriesSource source = sourceOf(responses);
        QVERIFY(isNear(source.leastNoiseSd, 0.03 / std::sqrt(12.0), 1e-12));
        const ModelSeries series = makeSeries(source, unfiltered(), 300, 40);
        QVERIFY(isNear(series.fullRateNoiseSd, 0.03 / std::sqrt(12.0), 1e-12));
        QCOMPARE(series.roundingSd, 0.002);
        QVERIFY(isNear(series.noiseSd, std::hypot(sdOf(response.noise), 0.002), 1e-9));
        QVERIFY(series.u_baseline >= 0.002);
        QVERIFY(roundingCounts(series));
        // Errors that last: lag 1 is nearly lag 0, without what is new at each sample.
        const double lasting = 0.002 * 0.002;
        const Eigen::VectorXd &covariance = series.fullRateNoise.values;
        QVERIFY(covariance[0] > lasting + 0.9 * std::pow(0.03, 2) / 12.0);
        QVERIFY(covariance[1] < lasting && covariance[1] > 0.7 * lasting);
        for (Index lag = 2; lag < covariance.size(); ++lag)
            QVERIFY(covariance[lag] > 0.0 && covariance[lag] < covariance[lag - 1]);
    }

    /// Far below the noise rounding leaves its covariance as it is.
    void roundingBelowTheNoise_changesNothing()
    {
        testing::Noise noise(8);
        WindowedResponse response = decayFrom(-1e4, noise.series(5000, 0.01));
        response.resolution = response.roundingSd = 1e-6;
        const std::vector<WindowedResponse> responses{response};
        const ModelSeries series = makeSeries(sourceOf(responses), unfiltered(), 300, 40);
        QVERIFY(!roundingCounts(series));
        const NoiseCovariance alone = noiseCovariance(response.noise, kLargestNoiseModelOrder);
        QCOMPARE(series.fullRateNoise.values, alone.values);
    }
};

DYNCAL_TEST(TestSeriesMaking)
#include "tst_series_making.moc"
