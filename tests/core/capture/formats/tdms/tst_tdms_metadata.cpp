// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Paths, property values and lists of objects, as they were written and cut at every byte.

#include "core/capture/formats/tdms/tdms_metadata.h"
#include "tests/support/memory_file.h"
#include "tests/support/tdms_writer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <random>

using namespace dyncal;
using testing::TdmsSegment;

namespace {

std::string quoted(const std::string &name)
{
    std::string text = "/'";
    for (const char c : name)
        text.append(c == '\'' ? 2 : 1, c);
    return text + "'";
}

using Objects = tl::expected<std::vector<TdmsObjectEntry>, TdmsProblem>;

Objects objectsIn(const std::string &bytes, bool bigEndian = false)
{
    const testing::MemoryFile file(bytes.data(), bytes.size());
    const auto source = *SampleFile::open(file.path());
    TdmsCursor cursor(*source);
    cursor.setByteOrder(bigEndian ? std::endian::big : std::endian::little);
    return readTdmsObjects(cursor);
}

/// One of every kind of property and of index.
TdmsSegment everything(bool bigEndian)
{
    const std::uint32_t order = bigEndian ? TdmsSegment::kBigEndian : 0U;
    TdmsSegment segment(TdmsSegment::kMetaData | TdmsSegment::kNewList | order);
    segment.object("/");
    segment.property("i8", std::int8_t(-128)).property("u8", std::uint8_t(255));
    segment.property("i16", std::int16_t(-2)).property("u16", std::uint16_t(65535));
    segment.property("i32", std::numeric_limits<std::int32_t>::min());
    segment.property("u32", std::uint32_t(4000000000));
    segment.property("i64", std::numeric_limits<std::int64_t>::min());
    segment.property("u64", std::numeric_limits<std::uint64_t>::max());
    segment.property("f32", 0.1F).property("f64", -0.1).property("truth", true);
    segment.property("text", "a\nb").property("empty", "");
    segment.property("time", testing::TdmsTime{-5, 7});
    segment.object("/'g'/'plain'", segment.index(2, 1000));
    segment.object("/'g'/'same'", segment.asBefore());
    segment.object("/'g'/'texts'", segment.textIndex(3, 77));
    segment.object("/'g'/'daqmx'", segment.daqmx(50, {{3, 0, 2, 9}, {5, 1, 4, 8}}, {8, 16}));
    return segment;
}

} // namespace

class TestTdmsMetadata : public QObject
{
    Q_OBJECT

private slots:
    void anyName_comesBackFromItsPath()
    {
        std::mt19937_64 random(2);
        const std::string letters = "'/ a\xC3\xA5";
        const auto name = [&] {
            std::string text;
            for (auto i = random() % 6; i > 0; --i)
                text += letters[random() % letters.size()];
            return text;
        };
        for (int trial = 0; trial < 3000; ++trial) {
            const std::string group = name();
            const std::string channel = name();
            const auto one = parseTdmsPath(quoted(group));
            QVERIFY(one && one->level == TdmsLevel::Group && one->group == group);
            const auto two = parseTdmsPath(quoted(group) + quoted(channel));
            QVERIFY(two && two->level == TdmsLevel::Channel);
            QCOMPARE(two->group, group);
            QCOMPARE(two->channel, channel);
        }
        QCOMPARE(parseTdmsPath("/")->level, TdmsLevel::File);
    }

    void textsThatAreNoPath_areNone()
    {
        for (const char *text : {"", "g", "/g", "//", "/'", "/'g", "/'g'x", "/'g'/", "/'g'/'",
                 "'g'", "/'g'/'c'/'d'", "/'g'/'c'x", "/'g''", "/'g'/'c''", " /'g'", "/'g''/'c'"})
            QVERIFY2(!parseTdmsPath(text), text);
    }

    void everyValue_isAsItWasWritten_data()
    {
        QTest::addColumn<bool>("bigEndian");
        QTest::newRow("little endian") << false;
        QTest::newRow("big endian") << true;
    }
    void everyValue_isAsItWasWritten()
    {
        QFETCH(bool, bigEndian);
        const Objects objects = objectsIn(everything(bigEndian).metadata(), bigEndian);
        QVERIFY(objects.has_value());
        QCOMPARE(objects->size(), std::size_t(5));
        const auto &list = objects->front().properties;
        const TdmsProperties properties(list.begin(), list.end());
        const std::vector<std::pair<const char *, TdmsValue>> expected{{"i8", std::int64_t(-128)},
            {"u8", std::uint64_t(255)}, {"i16", std::int64_t(-2)}, {"u16", std::uint64_t(65535)},
            {"i32", std::int64_t(-2147483648LL)}, {"u32", std::uint64_t(4000000000)},
            {"i64", std::numeric_limits<std::int64_t>::min()},
            {"u64", std::numeric_limits<std::uint64_t>::max()}, {"f32", double(0.1F)},
            {"f64", -0.1}, {"truth", std::uint64_t(1)}, {"text", std::string("a\nb")},
            {"empty", std::string()}, {"time", TdmsTimestamp{-5, 7}}};
        QCOMPARE(properties.size(), expected.size());
        for (const auto &[name, value] : expected)
            QVERIFY2(properties.at(name) == value, name);
        QVERIFY(!countOf(properties, "i8") && *countOf(properties, "u8") == 255);
        QCOMPARE(*numberOf(properties, "i16"), -2.0);
        QVERIFY(!numberOf(properties, "text") && !numberOf(properties, "absent"));
        QVERIFY(textOf(properties, "u8").empty() && !timestampOf(properties, "f64"));
        QCOMPARE(valueText(properties.at("f32")), std::string("0.10000000149011612"));
        QCOMPARE(valueText(properties.at("u64")), std::string("18446744073709551615"));
        QCOMPARE(valueText(std::monostate()), std::string());
    }

    void everyIndex_isAsItWasWritten()
    {
        const Objects objects = objectsIn(everything(false).metadata());
        QVERIFY(objects.has_value());
        QCOMPARE(objects->at(0).kind, TdmsIndexKind::NoData);
        QCOMPARE(objects->at(1).index.count, std::uint64_t(1000));
        QCOMPARE(objects->at(1).index.type, TdmsType::Int16);
        QCOMPARE(objects->at(2).kind, TdmsIndexKind::AsBefore);
        QCOMPARE(objects->at(3).index.textBytes, std::uint64_t(77));
        const TdmsRawIndex &daqmx = objects->at(4).index;
        QVERIFY(daqmx.isDaqmx() && !objects->at(1).index.isDaqmx());
        QCOMPARE(daqmx.widths, (std::vector<std::uint32_t>{8, 16}));
        QCOMPARE(daqmx.scalers[1].type, TdmsType::Int32);
        QCOMPARE(daqmx.scalers[1].byteOffset, 4U);
        QCOMPARE(daqmx.scalers[1].scaleId, 8U);
    }

    void cutAnywhere_isAProblemWithASentence()
    {
        for (const bool bigEndian : {false, true}) {
            const std::string whole = everything(bigEndian).metadata();
            for (std::size_t size = 0; size < whole.size(); ++size) {
                const Objects objects = objectsIn(whole.substr(0, size), bigEndian);
                QVERIFY2(!objects, qPrintable(QString::number(size)));
                QVERIFY(objects.error().text != nullptr);
            }
        }
    }

    void digitalLines_areBitsOfBytes()
    {
        // Line 21 is bit 5 of byte 2; in big-endian order only ports of one byte are certain.
        TdmsSegment segment;
        segment.object("/'g'/'d'", segment.daqmx(10, {{4, 0, 21, 0}}, {4}, true));
        const Objects objects = objectsIn(segment.metadata());
        QVERIFY(objects.has_value());
        const TdmsScaler &scaler = objects->front().index.scalers.front();
        QCOMPARE(scaler.type, TdmsType::UInt8);
        QCOMPARE(scaler.byteOffset, 2U);
        QCOMPARE(scaler.bit, 5);
        TdmsSegment big(TdmsSegment::kMetaData | TdmsSegment::kBigEndian);
        big.object("/'g'/'d'", big.daqmx(10, {{4, 0, 21, 0}}, {4}, true));
        QVERIFY(!objectsIn(big.metadata(), true));
    }
};

DYNCAL_TEST(TestTdmsMetadata)
#include "tst_tdms_metadata.moc"
