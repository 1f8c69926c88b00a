// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers and words as quantities of a DCC, in one language and in two.

#include "core/base/constants.h"
#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_quantity.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace dyncal;

namespace {

DccWords inTwo()
{
    return {{"en", "sv"}, [](const Message &message, const std::string &language) {
                const std::string text = english(message);
                return language == "sv" && text == "Value" ? std::string("V\u00e4rde") : text;
            }};
}

} // namespace

class TestDccQuantity : public QObject
{
    Q_OBJECT

private slots:
    void list_isSeparatedBySingleBlanks()
    {
        QCOMPARE(dccList({"1", "2", "3"}), std::string("1 2 3"));
        QCOMPARE(dccList({"2", "2", "2"}), std::string("2 2 2"));
        QCOMPARE(dccList({"2", "2", "2"}, true), std::string("2"));
        QCOMPARE(dccList({"2", "3"}, true), std::string("2 3"));
        QCOMPARE(dccList({}), std::string());
    }

    /// The D-SI takes no exponent, and nothing below 1.
    void factor_isWhatTheDSiTakes_data()
    {
        QTest::addColumn<QString>("printed");
        QTest::addColumn<QString>("factor");
        QTest::newRow("two") << "2"
                             << "2";
        QTest::newRow("Student") << "4.30"
                                 << "4.30";
        QTest::newRow("large") << "1.27e+04"
                               << "12700";
        QTest::newRow("below one") << "0.5"
                                   << "NaN";
        QTest::newRow("none") << ""
                              << "NaN";
        QTest::newRow("words") << "k"
                               << "NaN";
    }
    void factor_isWhatTheDSiTakes()
    {
        QFETCH(QString, printed);
        QFETCH(QString, factor);
        QCOMPARE(QString::fromStdString(dccFactor(printed.toStdString())), factor);
    }

    void number_readsBackAsItself()
    {
        for (const double value : {0.1, -1.0 / 3.0, 5.0244886239647644e-06, 1e300, 0.0})
            QCOMPARE(QString::fromStdString(dccNumber(value)).toDouble(), value);
        QCOMPARE(dccNumber(kUnknown), std::string("NaN"));
        QCOMPARE(dccNumber(std::numeric_limits<double>::infinity()), std::string("NaN"));
    }

    void words_areInEveryLanguage()
    {
        const auto contents = inTwo().contents({"Value", {}});
        QCOMPARE(contents.size(), std::size_t(2));
        QCOMPARE(contents[0].attributes.front().second, std::string("en"));
        QCOMPARE(contents[0].text, std::string("Value"));
        QCOMPARE(contents[1].attributes.front().second, std::string("sv"));
        QCOMPARE(contents[1].text, std::string("V\u00e4rde"));
    }

    void whatWasTyped_standsOnceWithoutALanguage()
    {
        const auto contents = inTwo().contents(verbatim("Bor\u00e5s"));
        QCOMPARE(contents.size(), std::size_t(1));
        QVERIFY(contents.front().attributes.empty());
    }

    void noWords_areADash()
    {
        QCOMPARE(DccWords().contents(verbatim("")).front().text, std::string("\u2013"));
        QCOMPARE(DccWords().contents(verbatim("  ")).front().text, std::string("\u2013"));
    }

    void number_isReal_andWordsAreNone()
    {
        const XmlElement real = dccQuantityOf({}, verbatim("f"), "basic_x", inNumbers("2.50 kHz"));
        QCOMPARE(real.children.back().name, std::string("si:real"));
        QCOMPARE(real.attributes.front().second, std::string("basic_x"));
        const XmlElement words = dccQuantityOf({}, verbatim("f"), "", verbatim("2.50 kHz"));
        QCOMPARE(words.children.back().name, std::string("dcc:noQuantity"));
        QVERIFY(words.attributes.empty());
    }

    void columnOfNeither_isNothing()
    {
        XmlElement list;
        addDccColumn({}, DccColumn{}, list);
        QVERIFY(list.children.empty());
    }

    /// What is said of the values stands before them, as the schema wants it.
    void description_standsBeforeTheValues()
    {
        DccColumn column{verbatim("x"), "basic_x", {"1"}, {"\\one"}};
        column.description = verbatim("normal");
        XmlElement list;
        addDccColumn({}, column, list);
        QCOMPARE(list.children.size(), std::size_t(1));
        const std::vector<XmlElement> &parts = list.children.front().children;
        QCOMPARE(parts.size(), std::size_t(3));
        QCOMPARE(parts[0].name, std::string("dcc:name"));
        QCOMPARE(parts[1].name, std::string("dcc:description"));
        QCOMPARE(parts[1].children.front().text, std::string("normal"));
        QCOMPARE(parts[2].name, std::string("si:realListXMLList"));
    }

    void result_hasItsNameAndRefType()
    {
        const XmlElement result = dccResult(inTwo(), {"Value", {}}, "basic_x");
        QCOMPARE(result.name, std::string("dcc:result"));
        QCOMPARE(result.attributes.front().second, std::string("basic_x"));
        QCOMPARE(result.children.size(), std::size_t(1));
        QCOMPARE(result.children.front().children.back().text, std::string("V\u00e4rde"));
        QVERIFY(dccResult({}, verbatim("x"), "").attributes.empty());
    }

    void standardUncertainty_standsWithoutAFactor()
    {
        DccColumn column{verbatim("x"), ""};
        column.values = {"1", "2"};
        column.units = {"\\one", "\\one"};
        column.standard = {"0.1", "NaN"};
        XmlElement list;
        addDccColumn({}, column, list);
        const std::string xml = xmlText(list.children.front());
        QVERIFY(xml.find("<si:valueStandardMUXMLList>0.1 NaN<") != xml.npos);
        QVERIFY(xml.find("coverageFactor") == xml.npos);
    }
};

DYNCAL_TEST(TestDccQuantity)
#include "tst_dcc_quantity.moc"
