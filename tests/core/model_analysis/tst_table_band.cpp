// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a table of the chain or of a reference transducer ends the band, and where it says too
// little.

#include "core/model_analysis/table_band.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

ReferenceSensitivity tableAt(const std::vector<double> &frequencies_Hz)
{
    std::vector<ReferencePoint> rows;
    for (const double f_Hz : frequencies_Hz)
        rows.push_back({f_Hz, 1.0, 0.001});
    return ReferenceSensitivity::fromTable(std::move(rows)).value();
}

/// The band of records from 1 kHz to 1 MHz, with such a table.
ResponseResult bandWith(const std::vector<double> &frequencies_Hz, BandEnd why = BandEnd::Chain)
{
    ResponseResult result;
    result.fLow_Hz = 1e3;
    result.fHigh_Hz = 1e6;
    endByTable(tableAt(frequencies_Hz), why, result);
    return result;
}

std::string saidOf(const ResponseResult &result, const char *id)
{
    const auto found = std::ranges::find(result.findings, std::string(id), &Finding::id);
    return found == result.findings.end() ? "" : english(found->message);
}

} // namespace

class TestTableBand : public QObject
{
    Q_OBJECT

private slots:
    void ends_areThoseOfTheNarrower()
    {
        const ResponseResult inside = bandWith({2e3, 1e4, 1e5});
        QCOMPARE(inside.fLow_Hz, 2e3);
        QCOMPARE(inside.fHigh_Hz, 1e5);
        QVERIFY(inside.lowEnd == BandEnd::Chain && inside.highEnd == BandEnd::Chain);
        const ResponseResult around = bandWith({100, 1e3, 1e4, 1e5, 1e6, 1e7}, BandEnd::Reference);
        QCOMPARE(around.fLow_Hz, 1e3);
        QCOMPARE(around.fHigh_Hz, 1e6);
        QVERIFY(around.lowEnd != BandEnd::Reference && around.highEnd != BandEnd::Reference);
        QVERIFY(inside.findings.empty() && around.findings.empty());
    }

    /// A decade is how far apart such tables have their rows.
    void moreThanADecadeWithoutRow_isSaid()
    {
        const std::string said = saidOf(bandWith({500, 5e3, 5.1e4, 1e6}), "RSP-006");
        QVERIFY2(said.find("51 kHz") != said.npos && said.find("1 MHz") != said.npos, said.c_str());
        QVERIFY(said.find("chain.source") != said.npos);
        QVERIFY(saidOf(bandWith({500, 5e3, 5e4, 5e5, 1e6}), "RSP-006").empty());
        QVERIFY(saidOf(bandWith({500, 5e3, 2e6}, BandEnd::Reference), "RSP-006")
                    .find("comparison.source")
            != std::string::npos);
    }

    /// Outside the band it does no harm.
    void gapOutsideTheBand_isNot()
    {
        QVERIFY(bandWith({1, 900, 8e3, 7e4, 5e5, 1.1e6, 1e9}).findings.empty());
    }

    void nothingInCommon_isSaid()
    {
        for (const auto &rows : {std::vector<double>{10, 500}, {2e6, 3e6}}) {
            const ResponseResult result = bandWith(rows);
            const std::string said = saidOf(result, "RSP-007");
            QVERIFY2(said.find("nothing in common") != said.npos, said.c_str());
            QVERIFY(said.find("1 kHz") != said.npos && said.find("1 MHz") != said.npos);
            QVERIFY(saidOf(result, "RSP-006").empty());
        }
        QVERIFY(saidOf(bandWith({10, 1e3}), "RSP-007").empty()); // one frequency
    }

    void model_hasNoGap()
    {
        const auto model
            = ReferenceSensitivity::fromModel({1e-9, 1e-12, 1e5, 10.0, 0.02, 1e-4}).value();
        ResponseResult result;
        result.fLow_Hz = 1e3;
        result.fHigh_Hz = 1e6;
        endByTable(model, BandEnd::Reference, result);
        QVERIFY(result.findings.empty() && result.fHigh_Hz == 1e6);
        QVERIFY(!model.widestGap(1.0, 1e9));
    }

    /// A sensor flat to 100 kHz, and a table of the chain in another unit than hertz.
    void tableThatDoesNotFit_isTold_data()
    {
        QTest::addColumn<QList<double>>("frequencies");
        QTest::addColumn<QList<double>>("magnitudes");
        QTest::addColumn<QString>("said");
        const QList<double> magnitudes{1.0, 0.999, 0.99, 0.9};
        QTest::newRow("fits") << QList<double>{1e3, 1e4, 1e5, 3e5} << magnitudes << "";
        QTest::newRow("in kHz") << QList<double>{1, 10, 1e3, 2e3} << magnitudes << "ends at 2 kHz";
        QTest::newRow("an amplifier too slow for the record") << QList<double>{1e3, 1e4, 3e4,
            2e5} << QList<double>{1.0, 0.9, 0.6, 0.1} << "off by -53";
        QTest::newRow("ends below the band's end")
            << QList<double>{1e3, 5e3, 1e4, 2e4} << magnitudes << "";
    }
    void tableThatDoesNotFit_isTold()
    {
        QFETCH(QList<double>, frequencies);
        QFETCH(QList<double>, magnitudes);
        QFETCH(QString, said);
        std::vector<ReferencePoint> rows;
        for (qsizetype i = 0; i < frequencies.size(); ++i)
            rows.push_back({frequencies[i], magnitudes[i], 0.001});
        const auto table = ReferenceSensitivity::fromTable(rows).value();
        for (const bool isFlatKnown : {true, false}) {
            ResponseResult result;
            result.fLow_Hz = 1e3;
            result.fHigh_Hz = 1e6;
            if (isFlatKnown)
                result.characteristics.within10percent_Hz = 1e5;
            endByTable(table, BandEnd::Chain, result);
            const QString text = QString::fromStdString(saidOf(result, "RSP-008"));
            QCOMPARE(text.isEmpty(), said.isEmpty() || !isFlatKnown);
            QVERIFY2(text.isEmpty() || text.contains(said), qPrintable(text));
        }
    }
};

DYNCAL_TEST(TestTableBand)
#include "tst_table_band.moc"
