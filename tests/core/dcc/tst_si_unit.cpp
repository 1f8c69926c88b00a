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

    void quotient_isThatOfTheUnits_data()
    {
        QTest::addColumn<QString>("above");
        QTest::addColumn<QString>("below");
        QTest::addColumn<QString>("quotient");
        const auto row = [](const char *above, const char *below, const char *quotient) {
            QTest::addRow("%s over %s", above, below) << above << below << quotient;
        };
        row("\\hertz", "\\kelvin", "\\hertz\\kelvin\\tothe{-1}");
        row("\\hertz", "\\hertz", "\\one");
        row("\\hertz", "\\one", "\\hertz");
        row("\\one", "\\hertz", "\\hertz\\tothe{-1}");
        row("\\one", "\\metre\\tothe{-1}", "\\metre");
        row("\\volt", "\\metre\\second\\tothe{-1}", "\\volt\\metre\\tothe{-1}\\second");
        row("\\volt", "\\metre\\tothe{2}", "\\volt\\metre\\tothe{-2}");
        row("\\volt", "\\metre\\tothe{-0.5}", "\\volt\\metre\\tothe{0.5}");
        row("\\one", "\\kilo\\pascal\\tothe{-1}", "\\kilo\\pascal");
        row("\\one", "\\kilogram\\mole\\tothe{-1}", "\\kilogram\\tothe{-1}\\mole");
    }
    void quotient_isThatOfTheUnits()
    {
        QFETCH(QString, above);
        QFETCH(QString, below);
        QFETCH(QString, quotient);
        QCOMPARE(QString::fromStdString(quotientOfUnits(above.toStdString(), below.toStdString())),
            quotient);
    }

    /// Read by other code: the quotient times what was divided by is what was divided.
    void quotientTimesDivisor_isTheDividend()
    {
        for (const char *above : {"\\hertz", "\\volt\\pascal\\tothe{-1}", "\\one", "\\percent"})
            for (const char *below : {"\\kelvin", "\\metre\\second\\tothe{-1}", "\\milli\\metre",
                     "\\kilogram\\mole\\tothe{-1}"}) {
                const auto product = parseDSiUnit(quotientOfUnits(above, below) + below);
                const auto wanted = parseDSiUnit(above);
                QVERIFY2(product && wanted, below);
                QVERIFY2(product->powers == wanted->powers, below);
                QVERIFY(std::abs(product->factor / wanted->factor - 1.0) < 1e-15);
            }
    }
};

DYNCAL_TEST(TestSiUnit)
#include "tst_si_unit.moc"
