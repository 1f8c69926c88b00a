// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/stages/certificate/field_labels.h"

#include <QtTest>

using namespace dyncal;

/// What the fields of a certificate are called, in forms and in the tables of cards.
class TestFieldLabels : public QObject
{
    Q_OBJECT

private slots:
    void printedFields_areCalledAsTheyArePrinted()
    {
        QCOMPARE(fieldLabel("sensor_serial"), QString("Serial number"));
        QVERIFY(printedField("sensor_serial")->missing); // it must be there
        QVERIFY(!printedField("laboratory_country"));
    }

    void otherFields_haveLabelsToo()
    {
        QCOMPARE(fieldLabel("laboratory_country"), QString("Country of the laboratory"));
        QCOMPARE(fieldLabel("customer_country"), QString("Country of the customer"));
        QCOMPARE(fieldLabel("remarks"), QString("Remarks"));
        for (const char *none : {"", "note", "sensor_serial ", "quantity", "due"})
            QCOMPARE(fieldLabel(none), QString());
    }

    void labels_followTheLanguage()
    {
        const test::InSwedish swedish;
        QCOMPARE(fieldLabel("sensor_serial"), QString("Serienummer"));
        QCOMPARE(fieldLabel("customer_country"), QString("Kundens land"));
        QCOMPARE(fieldLabel("remarks"), QString("Anmärkningar"));
    }
};

DYNCAL_TEST(TestFieldLabels)
#include "tst_field_labels.moc"
