// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Incomplete, damaged and hostile TDMS files: what is whole is kept and said to be less, nothing
// crashes, hangs or allocates what a header claims.

#include "tests/core/capture/formats/tdms/tdms_test_support.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>

#include <sys/resource.h>

#include <functional>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Segment = TdmsSegment;

constexpr std::uint32_t kFresh = Segment::kMetaData | Segment::kNewList | Segment::kRawData;
constexpr const char *kA = "/'group'/'a'";
constexpr const char *kB = "/'group'/'b'";

/// Refusals take far less; the slack is for a busy machine (bar R6: 100 ms, 64 MiB).
constexpr qint64 kLongestRefusal_ms = 1000;
constexpr long kMostMemory_KiB = 64 * 1024;

/// Peak memory of this process so far.
long peakMemory_KiB()
{
    struct rusage usage
    {
    };
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

Segment twoChannels(std::uint32_t contents, std::uint64_t rows)
{
    Segment segment(contents);
    segment.channel<std::int16_t>(kA, rows).channel<std::int32_t>(kB, rows);
    return segment;
}

/// A small file with all that a real one has; channel a counts up from 0, b down.
std::string smallFile()
{
    Segment first = twoChannels(kFresh, 3);
    first.property("wf_increment", 1e-6).property("unit_string", "V");
    for (int chunk = 0; chunk < 2; ++chunk) {
        for (int i = 0; i < 3; ++i)
            first.data().add(static_cast<std::int16_t>(3 * chunk + i));
        for (int i = 0; i < 3; ++i)
            first.data().add(-(3 * chunk + i));
    }
    Segment second = twoChannels(kFresh | Segment::kInterleaved, 4);
    for (int i = 6; i < 10; ++i)
        second.data().add(static_cast<std::int16_t>(i)).add(-i);
    return first.bytes() + second.bytes();
}

/// Values count up (or down) without a gap: nothing but a beginning of what was written.
bool isBeginning(const std::vector<double> &values, double sign)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != sign * static_cast<double>(i))
            return false;
    }
    return values.size() <= 10;
}

/// Complete values of channels a and b in the first `bytes` of smallFile().
std::pair<std::size_t, std::size_t> completeValues(std::size_t bytes)
{
    const std::string file = smallFile();
    constexpr std::size_t kSecondRows = 4 * 6;
    const std::size_t secondBegin = file.find("TDSm", 4);
    const std::size_t firstData = secondBegin - 2 * 3 * 6;
    const std::size_t secondData = file.size() - kSecondRows;
    const auto within = [&](std::size_t begin, std::size_t size, std::size_t most) {
        return bytes <= begin ? 0 : std::min((bytes - begin) / size, most);
    };
    std::size_t a = 0;
    std::size_t b = 0;
    for (std::size_t chunk = 0; chunk < 2; ++chunk) {
        a += within(firstData + chunk * 18, 2, 3);
        b += within(firstData + chunk * 18 + 6, 4, 3);
    }
    const std::size_t rows = within(secondData, 6, 4);
    return {a + rows, b + rows};
}

/// Bytes of a lead-in with what follows.
std::string withLead(const std::string &metadata, std::uint64_t next, std::uint64_t data)
{
    TdmsBytes file;
    file.raw("TDSm").add(kFresh).add<std::uint32_t>(4713).add(next).add(data).raw(metadata);
    return file.bytes();
}

} // namespace

class TestTdmsDamage : public QObject
{
    Q_OBJECT

private slots:
    void truncated_atEveryByte_keepsAllCompleteValues()
    {
        const std::string whole = smallFile();
        for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
            const auto set = m_folder.read(whole.substr(0, bytes));
            const std::string where = std::to_string(bytes) + " bytes: " + sentence(set);
            const auto [a, b] = completeValues(bytes);
            QVERIFY2(valuesIn(set, "a").size() == a, where.c_str());
            QVERIFY2(valuesIn(set, "b").size() == b, where.c_str());
            QVERIFY2(isBeginning(valuesIn(set, "a"), 1.0), where.c_str());
            QVERIFY2(isBeginning(valuesIn(set, "b"), -1.0), where.c_str());
            // Between two segments nothing shows that there was another one.
            const bool atBoundary = bytes == whole.find("TDSm", 4);
            QVERIFY2(!set || atBoundary || hasFinding(set->findings, "CAP-018"), where.c_str());
        }
        QVERIFY(!hasFinding(m_folder.read(whole)->findings, "CAP-018"));
    }

    void unclosedSegment_isReadToTheEndOfTheFile()
    {
        Segment segment = twoChannels(kFresh, 2);
        segment.data().all<std::int16_t>({1, 2}).all<std::int32_t>({3, 4});
        segment.data().all<std::int16_t>({5, 6}).all<std::int32_t>({7});
        const auto set = m_folder.read(segment.bytes(Segment::kUnclosed));
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2, 5, 6));
        QCOMPARE(valuesIn(set, "b"), numbers(3, 4, 7));
        const Finding *finding = findingWith(set->findings, "CAP-018");
        QVERIFY(finding != nullptr);
        QCOMPARE(finding->severity, Severity::Caution);
        QCOMPARE(finding->channel, std::string("b"));
        QCOMPARE(finding->value, std::optional(3.0));
        QCOMPARE(finding->limit, std::optional(4.0));
        QVERIFY(contains(english(finding->message), "3 of 4 samples"));
    }

    void segmentBeyondTheFile_saysHowMuchIsMissing()
    {
        Segment segment(kFresh);
        segment.channel<std::int16_t>(kA, 100);
        segment.data().all<std::int16_t>({1, 2, 3});
        const auto set = m_folder.read(segment.bytes(segment.metadata().size() + 1000));
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2, 3));
        QCOMPARE(findingWith(set->findings, "CAP-018")->limit, std::optional(500.0));
    }

    void closedSegmentWithLessData_sharesItOut()
    {
        Segment segment = twoChannels(kFresh, 4);
        segment.data().all<std::int16_t>({1, 2}).all<std::int32_t>({3, 4});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2));
        QCOMPARE(valuesIn(set, "b"), numbers(3, 4));
        QVERIFY(hasFinding(set->findings, "CAP-018"));
    }

    void textsInACutChunk_areDroppedWithWhatFollows()
    {
        Segment segment(kFresh);
        segment.channel<std::int16_t>(kA, 2);
        segment.object("/'group'/'t'", segment.textIndex(1, 10)).channel<std::int16_t>(kB, 1);
        segment.data().all<std::int16_t>({1, 2}).raw("123456");
        const auto set = m_folder.read(segment.bytes(Segment::kUnclosed));
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2));
        QVERIFY(channelNamed(set->shots[0], "b") == nullptr);
    }

    void damageLater_keepsWhatStandsBefore_data()
    {
        QTest::addColumn<QByteArray>("behind");
        const auto row = [](const char *name, const std::string &bytes) {
            QTest::newRow(name) << QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size()));
        };
        row("no tag", std::string(64, 'x'));
        row("objects that are not there", withLead(TdmsBytes().add(9U).bytes(), 4, 4));
        row("data behind the end", withLead(std::string(8, '\0'), 4, 8));
        Segment type(kFresh);
        type.channel<double>(kA, 1);
        type.data().add(1.0);
        row("other type", type.bytes());
        Segment unknown(kFresh);
        unknown.object("/'group'/'z'", unknown.asBefore());
        row("as before, but nothing was", unknown.bytes());
        Segment uneven(kFresh | Segment::kInterleaved);
        uneven.channel<std::int16_t>(kA, 1).channel<std::int32_t>(kB, 2);
        uneven.data().add<std::int16_t>(1).add(2).add(3);
        row("interleaved of different lengths", uneven.bytes());
        Segment twice(kFresh); // found by fuzzing: the second description has another type
        twice.channel<std::int32_t>(kB, 1).object(kB, twice.index(0, 1));
        twice.data().add(1);
        row("one object twice", twice.bytes());
    }

    void damageLater_keepsWhatStandsBefore()
    {
        QFETCH(QByteArray, behind);
        Segment segment(kFresh);
        segment.channel<std::int16_t>(kA, 2);
        segment.data().all<std::int16_t>({1, 2});
        const std::string first = segment.bytes();
        const auto set = m_folder.read(first + behind.toStdString());
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2));
        const Finding *finding = findingWith(set->findings, "CAP-018");
        QVERIFY(finding != nullptr && finding->severity == Severity::Caution);
        QVERIFY(contains(english(finding->message), "byte " + std::to_string(first.size())));
        // Where it comes first, the file is refused, unless it is sound by itself.
        const auto other = m_folder.read(behind.toStdString() + first);
        QVERIFY(!other.has_value() || valuesIn(other, "a") == numbers(1.0));
    }

    void damagedSegment_changesNoScale()
    {
        Segment segment(kFresh);
        segment.channel<std::int16_t>(kA, 1).property("wf_increment", 1e-3);
        segment.data().add<std::int16_t>(1);
        Segment bad(Segment::kMetaData);
        bad.object(kA).property("wf_increment", 5.0).object("no path");
        const auto set = m_folder.read(segment.bytes() + bad.bytes());
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 1000.0);
    }

    void emptyAndTinyFiles_areRefused()
    {
        for (const std::size_t bytes : {0U, 3U, 4U, 20U, 28U}) {
            const auto set = m_folder.read(smallFile().substr(0, bytes));
            QVERIFY(!set.has_value());
            QVERIFY(bytes < 4 || contains(sentence(set), "no data"));
        }
    }

    void bombs_areRefusedAtOnce_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char *name, const std::string &bytes) {
            QTest::newRow(name) << QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size()));
        };
        const auto alone = [](const TdmsBytes &metadata) {
            return withLead(metadata.bytes(), metadata.bytes().size(), metadata.bytes().size());
        };
        const auto object = [] { return TdmsBytes().add(1U).text(kA); };
        row("objects", alone(TdmsBytes().add(0xFFFFFFFFU).raw(std::string(1000, '\0'))));
        row("properties", alone(object().add(0xFFFFFFFFU).add(0xFFFFFFFFU)));
        row("path", alone(TdmsBytes().add(1U).add(0xFFFFFFFFU)));
        row("name", alone(object().add(0xFFFFFFFFU).add(1U).add(0x7FFFFFFFU)));
        row("scalers",
            alone(object()
                      .add(0x1269U)
                      .add(0xFFFFFFFFU)
                      .add(1U)
                      .add<std::uint64_t>(1)
                      .add(0xFFFFFFFFU)));
        row("metadata beyond the file", withLead("", Segment::kUnclosed, std::uint64_t{1} << 62));
        row("all ones", "TDSm" + std::string(64, '\xFF'));
        row("all zeros", "TDSm" + std::string(64, '\0'));
    }

    void bombs_areRefusedAtOnce()
    {
        QFETCH(QByteArray, bytes);
        const long before = peakMemory_KiB();
        QElapsedTimer clock;
        clock.start();
        const auto set = m_folder.read(bytes.toStdString());
        QVERIFY(!set.has_value());
        QVERIFY(clock.elapsed() < kLongestRefusal_ms);
        QVERIFY(peakMemory_KiB() - before < kMostMemory_KiB);
    }

    void claimedSamples_areNotBelieved()
    {
        constexpr std::uint64_t kClaim = 0x7FFFFFFFFFFFFFFF;
        for (const std::uint64_t claim : {kClaim, ~std::uint64_t{0}, std::uint64_t{1} << 46}) {
            for (const bool closed : {true, false}) {
                Segment segment(kFresh);
                segment.channel<double>(kA, claim).channel<double>(kB, claim);
                segment.data().add(1.0).add(2.0);
                const auto set
                    = m_folder.read(closed ? segment.bytes() : segment.bytes(Segment::kUnclosed));
                QVERIFY(valuesIn(set, "a").size() <= 2);
                QVERIFY(!closed || valuesIn(set, "a").size() <= 1);
            }
        }
    }

    void millionProperties_areQuickToRefuse()
    {
        constexpr std::uint32_t kProperties = 1'000'000;
        TdmsBytes metadata;
        metadata.add(1U).text(kA).add(0xFFFFFFFFU).add(kProperties);
        for (std::uint32_t i = 0; i < kProperties; ++i)
            metadata.text(std::string("p").append(std::to_string(i))).add(3U).add(i);
        const auto size = metadata.bytes().size();
        const std::string path = m_folder.write(withLead(metadata.bytes(), size, size));
        QElapsedTimer clock;
        clock.start();
        QVERIFY(!readTdms(path, {}, {}).has_value());
        QVERIFY(clock.elapsed() < kLongestRefusal_ms);
    }

    /// A log that appends one sample at a time: as many segments as samples.
    void manyTinySegments_takeLinearTimeAndLittleMemory()
    {
        constexpr int kSegments = 200'000;
        Segment first(kFresh);
        first.channel<std::int16_t>(kA, 1).channel<std::int16_t>(kB, 1);
        first.data().add<std::int16_t>(0).add<std::int16_t>(0);
        std::string bytes = first.bytes();
        for (int i = 1; i < kSegments; ++i) {
            Segment segment(Segment::kRawData);
            segment.data().add(static_cast<std::int16_t>(i % 30000));
            segment.data().add(static_cast<std::int16_t>(-(i % 30000)));
            bytes += segment.bytes();
        }
        const std::string path = m_folder.write(bytes);
        const long before = peakMemory_KiB();
        QElapsedTimer clock;
        clock.start();
        const auto set = readTdms(path, {}, {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QVERIFY(clock.elapsed() < 5 * kLongestRefusal_ms);
        QVERIFY(peakMemory_KiB() - before < kMostMemory_KiB);
        const std::vector<double> values = valuesIn(set, "b");
        QCOMPARE(std::ssize(values), std::ptrdiff_t{kSegments});
        for (int i = 0; i < kSegments; ++i)
            QCOMPARE(values[static_cast<std::size_t>(i)], -static_cast<double>(i % 30000));
        QVERIFY(clock.elapsed() < 10 * kLongestRefusal_ms);
    }

    void endlessLists_areGivenUp()
    {
        // 20000 channels with one value each, listed once; then segments without any data of them.
        Segment first(kFresh);
        for (int i = 0; i < 20000; ++i)
            first.channel<std::int8_t>("/'g'/'" + std::to_string(i) + "'", 1000);
        std::string bytes = first.bytes();
        for (int i = 0; i < 20000; ++i) {
            Segment segment(Segment::kRawData);
            segment.data().add<std::int8_t>(1);
            bytes += segment.bytes();
        }
        const std::string path = m_folder.write(bytes);
        QElapsedTimer clock;
        clock.start();
        readTdms(path, {}, {}); // read in part or refused, but soon
        QVERIFY(clock.elapsed() < 5 * kLongestRefusal_ms);
    }

    void daqmxChannelsOfTheSameBytes_areRefused()
    {
        Segment segment(kFresh);
        for (int i = 0; i < 1000; ++i)
            segment.object("/'g'/'" + std::to_string(i) + "'",
                segment.daqmx(4, {TdmsWriterScaler{3, 0, 0, 0}}, {2}));
        segment.data().all<std::int16_t>({1, 2, 3, 4});
        const auto set = m_folder.read(segment.bytes());
        QVERIFY(!set && findingId(set) == "CAP-018");
    }

    void cancelled_readingStops()
    {
        std::stop_source source;
        source.request_stop();
        const auto set = readTdms(m_folder.write(smallFile()), {}, {source.get_token(), {}});
        QVERIFY(!set && set.error().kind == ErrorKind::Cancelled);
    }

    /// Whatever bytes change, samples that are given out can be read or the file is refused.
    void mutants_neitherCrashNorPromiseWhatIsNotThere()
    {
        constexpr int kMutants = 3000;
        constexpr Index kMostSamples = 1000; // the file has 60 bytes of data
        std::mt19937_64 random(20260101);
        int read = 0;
        for (int i = 0; i < kMutants; ++i) {
            const auto set = m_folder.read(mutant(smallFile(), random));
            if (!set) {
                QCOMPARE(set.error().kind, ErrorKind::FileUnreadable);
                continue;
            }
            ++read;
            QVERIFY(!set->shots.empty());
            for (const Shot &shot : set->shots) {
                for (const Channel &channel : shot.channels) {
                    QVERIFY(channel.samples.size() < kMostSamples);
                    QCOMPARE(std::ssize(rawValuesOf(channel)), channel.samples.size());
                }
            }
        }
        qInfo("mutants read: %d of %d", read, kMutants);
        QVERIFY(read > kMutants / 10 && read < kMutants);
    }

private:
    static std::string mutant(std::string bytes, std::mt19937_64 &random)
    {
        constexpr std::array<char, 6> kNasty{'\0', '\xFF', '\x7F', '\x80', '\x01', ' '};
        const auto changes = 1 + random() % 4;
        for (std::uint64_t k = 0; k < changes; ++k) {
            const std::size_t place = random() % bytes.size();
            switch (random() % 5) {
            case 0:
                bytes[place] = static_cast<char>(random());
                break;
            case 1:
                bytes[place] = kNasty[random() % kNasty.size()];
                break;
            case 2:
                bytes.erase(place, 1 + random() % 8);
                break;
            case 3:
                bytes.insert(place, bytes.substr(random() % bytes.size(), random() % 40));
                break;
            default:
                bytes[place] = static_cast<char>(bytes[place] ^ (1 << (random() % 8)));
            }
            if (bytes.size() < 8)
                return "TDSm" + bytes;
        }
        return bytes;
    }

    TdmsFolder m_folder;
};

DYNCAL_TEST(TestTdmsDamage)
#include "tst_tdms_damage.moc"
