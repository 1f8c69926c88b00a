// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates of this program, which name everything by refTypes of their own.

#include "core/dcc_reading/dcc_words_read.h"
#include "core/dcc_reading/own_certificate.h"
#include "tests/support/made_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

DccContents contentsOf(const std::string &data)
{
    return readDcc(dccOf(data)).value();
}

std::string value(const char *number, const char *refType)
{
    return dccMarked(dccQuantity(number, "\\hertz", "1"), refType);
}

const std::string kHash(64, 'c');

std::vector<std::string> recordingsOf(const std::vector<std::string> &hashes)
{
    return ownRecordings(
        contentsOf(dccListOf("dyncal_recordings", dccWords("dyncal_sha256", hashes))));
}

} // namespace

class TestOwnCertificate : public QObject
{
    Q_OBJECT

private slots:
    void own_isKnownByItsRefTypes()
    {
        QVERIFY(isOwnCertificate(contentsOf(value("1", "dyncal_naturalFrequency"))));
        QVERIFY(isOwnCertificate(contentsOf(dccListOf("dyncal_poles", value("1", "")))));
        QVERIFY(!isOwnCertificate(contentsOf(value("1", "basic_measuredValue"))));
        QVERIFY(!isOwnCertificate(contentsOf(value("1", "xdyncal_poles"))));
        QVERIFY(!isOwnCertificate(contentsOf("")));
    }

    void values_areThoseWithThisRefTypeOnly()
    {
        const char *type = "dyncal_sensitivity";
        const DccContents one
            = contentsOf(value("1", type) + value("2", "dyncal_sensitivity dyncal_lowLevel"));
        QCOMPARE(ownValue(one, type)->stated.values.values[0], 1.0);
        QVERIFY(!ownValue(contentsOf(value("1", type) + value("2", type)), type));
        QVERIFY(!ownValue(contentsOf(value("1", "dyncal_sensitivity dyncal_lowLevel")), type));
        QVERIFY(!ownValue(contentsOf(value("1 2", type)), type)); // a list of values is no value
        QVERIFY(!ownValue(contentsOf(dccListOf("dyncal_shots", value("1", type))), type));
    }

    void responses_areThoseWithAllDigitsFirst()
    {
        const std::string exact = dccListOf("dyncal_complexResponse", value("1", "")),
                          printed = dccListOf("dyncal_frequencyResponse", value("2", "")),
                          marks = dccListOf("dyncal_complexResponseAtMarks", value("3", ""));
        const auto firstOf = [](const std::string &data) {
            const DccContents contents = contentsOf(data);
            const auto found = ownResponses(contents);
            return found.size() == 1 ? found[0]->columns[0].stated.values.values[0] : 0.0;
        };
        QCOMPARE(firstOf(printed + marks + exact), 1.0);
        QCOMPARE(firstOf(printed + marks), 2.0);
        QCOMPARE(firstOf(marks), 0.0);
        QCOMPARE(ownResponses(contentsOf(exact + exact)).size(), std::size_t(2));
    }

    void recordings_areAllOrNone()
    {
        const std::string other(64, '0');
        QCOMPARE(recordingsOf({kHash, other}), (std::vector<std::string>{other, kHash}));
        QVERIFY(recordingsOf({}).empty());
        QVERIFY(recordingsOf({kHash, std::string(63, 'c')}).empty());
        QVERIFY(recordingsOf({std::string(64, 'C')}).empty());
        QVERIFY(recordingsOf({kHash, "\xE2\x80\x93"}).empty());
        const std::string list = dccListOf("dyncal_recordings", dccWords("dyncal_sha256", {kHash}));
        QVERIFY(ownRecordings(contentsOf(list + list)).empty());
    }

    /// Words in several languages stand beside each other; those of no language are in all.
    void words_areInEnglishElseTheFirst()
    {
        const auto nameOf = [](const std::string &contents) {
            const ParsedElement name = readXml("<name>" + contents + "</name>").value();
            return wordsOfText(&name);
        };
        QCOMPARE(nameOf("<content lang='sv'>a</content><content lang='en'>b</content>"),
            std::string("b"));
        QCOMPARE(nameOf("<content lang='sv'>a</content><content>b</content>"), std::string("a"));
        QCOMPARE(nameOf(""), std::string());
        QCOMPARE(wordsOfText(nullptr), std::string());
        const ParsedElement element = readXml("<a refType=' x\n y  z '/>").value();
        QCOMPARE(wordsOfAttribute(element, "refType"), (std::vector<std::string>{"x", "y", "z"}));
        QVERIFY(wordsOfAttribute(element, "id").empty());
    }
};

DYNCAL_TEST(TestOwnCertificate)
#include "tst_own_certificate.moc"
