// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Who, what, when and where: each typed field in its place, and what stands where none was typed.

#include "core/base/version.h"
#include "core/dcc/dcc_administration.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::ExampleSource;
using testing::ReadXml;

namespace {

const QString kDash = QString::fromUtf8("\u2013");

ReadXml readOf(ExampleSource example)
{
    return ReadXml(dccAdministration(example.source()));
}

std::string core(const char *name)
{
    return std::string("/dcc:administrativeData/dcc:coreData/dcc:").append(name);
}

/// A single field set otherwise than in the example.
ReadXml with(const std::string &field, const std::string &value)
{
    ExampleSource example;
    example.field(field) = value;
    return readOf(example);
}

ReadXml without(const std::string &field)
{
    ExampleSource example;
    example.recipe.certificate.fields.erase(field);
    return readOf(example);
}

} // namespace

class TestDccAdministration : public QObject
{
    Q_OBJECT

private slots:
    void parts_standInTheOrderOfTheSchema()
    {
        QCOMPARE(readOf({}).parts(),
            QStringList({"dcc:dccSoftware", "dcc:coreData", "dcc:items",
                "dcc:calibrationLaboratory", "dcc:respPersons", "dcc:customer", "dcc:statements"}));
    }

    void software_isThisRelease()
    {
        const ReadXml xml = readOf({});
        QCOMPARE(xml.text("//dcc:dccSoftware/dcc:software/dcc:release"),
            QString::fromStdString(std::string("v") + versionText()));
        QCOMPARE(xml.text("//dcc:software/dcc:name/dcc:content"), QString("Dyncal"));
        QVERIFY(xml.text("//dcc:software/dcc:description/dcc:content")
                    .contains(QString::fromStdString(buildText())));
    }

    /// One place for each field, told apart by its value.
    void field_standsInItsPlace_data()
    {
        QTest::addColumn<QString>("path");
        const auto row = [](const char *field, const char *path) { QTest::newRow(field) << path; };
        row("laboratory", "//dcc:calibrationLaboratory/dcc:contact/dcc:name/dcc:content");
        row("laboratory_address",
            "//dcc:calibrationLaboratory/dcc:contact/dcc:location/dcc:further/dcc:content");
        row("customer", "/*/dcc:customer/dcc:name/dcc:content");
        row("customer_address", "/*/dcc:customer/dcc:location/dcc:further/dcc:content");
        row("operator", "//dcc:respPerson/dcc:person/dcc:name/dcc:content");
        row("sensor_manufacturer", "//dcc:item/dcc:manufacturer/dcc:name/dcc:content");
        row("sensor_model", "//dcc:item/dcc:model");
        row("sensor_serial", "//dcc:item//dcc:identification/dcc:value");
        row("sensor_description", "//dcc:item/dcc:description/dcc:content");
    }
    void field_standsInItsPlace()
    {
        QFETCH(QString, path);
        const std::string field = QTest::currentDataTag();
        QCOMPARE(
            with(field, " typed \t as  this ").text(path.toStdString()), QString("typed as this"));
        QCOMPARE(with(field, "\u041c\u043e\u0441\u043a\u0432\u0430 \u6771\u4eac")
                     .text(path.toStdString()),
            QString::fromUtf8("\u041c\u043e\u0441\u043a\u0432\u0430 \u6771\u4eac"));
        ExampleSource example;
        for (const std::string &hostile : test::hostileTexts()) {
            example.field(field) = hostile;
            const ReadXml xml(dccAdministration(example.source()));
            QVERIFY2(xml.isWellFormed(), hostile.c_str());
            const QString text = xml.text(path.toStdString());
            QVERIFY2(!text.trimmed().isEmpty(), hostile.c_str());
            QVERIFY2(test::isFitToShow(text.toStdString(), LineBreaks::Keep), hostile.c_str());
            QCOMPARE(xml.parts().size(), 7);
        }
    }

    /// Of a blank or no field a dash: no element is empty. What the card of the item knows stays.
    void missingField_isADash()
    {
        for (const char *field : {"laboratory", "customer"}) {
            const std::string path = std::string("//*[name()='dcc:")
                + (std::string(field) == "customer" ? "customer" : "contact")
                + "']/dcc:name/dcc:content";
            QCOMPARE(without(field).text(path), kDash);
            QCOMPARE(with(field, "   ").text(path), kDash);
        }
        QCOMPARE(without("operator").text("//dcc:person/dcc:name/dcc:content"), kDash);
        QCOMPARE(
            without("sensor_description").text("//dcc:item/dcc:description/dcc:content"), kDash);
        QCOMPARE(readOf({}).text("//dcc:item/dcc:model"), QString("optic3"));
        ExampleSource bare;
        bare.results = {};
        QCOMPARE(readOf(bare).text("//dcc:item/dcc:model"), kDash);
        QCOMPARE(readOf(bare).text("//dcc:identification/dcc:value"), kDash);
    }

    void number_isThatOfTheIssue()
    {
        QCOMPARE(readOf({}).text(core("uniqueIdentifier")), QString("draft"));
        ExampleSource example;
        example.issue = testing::exampleIssue();
        QCOMPARE(readOf(example).text(core("uniqueIdentifier")), QString("17"));
        QCOMPARE(readOf(example).count(core("reportAmendedSubstituted")), 0);
        example.issue->number = " K\t17 \n";
        QCOMPARE(readOf(example).text(core("uniqueIdentifier")), QString("K 17"));
        example.issue->number = "  ";
        QCOMPARE(readOf(example).text(core("uniqueIdentifier")), kDash);
    }

    void amendment_namesTheOther()
    {
        ExampleSource example;
        example.issue = testing::exampleIssue();
        example.issue->amends = " 16\n<&> ";
        example.issue->reason = "address";
        const ReadXml xml = readOf(example);
        QCOMPARE(xml.text(core("reportAmendedSubstituted/dcc:typeOfChange")), QString("amended"));
        QCOMPARE(xml.text(core("reportAmendedSubstituted/dcc:replacedUniqueIdentifier")),
            QString("16 <&>"));
    }

    /// A day of the calendar, or that of the computation where there must be one.
    void days_areOfTheCalendar()
    {
        const ReadXml xml = with("date_performed", " 2026-02-28 ");
        QCOMPARE(xml.text(core("beginPerformanceDate")), QString("2026-02-28"));
        QCOMPARE(xml.text(core("endPerformanceDate")), QString("2026-02-28"));
        for (const char *wrong : {"2026-02-30", "yesterday", "", "<b>", "20261120"}) {
            const ReadXml other = with("date_performed", wrong);
            QCOMPARE(other.text(core("beginPerformanceDate")), QString("2026-11-21"));
            QCOMPARE(with("date_received", wrong).count(core("receiptDate")), 0);
            QCOMPARE(with("date_issued", wrong).count(core("issueDate")), 0);
        }
        QCOMPARE(readOf({}).text(core("receiptDate")), QString("2026-11-02"));
        QCOMPARE(readOf({}).text(core("issueDate")), QString("2026-11-21"));
    }

    void country_isTypedOrOfTheAddress_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("country");
        QTest::newRow("typed") << "DE"
                               << "SE-504 62 Bor\u00e5s"
                               << "DE";
        QTest::newRow("typed with blanks") << " DE\n"
                                           << ""
                                           << "DE";
        QTest::newRow("no code") << "Sweden"
                                 << "SE-504 62 Bor\u00e5s"
                                 << "SE";
        QTest::newRow("small letters") << "se"
                                       << "Oslo, NO"
                                       << "NO";
        QTest::newRow("neither") << ""
                                 << "Brinellgatan 4"
                                 << "ZZ";
        QTest::newRow("markup") << "<b>"
                                << "<b>SE</b>"
                                << "ZZ";
    }
    void country_isTypedOrOfTheAddress()
    {
        QFETCH(QString, typed);
        QFETCH(QString, address);
        QFETCH(QString, country);
        ExampleSource example;
        for (const char *whose : {"laboratory", "customer"}) {
            example.field(std::string(whose) + "_country") = typed.toStdString();
            example.field(std::string(whose) + "_address") = address.toStdString();
        }
        const ReadXml xml = readOf(example);
        QCOMPARE(xml.text(core("countryCodeISO3166_1")), country);
        QCOMPARE(xml.texts("//dcc:countryCode"), QStringList({country, country}));
    }

    void countries_areNotMixedUp()
    {
        const ReadXml xml = with("customer_country", "NO");
        QCOMPARE(xml.text(core("countryCodeISO3166_1")), QString("SE"));
        QCOMPARE(xml.text("//dcc:contact//dcc:countryCode"), QString("SE"));
        QCOMPARE(xml.text("/*/dcc:customer//dcc:countryCode"), QString("NO"));
    }

    void place_isOneOfTheWordsOfTheDcc()
    {
        const auto place = [](const char *typed) {
            return with("place", typed).text(core("performanceLocation"));
        };
        QCOMPARE(place("Dynamic Pressure  Laboratory"), QString("laboratory"));
        QCOMPARE(place("Brinellgatan 4, 504 62 Bor\u00e5s, Sweden"), QString("laboratory"));
        QCOMPARE(place("Example Motors AB"), QString("customer"));
        QCOMPARE(place("Bor\u00e5s"), QString("other"));
        ExampleSource bare; // nobody's place is not that of a laboratory without a name
        bare.recipe.certificate.fields.clear();
        QCOMPARE(readOf(bare).text(core("performanceLocation")), QString("other"));
    }

    void languages_areThoseOfTheDocument()
    {
        ExampleSource example;
        example.words = testing::exampleWordsInTwo();
        const ReadXml xml = readOf(example);
        QCOMPARE(xml.texts(core("usedLangCodeISO639_1")), QStringList({"en", "sv"}));
        QCOMPARE(xml.text(core("mandatoryLangCodeISO639_1")), QString("en"));
        QCOMPARE(xml.text("//dcc:item/dcc:name/dcc:content[@lang='sv']"),
            QString("sv: Pressure sensor"));
        QCOMPARE(xml.text("//dcc:person/dcc:name/dcc:content"), QString("A. Operator"));
    }

    /// Somebody signs, and only one.
    void signer_isWhoApproved_elseTheOperator()
    {
        QCOMPARE(readOf({}).texts("//dcc:mainSigner"), QStringList("true"));
        const ReadXml xml = with("approved_by", "B. Head");
        QCOMPARE(xml.texts("//dcc:role"), QStringList({"calibrated by", "approved by"}));
        QCOMPARE(xml.texts("//dcc:mainSigner"), QStringList({"false", "true"}));
        QCOMPARE(xml.texts("//dcc:person/dcc:name/dcc:content"),
            QStringList({"A. Operator", "B. Head"}));
        QCOMPARE(with("approved_by", " \n").texts("//dcc:role"), QStringList("calibrated by"));
    }

    void noElement_isEmpty()
    {
        ExampleSource bare;
        bare.recipe.certificate.fields.clear();
        bare.results = {};
        for (ExampleSource example : {ExampleSource(), bare})
            QCOMPARE(readOf(example).count("//*[not(node())]"), 0);
    }
};

DYNCAL_TEST(TestDccAdministration)
#include "tst_dcc_administration.moc"
