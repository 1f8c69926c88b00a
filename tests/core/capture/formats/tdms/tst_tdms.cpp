// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_types.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/formats/tdms/tdms_test_support.h"
#include "tests/support/test_program.h"

#include <complex>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Segment = TdmsSegment;

constexpr std::uint32_t kFresh = Segment::kMetaData | Segment::kNewList | Segment::kRawData;
constexpr std::uint32_t kGoesOn = Segment::kMetaData | Segment::kRawData;
constexpr const char *kA = "/'group'/'a'";
constexpr const char *kB = "/'group'/'b'";
constexpr const char *kC = "/'group'/'c'";

/// One channel of a random file: its type by number, and the values written so far.
struct ModelChannel
{
    std::string path;
    std::string name;
    std::uint32_t type = 2;
    std::vector<double> values;
    std::uint64_t count = 0; ///< per chunk, in the current list
    bool listed = false;
};

/// Writes a random value of a type and returns it as number.
double addRandom(TdmsBytes &bytes, std::uint32_t type, std::mt19937_64 &random)
{
    const auto add = [&]<typename T>(T) {
        std::uint64_t bits = random();
        T value;
        if constexpr (std::is_floating_point_v<T>)
            value = static_cast<T>(static_cast<std::int64_t>(bits)) / T(3e9);
        else
            value = static_cast<T>(bits);
        bytes.add(value);
        return static_cast<double>(value);
    };
    switch (type) {
    case 1:
        return add(std::int8_t());
    case 2:
        return add(std::int16_t());
    case 3:
        return add(std::int32_t());
    case 5:
        return add(std::uint8_t());
    case 6:
        return add(std::uint16_t());
    case 7:
        return add(std::uint32_t());
    case 9:
        return add(float());
    default:
        return add(double());
    }
}

/// A file of random segments and what must be read from it.
class RandomFile
{
public:
    explicit RandomFile(std::uint64_t seed)
        : m_random(seed)
    {
        constexpr std::array<std::uint32_t, 8> kTypes{1, 2, 3, 5, 6, 7, 9, 10};
        const auto channels = 1 + below(5);
        for (std::uint64_t i = 0; i < channels; ++i) {
            ModelChannel channel;
            channel.name = std::string("c").append(std::to_string(i));
            channel.path = "/'g'/'" + channel.name + "'";
            channel.type = kTypes[below(kTypes.size())];
            m_channels.push_back(channel);
        }
        const auto segments = 1 + below(12);
        for (std::uint64_t i = 0; i < segments; ++i)
            addSegment(i == 0);
    }

    const std::string &bytes() const { return m_bytes; }
    const std::vector<ModelChannel> &channels() const { return m_channels; }

private:
    std::uint64_t below(std::uint64_t end) { return m_random() % end; }

    void addSegment(bool first)
    {
        const bool metadata = first || below(3) > 0;
        const bool newList = metadata && (first || below(2) == 0);
        if (metadata)
            m_interleaved = below(2) == 0;
        std::uint32_t contents = Segment::kRawData;
        contents |= metadata ? Segment::kMetaData : 0U;
        contents |= newList ? Segment::kNewList : 0U;
        contents |= m_interleaved ? Segment::kInterleaved : 0U;
        contents |= below(2) == 0 ? Segment::kBigEndian : 0U;
        Segment segment(contents);
        if (metadata)
            listObjects(segment, newList);
        const auto chunks = below(4);
        for (std::uint64_t chunk = 0; chunk < chunks; ++chunk)
            addChunk(segment);
        m_bytes += segment.bytes();
    }

    void listObjects(Segment &segment, bool newList)
    {
        if (newList) {
            for (const std::size_t i : m_order)
                m_channels[i].listed = false;
            m_order.clear();
        }
        const auto rows = 1 + below(20); // interleaved channels have equal lengths
        for (std::size_t i = 0; i < m_channels.size(); ++i) {
            ModelChannel &channel = m_channels[i];
            // Without a new list the objects of the old one stay, so all are given the new length.
            if (!channel.listed && below(3) == 0)
                continue;
            channel.count = m_interleaved ? rows : 1 + below(20);
            segment.object(channel.path, segment.index(channel.type, channel.count));
            if (!channel.listed)
                m_order.push_back(i);
            channel.listed = true;
        }
    }

    void addChunk(Segment &segment)
    {
        if (m_interleaved && !m_order.empty()) {
            for (std::uint64_t row = 0; row < m_channels[m_order[0]].count; ++row) {
                for (const std::size_t i : m_order)
                    addValue(segment, m_channels[i]);
            }
            return;
        }
        for (const std::size_t i : m_order) {
            for (std::uint64_t k = 0; k < m_channels[i].count; ++k)
                addValue(segment, m_channels[i]);
        }
    }

    void addValue(Segment &segment, ModelChannel &channel)
    {
        channel.values.push_back(addRandom(segment.data(), channel.type, m_random));
    }

    std::mt19937_64 m_random;
    std::vector<ModelChannel> m_channels;
    std::vector<std::size_t> m_order;
    bool m_interleaved = false;
    std::string m_bytes;
};
} // namespace

class TestTdms : public QObject
{
    Q_OBJECT

private slots:
    void contiguous_manyChunks_areOneRecordPerChannel()
    {
        Segment segment;
        segment.channel<std::int16_t>(kA, 2).channel<float>(kB, 1);
        for (int chunk = 0; chunk < 5; ++chunk) {
            segment.data().add(static_cast<std::int16_t>(2 * chunk));
            segment.data().add(static_cast<std::int16_t>(2 * chunk + 1));
            segment.data().add(static_cast<float>(chunk) / 4);
        }
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
        QCOMPARE(valuesIn(set, "b"), numbers(0.0, 0.25, 0.5, 0.75, 1.0));
        QCOMPARE(set->shots[0].channels[0].samples.type(), SampleType::Int16);
        QCOMPARE(set->shots[0].channels[1].samples.type(), SampleType::Float32);
        QVERIFY(!set->shots[0].channels[0].samples.isInMemory());
        QVERIFY(!hasFinding(set->findings, "CAP-018"));
    }

    void interleavedBigEndian_mixedWidths_areTakenApart()
    {
        Segment segment(kFresh | Segment::kInterleaved | Segment::kBigEndian);
        segment.version = 4712;
        segment.channel<std::int8_t>(kA, 3).channel<double>(kB, 3).channel<std::uint16_t>(kC, 3);
        for (int row = 0; row < 6; ++row) {
            segment.data().add(static_cast<std::int8_t>(-row));
            segment.data().add(row + 0.125);
            segment.data().add(static_cast<std::uint16_t>(60000 + row));
        }
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(0, -1, -2, -3, -4, -5));
        QCOMPARE(valuesIn(set, "b"), numbers(0.125, 1.125, 2.125, 3.125, 4.125, 5.125));
        QCOMPARE(valuesIn(set, "c"), numbers(60000, 60001, 60002, 60003, 60004, 60005));
    }

    /// Every combination of order, lists, interleaving, byte order and chunks that comes up: the
    /// expected values are those that were written.
    void randomFiles_giveEveryValueWritten()
    {
        constexpr int kFiles = 400;
        Index values = 0;
        for (std::uint64_t seed = 0; seed < kFiles; ++seed) {
            const RandomFile file(seed);
            const auto set = m_folder.read(file.bytes());
            for (const ModelChannel &channel : file.channels()) {
                const std::string where
                    = "seed " + std::to_string(seed) + " " + channel.name + sentence(set);
                QVERIFY2(valuesIn(set, channel.name) == channel.values, where.c_str());
                values += std::ssize(channel.values);
            }
        }
        QVERIFY(values > 10000);
    }

    /// Whatever part of a record is asked for is that part of the whole.
    void anyStretch_isPartOfTheWhole()
    {
        std::mt19937_64 random(7);
        for (std::uint64_t seed = 1000; seed < 1060; ++seed) {
            const RandomFile file(seed);
            const auto set = m_folder.read(file.bytes());
            for (int i = 0; set && i < 20; ++i) {
                const auto &channels = set->shots[0].channels;
                const Channel &channel = channels[random() % channels.size()];
                const std::vector<double> all = rawValuesOf(channel);
                const auto begin = static_cast<Index>(random() % all.size());
                const auto end
                    = begin + static_cast<Index>(random() % (all.size() - std::size_t(begin) + 1));
                QCOMPARE(rawValuesOf(channel.samples, begin, end),
                    std::vector<double>(all.begin() + begin, all.begin() + end));
            }
        }
    }

    void lists_goOnWithNewLengthsAndWithoutData()
    {
        Segment first;
        first.channel<std::int16_t>(kA, 1).channel<std::int16_t>(kB, 1);
        first.data().all<std::int16_t>({1, 10});
        Segment longer(kGoesOn); // b grows, a stays
        longer.channel<std::int16_t>(kB, 2);
        longer.data().all<std::int16_t>({2, 11, 12});
        Segment without(kGoesOn); // a takes a break
        without.object(kA);
        without.data().all<std::int16_t>({13, 14});
        Segment back(kGoesOn); // a is as before, and stands where it stood
        back.object(kA, back.asBefore()).channel<std::int16_t>(kC, 1);
        back.data().all<std::int16_t>({3, 15, 16, 100});
        Segment repeated(Segment::kRawData);
        repeated.data().all<std::int16_t>({4, 17, 18, 101});
        const auto set = m_folder.read(
            first.bytes() + longer.bytes() + without.bytes() + back.bytes() + repeated.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2, 3, 4));
        QCOMPARE(valuesIn(set, "b"), numbers(10, 11, 12, 13, 14, 15, 16, 17, 18));
        QCOMPARE(valuesIn(set, "c"), numbers(100, 101));
    }

    void newList_remembersTheLastIndexOfAnObject()
    {
        Segment first;
        first.channel<std::int16_t>(kA, 2).channel<std::int16_t>(kB, 1);
        first.data().all<std::int16_t>({1, 2, 10});
        Segment onlyB;
        onlyB.object(kB, onlyB.asBefore());
        onlyB.data().all<std::int16_t>({11, 12});
        Segment swapped;
        swapped.object(kB, swapped.asBefore()).object(kA, swapped.asBefore());
        swapped.data().all<std::int16_t>({13, 3, 4});
        const auto set = m_folder.read(first.bytes() + onlyB.bytes() + swapped.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2, 3, 4));
        QCOMPARE(valuesIn(set, "b"), numbers(10, 11, 12, 13));
    }

    void padding_behindMetadata_isPassedOver()
    {
        Segment segment;
        segment.channel<std::int16_t>(kA, 2);
        const std::string meta = segment.metadata() + std::string(100, 'x');
        TdmsBytes file;
        file.raw("TDSm").add(kFresh).add<std::uint32_t>(4713);
        file.add<std::uint64_t>(meta.size() + 4).add<std::uint64_t>(meta.size()).raw(meta);
        file.all<std::int16_t>({5, 6});
        QCOMPARE(valuesIn(m_folder.read(file.bytes()), "a"), numbers(5, 6));
    }

    void integersWithoutSampleType_becomeExactDoubles()
    {
        Segment segment;
        segment.channel<std::uint32_t>(kA, 2).channel<std::int64_t>(kB, 2);
        segment.channel<std::uint64_t>(kC, 2);
        constexpr std::int64_t kLargest = std::int64_t{1} << 53;
        segment.data().all<std::uint32_t>({4294967295U, 7});
        segment.data().all<std::int64_t>({-kLargest, 3});
        segment.data().all<std::uint64_t>({static_cast<std::uint64_t>(kLargest), 0});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(4294967295.0, 7));
        QCOMPARE(valuesIn(set, "b"), numbers(-kLargest, 3));
        QCOMPARE(valuesIn(set, "c"), numbers(kLargest, 0));
        QCOMPARE(set->shots[0].channels[0].samples.type(), SampleType::Float64);
    }

    void integersBeyondDouble_areRefusedByName()
    {
        Segment segment;
        segment.channel<std::int64_t>("/'group'/'clock'", 1);
        segment.data().add((std::int64_t{1} << 53) + 1);
        const auto set = m_folder.read(segment.bytes());
        QVERIFY(!set && contains(sentence(set), "clock") && contains(sentence(set), "2^53"));
        Segment negative;
        negative.channel<std::uint64_t>("/'group'/'clock'", 1);
        negative.data().add(~std::uint64_t{0});
        QVERIFY(!m_folder.read(negative.bytes()));
    }

    void truthValues_areZeroAndOne()
    {
        Segment segment;
        segment.channel<bool>(kA, 4);
        segment.data().all<std::uint8_t>({0, 1, 255, 2});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(0, 1, 1, 1));
        QCOMPARE(set->shots[0].channels[0].samples.type(), SampleType::UInt8);
    }

    void floatsWithUnit_areFloats()
    {
        Segment segment;
        segment.object(kA, segment.index(0x19, 1)).object(kB, segment.index(0x1A, 1));
        segment.data().add(1.5F).add(2.5);
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(1.5));
        QCOMPARE(valuesIn(set, "b"), numbers(2.5));
        QCOMPARE(set->shots[0].channels[0].samples.type(), SampleType::Float32);
    }

    void valuesThatAreNoSamples_areLeftOutAndNamed()
    {
        Segment segment;
        segment.object("/'group'/'remark'", segment.textIndex(2, 4 * 2 + 5));
        segment.channel<TdmsTime>("/'group'/'clock'", 1);
        segment.object("/'group'/'wave'", segment.index(0x08000C, 1));
        segment.channel<std::int16_t>(kA, 2).object("/'group'/'empty'");
        segment.data().all<std::uint32_t>({2, 5}).raw("abcde").add(TdmsTime{1, 2});
        segment.data().add(1.0F).add(2.0F).all<std::int16_t>({7, 8});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(7, 8));
        QCOMPARE(set->shots[0].channels.size(), std::size_t{1});
        std::string all;
        for (const Finding &finding : set->findings)
            all += finding.id == "CAP-026" ? english(finding.message) : std::string();
        for (const char *name : {"remark", "clock", "wave", "empty"})
            QVERIFY2(contains(all, name), name);
    }

    void textsOnly_areRefused()
    {
        Segment segment;
        segment.object("/'group'/'remark'", segment.textIndex(1, 5));
        segment.data().add<std::uint32_t>(1).raw("x");
        const auto set = m_folder.read(segment.bytes());
        QVERIFY(!set && contains(sentence(set), "remark") && contains(sentence(set), "text"));
        QCOMPARE(findingId(set), std::string("CAP-018"));
    }

    void unknownTypes_areRefusedByName()
    {
        for (const std::uint32_t type : {0x0BU, 0x1BU, 0x4FU, 77U, 0xFFFFFFFFU}) {
            Segment segment;
            segment.object("/'group'/'odd'", segment.index(type, 1));
            segment.data().add(0.0).add(0.0);
            const auto set = m_folder.read(segment.bytes());
            QVERIFY(!set && contains(sentence(set), "odd"));
        }
    }

private:
    TdmsFolder m_folder;
};

DYNCAL_TEST(TestTdms)
#include "tst_tdms.moc"
