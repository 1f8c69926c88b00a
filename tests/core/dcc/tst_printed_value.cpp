// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers as the certificate prints them, digit by digit.

#include "core/certificate/certificate_words.h"
#include "core/dcc/printed_value.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestPrintedValue : public QObject
{
    Q_OBJECT

private slots:
    void number_keepsItsDigits_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("expanded");
        QTest::addColumn<QString>("factor");
        QTest::newRow("trailing zeros") << "2.3300 MHz"
                                        << "2.3300"
                                        << "\\mega\\hertz"
                                        << ""
                                        << "";
        QTest::newRow("number") << "0.020"
                                << "0.020"
                                << "\\one"
                                << ""
                                << "";
        QTest::newRow("negative") << "-1.50 \u00b0"
                                  << "-1.50"
                                  << "\\degree"
                                  << ""
                                  << "";
        QTest::newRow("hard space") << "12\u00a0%"
                                    << "12"
                                    << "\\percent"
                                    << ""
                                    << "";
        QTest::newRow("power of ten") << "1.5 \u00d710^-7 V/Pa"
                                      << "1.5E-7"
                                      << "\\volt\\pascal\\tothe{-1}"
                                      << ""
                                      << "";
        QTest::newRow("with U") << "2.33 MHz \u00b1 0.12 MHz (k = 2)"
                                << "2.33"
                                << "\\mega\\hertz"
                                << "0.12"
                                << "2";
        QTest::newRow("U alone") << "0.12 MHz (k = 4.30)"
                                 << "0.12"
                                 << "\\mega\\hertz"
                                 << ""
                                 << "4.30";
    }
    void number_keepsItsDigits()
    {
        QFETCH(QString, text);
        QFETCH(QString, value);
        QFETCH(QString, unit);
        QFETCH(QString, expanded);
        QFETCH(QString, factor);
        const auto printed = printedValue(inNumbers(text.toStdString()));
        QVERIFY(printed.has_value());
        QCOMPARE(QString::fromStdString(printed->value), value);
        QCOMPARE(QString::fromStdString(printed->unit), unit);
        QCOMPARE(QString::fromStdString(printed->expanded), expanded);
        QCOMPARE(QString::fromStdString(printed->factor), factor);
    }

    void anythingElse_isNoNumber_data()
    {
        QTest::addColumn<QString>("text");
        for (const char *text : {"", "\xE2\x80\x93", "above 3 MHz", "0.9 \xC2\xB1 j 0.1",
                 "1 MHz \xC2\xB1 1 kHz (k = 2)", "1 MHz \xC2\xB1 1 MHz", "1 \xE2\x80\xA6 2 K",
                 "1.2 mv/Pa", "nan", "inf Hz", "1,5 Hz", "12 of 13",
                 "1 \xC3\x97"
                 "10^x V"})
            QTest::newRow(qPrintable(QString("'%1'").arg(QString::fromUtf8(text))))
                << QString::fromUtf8(text);
    }
    void anythingElse_isNoNumber()
    {
        QFETCH(QString, text);
        QVERIFY(!printedValue(inNumbers(text.toStdString())).has_value());
    }

    /// A serial number "2.10" stays one.
    void whatWasTyped_isNoNumber()
    {
        QVERIFY(!printedValue(verbatim("2.10")).has_value());
        Message two = inNumbers("2.10");
        two.below.push_back(inNumbers("3"));
        QVERIFY(!printedValue(two).has_value());
    }

    /// What the certificate's own functions print is read, whatever the size.
    void whatIsPrinted_isRead()
    {
        for (const double size : {1e-17, 1e-9, 0.5, 1.0, 999.96, 4.2e6, 3e11}) {
            const auto printed = printedValue(printedWithUncertainty(size, 0.003 * size, "Hz"));
            QVERIFY(printed.has_value());
            QCOMPARE(printed->factor, std::string("2"));
            QVERIFY(printed->expanded.size() >= 1);
            const auto bare = printedValue(printedWithUncertainty(size, 0.003 * size, ""));
            QVERIFY(bare.has_value());
            QCOMPARE(bare->unit, std::string("\\one"));
        }
    }
};

DYNCAL_TEST(TestPrintedValue)
#include "tst_printed_value.moc"
