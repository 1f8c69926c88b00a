// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Units as digital calibration certificates write them.

#include "core/dcc_reading/d_si_unit.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <numbers>

using namespace dyncal;
using testing::isNear;

class TestDSiUnit : public QObject
{
    Q_OBJECT

private slots:
    void units_areRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("symbol");
        QTest::addColumn<double>("factor");
        QTest::newRow("V/MPa") << "\\volt\\mega\\pascal\\tothe{-1}"
                               << "V/Pa" << 1e-6;
        QTest::newRow("per") << "\\milli\\volt\\per\\kilo\\pascal"
                             << "V/Pa" << 1e-6;
        QTest::newRow("pC/bar") << "\\pico\\coulomb\\bar\\tothe{-1}"
                                << "C/Pa" << 1e-17;
        QTest::newRow("Hz") << "\\hertz"
                            << "Hz" << 1.0;
        QTest::newRow("kHz") << "\\kilo\\hertz"
                             << "Hz" << 1e3;
        QTest::newRow("degree") << "\\degree"
                                << "rad" << std::numbers::pi / 180.0;
        QTest::newRow("one") << "\\one"
                             << "1" << 1.0;
        QTest::newRow("per first") << "\\per\\mega\\pascal"
                                   << "1/Pa" << 1e-6;
        QTest::newRow("squared") << "\\kilo\\pascal\\tothe{2}"
                                 << "Pa2" << 1e6;
        QTest::newRow("cancels") << "\\pascal\\kilo\\pascal\\tothe{-1}"
                                 << "1" << 1e-3;
    }
    void units_areRead()
    {
        QFETCH(QString, text);
        QFETCH(QString, symbol);
        QFETCH(double, factor);
        const auto unit = parseDSiUnit(text.toStdString());
        QVERIFY(unit.has_value());
        QCOMPARE(unit->symbol(), symbol.toStdString());
        QVERIFY(isNear(unit->factor, factor, 1e-12));
    }

    void malformedOnes_areRefused()
    {
        for (const char *text :
            {"", "V/Pa", "\\furlong", "\\mega", "\\volt\\mega", "\\volt\\tothe{x}", "\\tothe{2}",
                "\\volt\\tothe{0.5}", "\\kilo\\mega\\volt", "\\volt pascal",
                "\\volt\\per\\per\\pascal", "\\volt\\tothe{99}", "\\volt\\per", "\\per",
                "\\per\\per\\pascal", "\\volt\\kilo\\per\\pascal", "\\volt\\per\\tothe{2}\\pascal",
                "\\volt\\kilo\\tothe{2}\\pascal", "\\volt\\tothe{2}\\tothe{3}"})
            QVERIFY2(!parseDSiUnit(text), text);
    }
};

DYNCAL_TEST(TestDSiUnit)
#include "tst_d_si_unit.moc"
