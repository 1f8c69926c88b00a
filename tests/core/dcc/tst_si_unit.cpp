// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Printed units in the D-SI: by its grammar, and back by the reader of references.

#include "core/dcc/si_unit.h"
#include "core/dcc_reading/d_si_unit.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestSiUnit : public QObject
{
    Q_OBJECT

private slots:
    void printedUnit_isThatOfTheDSi_data()
    {
        QTest::addColumn<QString>("printed");
        QTest::addColumn<QString>("dsi");
        QTest::newRow("none") << ""
                              << "\\one";
        QTest::newRow("one") << "1"
                             << "\\one";
        QTest::newRow("hertz") << "Hz"
                               << "\\hertz";
        QTest::newRow("prefix") << "MHz"
                                << "\\mega\\hertz";
        QTest::newRow("metre, not milli") << "m"
                                          << "\\metre";
        QTest::newRow("millimetre") << "mm"
                                    << "\\milli\\metre";
        QTest::newRow("quotient") << "\u00b5V/Pa"
                                  << "\\micro\\volt\\pascal\\tothe{-1}";
        QTest::newRow("Greek micro") << "\u03bcs"
                                     << "\\micro\\second";
        QTest::newRow("prefixes on both sides") << "mV/kPa"
                                                << "\\milli\\volt\\kilo\\pascal\\tothe{-1}";
        QTest::newRow("charge") << "pC/Pa"
                                << "\\pico\\coulomb\\pascal\\tothe{-1}";
        QTest::newRow("velocity") << "m/s"
                                  << "\\metre\\second\\tothe{-1}";
        QTest::newRow("squared") << "m/s2"
                                 << "\\metre\\second\\tothe{-2}";
        QTest::newRow("area") << "N/mm2"
                              << "\\newton\\milli\\metre\\tothe{-2}";
        QTest::newRow("one over") << "1/Pa"
                                  << "\\pascal\\tothe{-1}";
        QTest::newRow("trend") << "%/MPa"
                               << "\\percent\\mega\\pascal\\tothe{-1}";
        QTest::newRow("degree") << "\u00b0"
                                << "\\degree";
        QTest::newRow("level") << "dB"
                               << "\\deci\\bel";
        QTest::newRow("kelvin") << "K"
                                << "\\kelvin";
        QTest::newRow("bar") << "mbar"
                             << "\\milli\\bar";
    }
    void printedUnit_isThatOfTheDSi()
    {
        QFETCH(QString, printed);
        QFETCH(QString, dsi);
        const auto unit = dsiUnitOf(printed.toStdString());
        QVERIFY(unit.has_value());
        QCOMPARE(QString::fromStdString(*unit), dsi);
    }

    void whatIsNotKnown_isNeverGuessed_data()
    {
        QTest::addColumn<QString>("printed");
        for (const char *unit : {"g", "psi", "mv/Pa", "V/", "/Pa", "V Pa", "kkPa", "m%", "counts"})
            QTest::newRow(unit) << unit;
    }
    void whatIsNotKnown_isNeverGuessed()
    {
        QFETCH(QString, printed);
        QVERIFY(!dsiUnitOf(printed.toStdString()).has_value());
    }

    /// The other way round, by code that this one shares nothing with.
    void theReaderOfReferences_understandsThem()
    {
        const auto unit = dsiUnitOf("mV/kPa");
        QVERIFY(unit.has_value());
        const auto read = parseDSiUnit(*unit);
        QVERIFY(read.has_value());
        QCOMPARE(QString::fromStdString(read->symbol()), QString("V/Pa"));
        QVERIFY(std::abs(read->factor - 1e-6) < 1e-18);
    }
};

DYNCAL_TEST(TestSiUnit)
#include "tst_si_unit.moc"
