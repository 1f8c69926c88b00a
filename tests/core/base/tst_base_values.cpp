// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/auto_value.h"
#include "core/base/content_hash.h"
#include "core/base/finding.h"
#include "core/base/interval.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/shock/pressure_units.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace dyncal;

namespace {

Finding findingOf(Severity severity)
{
    return {.id = "XXX-001", .severity = severity};
}

} // namespace

class TestBaseValues : public QObject
{
    Q_OBJECT

private slots:
    // FIPS 180-4 example messages (NIST CSRC) and the digest of the empty message.
    void sha256_equalsTheKnownVectors_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("digest");
        QTest::newRow("empty") << QByteArray(
            "") << QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        QTest::newRow("one block")
            << QByteArray("abc")
            << QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        QTest::newRow("two blocks")
            << QByteArray("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")
            << QByteArray("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
        QTest::newRow("a million a") << QByteArray(1000000,
            'a') << QByteArray("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    }
    void sha256_equalsTheKnownVectors()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, digest);
        QCOMPARE(sha256Hex(text.toStdString()), digest.toStdString());
    }

    void sha256OfFile_equalsThatOfItsBytes()
    {
        // Longer than one block of reading (1 MiB), and not a multiple of it.
        const QTemporaryDir folder;
        const std::string path = folder.filePath("bytes.bin").toStdString();
        std::string bytes((1 << 20) + 12345, '\0');
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<char>(i * 31 % 251);
        std::ofstream(path, std::ios::binary) << bytes;
        QCOMPARE(sha256OfFile(path), sha256Hex(bytes));
    }

    void sha256OfFile_missingFileOrFolder_isEmpty()
    {
        const QTemporaryDir folder;
        QVERIFY(sha256OfFile(folder.filePath("none").toStdString()).empty());
        QVERIFY(sha256OfFile(folder.path().toStdString()).empty());
    }

    void places_areFilledInOnePass()
    {
        QCOMPARE(fillPlaces("a %1 b %2 c %1", {"x", "y"}), std::string("a x b y c x"));
        QCOMPARE(fillPlaces("%2%1", {"%2", "%1"}), std::string("%1%2")); // never expanded again
        QCOMPARE(fillPlaces("%9", {"1", "2", "3", "4", "5", "6", "7", "8", "9"}), std::string("9"));
    }

    void places_withoutArgument_stay()
    {
        QCOMPARE(fillPlaces("%1 of %3", {"one"}), std::string("one of %3"));
        QCOMPARE(fillPlaces("5 % of %0 and %", {"one"}), std::string("5 % of %0 and %"));
        QCOMPARE(fillPlaces("%%1", {"5"}), std::string("%5"));
        QCOMPARE(fillPlaces("%L2, %V1", {"1.5", "2.5"}), std::string("2.5, 1.5"));
        QCOMPARE(fillPlaces("%L %V0 %L3 %", {"one"}), std::string("%L %V0 %L3 %"));
        QCOMPARE(fillPlaces("", {"5"}), std::string());
    }

    void messages_areEqualByText()
    {
        const std::string copy = "Shot %1.";
        const Message message{"Shot %1.", {"3"}};
        QVERIFY((message == Message{copy.c_str(), {"3"}}));
        QVERIFY(!(message == Message{"Shot %1.", {"4"}}));
        QVERIFY(!(message == Message{"Shot  %1.", {"3"}}));
        QCOMPARE(english(message), std::string("Shot 3."));
        QCOMPARE(english({}), std::string());
    }

    void severities_haveTheWordsOfTheResultFile()
    {
        QCOMPARE(severityName(Severity::Info), "info");
        QCOMPARE(severityName(Severity::Caution), "caution");
        QCOMPARE(severityName(Severity::Block), "block");
    }

    void worstSeverity_isTheMostSevere_whateverTheOrder()
    {
        const Finding info = findingOf(Severity::Info);
        const Finding caution = findingOf(Severity::Caution);
        const Finding block = findingOf(Severity::Block);
        QCOMPARE(worstSeverity({}), Severity::Info);
        QCOMPARE(worstSeverity({info, info}), Severity::Info);
        QCOMPARE(worstSeverity({info, caution, info}), Severity::Caution);
        QCOMPARE(worstSeverity({block, caution, info}), Severity::Block);
        QCOMPARE(worstSeverity({info, caution, block}), Severity::Block);
    }

    void fail_carriesWhatItWasGiven()
    {
        const Result<int> result
            = fail(ErrorKind::DataBlocked, Message{"Shot %1.", {"2"}}, "CAP-009", 2);
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().kind, ErrorKind::DataBlocked);
        QCOMPARE(result.error().findingId, std::string("CAP-009"));
        QCOMPARE(result.error().shot, Index(2));
        QCOMPARE(english(result.error().message), std::string("Shot 2."));
    }

    void interval_isClosed()
    {
        const Interval interval{-1.0, 2.0};
        QCOMPARE(interval.length(), 3.0);
        QVERIFY(interval.contains(-1.0) && interval.contains(2.0) && interval.contains(0.0));
        QVERIFY(!interval.contains(-1.0001) && !interval.contains(2.0001));
        QVERIFY(!interval.contains(std::nan("")));
    }

    void autoValue_differsFromEveryValue()
    {
        QVERIFY(Auto<double>().isAuto());
        QVERIFY(!Auto<double>(0.0).isAuto());
        QVERIFY(!(Auto<double>() == Auto<double>(0.0)));
        QVERIFY(Auto<double>(2.0) == Auto<double>(2.0));
    }

    void pressureUnits_areExact()
    {
        QCOMPARE(pascalsPer("Pa"), std::optional<double>(1.0));
        QCOMPARE(pascalsPer("hPa"), std::optional<double>(100.0));
        QCOMPARE(pascalsPer("mbar"), std::optional<double>(100.0));
        QCOMPARE(pascalsPer("kPa"), std::optional<double>(1e3));
        QCOMPARE(pascalsPer("bar"), std::optional<double>(1e5));
        QCOMPARE(pascalsPer("MPa"), std::optional<double>(1e6));
        // One pound-force (0.45359237 kg * 9.80665 m/s^2) on a square inch (0.0254 m)^2.
        const double psi_Pa = 0.45359237 * 9.80665 / (0.0254 * 0.0254);
        constexpr double kPrinted = 1e-7; // seven digits are kept
        QVERIFY(std::abs(*pascalsPer("psi") / psi_Pa - 1.0) < kPrinted);
    }

    void otherUnits_areNoPressure()
    {
        for (const char *unit : {"V", "", "1", "pa", "PSI", "Pa ", "counts"})
            QVERIFY2(!pascalsPer(unit), unit);
    }

    void unitThatFits_isFoundFromTheReading()
    {
        QCOMPARE(unitThatFits(5.1, 5.0e5), std::optional<std::string>("bar"));
        QCOMPARE(unitThatFits(-0.49, 5.0e5), std::optional<std::string>("MPa"));
        QCOMPARE(unitThatFits(72.5, 5.0e5), std::optional<std::string>("psi"));
        QCOMPARE(unitThatFits(505.0, 5.0e5), std::optional<std::string>("kPa"));
        QVERIFY(!unitThatFits(2.0, 5.0e5)); // 2 bar and 2 MPa are both far off
        QVERIFY(!unitThatFits(0.0, 5.0e5));
        QVERIFY(!unitThatFits(5.0, 0.0));
        QVERIFY(!unitThatFits(std::nan(""), 5.0e5));
    }
};

DYNCAL_TEST(TestBaseValues)
#include "tst_base_values.moc"
