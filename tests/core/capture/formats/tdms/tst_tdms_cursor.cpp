// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers and texts read through a small window of the file, against the bytes themselves.

#include "core/capture/formats/tdms/tdms_cursor.h"
#include "tests/support/memory_file.h"
#include "tests/support/tdms_writer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace dyncal;

namespace {

std::shared_ptr<const SampleFile> opened(const testing::MemoryFile &file)
{
    return *SampleFile::open(file.path());
}

std::string randomBytes(std::size_t count, std::mt19937_64 &random)
{
    std::string bytes(count, '\0');
    for (char &byte : bytes)
        byte = static_cast<char>(random());
    return bytes;
}

template <typename T>
T numberAt(const std::string &bytes, std::uint64_t position, bool bigEndian)
{
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        const std::size_t place = bigEndian ? i : sizeof(T) - 1 - i;
        value = static_cast<T>(
            (sizeof(T) > 1 ? value << 8 : 0) | static_cast<unsigned char>(bytes[position + place]));
    }
    return value;
}

/// One read of a number; whether cursor and bytes agree on it.
template <typename T>
bool agreesOnNumber(TdmsCursor &cursor, const std::string &bytes, bool bigEndian)
{
    const std::uint64_t before = cursor.position();
    T value = 0;
    const bool isThere = before + sizeof(T) <= bytes.size();
    if (cursor.number(value) != isThere)
        return false;
    return isThere
        ? value == numberAt<T>(bytes, before, bigEndian) && cursor.position() == before + sizeof(T)
        : cursor.position() == before;
}

} // namespace

class TestTdmsCursor : public QObject
{
    Q_OBJECT

private slots:
    void anyWay_throughAFile_readsItsBytes_data()
    {
        QTest::addColumn<int>("size");
        for (const int size : {0, 1, 7, 1023, 1024, 1025, 40000, 200000})
            QTest::addRow("%d", size) << size;
    }
    void anyWay_throughAFile_readsItsBytes()
    {
        // Steps and jumps of all sizes: the window is moved, grown, left and come back to.
        QFETCH(int, size);
        std::mt19937_64 random(static_cast<std::uint64_t>(size));
        const std::string bytes = randomBytes(static_cast<std::size_t>(size), random);
        const testing::MemoryFile file(bytes.data(), bytes.size());
        const auto source = opened(file);
        TdmsCursor cursor(*source);
        for (int step = 0; step < 20000; ++step) {
            const bool bigEndian = random() % 2 == 0;
            cursor.setByteOrder(bigEndian ? std::endian::big : std::endian::little);
            switch (random() % 64) {
            case 0:
                cursor.moveTo(random() % (bytes.size() + 40));
                break;
            case 1:
                if (const std::uint64_t far = random() % 5000; cursor.remaining() >= far)
                    QVERIFY(cursor.skip(far));
                break;
            default:
                QVERIFY(agreesOnNumber<std::uint8_t>(cursor, bytes, bigEndian));
                QVERIFY(agreesOnNumber<std::uint16_t>(cursor, bytes, bigEndian));
                QVERIFY(agreesOnNumber<std::uint32_t>(cursor, bytes, bigEndian));
                QVERIFY(agreesOnNumber<std::uint64_t>(cursor, bytes, bigEndian));
            }
            if (cursor.remaining() == 0)
                cursor.moveTo(bytes.empty() ? 0 : random() % bytes.size());
        }
    }

    void texts_ofEveryLength_areWhole()
    {
        // Above 512 bytes they are read past the window.
        std::mt19937_64 random(4);
        testing::TdmsBytes bytes;
        std::vector<std::string> texts;
        for (const std::size_t length : {0, 1, 511, 512, 513, 1020, 5000, 0, 70000, 3}) {
            texts.push_back(randomBytes(length, random));
            bytes.text(texts.back());
        }
        const testing::MemoryFile file(bytes.bytes().data(), bytes.bytes().size());
        const auto source = opened(file);
        TdmsCursor cursor(*source);
        for (const std::string &text : texts) {
            std::string read = "old";
            QVERIFY(cursor.text(read));
            QVERIFY(read == text);
        }
        QCOMPARE(cursor.remaining(), std::uint64_t(0));
        std::string none;
        QVERIFY(!cursor.text(none));
    }

    void textThatIsNotThere_isNotMadeRoomFor()
    {
        for (const std::uint32_t claimed : {5U, TdmsCursor::kLongestText + 1, 0xFFFFFFFFU}) {
            const std::string bytes = testing::TdmsBytes().add(claimed).raw("abcd").bytes();
            const testing::MemoryFile file(bytes.data(), bytes.size());
            const auto source = opened(file);
            TdmsCursor cursor(*source);
            std::string text;
            QVERIFY(!cursor.text(text));
            QVERIFY(text.capacity() < 100);
        }
    }

    void limit_endsAllReading()
    {
        const std::string bytes(100, '\x01');
        const testing::MemoryFile file(bytes.data(), bytes.size());
        const auto source = opened(file);
        TdmsCursor cursor(*source);
        cursor.limit(10);
        std::uint64_t eight = 0;
        QVERIFY(cursor.number(eight));
        QVERIFY(!cursor.number(eight)); // though the file goes on
        QVERIFY(!cursor.skip(3) && cursor.skip(2) && cursor.skip(0));
        QCOMPARE(cursor.position(), std::uint64_t(10));
        cursor.limit(1000); // at most the file
        QCOMPARE(cursor.remaining(), std::uint64_t(90));
        QVERIFY(!cursor.skip(~std::uint64_t(0)));
        cursor.moveTo(~std::uint64_t(0) - 3);
        QCOMPARE(cursor.remaining(), std::uint64_t(0));
        QVERIFY(!cursor.number(eight) && !cursor.skip(1));
    }
};

DYNCAL_TEST(TestTdmsCursor)
#include "tst_tdms_cursor.moc"
