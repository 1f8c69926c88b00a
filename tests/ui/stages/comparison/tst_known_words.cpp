// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of other calibrations in the words of the page.

#include "tests/support/made_known.h"
#include "tests/support/test_program.h"
#include "ui/stages/comparison/known_words.h"

#include <QtTest>

using namespace dyncal;
using testing::madeKnown;

class TestKnownWords : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void entry_isReadAsTyped()
    {
        QCOMPARE(knownText({"works", 0.0, 1.02, 0.01, "mV/bar"}),
            QString("works, static: 1.020 mV/bar \u00b1 0.020 mV/bar (k = 2)"));
        QVERIFY(knownText({"valve", 800.0, 1.02, 0.01, "mV/bar"}).startsWith("valve, 800 Hz: "));
    }

    void verdict_counts()
    {
        QVERIFY(knownVerdict({}).isEmpty());
        QCOMPARE(knownVerdict({madeKnown(0.5), madeKnown(-1.5), testing::madeUncompared()}),
            QString("Of 3 values of other calibrations 1 agree with this one within U."));
    }

    void table_saysWhatIsJoined_andWhyNot()
    {
        const ShownTable table
            = knownTable({madeKnown(0.5), madeKnown(-1.5, 800.0), testing::madeUncompared()});
        QCOMPARE(table.rows.size(), 3);
        QCOMPARE(table.rows[0].last(), QString("agrees, joined"));
        QCOMPARE(table.rows[1].last(), QString("differs, not joined"));
        QVERIFY2(table.rows[2].last().contains("2 MHz is above the band"),
            qPrintable(table.rows[2].last()));
        QCOMPARE(table.rows[0][4], QString("1 %"));
        QCOMPARE(table.rows[1][1], QString("800 Hz"));
        for (const QStringList &row : table.rows)
            QCOMPARE(row.size(), table.headers.size());
    }
};

DYNCAL_TEST(TestKnownWords)
#include "tst_known_words.moc"
