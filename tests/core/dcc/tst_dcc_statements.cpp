// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the laboratory states: draft, clauses, place, conformity, issue.

#include "core/dcc/dcc_statements.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace dyncal;
using testing::ExampleSource;
using testing::ReadXml;

namespace {

const std::string kConformity = "//dcc:statement[@refType='dyncal_conformityStatement']";

ReadXml readOf(ExampleSource example)
{
    return ReadXml(dccStatements(example.source()));
}

std::string of(const char *refType, const char *rest)
{
    return std::string("//dcc:statement[@refType='") + refType + "']" + rest;
}

/// 2 V/Pa at the onset; the last of four rows deviates by 4 %, each with u of 0.3 % and the level's
/// noise of 0.4 %: u of the ratio is 0.5 % but for the deviation itself.
ExampleSource judged(double within_percent, DecisionRule rule = DecisionRule::Simple)
{
    ExampleSource example;
    example.results = {};
    ResponseResult made;
    made.unit = made.sensitivityUnit = "V/Pa";
    made.sensitivity = 2.0;
    made.fLow_Hz = 500.0;
    made.fHigh_Hz = 5e3;
    made.frequency_Hz = Eigen::Vector4d(1000.0, 1258.9, 1584.9, 1995.3);
    made.magnitude = Eigen::Vector4d(2.0, 2.02, 2.04, 2.08);
    made.phase_rad = Eigen::Vector4d::Zero();
    made.u_noiseMagnitude = made.u_magnitude = Eigen::Vector4d::Constant(0.006);
    made.boundEnd = made.boundAlias = made.u_frontMagnitude = Eigen::Vector4d::Zero();
    made.dof = Eigen::Vector4d::Constant(std::numeric_limits<double>::infinity());
    made.front = {1e-9, 1e-10};
    ShotSensitivity shot;
    shot.shot = 1;
    shot.uLevel_relative = 0.004;
    made.shots = {shot};
    example.results.response = std::make_shared<ResponseResult>(made);
    example.recipe.certificate.decision
        = DecisionSettings{rule, within_percent, 1000.0, 1995.3, 5.0};
    return example;
}

ExampleSource issued(const char *amends = "")
{
    ExampleSource example;
    example.issue = testing::exampleIssue();
    example.issue->amends = amends;
    example.issue->reason = "address <corrected> & more";
    return example;
}

} // namespace

class TestDccStatements : public QObject
{
    Q_OBJECT

private slots:
    void sentences_haveTheirClauses()
    {
        const ReadXml xml = readOf({});
        QCOMPARE(xml.texts(of("dyncal_statement", "/dcc:reference")),
            QStringList({"7.8.2.1 l", "7.8.2.1", "7.8.6.2", "7.8.4.1 c", "7.8.4.3"}));
        for (const QString &norm : xml.texts("//dcc:norm"))
            QCOMPARE(norm, QString("ISO/IEC 17025:2017"));
        const QStringList said = xml.texts(of("dyncal_statement", "/dcc:declaration/dcc:content"));
        QCOMPARE(said.size(), 5);
        QVERIFY(said[0].contains("only to the item"));
        QVERIFY(said[1].contains("reproduced"));
        QVERIFY(said[2].contains("conformity"));
        QVERIFY(said[3].contains("traceability"));
        QVERIFY(said[4].contains("interval"));
    }

    /// That it is traceable says the clause of traceability, and only of what is issued.
    void traceable_isTheIssuedOneAlone()
    {
        const std::string path = "//dcc:statement[dcc:reference='7.8.4.1 c']/dcc:traceable";
        QCOMPARE(readOf({}).text(path), QString("false"));
        QCOMPARE(readOf(issued()).text(path), QString("true"));
        QCOMPARE(readOf(issued()).count("//dcc:traceable"), 1);
    }

    void draft_namesWhatIsMissing()
    {
        const std::string path = of("dyncal_draft", "/dcc:declaration/dcc:content");
        QCOMPARE(readOf({}).count(path), 1);
        ExampleSource example;
        example.recipe.certificate.fields.erase("customer");
        example.recipe.certificate.fields.erase("place");
        const QStringList said = readOf(example).texts(path);
        QCOMPARE(said.size(), 3);
        QVERIFY(said[1].endsWith("\nPlace of calibration"));
        QVERIFY(said[2].endsWith("\nCustomer"));
        QCOMPARE(readOf(issued()).count(of("dyncal_draft", "")), 0);
        QCOMPARE(readOf({}).count(of("dyncal_issue", "")), 0);
    }

    void place_isText()
    {
        const std::string path = of("dyncal_placeOfCalibration", "/dcc:declaration/dcc:content");
        QCOMPARE(readOf({}).text(path), QString::fromUtf8("Bor\u00e5s"));
        ExampleSource example;
        for (const std::string &hostile : test::hostileTexts()) {
            example.field("place") = hostile;
            const ReadXml xml(dccStatements(example.source()));
            QVERIFY2(xml.isWellFormed(), hostile.c_str());
            QVERIFY2(
                test::isFitToShow(xml.text(path).toStdString(), LineBreaks::Keep), hostile.c_str());
            QCOMPARE(xml.count("//dcc:statement"), 7);
        }
    }

    void issue_isBoundToItsHashes()
    {
        const ReadXml xml = readOf(issued());
        const auto quantity = [](const char *refType) {
            return of("dyncal_issue", "/dcc:data/dcc:quantity[@refType='") + refType
                + "']/dcc:noQuantity/dcc:content";
        };
        QCOMPARE(xml.text(quantity("dyncal_trailHead dyncal_sha256")), QString(64, 'a'));
        QCOMPARE(xml.text(quantity("dyncal_resultsHash dyncal_sha256")), QString(64, 'b'));
        QCOMPARE(xml.text(quantity("dyncal_state")), QString("issued, not signed"));
        QCOMPARE(xml.count(of("dyncal_issue", "/dcc:declaration/dcc:content")), 1);
    }

    void amendment_saysWhatChanged()
    {
        const ReadXml xml = readOf(issued("16"));
        const QStringList said = xml.texts(of("dyncal_issue", "/dcc:declaration/dcc:content"));
        QCOMPARE(said.size(), 2);
        QCOMPARE(said[1],
            QString("certificate 16, which is no longer valid; what changed: address <corrected> & "
                    "more"));
    }

    void noDecision_noStatementOfConformity()
    {
        QCOMPARE(readOf({}).count(kConformity), 0);
        QCOMPARE(readOf({}).count("//dcc:conformity"), 0);
    }

    /// 4 % lies within 5 and not within 3; the guard band of about 1 % leaves neither 4.5.
    void verdict_isThatOfTheRule()
    {
        const auto verdict = [](double within, DecisionRule rule) {
            return readOf(judged(within, rule)).text(kConformity + "/dcc:conformity");
        };
        QCOMPARE(verdict(5.0, DecisionRule::Simple), QString("pass"));
        QCOMPARE(verdict(3.0, DecisionRule::Simple), QString("fail"));
        QCOMPARE(verdict(4.5, DecisionRule::Simple), QString("pass"));
        QCOMPARE(verdict(4.5, DecisionRule::GuardBand), QString("fail"));
        QCOMPARE(verdict(9.0, DecisionRule::Risk), QString("pass"));
    }

    void norm_isThatOfTheRule()
    {
        const auto norm = [](DecisionRule rule) {
            return readOf(judged(5.0, rule)).text(kConformity + "/dcc:norm");
        };
        QCOMPARE(norm(DecisionRule::Simple), QString("ILAC-G8:09/2019"));
        QCOMPARE(norm(DecisionRule::GuardBand), QString("ILAC-G8:09/2019"));
        QCOMPARE(norm(DecisionRule::Risk), QString("JCGM 106:2012"));
    }

    void worstFrequency_hasItsDeviationWithU()
    {
        const ReadXml xml = readOf(judged(5.0));
        const auto real = [&](const char *refType, const char *part) {
            return xml.text(
                kConformity + "/dcc:data/dcc:quantity[@refType='" + refType + "']" + part);
        };
        QCOMPARE(real("dyncal_conformityLimit", "/si:real/si:value").toDouble(), 5.0);
        QCOMPARE(real("dyncal_conformityLimit", "/si:real/si:unit"), QString("\\percent"));
        const QString frequency
            = real("dyncal_conformityWorst dyncal_frequency", "/si:real/si:value");
        QVERIFY(std::abs(frequency.toDouble() - 1.995) < 1e-9);
        QCOMPARE(real("dyncal_conformityWorst dyncal_frequency", "/si:real/si:unit"),
            QString("\\kilo\\hertz"));
        QCOMPARE(real("dyncal_conformityDeviation", "/si:real/si:value").toDouble(), 4.0);
        const double U = real("dyncal_conformityDeviation", "//si:valueExpandedMU").toDouble();
        QVERIFY2(U > 0.95 && U < 1.1, qPrintable(QString::number(U)));
        QCOMPARE(real("dyncal_conformityDeviation", "//si:coverageProbability"), QString("0.95"));
        QCOMPARE(real("dyncal_conformityRisk", "/si:real/si:unit"), QString("\\percent"));
    }

    /// 4 % less the limit of 4 % is nothing: as likely beyond it as not.
    void risk_isHalfAtTheLimit()
    {
        const double risk = readOf(judged(4.0))
                                .text(kConformity
                                    + "/dcc:data/dcc:quantity[@refType='dyncal_conformityRisk']"
                                      "/si:real/si:value")
                                .toDouble();
        QCOMPARE(risk, 50.0);
    }

    void noVerdict_hasNoWordOfTheSchema()
    {
        ExampleSource example = judged(5.0);
        example.results.response = nullptr;
        const ReadXml xml = readOf(example);
        QCOMPARE(xml.count(kConformity), 1);
        QCOMPARE(xml.count("//dcc:conformity"), 0);
        QCOMPARE(xml.count("//si:real"), 0);
        QVERIFY(xml.count(kConformity + "/dcc:data/dcc:quantity") >= 3);
    }

    void sentences_areInBothLanguages()
    {
        ExampleSource example = judged(5.0);
        example.words = testing::exampleWordsInTwo();
        const ReadXml xml = readOf(example);
        QVERIFY(xml.count("//dcc:declaration/dcc:content[@lang='sv']") > 5);
        QCOMPARE(xml.count("//dcc:declaration/dcc:content[@lang='sv']"),
            xml.count("//dcc:declaration/dcc:content[@lang='en']"));
    }
};

DYNCAL_TEST(TestDccStatements)
#include "tst_dcc_statements.moc"
