// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/plot/values/record_samples.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace dyncal;

namespace {

constexpr Index kLength = 3'000'017;
constexpr double kRate_Hz = 1e8;
constexpr double kStart_s = -0.01;

Channel spiky(Index spike)
{
    std::mt19937 random(4);
    std::uniform_int_distribution<int> noise(-50, 50);
    std::vector<std::int16_t> counts(static_cast<std::size_t>(kLength));
    for (std::int16_t &count : counts)
        count = static_cast<std::int16_t>(noise(random));
    counts[static_cast<std::size_t>(spike)] = 20000;
    Channel channel;
    channel.role = ChannelRole::Dut;
    channel.samples = RawSamples(std::move(counts));
    channel.sampleRate_Hz = kRate_Hz;
    channel.t0_s = kStart_s;
    channel.polynomial = {0.1, 1e-4};
    channel.unit = "V";
    return channel;
}

std::shared_ptr<const ChannelEnvelope> envelopeOf(const Channel &channel)
{
    return std::make_shared<const ChannelEnvelope>(*ChannelEnvelope::build(channel));
}

std::vector<double> evenEdges(double from, double to, int columns)
{
    std::vector<double> edges;
    for (int k = 0; k <= columns; ++k)
        edges.push_back(from + (to - from) * k / columns);
    return edges;
}

CaptureSet setOf(const std::vector<Channel> &channels)
{
    CaptureSet set;
    for (const Channel &channel : channels) {
        Shot shot;
        shot.channels.push_back(channel);
        set.shots.push_back(shot);
    }
    return set;
}

} // namespace

class TestRecordSamples : public QObject
{
    Q_OBJECT

private slots:
    void indices_ofTimes_areThoseOfTheSamples();
    void samples_areConverted();
    void points_everyScale_showTheSpikeWhereItIs();
    void points_everyScale_areExtremesOfSamplesNearTheirColumn();
    void points_fewerSamplesThanColumns_areTheSamples();
    void points_ofFarTimes_endAndAreEmpty();
    void placeOf_anExtreme_isTheSample();
    void overview_wholeRecord_isExact();
    void overview_columns_areOfOneWidth();
    void rawCurves_withoutEnvelopeYet_showTheAxisAndNoPoints();
    void rawCurves_withEnvelope_carryTheRecord();
    void longRecords_areThoseOfPlottedRolesAndIncludedShots();
};

void TestRecordSamples::indices_ofTimes_areThoseOfTheSamples()
{
    const Channel channel = spiky(5);
    const RecordSamples record(envelopeOf(channel));
    for (const Index i : {Index(0), Index(1), Index(12345), Index(999999), kLength - 1}) {
        const double x = channel.timeOf_s(i);
        QCOMPARE(record.firstFrom(x), i);
        QCOMPARE(record.firstBeyond(x), i + 1);
        QCOMPARE(record.firstFrom(x + 0.5 / kRate_Hz), i + 1);
        QCOMPARE(record.firstBeyond(x - 0.5 / kRate_Hz), i);
    }
    QCOMPARE(record.firstFrom(-1e300), Index(0));
    QCOMPARE(record.firstFrom(1e300), kLength);
}

void TestRecordSamples::samples_areConverted()
{
    const Channel channel = spiky(1001);
    const RecordSamples record(envelopeOf(channel));
    const DrawnPoints points = record.samples(1000, 1003);
    QCOMPARE(points.y.size(), std::size_t(3));
    QCOMPARE(points.y[1], 0.1 + 1e-4 * 20000);
    QCOMPARE(points.x[2], channel.timeOf_s(1002));
    QVERIFY(record.samples(7, 7).x.empty());
}

void TestRecordSamples::points_everyScale_showTheSpikeWhereItIs()
{
    constexpr int kColumns = 800;
    for (const Index spike : {Index(0), Index(63), Index(64), Index(1'234'567), kLength - 1}) {
        const Channel channel = spiky(spike);
        const RecordSamples record(envelopeOf(channel));
        const double at = channel.timeOf_s(spike);
        for (double width = 5e-8; width < 0.1; width *= 1.7) {
            for (const double place : {0.01, 0.4, 0.99}) { // where in the view the spike is
                const double from = at - place * width;
                const DrawnPoints points = record.points(evenEdges(from, from + width, kColumns));
                const auto top = std::ranges::max_element(points.y);
                QCOMPARE(*top, 2.1);
                const double x = points.x[static_cast<std::size_t>(top - points.y.begin())];
                QVERIFY(std::abs(x - at) <= width / kColumns);
            }
        }
    }
}

void TestRecordSamples::points_everyScale_areExtremesOfSamplesNearTheirColumn()
{
    const Channel channel = spiky(1'500'000);
    const RecordSamples record(envelopeOf(channel));
    const Eigen::VectorXd all = physicalValues(channel, 0, kLength);
    constexpr int kColumns = 500;
    for (const double width : {3e-5, 3e-4, 3e-3, 0.03}) {
        const double from = 0.004 - 0.3 * width;
        const std::vector<double> edges = evenEdges(from, from + width, kColumns);
        const DrawnPoints points = record.points(edges);
        QVERIFY(points.enveloped);
        QVERIFY(points.x.size() <= 2 * kColumns);
        const double column = width / kColumns;
        for (std::size_t i = 0; i < points.x.size(); i += 2) {
            // At most a sixteenth of a column wider or narrower than the pixels say.
            const auto [low, high] = std::minmax({points.y[i], points.y[i + 1]});
            const auto stretch = [&](double half) {
                const Index begin = record.firstFrom(points.x[i] - half * column);
                const Index end = record.firstFrom(points.x[i] + half * column);
                return all.segment(begin, end - begin);
            };
            QVERIFY(low >= stretch(0.57).minCoeff() && high <= stretch(0.57).maxCoeff());
            QVERIFY(low <= stretch(0.43).minCoeff() && high >= stretch(0.43).maxCoeff());
        }
    }
}

void TestRecordSamples::points_fewerSamplesThanColumns_areTheSamples()
{
    const Channel channel = spiky(50);
    const RecordSamples record(envelopeOf(channel));
    const double from = channel.timeOf_s(40) + 0.1 / kRate_Hz;
    const DrawnPoints points = record.points(evenEdges(from, from + 20.0 / kRate_Hz, 1000));
    QVERIFY(!points.enveloped);
    QCOMPARE(points.x.size(), std::size_t(22)); // a neighbour at either side
    QCOMPARE(points.x.front(), channel.timeOf_s(40));
    QCOMPARE(points.y[10], 2.1);
}

void TestRecordSamples::points_ofFarTimes_endAndAreEmpty()
{
    // Times so late that samples share them: the search must still end.
    Channel channel = spiky(50);
    channel.t0_s = 1e15;
    const RecordSamples record(envelopeOf(channel));
    QVERIFY(record.points(evenEdges(-1.0, 1.0, 100)).y.size() <= 2);
    QVERIFY(!record.points(evenEdges(0.0, 2e15, 100)).x.empty());
}

void TestRecordSamples::placeOf_anExtreme_isTheSample()
{
    const Index spike = 1'234'567;
    const Channel channel = spiky(spike);
    const RecordSamples record(envelopeOf(channel));
    for (const double width : {1e-4, 1e-3, 0.03}) {
        const double from = channel.timeOf_s(spike) - 0.3 * width;
        const std::vector<double> edges = evenEdges(from, from + width, 100);
        const DrawnPoints points = record.points(edges);
        QVERIFY(points.enveloped);
        const auto top = std::ranges::max_element(points.y) - points.y.begin();
        const double x = points.x[static_cast<std::size_t>(top)];
        QCOMPARE(record.placeOf(x, 2.1, edges), channel.timeOf_s(spike));
        QCOMPARE(record.placeOf(from - 1.0, 2.1, edges), from - 1.0); // in no column
    }
}

void TestRecordSamples::overview_wholeRecord_isExact()
{
    const Channel channel = spiky(kLength - 1);
    const RecordSamples record(envelopeOf(channel));
    const DrawnPoints whole = record.overview(1000);
    QVERIFY(whole.x.size() <= 2000 && whole.x.size() > 1900);
    QVERIFY(std::ranges::is_sorted(whole.x));
    QCOMPARE(whole.y.back(), 2.1);
    QCOMPARE(std::ranges::min(whole.y), physicalValues(channel, 0, kLength).minCoeff());
}

/// Whatever the length: what does not divide evenly is no long last column.
void TestRecordSamples::overview_columns_areOfOneWidth()
{
    for (const Index length : {Index(30'000), Index(7'999), Index(8'001), kLength}) {
        Channel channel = spiky(kLength - 1);
        channel.samples
            = RawSamples(std::vector<std::int16_t>(static_cast<std::size_t>(length), 1));
        const RecordSamples record(envelopeOf(channel));
        const DrawnPoints whole = record.overview(4000);
        const double even_s = static_cast<double>(length) / kRate_Hz / 4000.0;
        double widest_s = 0.0;
        for (std::size_t i = 2; i < whole.x.size(); ++i)
            widest_s = std::max(widest_s, whole.x[i] - whole.x[i - 1]);
        const double grain_s = static_cast<double>(EnvelopePyramid::kBaseBlock) / kRate_Hz;
        QVERIFY2(
            widest_s <= 2.0 * (even_s + grain_s), qPrintable(QString::number(widest_s / even_s)));
    }
}

void TestRecordSamples::rawCurves_withoutEnvelopeYet_showTheAxisAndNoPoints()
{
    const CaptureSet set = setOf({spiky(5)});
    const PlotContent content
        = rawCurves(set, ChannelRole::Dut, [](const Channel &) { return nullptr; });
    QCOMPARE(content.curves.size(), std::size_t(1));
    QVERIFY(content.curves[0].x.empty() && !content.curves[0].record);
    QCOMPARE(*content.xMin, kStart_s);
    QCOMPARE(*content.xMax, set.shots[0].channels[0].timeOf_s(kLength - 1));
}

void TestRecordSamples::rawCurves_withEnvelope_carryTheRecord()
{
    const CaptureSet set = setOf({spiky(5)});
    const PlotContent content = rawCurves(
        set, ChannelRole::Dut, [](const Channel &channel) { return envelopeOf(channel); });
    QVERIFY(content.curves[0].record != nullptr);
    QCOMPARE(content.curves[0].record->size(), kLength);
    QCOMPARE(std::ranges::max(content.curves[0].y), 2.1);
    // Without a place for envelopes, as reports have none, it is the extremes alone.
    const PlotContent printed = rawCurves(set, ChannelRole::Dut);
    QVERIFY(!printed.curves[0].record);
    QCOMPARE(printed.curves[0].y, content.curves[0].y);
}

void TestRecordSamples::longRecords_areThoseOfPlottedRolesAndIncludedShots()
{
    Channel shortOne = spiky(5);
    shortOne.samples = shortOne.samples.inMemory(0, 100);
    Channel trigger = spiky(5);
    trigger.role = ChannelRole::Trigger;
    Channel noRate = spiky(5);
    noRate.sampleRate_Hz = 0.0;
    CaptureSet set = setOf({spiky(5), shortOne, trigger, noRate, spiky(6)});
    QCOMPARE(longRecords(set).size(), std::size_t(2));
    set.shots[4].included = false;
    QCOMPARE(longRecords(set).size(), std::size_t(1));
    QVERIFY(longRecords(set)[0].samples.sharesWith(set.shots[0].channels[0].samples));
}

DYNCAL_TEST(TestRecordSamples)
#include "tst_record_samples.moc"
