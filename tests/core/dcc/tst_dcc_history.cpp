// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The section of earlier calibrations in the DCC: what the pages say of them.

#include "core/dcc_reading/dcc_contents.h"
#include "core/history/history_section.h"
#include "core/project/certificate_template.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/core/history/made_history.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::ReadXml;

namespace {

/// Issued, with a template that asks for the section.
std::string dccWith(const std::optional<CertificateSection> &history)
{
    const CalibrationResults results = example::calibration();
    const Recipe recipe = testing::exampleDccRecipe();
    CertificateData data = makeCertificate(results, recipe, testing::kExampleCreated);
    if (!data.section(kHistorySection)) {
        CertificateSection section;
        section.id = kHistorySection;
        section.title = {"Earlier calibrations", {}};
        section.paragraphs = {{"To come.", {}}};
        data.sections.push_back(section);
    }
    CertificateIssue issue = testing::exampleIssue();
    issue.history = history;
    markIssued(issue, data);
    return dccText(data, results, recipe, issue, {});
}

const std::string kResult = "//dcc:result[@refType='dyncal_history']";

std::string listOf(const std::string &quantity, const std::string &rest = {})
{
    return kResult + "//dcc:list[@refType='dyncal_historyOf " + quantity + "']" + rest;
}

std::string columnOf(const std::string &quantity, const std::string &column, const char *rest)
{
    return listOf(quantity, "/dcc:quantity[@refType='" + column + "']" + rest);
}

} // namespace

class TestDccHistory : public QObject
{
    Q_OBJECT

private slots:
    /// As printed: 5.00 uV/Pa with U = 0.10 uV/Pa, then 5.20, which is sqrt(2) of both U away.
    void rows_areThoseOfThePages()
    {
        const ReadXml xml(dccWith(historySection(testing::madeHistory({5e-6, 5.2e-6}))));
        const std::string of = "dyncal_sensitivity";
        QCOMPARE(xml.texts(columnOf(of, "dyncal_dayOfCalibration", "/dcc:noQuantity/dcc:content")),
            QStringList({"2020-01-01", "2021-01-01"}));
        QCOMPARE(
            xml.texts(columnOf(of, "dyncal_earlierCertificate", "/dcc:noQuantity/dcc:content")),
            QStringList({"11", "12"}));
        const auto value = [&](const char *list) {
            return xml.text(columnOf(of, "dyncal_earlierValue", "//si:").append(list));
        };
        QCOMPARE(value("valueXMLList"), QString("5.00 5.20"));
        QCOMPARE(value("unitXMLList"), QString("\\micro\\volt\\pascal\\tothe{-1}"));
        QCOMPARE(value("valueExpandedMUXMLList"), QString("0.10 0.10"));
        QCOMPARE(value("coverageFactorXMLList"), QString("2"));
        QCOMPARE(xml.text(columnOf(of, "dyncal_normalisedError", "//si:valueXMLList")),
            QString("NaN 1.4"));
    }

    void everyQuantity_hasItsList_andNoteIsSaid()
    {
        const SensorHistory history = testing::madeHistory({5e-6, 5.1e-6, 5e-6});
        const CertificateSection section = historySection(history);
        const ReadXml xml(dccWith(section));
        for (const char *quantity :
            {"dyncal_naturalFrequency", "dyncal_dampingRatio", "dyncal_sensitivity"})
            QCOMPARE(xml.count(listOf(quantity)), 1);
        QCOMPARE(xml.count(kResult + "//dcc:list"), static_cast<int>(section.tables.size()));
        const QString said = xml.texts(kResult + "/dcc:data/dcc:text//dcc:content").join('\n');
        for (const Message &note : section.notes)
            QVERIFY2(said.contains(QString::fromStdString(english(note))), note.text);
    }

    /// A machine finds them by the refType, and the one of today by its own as before.
    void reader_hasValueAndU_andIsNotMistaken()
    {
        const Result<DccContents> contents
            = readDcc(dccWith(historySection(testing::madeHistory({5e-6, 5.2e-6}))));
        QVERIFY(contents.has_value());
        int lists = 0;
        for (const StatedTable &table : contents->tables) {
            if (table.refTypes
                != std::vector<std::string>{"dyncal_historyOf", "dyncal_sensitivity"})
                continue;
            ++lists;
            QVERIFY(table.notUnderstood.empty());
            const StatedValues &stated = table.columns.front().stated.values;
            QCOMPARE(stated.values.size(), std::size_t(2));
            QVERIFY(std::abs(stated.values[1] - 5.2e-6) < 1e-20);
            QVERIFY(std::abs(stated.u[1] * stated.k[1] - 1e-7) < 1e-20);
        }
        QCOMPARE(lists, 1);
    }

    void draft_saysWhatIsToCome()
    {
        const ReadXml xml(dccWith({}));
        QCOMPARE(xml.count(kResult), 1);
        QCOMPARE(xml.count(kResult + "//dcc:list"), 0);
        QCOMPARE(xml.count(kResult + "/dcc:data/dcc:text"), 1);
    }
};

DYNCAL_TEST(TestDccHistory)
#include "tst_dcc_history.moc"
