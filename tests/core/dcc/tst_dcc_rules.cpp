// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every rule has a DCC that breaks it and no other.

#include "core/dcc/dcc_check.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::exampleDcc;
using testing::replacedOnce;

namespace {

QStringList rulesOf(const std::string &xml)
{
    const Result<DccCheck> check = checkDcc(xml);
    if (!check)
        return {"unreadable"};
    QStringList rules;
    for (const DccFinding &finding : check->findings)
        rules << QString::fromStdString(finding.rule);
    rules.removeDuplicates();
    return rules;
}

} // namespace

class TestDccRules : public QObject
{
    Q_OBJECT

private:
    std::string m_good;

private slots:
    void initTestCase() { m_good = exampleDcc(); }

    void ownDocument_holds()
    {
        const Result<DccCheck> check = checkDcc(m_good);
        QVERIFY(check.has_value());
        for (const DccFinding &finding : check->findings)
            qWarning(
                "%s %s %s", finding.rule.c_str(), finding.where.c_str(), finding.found.c_str());
        QVERIFY(check->findings.empty());
        QCOMPARE(check->version, std::string("3.3.0"));
        QCOMPARE(check->number, std::string("draft"));
        QVERIFY(!check->isSchemaChecked);
    }

    void fault_isFoundByItsRuleAlone_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("with");
        QTest::addColumn<QString>("rule");
        const auto row = [](const char *name, const char *what, const char *with,
                             const char *rule) { QTest::newRow(name) << what << with << rule; };
        row("release without v", "<dcc:release>v", "<dcc:release>", "release");
        row("release of two numbers", "<dcc:release>v0.1.0", "<dcc:release>v0.1", "release");
        row("release with a word", "<dcc:release>v0.1.0", "<dcc:release>v0.1.0-rc", "release");
        row("release with two dots", "<dcc:release>v0.1.0", "<dcc:release>v0..0", "release");
        row("id nobody refers to", "<dcc:respPersons>", "<dcc:respPersons id=\"x\">", "id");
        row("id twice", "<dcc:respPersons>", "<dcc:respPersons id=\"item\">", "id");
        row("refId to nothing", "<dcc:respPersons>", "<dcc:respPersons refId=\"x\">", "refId");
        row("two blanks", "<si:valueRealXMLList>", "<si:valueRealXMLList> ", "list");
        row("country in small letters", "<dcc:countryCodeISO3166_1>SE",
            "<dcc:countryCodeISO3166_1>se", "country");
        row("country that is none", "<dcc:countryCode>SE", "<dcc:countryCode>ZZ", "country");
        row("language that is none", "lang=\"en\"", "lang=\"xx\"", "language");
        row("language that is not used", "lang=\"en\"", "lang=\"sv\"", "language");
        row("mandatory language that is not used", "<dcc:mandatoryLangCodeISO639_1>en",
            "<dcc:mandatoryLangCodeISO639_1>de", "language");
        row("day that is none", "<dcc:receiptDate>2026-11-02", "<dcc:receiptDate>2026-11-31",
            "date");
        row("end before begin", "<dcc:endPerformanceDate>2026-11-20",
            "<dcc:endPerformanceDate>2026-11-19", "date");
        row("unit with a blank", "<si:unit>", "<si:unit> ", "unit");
        row("unit in letters", "<si:unit>\\", "<si:unit>", "unit");
        row("unit with a brace", "\\tothe{-1}", "\\tothe{-1", "unit");
        row("refType nobody declared", "refType=\"dyncal_draft\"", "refType=\"dyncal_other\"",
            "refType");
    }
    void fault_isFoundByItsRuleAlone()
    {
        QFETCH(QString, what);
        QFETCH(QString, with);
        QFETCH(QString, rule);
        const std::string broken = replacedOnce(m_good, what.toStdString(), with.toStdString());
        QVERIFY(broken != m_good);
        QCOMPARE(rulesOf(broken), QStringList(rule));
    }

    /// An element as a whole, from its begin to its end.
    void missingPart_isFound()
    {
        for (const char *part : {"usedMethods", "influenceConditions"}) {
            const std::string name = std::string("dcc:").append(part);
            const std::size_t begin = m_good.find("<" + name + ">");
            const std::string end = "</" + name + ">";
            const std::size_t behind = m_good.find(end, begin) + end.size();
            std::string broken = m_good;
            broken.erase(begin, behind - begin);
            QVERIFY(rulesOf(broken).contains(part));
        }
    }

    /// One value less or more than the others.
    void lengths_areCounted_data()
    {
        QTest::addColumn<QString>("list");
        for (const char *list : {"valueRealXMLList", "valueImagXMLList", "valueStandardMUXMLList",
                 "valueExpandedMUXMLList"})
            QTest::newRow(list) << list;
    }
    void lengths_areCounted()
    {
        QFETCH(QString, list);
        const std::string begin = "<si:" + list.toStdString() + ">";
        QCOMPARE(rulesOf(replacedOnce(m_good, begin, begin + "1 ")), QStringList("length"));
        QVERIFY(m_good.find(begin) != m_good.npos);
    }

    /// One unit for all, or one for each: nothing between.
    void units_areOneOrOneForEach()
    {
        const std::string unit = "<si:unitXMLList>\\hertz</si:unitXMLList>";
        QVERIFY(m_good.find(unit) != m_good.npos);
        const std::string two = "<si:unitXMLList>\\hertz \\hertz</si:unitXMLList>";
        QCOMPARE(rulesOf(replacedOnce(m_good, unit, two)), QStringList("length"));
    }

    void finding_saysWhereWhatAndWhatIsNeeded()
    {
        const Result<DccCheck> check
            = checkDcc(replacedOnce(m_good, "<dcc:countryCode>SE", "<dcc:countryCode>ZZ"));
        QVERIFY(check.has_value());
        QCOMPARE(check->findings.size(), std::size_t(1));
        const DccFinding &finding = check->findings.front();
        QCOMPARE(finding.where,
            std::string("administrativeData/calibrationLaboratory/contact/location/countryCode"));
        QCOMPARE(finding.found, std::string("ZZ"));
        QVERIFY(english(finding.needed).find("countries of laboratory and customer")
            != std::string::npos);
    }

    void conditionsOfAllResults_countForEach()
    {
        std::string xml = m_good;
        const std::string begin = "<dcc:influenceConditions>", end = "</dcc:influenceConditions>";
        const std::size_t from = xml.find(begin);
        const std::string part = xml.substr(from, xml.find(end) + end.size() - from);
        xml.erase(from, part.size());
        xml = replacedOnce(xml, "<dcc:measurementResults>", "<dcc:measurementResults>" + part);
        QCOMPARE(rulesOf(xml), QStringList());
    }

    /// A signature brings ids of its own.
    void idsOfASignature_areItsOwn()
    {
        const std::string signature
            = "<ds:Signature xmlns:ds=\"http://www.w3.org/2000/09/xmldsig#\">"
              "<ds:Object id=\"o\"/></ds:Signature>";
        const std::string end = "</dcc:digitalCalibrationCertificate>";
        QCOMPARE(rulesOf(replacedOnce(m_good, end, signature + end)), QStringList());
    }

    void otherPrefixes_areTheSame()
    {
        QString xml = QString::fromStdString(m_good);
        xml.replace("<dcc:", "<c:").replace("</dcc:", "</c:").replace("xmlns:dcc", "xmlns:c");
        QCOMPARE(rulesOf(xml.toStdString()), QStringList());
    }

    void whatIsNoDcc_isRefused_data()
    {
        QTest::addColumn<QString>("xml");
        QTest::newRow("empty") << "";
        QTest::newRow("no XML") << "hello";
        QTest::newRow("cut off") << "<a><b>";
        QTest::newRow("other document") << "<?xml version=\"1.0\"?><html/>";
        QTest::newRow("document type")
            << "<!DOCTYPE a SYSTEM \"file:///etc/passwd\"><digitalCalibrationCertificate/>";
        QTest::newRow("entity")
            << "<!DOCTYPE a [<!ENTITY b \"c\">]><digitalCalibrationCertificate/>";
        QTest::newRow("deep") << "<digitalCalibrationCertificate>" + QString("<a>").repeated(5000)
                + QString("</a>").repeated(5000) + "</digitalCalibrationCertificate>";
    }
    void whatIsNoDcc_isRefused()
    {
        QFETCH(QString, xml);
        const Result<DccCheck> check = checkDcc(xml.toStdString());
        QVERIFY(!check.has_value());
        QCOMPARE(check.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(english(check.error().message).size() > 20);
    }

    void tooLarge_isRefused()
    {
        const Result<DccCheck> check = checkDcc(std::string((std::size_t(64) << 20U) + 1, ' '));
        QVERIFY(!check.has_value());
    }

    /// Cut anywhere: refused or judged, never a crash.
    void everyCut_isAnswered()
    {
        for (std::size_t size = 0; size < m_good.size(); size += 997)
            (void)checkDcc(m_good.substr(0, size));
        QVERIFY(true);
    }
};

DYNCAL_TEST(TestDccRules)
#include "tst_dcc_rules.moc"
