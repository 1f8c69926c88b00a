// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/kept_results.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>

using namespace dyncal;

class TestKeptResults : public QObject
{
    Q_OBJECT

private slots:
    void certificate_comesBackAsItWas();
    void nothingKept_orNotInThisForm_isNothing_data();
    void nothingKept_orNotInThisForm_isNothing();
    void tableOfUnevenRows_isMadeEven();
    void textOfAnotherHand_isMadeFitToShow();
};

namespace {

/// The content of a project that keeps `certificate`, through bytes as a file does.
QJsonObject projectOf(const CertificateData &certificate)
{
    const QJsonObject project{{kKeptResults, keptResultsJson(certificate, "2026-01-31T12:00:00Z")}};
    return QJsonDocument::fromJson(QJsonDocument(project).toJson()).object();
}

Message plain(const char *text)
{
    return {text, {}};
}

CertificateSection section()
{
    CertificateSection section;
    section.title = plain("Results");
    section.paragraphs
        = {{"Of %1 shots, %M1.", {"3"}, {plain("as was said"), plain("A line below.")}}};
    section.fields = {{"natural_frequency", plain("Frequency"), {"%1 Hz", {"1.5e4"}}}};
    section.tables = {{"shots", plain("Shots"), {{plain("Shot")}, {plain("Step"), true}},
        {{plain("1"), {"%1 Pa", {"2e5"}}}, {plain("2"), {"%1 Pa", {"4e5"}}}}}};
    section.notes = {{"A note of %1 and %2.", {"å", "%1"}}};
    return section;
}

} // namespace

void TestKeptResults::certificate_comesBackAsItWas()
{
    CertificateData certificate;
    certificate.title = plain("Calibration certificate");
    certificate.sections = {section(), {}};
    const auto kept = keptResults(projectOf(certificate));
    QVERIFY(kept.has_value());
    QCOMPARE(kept->savedUtc, std::string("2026-01-31T12:00:00Z"));
    QCOMPARE(kept->certificate.title, certificate.title);
    QCOMPARE(kept->certificate.sections.size(), 2U);
    const CertificateSection &was = certificate.sections.front();
    const CertificateSection &is = kept->certificate.sections.front();
    QCOMPARE(is.title, was.title);
    QCOMPARE(is.paragraphs, was.paragraphs);
    QCOMPARE(is.notes, was.notes);
    QCOMPARE(is.fields.size(), 1U);
    QCOMPARE(is.fields[0].label, was.fields[0].label);
    QCOMPARE(is.fields[0].value, was.fields[0].value);
    QCOMPARE(is.tables.size(), 1U);
    QCOMPARE(is.tables[0].caption, was.tables[0].caption);
    QCOMPARE(is.tables[0].columns[1].heading, was.tables[0].columns[1].heading);
    QCOMPARE(is.tables[0].rows, was.tables[0].rows);
}

void TestKeptResults::nothingKept_orNotInThisForm_isNothing_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::newRow("nothing") << QByteArray("{}");
    QTest::newRow("a text") << QByteArray(R"({"kept_results": "yes"})");
    QTest::newRow("a list") << QByteArray(R"({"kept_results": [1, 2]})");
    QTest::newRow("no sections") << QByteArray(R"({"kept_results": {"title": {"text": "A"}}})");
    QTest::newRow("sections no list") << QByteArray(R"({"kept_results": {"sections": 3}})");
}

void TestKeptResults::nothingKept_orNotInThisForm_isNothing()
{
    QFETCH(const QByteArray, json);
    const QJsonDocument document = QJsonDocument::fromJson(json);
    QVERIFY(document.isObject());
    QVERIFY(!keptResults(document.object()));
}

void TestKeptResults::tableOfUnevenRows_isMadeEven()
{
    const auto kept = keptResults(QJsonDocument::fromJson(R"({"kept_results": {"sections": [
        {"tables": [{"columns": [{"text": "A"}, {"text": "B"}],
            "rows": [[{"text": "1"}], [], 7, [{"text": "1"}, {"text": "2"}, {"text": "3"}]]}]},
        "no section"]}})")
                                      .object());
    QVERIFY(kept.has_value());
    QCOMPARE(kept->certificate.sections.size(), 2U);
    const CertificateTable &table = kept->certificate.sections[0].tables.at(0);
    QCOMPARE(table.rows.size(), 4U);
    for (const auto &row : table.rows)
        QCOMPARE(row.size(), 2U);
    QVERIFY(kept->certificate.sections[1].fields.empty());
}

void TestKeptResults::textOfAnotherHand_isMadeFitToShow()
{
    CertificateData certificate;
    const std::string foreign = "a\x1b[2J\u202eb";
    certificate.title = plain(foreign.c_str());
    certificate.sections = {section()};
    const auto kept = keptResults(projectOf(certificate));
    QVERIFY(kept.has_value());
    QCOMPARE(std::string(kept->certificate.title.text), std::string("a\\x1b[2J<U+202E>b"));
}

DYNCAL_TEST(TestKeptResults)
#include "tst_kept_results.moc"
