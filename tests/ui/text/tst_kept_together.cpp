// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/text/kept_together.h"

#include <QtTest>

using namespace dyncal;

/// Where a line of a table or a sentence may end.
class TestKeptTogether : public QObject
{
    Q_OBJECT

private slots:
    void lines_endBetweenValuesOnly_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("kept"); // '_' for a no-break space
        const auto row = [](const char *text, const char *kept) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(kept);
        };
        row("5.02 µV/Pa ± 0.12 µV/Pa (k = 2)", "5.02_µV/Pa ±_0.12_µV/Pa (k_=_2)");
        row("429,4 m/s ± 1,5 m/s (k = 1,96)", "429,4_m/s ±_1,5_m/s (k_=_1,96)");
        row("54.0 dB", "54.0_dB");
        row("-0.0017 °", "-0.0017_°");
        row("1 kHz … 100 kHz", "1_kHz … 100_kHz");
        row("U (k = 2)", "U (k_=_2)");
        row("2.33 MHz (u = 0.01 MHz)", "2.33_MHz (u_=_0.01_MHz)");
        row("10 % to 90 %", "10_% to 90_%");
        row("0.103819 ± j0.965585", "0.103819 ± j0.965585");
        row("Damping ratio", "Damping ratio");
        row("–", "–");
        row("", "");
    }
    void lines_endBetweenValuesOnly()
    {
        QFETCH(QString, text);
        QFETCH(QString, kept);
        QCOMPARE(keptTogether(text), kept.replace('_', QChar(QChar::Nbsp)));
    }

    void nothingElse_changes()
    {
        const QString text = "5.02 µV/Pa ± 0.12 µV/Pa (k = 2), measured 17 times at 294.15 K";
        QCOMPARE(keptTogether(text).replace(QChar(QChar::Nbsp), ' '), text);
        QCOMPARE(keptTogether(keptTogether(text)), keptTogether(text));
    }

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

DYNCAL_TEST(TestKeptTogether)
#include "tst_kept_together.moc"
