// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/record_starts.h"
#include "tests/support/test_program.h"

#include "tests/support/signals.h"

#include <QtTest>

using namespace dyncal;

namespace {

Channel stepAt(const char *name, ChannelRole role, Index sample)
{
    testing::Gaussian noise(static_cast<std::uint64_t>(sample));
    std::vector<double> values(4000);
    for (Index i = 0; i < std::ssize(values); ++i)
        values[static_cast<std::size_t>(i)] = (i >= sample ? 1.0 : 0.0) + 0.005 * noise();
    Channel channel;
    channel.name = name;
    channel.role = role;
    channel.sampleRate_Hz = 1e6;
    channel.samples = RawSamples(RawSamples::Counts(std::move(values)));
    return channel;
}

CaptureSet twoShots()
{
    CaptureSet set;
    for (const Index late : {0, 100}) {
        Shot shot;
        shot.channels = {stepAt("far", ChannelRole::Other, 1000 + late),
            stepAt("side", ChannelRole::DrivenSide, 1500 + late),
            stepAt("sensor", ChannelRole::Dut, 2000 + late)};
        set.shots.push_back(shot);
    }
    return set;
}

} // namespace

class TestRecordStarts : public QObject
{
    Q_OBJECT

private slots:
    void dutAndSide_areFoundInEveryShot()
    {
        const CaptureSet set = twoShots();
        const RecordStarts starts = detectStarts(set, {}).value();
        for (Index shot = 1; shot <= 2; ++shot) {
            const Shot &records = set.shots[static_cast<std::size_t>(shot - 1)];
            for (const std::size_t channel : {1, 2}) {
                const DetectedStart *start = starts.of(set, shot, &records.channels[channel]);
                QVERIFY(start != nullptr);
                // the very same as asked for alone
                QCOMPARE(start->sample, detectStart(records.channels[channel])->sample);
                QCOMPARE(start->threshold, detectStart(records.channels[channel])->threshold);
            }
            QVERIFY(starts.of(set, shot, &records.channels[0]) == nullptr); // nobody asked
        }
    }

    void others_byNameOrRole()
    {
        CaptureSet set = twoShots();
        QVERIFY(detectStarts(set, {"far"})->of(set, 2, &set.shots[1].channels[0]));
        set.shots[0].channels[0].role = ChannelRole::Trigger;
        QVERIFY(detectStarts(set, {"trigger"})->of(set, 1, &set.shots[0].channels[0]));
        QVERIFY(detectStarts(set, {"no such"}).has_value());
    }

    void excludedShotAndSilentRecord_haveNone()
    {
        CaptureSet set = twoShots();
        set.shots[0].included = false;
        set.shots[1].channels[2] = stepAt("sensor", ChannelRole::Dut, 100000); // only noise
        set.shots[1].channels[1].sampleRate_Hz = 0.0;
        const RecordStarts starts = detectStarts(set, {}).value();
        for (Index shot = 1; shot <= 2; ++shot) {
            for (const Channel &channel : set.shots[static_cast<std::size_t>(shot - 1)].channels)
                QVERIFY(starts.of(set, shot, &channel) == nullptr);
        }
    }

    void askedForWhatIsNotThere_isNull()
    {
        const CaptureSet set = twoShots();
        const RecordStarts starts = detectStarts(set, {}).value();
        QVERIFY(starts.of(set, 3, &set.shots[0].channels[0]) == nullptr);
        QVERIFY(starts.of(set, 1, nullptr) == nullptr);
        QVERIFY(starts.of(set, 1, &set.shots[1].channels[2]) == nullptr); // another shot's
        QVERIFY(RecordStarts().of(set, 1, &set.shots[0].channels[2]) == nullptr);
    }

    void stopped_isCancelled()
    {
        std::stop_source source;
        source.request_stop();
        const auto result = detectStarts(twoShots(), {}, {source.get_token(), {}});
        QVERIFY(!result && result.error().kind == ErrorKind::Cancelled);
    }
};

DYNCAL_TEST(TestRecordStarts)
#include "tst_record_starts.moc"
