// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the readers of binary files are made of; files themselves: tst_mat, tst_scope_bin, ...

#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"
#include "core/capture/formats/bytes/byte_stream.h"
#include "core/capture/formats/bytes/zlib_stream.h"
#include "tests/support/memory_file.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <optional>

using namespace dyncal;

/// A value of each kind that the stream knows.
struct Packed
{
    double number = 0.0;
    std::string text;
    std::vector<std::vector<std::int16_t>> rows;
    std::map<std::string, double> named;

    bool operator==(const Packed &) const = default;
};

template <typename Stream>
void transfer(Stream &stream, Packed &value)
{
    stream(value.number, value.text, value.rows, value.named);
}

using namespace dyncal;

namespace {

std::vector<std::byte> bytesOf(const QByteArray &hex)
{
    const QByteArray raw = QByteArray::fromHex(hex);
    std::vector<std::byte> bytes;
    for (const char character : raw)
        bytes.push_back(static_cast<std::byte>(character));
    return bytes;
}

/// bytes(range(10))*3 by /usr/bin/python3: zlib.compress(bytes(range(10)) * 3, 9).hex()
const QByteArray kCompressed = "78da6360646266616563e7e064c0c2020007530088";

struct Expanded
{
    std::vector<std::byte> bytes;
    bool ok = false;
    bool ended = false;
};

/// Read in pieces of `piece` bytes, as long as any come.
Expanded expanded(const std::vector<std::byte> &stream, std::size_t piece)
{
    const testing::MemoryFile file(stream.data(), stream.size());
    const auto opened = SampleFile::open(file.path()).value();
    ZlibStream source(opened, 0, stream.size());
    Expanded result;
    std::vector<std::byte> part(piece);
    std::size_t count = piece;
    while (count == piece) {
        count = source.read(part);
        result.bytes.insert(
            result.bytes.end(), part.begin(), part.begin() + static_cast<Index>(count));
    }
    result.ok = source.ok();
    result.ended = source.ended();
    return result;
}

} // namespace

class TestBinaryParts : public QObject
{
    Q_OBJECT

private slots:
    void numbers_inEitherByteOrder()
    {
        const auto bytes = bytesOf("c0200000"
                                   "9a9999999999b93f"
                                   "abcd"
                                   "ff");
        ByteReader big(bytes, std::endian::big);
        QCOMPARE(big.next<float>(), -2.5F);
        QCOMPARE(big.at<std::uint16_t>(12), std::uint16_t(0xABCD));
        QCOMPARE(big.next<std::int8_t>(), std::int8_t(-1));
        QVERIFY(big.ok() && big.remaining() == 0);
        ByteReader little(bytes);
        QCOMPARE(little.at<double>(4), 0.1);
        QCOMPARE(little.next<std::uint16_t>(), std::uint16_t(0xCDAB));
        QCOMPARE(little.at<std::uint32_t>(0), 0x000020c0U);
        QVERIFY(little.ok());
    }

    void beyondTheEnd_isZeroAndNotOkFromThenOn()
    {
        const auto bytes = bytesOf("01020304");
        ByteReader reader(bytes);
        QCOMPARE(reader.at<std::uint32_t>(1), 0U); // three bytes are no number
        QVERIFY(!reader.ok());
        QCOMPARE(reader.at<std::uint8_t>(0), std::uint8_t(1)); // there, but not believed
        QVERIFY(!reader.ok());
        for (const std::size_t position :
            {std::size_t(5), std::numeric_limits<std::size_t>::max()}) {
            ByteReader other(bytes);
            other.seek(position);
            QVERIFY(!other.ok());
            QCOMPARE(other.remaining(), std::size_t(0));
            ByteReader skipping(bytes);
            skipping.next<std::uint8_t>();
            skipping.skip(position); // 1 + the largest number would be 0
            QVERIFY(!skipping.ok());
            QVERIFY(skipping.take(1).empty());
        }
        ByteReader atEnd(bytes);
        atEnd.seek(4);
        QVERIFY(atEnd.ok()); // the end itself is allowed
        QVERIFY(atEnd.take(0).empty() && atEnd.ok());
        ByteReader nothing({});
        QCOMPARE(nothing.next<double>(), 0.0);
        QVERIFY(!nothing.ok());
    }

    void texts_endAtTheirNulAndHaveNoBlanksAround()
    {
        const std::string raw("  CH 1 \0junk\t\n  ", 16);
        const auto *begin = reinterpret_cast<const std::byte *>(raw.data());
        ByteReader reader(std::span(begin, raw.size()));
        QCOMPARE(reader.text(12), std::string("CH 1"));
        QCOMPARE(reader.text(4), std::string());
        QVERIFY(reader.ok());
        QCOMPARE(reader.text(1), std::string());
        QVERIFY(!reader.ok());
    }

    void values_comeBackAsTheyWerePacked()
    {
        const Packed value{-0.1, std::string("a\0b", 3), {{1, -2}, {}, {32767}},
            {{"", 1.0}, {"\xC2\xB5V", std::numeric_limits<double>::infinity()}}};
        BytePacker packer;
        packer(value, value);
        ByteUnpacker unpacker(packer.bytes());
        Packed first, second;
        unpacker(first, second);
        QVERIFY(unpacker.ok() && unpacker.atEnd());
        QVERIFY(first == value && second == value);
    }

    void packedBytes_cutAnywhere_areNotBelieved()
    {
        const Packed value{2.0, "text", {{1, 2, 3}, {4}}, {{"a", 1.0}, {"b", 2.0}}};
        BytePacker packer;
        packer(value);
        const std::span<const std::byte> bytes(packer.bytes());
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            ByteUnpacker unpacker(bytes.first(size));
            Packed found;
            unpacker(found);
            QVERIFY(!unpacker.ok());
        }
    }

    void packedLength_ofAnything_allocatesNoMoreThanIsThere()
    {
        for (const std::size_t claimed :
            {std::size_t(9), std::size_t(1) << 40, std::numeric_limits<std::size_t>::max()}) {
            BytePacker packer;
            packer(claimed, 0.5); // eight bytes follow
            ByteUnpacker asText(packer.bytes()), asList(packer.bytes());
            std::string text;
            asText(text);
            QVERIFY(!asText.ok() && text.empty());
            std::vector<std::vector<double>> list;
            asList(list);
            QVERIFY(!asList.ok() && list.empty());
        }
    }

    void stream_isExpandedInPiecesOfAnySize()
    {
        const auto stream = bytesOf(kCompressed);
        for (const std::size_t piece : {1, 7, 10, 30, 31, 1000}) {
            const Expanded found = expanded(stream, piece);
            QVERIFY(found.ok && found.ended);
            QCOMPARE(found.bytes.size(), std::size_t(30));
            for (std::size_t i = 0; i < 30; ++i)
                QCOMPARE(int(found.bytes[i]), int(i % 10));
        }
    }

    void streamCutAnywhere_isNotWhole()
    {
        const auto stream = bytesOf(kCompressed);
        for (std::size_t size = 0; size < stream.size(); ++size) {
            const Expanded found
                = expanded({stream.begin(), stream.begin() + static_cast<Index>(size)}, 1000);
            QVERIFY(!found.ok && !found.ended);
            QVERIFY(found.bytes.size() <= 30);
        }
    }

    void streamWithAWrongByte_isNotWhole()
    {
        const auto stream = bytesOf(kCompressed);
        for (std::size_t at = 0; at < stream.size(); ++at) {
            auto spoilt = stream;
            spoilt[at] ^= std::byte{0x55};
            const Expanded found = expanded(spoilt, 1000);
            QVERIFY2(!found.ok || !found.ended, qPrintable(QString("byte %1").arg(at)));
        }
    }

    void intervalInSinglePrecision_isTheDecimalThatWasMeant()
    {
        for (const double meant : {1e-8, 2e-9, 5e-6, 1.25e-7, 3.3e-10, 0.1, 1.0}) {
            QCOMPARE(intendedInterval(static_cast<double>(static_cast<float>(meant))), meant);
            QCOMPARE(intendedInterval(meant), meant); // double precision is as it is
        }
        const double full = 1.0 / 3e6;
        QCOMPARE(intendedInterval(full), full);
        QCOMPARE(intendedInterval(0.0), 0.0);
        QVERIFY(std::isnan(intendedInterval(std::nan(""))));
        QVERIFY(std::isinf(intendedInterval(std::numeric_limits<double>::infinity())));
    }

    void rate_ofWhatIsNoInterval_isUnknownAndSaid()
    {
        Findings findings;
        QCOMPARE(sampleRateOf(1e-8, "a.bin", "CH1", 1, findings), 1e8);
        QVERIFY(findings.empty());
        for (const double nonsense :
            {0.0, -1e-8, std::nan(""), 1e-320, std::numeric_limits<double>::infinity()}) {
            findings.clear();
            QCOMPARE(sampleRateOf(nonsense, "a.bin", "CH1", 3, findings), 0.0);
            QVERIFY(testing::hasFinding(findings, "CAP-016"));
            QCOMPARE(findings[0].shot, Index(3));
        }
    }

    void channelNames_areFree()
    {
        Shot shot;
        for (const char *expected : {"CH1", "CH1 (2)", "CH1 (3)"}) {
            Channel channel;
            channel.name = freeChannelName(shot, "CH1");
            QCOMPARE(channel.name, std::string(expected));
            shot.channels.push_back(channel);
        }
        QCOMPARE(freeChannelName(shot, "CH1 (2)"), std::string("CH1 (2) (2)"));
    }
};

DYNCAL_TEST(TestBinaryParts)
#include "tst_binary_parts.moc"
