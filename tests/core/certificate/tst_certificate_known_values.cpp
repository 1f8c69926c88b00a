// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of other calibrations on the certificate: what is joined stands in the table of S(f), all
// stand in a table of their own.

#include "core/certificate/certificate_frequency_section.h"
#include "core/certificate/certificate_known_values.h"
#include "tests/support/example_results.h"
#include "tests/support/made_known.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::madeKnown;

namespace {

UncertaintyReport reportWith(std::vector<KnownValue> values)
{
    UncertaintyReport report;
    report.known = std::move(values);
    return report;
}

QStringList words(const std::vector<Message> &row)
{
    QStringList list;
    for (const Message &cell : row)
        list << QString::fromStdString(english(cell));
    return list;
}

} // namespace

class TestCertificateKnownValues : public QObject
{
    Q_OBJECT

private slots:
    void everyValue_hasItsLine()
    {
        const CertificateTable table = knownValuesTable(
            reportWith({madeKnown(0.93), madeKnown(-1.4, 500.0), testing::madeUncompared()}));
        QCOMPARE(table.rows.size(), std::size_t(3));
        QCOMPARE(words(table.rows[0]),
            QStringList({"works, certificate K 7", "static",
                "2.0000 \u00b5V/Pa \u00b1 0.0080 \u00b5V/Pa (k = 2)",
                "2.020 \u00b5V/Pa \u00b1 0.020 \u00b5V/Pa (k = 2)", "0.93", "agrees, joined"}));
        QCOMPARE(words(table.rows[1])[1], QString("500 Hz"));
        QCOMPARE(words(table.rows[1]).last(), QString("differs, not joined"));
        QCOMPARE(words(table.rows[2])[0], QString("far"));
        QCOMPARE(words(table.rows[2]).mid(3), QStringList({"\u2013", "\u2013", "not compared"}));
        for (const auto &row : table.rows)
            QCOMPARE(row.size(), table.columns.size());
    }

    void onlyWhatAgrees_isALineOfS_byFrequency()
    {
        const std::vector<JoinedLine> lines = joinedLines(
            reportWith({madeKnown(0.5, 800.0, "valve"), madeKnown(1.2), madeKnown(-0.2)}));
        QCOMPARE(lines.size(), std::size_t(2));
        QCOMPARE(QString::fromStdString(english(lines[0].name)), QString("static: works"));
        QCOMPARE(QString::fromStdString(english(lines[1].name)), QString("800 Hz: valve"));
        QCOMPARE(english(lines[0].magnitude), std::string("2.0000 \u00b5V/Pa"));
    }

    void section_hasTheJoinedLineAtItsPlace()
    {
        const CalibrationResults plain = example::calibration();
        CalibrationResults results = plain;
        auto report = std::make_shared<UncertaintyReport>(*plain.uncertainty);
        report->known = {madeKnown(0.5), madeKnown(-2.0, 10.0, "odd")};
        results.uncertainty = report;
        const Recipe recipe;
        const CertificateSection before = frequencyResponseSection(plain, recipe);
        const CertificateSection after = frequencyResponseSection(results, recipe);
        QCOMPARE(before.tables.size(), std::size_t(1));
        QCOMPARE(after.tables.size(), std::size_t(2));
        QCOMPARE(after.tables[0].rows.size(), before.tables[0].rows.size() + 1);
        QCOMPARE(words(after.tables[0].rows.front()).first(), QString("static: works"));
        QCOMPARE(after.tables[0].rows.front().size(), after.tables[0].columns.size());
        QVERIFY(words(after.tables[0].rows[1]) == words(before.tables[0].rows[0]));
        QCOMPARE(after.notes.size(), before.notes.size() + 1);
    }
};

DYNCAL_TEST(TestCertificateKnownValues)
#include "tst_certificate_known_values.moc"
