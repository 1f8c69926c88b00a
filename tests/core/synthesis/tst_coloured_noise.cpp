// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/coloured_noise.h"
#include "tests/support/test_program.h"

#include "tests/core/synthesis/simulated_defect.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::vector<double> drawn(const NoiseKind &kind, Index count, std::uint64_t seed)
{
    std::vector<double> values(static_cast<std::size_t>(count), 0.0);
    NoiseSource(kind, count, RandomStream(seed, 1, 1)).addTo(values, 1.0);
    return values;
}

double covariance(const std::vector<double> &values, std::size_t lag)
{
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < values.size(); ++i)
        sum += values[i] * values[i + lag];
    return sum / static_cast<double>(values.size() - lag);
}

/// Half the mean square of the difference of neighbouring means over `length` samples.
double allanVariance(const std::vector<double> &values, std::size_t length)
{
    double sum = 0.0;
    double before = 0.0;
    const std::size_t blocks = values.size() / length;
    for (std::size_t b = 0; b < blocks; ++b) {
        double mean = 0.0;
        for (std::size_t i = b * length; i < (b + 1) * length; ++i)
            mean += values[i] / static_cast<double>(length);
        if (b > 0)
            sum += 0.5 * (mean - before) * (mean - before);
        before = mean;
    }
    return sum / static_cast<double>(blocks - 1);
}

} // namespace

/// Noise that is not white: its correlation, its spectrum, its first sample.
class TestColouredNoise : public QObject
{
    Q_OBJECT

private slots:
    void white_isTheStreamItself();
    void autoregressive_autocorrelation_data();
    void autoregressive_autocorrelation();
    void autoregressive_stationaryFromTheFirstSample();
    void flicker_allanVarianceDoesNotFall();
    void flicker_varianceOne();
    void blocks_doNotMatter();
    void record_noiseOfTheDutOnly();
};

void TestColouredNoise::white_isTheStreamItself()
{
    std::vector<double> expected(1000, 0.5);
    RandomStream(7, 2, 1).addNormal(expected, 0.3);
    std::vector<double> found(1000, 0.5);
    NoiseSource({}, 1000, RandomStream(7, 2, 1)).addTo(found, 0.3);
    QCOMPARE(found, expected);
}

void TestColouredNoise::autoregressive_autocorrelation_data()
{
    QTest::addColumn<double>("phi");
    for (const double phi : {0.9, 0.5, -0.7, 0.99})
        QTest::newRow(qPrintable(QString::number(phi))) << phi;
}

void TestColouredNoise::autoregressive_autocorrelation()
{
    QFETCH(double, phi);
    constexpr Index kCount = 400000;
    const std::vector<double> values = drawn({NoiseColour::Autoregressive, phi}, kCount, 11);
    // Bartlett: variance of an estimated covariance is at most sum over all lags of 2 phi^2|k|.
    const double sd
        = std::sqrt(2.0 * (1.0 + phi * phi) / (1.0 - phi * phi) / static_cast<double>(kCount));
    for (const std::size_t lag : {0u, 1u, 2u, 5u, 20u, 100u}) {
        const double expected = std::pow(phi, static_cast<double>(lag));
        QVERIFY2(std::abs(covariance(values, lag) - expected) < kSigmas * sd,
            qPrintable(
                QString("lag %1: %2 of %3").arg(lag).arg(covariance(values, lag)).arg(expected)));
    }
}

void TestColouredNoise::autoregressive_stationaryFromTheFirstSample()
{
    constexpr int kSeeds = 4000;
    double squares[2] = {};
    for (int seed = 0; seed < kSeeds; ++seed) {
        const std::vector<double> values
            = drawn({NoiseColour::Autoregressive, 0.99}, 20, static_cast<std::uint64_t>(seed));
        squares[0] += values.front() * values.front() / kSeeds;
        squares[1] += values.back() * values.back() / kSeeds;
    }
    for (const double square : squares)
        QVERIFY(std::abs(square - 1.0) < kSigmas * std::sqrt(2.0 / kSeeds));
}

void TestColouredNoise::flicker_allanVarianceDoesNotFall()
{
    // Of 1/f noise it does not depend on the length of the blocks (2 ln 2 times the density); of
    // white noise it would fall by two for every doubling. Mean of several records.
    constexpr Index kCount = 1 << 17;
    constexpr int kRecords = 8;
    std::vector<double> variances;
    for (std::size_t length = 16; length <= 1024; length *= 2) {
        double mean = 0.0;
        for (int r = 0; r < kRecords; ++r)
            mean += allanVariance(
                        drawn({NoiseColour::Flicker, 0.0}, kCount, static_cast<std::uint64_t>(r)),
                        length)
                / kRecords;
        variances.push_back(mean);
    }
    for (const double variance : variances)
        QVERIFY2(std::abs(variance / variances.front() - 1.0) < 0.15,
            qPrintable(QString("%1 of %2").arg(variance).arg(variances.front())));
}

void TestColouredNoise::flicker_varianceOne()
{
    // Over many records, as a single one does not hold its slowest part.
    constexpr int kSeeds = 4000;
    double first = 0.0;
    double last = 0.0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const std::vector<double> values
            = drawn({NoiseColour::Flicker, 0.0}, 500, static_cast<std::uint64_t>(seed));
        first += values.front() * values.front() / kSeeds;
        last += values.back() * values.back() / kSeeds;
    }
    QVERIFY(std::abs(first - 1.0) < kSigmas * std::sqrt(2.0 / kSeeds));
    QVERIFY(std::abs(last - 1.0) < kSigmas * std::sqrt(2.0 / kSeeds));
}

void TestColouredNoise::blocks_doNotMatter()
{
    for (const NoiseKind &kind : {NoiseKind{NoiseColour::Autoregressive, 0.9},
             NoiseKind{NoiseColour::Flicker, 0.0}, NoiseKind{}}) {
        const std::vector<double> whole = drawn(kind, 1000, 3);
        std::vector<double> parts(1000, 0.0);
        NoiseSource source(kind, 1000, RandomStream(3, 1, 1));
        const std::span<double> all(parts);
        source.addTo(all.subspan(0, 1), 1.0);
        source.addTo(all.subspan(1, 600), 1.0);
        source.addTo(all.subspan(601), 1.0);
        QCOMPARE(parts, whole);
    }
}

void TestColouredNoise::record_noiseOfTheDutOnly()
{
    const SimulatedCapture clean = simulated(withDefects({}));
    SimulationSettings settings = withDefects({"ar@1", "flicker@3"});
    settings.noise = 0.02;
    const SimulatedCapture capture = simulated(settings);
    QCOMPARE(capture.truth[0].at("noise_phi"), 0.9);
    QCOMPARE(capture.truth[2].at("noise_exponent"), -1.0);
    QVERIFY(capture.truth[1].count("noise_phi") == 0);
    for (std::size_t s = 0; s < 3; ++s)
        QCOMPARE(channelOf(capture, s, 1).sha256, channelOf(clean, s, 1).sha256);
    const Channel &dut = channelOf(capture, 0, 0);
    const Eigen::VectorXd values
        = physicalValues(dut, 0, 30000) / capture.truth[0].at("noise_sd_V");
    const double neighbours = values.head(29999).dot(values.tail(29999)) / 29999.0;
    QVERIFY(std::abs(neighbours - 0.9) < kSigmas * std::sqrt(2.0 * 1.81 / 0.19 / 3e4));
}

DYNCAL_TEST(TestColouredNoise)
#include "tst_coloured_noise.moc"
