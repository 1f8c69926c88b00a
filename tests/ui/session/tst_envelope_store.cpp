// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/envelope_store.h"

#include <QSignalSpy>
#include <QtTest>

#include <atomic>

using namespace dyncal;

namespace {

constexpr Index kLength = 3 * RawSamples::kBlock;

/// Counts how often it is read, and may be out of reach.
class CountedSource : public SampleSource
{
public:
    bool read(Index, Index count, std::byte *target) const override
    {
        ++reads;
        std::fill(target, target + 2 * count, std::byte(1));
        return reachable;
    }
    mutable std::atomic<int> reads = 0;
    std::atomic<bool> reachable = true;
};

Channel channelOf(const std::shared_ptr<const SampleSource> &source)
{
    Channel channel;
    channel.samples = RawSamples(source, SampleType::Int16, kLength);
    channel.sampleRate_Hz = 1e8;
    return channel;
}

} // namespace

class TestEnvelopeStore : public QObject
{
    Q_OBJECT

private slots:
    void wanted_isBuiltInTheBackground();
    void wantedAgain_isNotReadAgain();
    void otherScale_isThereAtOnce();
    void severalRecords_comeOneByOne_andProgressRises();
    void noLongerWanted_isForgotten();
    void unreadable_isTriedOnce();
    void deleted_whileBuilding_stops();
};

void TestEnvelopeStore::wanted_isBuiltInTheBackground()
{
    EnvelopeStore store;
    QVERIFY(!store.isBusy());
    QCOMPARE(store.progress(), 1.0);
    const Channel channel = channelOf(std::make_shared<CountedSource>());
    store.want({channel});
    QVERIFY(store.isBusy());
    QVERIFY(!store.find(channel)); // never on this thread
    QTRY_VERIFY(!store.isBusy());
    QVERIFY(store.find(channel) != nullptr);
    QCOMPARE(store.find(channel)->extremes().max, 257.0);
    QCOMPARE(store.progress(), 1.0);
}

void TestEnvelopeStore::wantedAgain_isNotReadAgain()
{
    EnvelopeStore store;
    const auto source = std::make_shared<CountedSource>();
    const Channel channel = channelOf(source);
    for (int i = 0; i < 5; ++i) // every refresh of a page asks
        store.want({channel});
    QTRY_VERIFY(!store.isBusy());
    store.want({channel});
    QVERIFY(!store.isBusy());
    QCOMPARE(source->reads.load(), 3);
}

void TestEnvelopeStore::otherScale_isThereAtOnce()
{
    EnvelopeStore store;
    Channel channel = channelOf(std::make_shared<CountedSource>());
    store.want({channel});
    QTRY_VERIFY(!store.isBusy());
    channel.userScale = -2.0;
    QVERIFY(!store.find(channel));
    store.want({channel});
    QVERIFY(!store.isBusy());
    QCOMPARE(store.find(channel)->extremes().max, -514.0);
}

void TestEnvelopeStore::severalRecords_comeOneByOne_andProgressRises()
{
    EnvelopeStore store;
    std::vector<Channel> channels;
    for (int i = 0; i < 3; ++i)
        channels.push_back(channelOf(std::make_shared<CountedSource>()));
    std::vector<double> progress;
    std::vector<int> there;
    connect(&store, &EnvelopeStore::changed, this, [&] {
        progress.push_back(store.progress());
        there.push_back(static_cast<int>(std::ranges::count_if(
            channels, [&](const Channel &channel) { return store.find(channel) != nullptr; })));
    });
    store.want(channels);
    QTRY_VERIFY(!store.isBusy());
    QVERIFY(std::ranges::is_sorted(progress));
    QVERIFY(std::ranges::is_sorted(there));
    QVERIFY(std::ranges::find(there, 1) != there.end()); // not all at the end
    QCOMPARE(there.back(), 3);
    QCOMPARE(progress.back(), 1.0);
}

void TestEnvelopeStore::noLongerWanted_isForgotten()
{
    EnvelopeStore store;
    const auto source = std::make_shared<CountedSource>();
    {
        const Channel channel = channelOf(source);
        store.want({channel});
        QTRY_VERIFY(!store.isBusy());
        store.want({});
        QVERIFY(!store.find(channel));
    }
    QCOMPARE(source.use_count(), 1L);
}

void TestEnvelopeStore::unreadable_isTriedOnce()
{
    EnvelopeStore store;
    const auto source = std::make_shared<CountedSource>();
    source->reachable = false;
    const Channel gone = channelOf(source);
    const Channel good = channelOf(std::make_shared<CountedSource>());
    store.want({gone, good});
    QTRY_VERIFY(!store.isBusy());
    QVERIFY(!store.find(gone));
    QVERIFY(store.find(good) != nullptr);
    store.want({gone, good});
    QVERIFY(!store.isBusy());
    QCOMPARE(source->reads.load(), 1);
}

void TestEnvelopeStore::deleted_whileBuilding_stops()
{
    for (int i = 0; i < 20; ++i) {
        EnvelopeStore store;
        store.want({channelOf(std::make_shared<CountedSource>())});
        QTest::qWait(i % 3);
    }
}

DYNCAL_TEST(TestEnvelopeStore)
#include "tst_envelope_store.moc"
