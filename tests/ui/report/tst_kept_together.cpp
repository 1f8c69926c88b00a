// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/report/kept_together.h"

#include <QtTest>

using namespace dyncal;

/// Where a line of a table may end.
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
};

DYNCAL_TEST(TestKeptTogether)
#include "tst_kept_together.moc"
