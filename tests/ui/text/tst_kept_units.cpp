// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers and their units on one line.

#include "tests/support/test_program.h"
#include "ui/text/kept_units.h"

#include <QTest>

using namespace dyncal;

class TestKeptUnits : public QObject
{
    Q_OBJECT

private slots:
    void number_staysWithItsUnit_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("kept"); // spaces that do not break any more
        QTest::newRow("frequency") << "ends at 12.5 kHz and 3 MHz" << 2;
        QTest::newRow("share") << "0.15 % of the step" << 1;
        QTest::newRow("decimal comma") << QString::fromUtf8("2,5 µs efter steget") << 1;
        QTest::newRow("compound") << QString::fromUtf8("12 µV/Pa, 430 m/s, 8 MiB") << 3;
        QTest::newRow("temperature") << QString::fromUtf8("21 °C or 294 K") << 2;
        QTest::newRow("with u") << "2.33 MHz (u = 0.01 MHz)" << 4;
        QTest::newRow("counted things") << "2 shots, 3 models, 5 samples" << 0;
        QTest::newRow("words before a unit") << "shot 1 as shot 2: s and Pa" << 0;
        QTest::newRow("umlaut behind") << QString::fromUtf8("3 m\u00e4tningar, 3 s\u00e4nk") << 0;
    }
    void number_staysWithItsUnit()
    {
        QFETCH(QString, text);
        const QString kept = withUnitsKept(text);
        QTEST(static_cast<int>(kept.count(QChar::Nbsp)), "kept");
        QCOMPARE(QString(kept).replace(QChar::Nbsp, ' '), text); // nothing else is changed
    }
};

DYNCAL_TEST(TestKeptUnits)
#include "tst_kept_units.moc"
