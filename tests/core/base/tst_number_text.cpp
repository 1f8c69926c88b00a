// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "tests/support/decimal_comma.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

using namespace dyncal;

class TestNumberText : public QObject
{
    Q_OBJECT

private slots:
    void shortestText_readsBackAsTheSameDouble()
    {
        std::mt19937_64 bits(1);
        for (int i = 0; i < 20000; ++i) {
            const std::uint64_t word = bits();
            double value = 0.0;
            std::memcpy(&value, &word, sizeof value);
            if (!std::isfinite(value))
                continue;
            const auto read = parseNumber(numberText(value));
            QVERIFY(read.has_value());
            QCOMPARE(std::memcmp(&*read, &value, sizeof value), 0);
        }
    }

    void shortestText_isShort()
    {
        QCOMPARE(numberText(0.1), std::string("0.1"));
        QCOMPARE(numberText(-3.0), std::string("-3"));
        QCOMPARE(exactNumber(std::numeric_limits<double>::infinity()), std::string("inf"));
        QCOMPARE(exactNumber(-std::numeric_limits<double>::infinity()), std::string("-inf"));
        QCOMPARE(exactNumber(std::nan("")), std::string("nan"));
    }

    void notFinite_isNoWord()
    {
        const double infinity = std::numeric_limits<double>::infinity();
        for (const int digits : {1, 3, 17}) {
            QCOMPARE(numberText(std::nan(""), digits), std::string("\u2013"));
            QCOMPARE(numberText(infinity, digits), std::string("\u221e"));
            QCOMPARE(fixedText(-infinity, digits), std::string("-\u221e"));
            QCOMPARE(fixedText(std::nan(""), -digits), std::string("\u2013"));
        }
        QCOMPARE(numberText(infinity), std::string("\u221e"));
        QCOMPARE(numberText(-std::nan("")), std::string("\u2013"));
    }

    void digits_areSignificantAndClamped()
    {
        QCOMPARE(numberText(3.14159265, 4), std::string("3.142"));
        QCOMPARE(numberText(123456.0, 3), std::string("123000"));
        QCOMPARE(numberText(-420.0, 1), std::string("-400"));
        QCOMPARE(numberText(1.26e14, 2), std::string("130000000000000"));
        QCOMPARE(numberText(1.26e15, 2), std::string("1.3e+15"));
        QCOMPARE(numberText(1.26e-4, 2), std::string("0.00013"));
        QCOMPARE(numberText(1.26e-5, 2), std::string("1.3e-05"));
        QCOMPARE(numberText(3.14159265, 0), std::string("3"));
        QCOMPARE(numberText(0.1, 99), std::string("0.10000000000000001"));
    }

    void text_doesNotFollowTheLocale()
    {
        const dyncal::testing::DecimalComma locale;
        QVERIFY(locale.isInForce());
        const std::string shown = numberText(1.5) + numberText(1.25, 3);
        const auto read = parseNumber("2.5");
        QCOMPARE(shown, std::string("1.51.25"));
        QCOMPARE(read, std::optional<double>(2.5));
    }

    void withUnit_choosesThePrefix_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<int>("digits");
        QTest::addColumn<QString>("text");
        const auto row = [](double value, const char *unit, int digits, const char *text) {
            QTest::addRow("%g %s %d", value, unit, digits)
                << value << unit << digits << QString::fromUtf8(text);
        };
        row(2.33e6, "Hz", 3, "2.33 MHz");
        row(-2.33e6, "Hz", 3, "-2.33 MHz");
        row(1.0, "V", 4, "1 V");
        row(1000.0, "Pa", 4, "1 kPa");
        row(5e-6, "s", 4, "5 \xC2\xB5s");
        row(4.2e-13, "s", 2, "420 fs"); // no exponent beside a prefix
        row(1e-18, "s", 2, "0.001 fs"); // below the last prefix
        row(7e12, "Hz", 4, "7000 GHz"); // above the first
        row(0.0, "V", 4, "0 V");
        row(1234.5, "1", 6, "1234.5"); // a pure number
        row(0.0012, "", 4, "0.0012");
        // Units that have a prefix, or may have one, get no other.
        row(0.01, "mv/Pa", 4, "0.01 mv/Pa");
        row(1.5e-7, "Millivolts/Pa", 4, "1.5 \u00D710^-7 Millivolts/Pa");
        row(-2.5e9, "kPa", 4, "-2.5 \u00D710^9 kPa");
        row(9.99996e-5, "N/mm2/Pa", 4, "1 \u00D710^-4 N/mm2/Pa");
        row(293.15, "K", 5, "293.15 K");
        row(0.0, "mV", 4, "0 mV");
    }
    void withUnit_choosesThePrefix()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(int, digits);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(numberWithUnit(value, unit.toStdString(), digits)), text);
    }

    void withUnit_roundsIntoTheNextPrefix()
    {
        // Rounded to the digits asked, a mantissa of 1000 belongs to the next prefix.
        for (int digits = 3; digits <= 8; ++digits) {
            const double half = 0.5 * std::pow(10.0, 3 - digits); // of the last digit below 1000
            const std::string justAbove = numberWithUnit(1000.0 - 0.9 * half, "Hz", digits);
            QCOMPARE(justAbove, std::string("1 kHz"));
            const std::string justBelow = numberWithUnit(1000.0 - 1.1 * half, "Hz", digits);
            QVERIFY2(justBelow.find("kHz") == std::string::npos, justBelow.c_str());
            QVERIFY2(justBelow.starts_with("999"), justBelow.c_str());
        }
        QCOMPARE(numberWithUnit(0.99999, "V", 3), std::string("1 V"));
        QCOMPARE(numberWithUnit(999.99e-9, "s", 4), std::string("1 \xC2\xB5s"));
    }

    void withUnit_notFinite_hasNoPrefix()
    {
        QCOMPARE(
            numberWithUnit(std::numeric_limits<double>::infinity(), "V"), std::string("\u221e V"));
        QCOMPARE(numberWithUnit(std::nan(""), "V"), std::string("\u2013"));
    }

    void parse_takesWholeNumbersOnly()
    {
        QCOMPARE(parseNumber("1.5e3"), std::optional<double>(1500.0));
        QCOMPARE(parseNumber("+2"), std::optional<double>(2.0));
        for (const char *bad :
            {"", "+", "-", " 1", "1 ", "1,5", "1.5x", "0x10", "1e", "e5", "1e999"})
            QVERIFY2(!parseNumber(bad), bad);
    }

    void parse_twoSigns_isRefused()
    {
        QVERIFY(!parseNumber("+-2"));
        QVERIFY(!parseNumber("++2"));
    }
};

DYNCAL_TEST(TestNumberText)
#include "tst_number_text.moc"
