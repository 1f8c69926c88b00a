// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_envelope.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;

namespace {

constexpr Index kLength = 20000;

Channel channelOf(RawSamples samples, std::vector<double> polynomial)
{
    Channel channel;
    channel.samples = std::move(samples);
    channel.polynomial = std::move(polynomial);
    channel.sampleRate_Hz = 1e6;
    return channel;
}

std::vector<std::int16_t> randomCounts(int reach)
{
    std::mt19937 random(5);
    std::uniform_int_distribution<int> count(-reach, reach);
    std::vector<std::int16_t> counts(kLength);
    for (std::int16_t &each : counts)
        each = static_cast<std::int16_t>(count(random));
    return counts;
}

/// Largest and smallest of the converted samples one by one.
SampleExtremes bruteForce(const Channel &channel, Index begin, Index end)
{
    SampleExtremes found;
    for (const double value : physicalValues(channel, begin, end - begin)) {
        if (!std::isfinite(value)) {
            found.invalid = true;
            continue;
        }
        found.min = found.any ? std::min(found.min, value) : value;
        found.max = found.any ? std::max(found.max, value) : value;
        found.any = true;
    }
    return found;
}

void compareStretches(const Channel &channel)
{
    const auto envelope = ChannelEnvelope::build(channel);
    QVERIFY(envelope.has_value());
    const std::vector<Index> edges{0, 1, 64, 100, 100, 5000, 5003, 12800, kLength};
    const auto found = envelope->stretches(edges);
    QVERIFY(found.has_value());
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
        const SampleExtremes expected = bruteForce(channel, edges[k], edges[k + 1]);
        QCOMPARE((*found)[k].any, expected.any);
        QCOMPARE((*found)[k].min, expected.min);
        QCOMPARE((*found)[k].max, expected.max);
    }
    const SampleExtremes all = bruteForce(channel, 0, kLength);
    QCOMPARE(envelope->extremes().min, all.min);
    QCOMPARE(envelope->extremes().max, all.max);
}

} // namespace

/// Extremes of converted samples are those of each sample converted, whatever the conversion.
class TestChannelEnvelope : public QObject
{
    Q_OBJECT

private slots:
    void stretches_anyConversion_equalConvertedSamples_data();
    void stretches_anyConversion_equalConvertedSamples();
    void stretches_conversionThatTurns_findsTheTurn();
    void of_otherScale_needsNoReading();
    void of_otherRecordOrTurningConversion_isNothing();
    void isMonotone_knownPolynomials_data();
    void isMonotone_knownPolynomials();
    void isMonotone_provenOnes_riseOrFallOnAGrid();
    void conversion_toInfinity_isNoNumber();
};

void TestChannelEnvelope::stretches_anyConversion_equalConvertedSamples_data()
{
    QTest::addColumn<std::vector<double>>("polynomial");
    QTest::addColumn<double>("scale");
    QTest::newRow("line") << std::vector<double>{0.5, 3e-4} << 1.0;
    QTest::newRow("falling line") << std::vector<double>{0.5, -3e-4} << 2.0;
    QTest::newRow("inverted by the operator") << std::vector<double>{0.5, 3e-4} << -2.0;
    QTest::newRow("constant") << std::vector<double>{0.5} << 1.0;
    QTest::newRow("nothing") << std::vector<double>{} << 1.0;
    QTest::newRow("rising parabola") << std::vector<double>{0.0, 1.0, 1e-6} << 1.0;
    QTest::newRow("parabola that turns") << std::vector<double>{0.0, 1.0, 1e-3} << 1.0;
    QTest::newRow("cubic that rises") << std::vector<double>{0.0, 1.0, 0.0, 1e-8} << 1.0;
    QTest::newRow("cubic that turns twice") << std::vector<double>{0.0, -1.0, 0.0, 1e-7} << 1.0;
    QTest::newRow("fourth power") << std::vector<double>{0.0, 0.0, 0.0, 0.0, 1e-9} << -1.0;
}

void TestChannelEnvelope::stretches_anyConversion_equalConvertedSamples()
{
    QFETCH(std::vector<double>, polynomial);
    QFETCH(double, scale);
    Channel channel = channelOf(RawSamples(randomCounts(8000)), polynomial);
    channel.userScale = std::abs(scale);
    channel.polarity = scale < 0.0 ? -1.0 : 1.0;
    compareStretches(channel);
}

void TestChannelEnvelope::stretches_conversionThatTurns_findsTheTurn()
{
    // The greatest value, at count 0, is at neither extreme of the counts.
    std::vector<std::int16_t> counts(kLength, 50);
    counts[777] = 0;
    counts[778] = -60;
    const auto envelope = ChannelEnvelope::build(channelOf(RawSamples(counts), {3.0, 0.0, -1.0}));
    const auto found = *envelope->stretches(std::vector<Index>{0, 777, 778, 779});
    QCOMPARE(found[0].max, 3.0 - 2500.0);
    QCOMPARE(found[1].max, 3.0);
    QCOMPARE(found[2].min, 3.0 - 3600.0);
    QCOMPARE(envelope->extremes().max, 3.0);
}

void TestChannelEnvelope::of_otherScale_needsNoReading()
{
    const Channel channel = channelOf(RawSamples(randomCounts(100)), {0.0, 1.0});
    const auto envelope = ChannelEnvelope::build(channel);
    Channel other = channel;
    other.polynomial = {1.0, -2.0};
    other.userScale = 3.0;
    other.unit = "bar";
    const auto rescaled = envelope->of(other);
    QVERIFY(rescaled.has_value());
    QCOMPARE(rescaled->extremes().min, bruteForce(other, 0, kLength).min);
    QCOMPARE(rescaled->channel().unit, std::string("bar"));

    // An envelope of converted values serves only that conversion.
    Channel turning = channel;
    turning.polynomial = {0.0, 0.0, 1.0};
    const auto ofValues = ChannelEnvelope::build(turning);
    turning.t0_s = -1.0;
    QVERIFY(ofValues->of(turning).has_value());
    turning.userScale = 2.0;
    QVERIFY(!ofValues->of(turning).has_value());
}

void TestChannelEnvelope::of_otherRecordOrTurningConversion_isNothing()
{
    const Channel channel = channelOf(RawSamples(randomCounts(100)), {0.0, 1.0});
    const auto envelope = ChannelEnvelope::build(channel);
    QVERIFY(!envelope->of(channelOf(RawSamples(randomCounts(100)), {0.0, 1.0})).has_value());
    Channel turning = channel;
    turning.polynomial = {0.0, 0.0, 1.0};
    QVERIFY(!envelope->of(turning).has_value());
}

void TestChannelEnvelope::isMonotone_knownPolynomials_data()
{
    QTest::addColumn<std::vector<double>>("polynomial");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<bool>("monotone");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("none") << std::vector<double>{} << -1.0 << 1.0 << true;
    QTest::newRow("constant") << std::vector<double>{2.0} << -1.0 << 1.0 << true;
    QTest::newRow("line") << std::vector<double>{0.0, -1.0} << -1.0 << 1.0 << true;
    QTest::newRow("parabola over its turn") << std::vector<double>{0, 0, 1} << -1.0 << 1.0 << false;
    QTest::newRow("parabola beside it") << std::vector<double>{0, 0, 1} << 0.0 << 1.0 << true;
    QTest::newRow("turn just inside") << std::vector<double>{0, 0, 1} << -1e-6 << 1.0 << false;
    QTest::newRow("cubic") << std::vector<double>{0, 1, 0, 1} << -0.5 << 0.5 << true;
    QTest::newRow("not proven") << std::vector<double>{0, 1, 0, 1} << -5.0 << 5.0 << false;
    QTest::newRow("cubic with turns") << std::vector<double>{0, -1, 0, 1} << -1.0 << 1.0 << false;
    QTest::newRow("single point") << std::vector<double>{0, 0, 1} << 3.0 << 3.0 << true;
    QTest::newRow("NaN") << std::vector<double>{0, nan} << 0.0 << 1.0 << false;
}

void TestChannelEnvelope::isMonotone_knownPolynomials()
{
    QFETCH(std::vector<double>, polynomial);
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(bool, monotone);
    QCOMPARE(isMonotone(polynomial, low, high), monotone);
}

void TestChannelEnvelope::isMonotone_provenOnes_riseOrFallOnAGrid()
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int proven = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> polynomial;
        for (int k = 0; k < 2 + trial % 4; ++k)
            polynomial.push_back(normal(random));
        const auto [low, high] = std::minmax({normal(random), normal(random)});
        if (!isMonotone(polynomial, low, high))
            continue;
        ++proven;
        const Channel channel = channelOf(RawSamples(), polynomial);
        const double sign
            = physicalValue(channel, high) >= physicalValue(channel, low) ? 1.0 : -1.0;
        constexpr int kSteps = 500;
        constexpr double kRounding = 1e-12;
        double before = sign * physicalValue(channel, low);
        for (int i = 1; i <= kSteps; ++i) {
            const double now = sign * physicalValue(channel, low + (high - low) * i / kSteps);
            QVERIFY(now >= before - kRounding);
            before = now;
        }
    }
    QVERIFY(proven > 500);
}

void TestChannelEnvelope::conversion_toInfinity_isNoNumber()
{
    const auto envelope = ChannelEnvelope::build(
        channelOf(RawSamples(std::vector<double>(kLength, 1e300)), {0.0, 1e300}));
    QVERIFY(!envelope->extremes().any);
    QVERIFY(envelope->extremes().invalid);
}

DYNCAL_TEST(TestChannelEnvelope)
#include "tst_channel_envelope.moc"
