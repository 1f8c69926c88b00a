// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A certificate as its contents: what is administrative, which quantities are results, versions.

#include "core/dcc_reading/dcc_contents.h"
#include "tests/support/made_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace dyncal;
using testing::dccList;
using testing::dccOf;
using testing::dccQuantity;

namespace {

std::string replaced(std::string text, const std::string &what, const std::string &with)
{
    return text.replace(text.find(what), what.size(), with);
}

/// The serial number that follows from these identifications.
std::string serialOf(const std::string &identifications)
{
    const std::string whole = dccOf("");
    const std::size_t begin = whole.find("<dcc:identification "),
                      end = whole.find("</dcc:identifications>");
    const auto read = readDcc(whole.substr(0, begin) + identifications + whole.substr(end));
    return read ? read->items.at(0).serial : "not read";
}

std::string identification(const std::string &issuer, const std::string &value,
    const std::string &name = "", const std::string &refType = "")
{
    return "<dcc:identification" + (refType.empty() ? "" : " refType=\"" + refType + "\"")
        + "><dcc:issuer>" + issuer + "</dcc:issuer><dcc:value>" + value + "</dcc:value>"
        + (name.empty() ? "" : "<dcc:name><dcc:content>" + name + "</dcc:content></dcc:name>")
        + "</dcc:identification>";
}

} // namespace

class TestDccContents : public QObject
{
    Q_OBJECT

private slots:
    void administrativeData_isRead()
    {
        const auto read = readDcc(dccOf(""));
        QVERIFY(read.has_value());
        QCOMPARE(read->version, std::string("3.3.0"));
        QCOMPARE(read->number, std::string("K-17"));
        QCOMPARE(read->begun + ' ' + read->ended, std::string("2025-03-03 2025-03-04"));
        QCOMPARE(read->laboratory, std::string("A laboratory"));
        QCOMPARE(read->items.size(), std::size_t(1));
        QCOMPARE(read->items[0].name, std::string("Sensor")); // English, though it stands second
        QCOMPARE(read->items[0].serial, std::string("4711"));
        QVERIFY(read->tables.empty() && read->single.empty() && read->notUnderstood.empty());
    }

    void versions_areThoseWithSamples()
    {
        for (const char *version : {"3.0.0", "3.1.2", "3.2.1", "3.3.0"})
            QVERIFY2(readDcc(dccOf("", version)).has_value(), version);
        for (const char *version : {"", "2.4.0", "3.4.0", "4.0.0", "3", "3.30.0"}) {
            const auto read = readDcc(dccOf("", version));
            QVERIFY2(!read && read.error().kind == ErrorKind::FileUnreadable, version);
            QVERIFY(english(read.error().message).find("3.0 to 3.3") != std::string::npos);
        }
        QVERIFY(english(readDcc("<svg/>").error().message).find("svg") != std::string::npos);
    }

    void serialNumber_isTheOneThatIsMarked()
    {
        const std::string marked = identification("customer", "A", "", "basic_serialNumber"),
                          named = identification("other", "B", "Serial no."),
                          german = identification("other", "C", "Seriennummer"),
                          maker = identification("manufacturer", "D");
        QCOMPARE(serialOf(maker + named + marked), std::string("A"));
        QCOMPARE(serialOf(maker + named), std::string("B"));
        QCOMPARE(serialOf(german + maker), std::string("C"));
        QCOMPARE(serialOf(maker + identification("customer", "E")), std::string("D"));
        QCOMPARE(serialOf(named + german + maker), std::string("D")); // two say serial
        QCOMPARE(serialOf(maker + maker), std::string()); // which one?
        QCOMPARE(serialOf(identification("customer", "E")), std::string());
        QCOMPARE(serialOf(identification("manufacturer", "\xE2\x80\x93")), std::string()); // a dash
    }

    void results_areListsAndSingleQuantities()
    {
        const std::string words
            = "<dcc:quantity><dcc:noQuantity><dcc:content>x</dcc:content></dcc:noQuantity></dcc:quantity>";
        const auto read = readDcc(dccOf(dccQuantity("5", "\\volt") + words
            + dccList(
                dccQuantity("1 2", "\\hertz") + words + dccList(dccQuantity("7", "\\one"), "in"))));
        QVERIFY(read.has_value());
        QCOMPARE(read->single.size(), std::size_t(1));
        QCOMPARE(read->tables.size(), std::size_t(2));
        QCOMPARE(read->tables[0].id + ' ' + read->tables[1].id, std::string("a in"));
        QCOMPARE(read->tables[0].columns.size(), std::size_t(1));
        QVERIFY(read->notUnderstood.empty() && read->tables[0].notUnderstood.empty());
    }

    /// What stands around a result is none, nor is what qualifies it.
    void conditionsAndMetadata_areNoResults()
    {
        const std::string inside = "<dcc:measurementMetaData><dcc:metaData><dcc:data>"
            + dccQuantity("9", "\\volt") + "</dcc:data></dcc:metaData></dcc:measurementMetaData>";
        std::string whole = dccOf(
            replaced(dccQuantity("5", "\\volt"), "</dcc:quantity>", inside + "</dcc:quantity>"));
        whole = replaced(whole, "<dcc:results>",
            "<dcc:influenceConditions><dcc:influenceCondition><dcc:data>"
                + dccQuantity("294", "\\kelvin")
                + "</dcc:data></dcc:influenceCondition></dcc:influenceConditions><dcc:results>");
        const auto read = readDcc(whole);
        QVERIFY(read.has_value());
        QCOMPARE(read->single.size(), std::size_t(1));
        QCOMPARE(read->single[0].stated.values.values, std::vector<double>{5});
    }

    void whatIsNotUnderstood_hasItsSentence()
    {
        const auto read
            = readDcc(dccOf(dccQuantity("5", "\\knot") + dccList(dccQuantity("1,5", "\\hertz"))));
        QCOMPARE(read->notUnderstood.size(), std::size_t(1));
        QVERIFY(english(read->notUnderstood[0]).find("\\knot") != std::string::npos);
        QVERIFY(english(read->tables[0].notUnderstood.at(0)).find("comma") != std::string::npos);
        const auto empty = readDcc(dccOf("<dcc:quantity/>"));
        QVERIFY(english(empty->notUnderstood.at(0)).find("not understood") != std::string::npos);
    }

    void relativeUncertainties_areNamed_notTaken()
    {
        const std::string relative
            = "<dcc:relativeUncertainty><dcc:relativeUncertaintySingle><si:value>0.01</si:value>"
              "<si:unit>\\one</si:unit></dcc:relativeUncertaintySingle></dcc:relativeUncertainty>";
        const auto read = readDcc(dccOf(
            replaced(dccQuantity("5", "\\volt"), "</dcc:quantity>", relative + "</dcc:quantity>")));
        QVERIFY(read->single.at(0).stated.values.u.empty());
        QVERIFY(english(read->notUnderstood.at(0)).find("coverage factor") != std::string::npos);
    }

    void namesAndRefTypes_areOfTheListOrItsResult()
    {
        std::string whole = dccOf(dccList(dccQuantity("1", "\\hertz"), "a")
            + replaced(dccList(dccQuantity("1", "\\hertz"), "b"), "<dcc:list ",
                "<dcc:list refType=\"own other\" "));
        whole = replaced(whole, "<dcc:result>",
            "<dcc:result refType=\"whole\"><dcc:name><dcc:content lang=\"sv\">Svar</dcc:content></dcc:name>");
        const auto read = readDcc(whole);
        QCOMPARE(read->tables[0].refTypes, std::vector<std::string>{"whole"});
        QCOMPARE(read->tables[1].refTypes, (std::vector<std::string>{"own", "other"}));
        QCOMPARE(read->tables[1].name, std::string("Svar"));
    }
};

DYNCAL_TEST(TestDccContents)
#include "tst_dcc_contents.moc"
