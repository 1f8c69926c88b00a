// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>

using dyncal::BoundSide;
using dyncal::boundText;
using dyncal::fixedText;
using dyncal::neverBelow;
using dyncal::roundedText;
using dyncal::roundedTextWithU;
using dyncal::RoundedValue;
using dyncal::roundedValue;
using dyncal::settingText;

namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
} // namespace

class TestRounding : public QObject
{
    Q_OBJECT

private slots:
    void rounded_knownUncertainty_twoDigitsOfIt_data();
    void rounded_knownUncertainty_twoDigitsOfIt();
    void rounded_noUncertainty_threeDigits_data();
    void rounded_noUncertainty_threeDigits();
    void workingView_mayAskForMoreDigits();
    void setting_hasTheDigitsOfItself_data();
    void setting_hasTheDigitsOfItself();
    void bound_staysTrueWhenRounded();
    void neverBelow_isTheNextTwoDigitsUp();
    void textWithU_bothInOneUnitWithEqualDecimals();
    void rounded_randomValues_isWithinHalfOfLastDigit();
    void fixed_negativeZero_hasNoSign();
    void fixed_negativeDecimals_roundsToTens();
    void fixed_largestDouble_isWritten();
};

void TestRounding::rounded_knownUncertainty_twoDigitsOfIt_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("u");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("uText");
    QTest::addColumn<QString>("shownUnit");
    const auto row = [](const char *name, double v, double u, const char *unit, const char *t,
                         const char *ut, const char *shown) {
        QTest::newRow(name) << v << u << QString(unit) << QString(t) << QString(ut)
                            << QString::fromUtf8(shown);
    };
    // GUM 7.2.6: 10.057 62 ohm with u = 27 mohm is stated as 10.058 ohm.
    row("GUM 7.2.6", 10.05762, 0.027, "", "10.058", "0.027", "");
    row("prefix", 2330123.0, 412.0, "Hz", "2.33012", "0.00041", "MHz");
    row("carry in u", 5.0, 0.0999, "V", "5.00", "0.10", "V");
    row("carry in u to one", 5.0, 0.996, "V", "5.0", "1.0", "V");
    row("u of tens", 512.8, 26.4, "m/s", "513", "26", "m/s");
    row("u of hundreds", 512.8, 264.0, "m/s", "510", "260", "m/s");
    row("u larger than value", 0.5, 1234.0, "Hz", "0.0", "1.2", "kHz");
    row("negative value", -89.95, 0.23, "\xC2\xB0", "-89.95", "0.23", "\xC2\xB0");
    row("negative to zero", -0.001, 0.25, "%", "0.00", "0.25", "%");
    row("zero value", 0.0, 0.0123, "V", "0", "12", "mV");
    row("nine nines", 999.996e3, 0.012e3, "Hz", "999.996", "0.012", "kHz");
    row("nine nines, carry", 999.996e3, 0.12e3, "Hz", "1.00000", "0.00012", "MHz");
    row("nano", 12.5e-6, 0.13e-6, "V/Pa", "12.50", "0.13", "\xC2\xB5V/Pa");
    row("small without prefix", 2.0e-2, 1.77e-4, "", "0.02000", "0.00018", "");
}

void TestRounding::rounded_knownUncertainty_twoDigitsOfIt()
{
    QFETCH(double, value);
    QFETCH(double, u);
    QFETCH(QString, unit);
    const RoundedValue rounded = roundedValue(value, u, unit.toStdString());
    QTEST(QString::fromStdString(rounded.value), "text");
    QTEST(QString::fromStdString(rounded.u), "uText");
    QTEST(QString::fromStdString(rounded.unit), "shownUnit");
}

void TestRounding::rounded_noUncertainty_threeDigits_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, double value, const char *unit, const char *text) {
        QTest::newRow(name) << value << QString::fromUtf8(unit) << QString::fromUtf8(text);
    };
    row("prefix", 434498.068, "Pa", "434 kPa");
    row("trailing zeros stay", 2.0, "V", "2.00 V");
    row("zero", 0.0, "Hz", "0 Hz");
    row("no unit", 1.49044774, "", "1.49");
    row("carry", 99.9999, "%", "100 %");
    row("carry into prefix", 999.999, "Hz", "1.00 kHz");
    row("micro", 1.63e-3, "s", "1.63 ms");
    row("milli edge", 1.0e-3, "s", "1.00 ms");
    row("below milli", 0.999e-3, "s", "999 \xC2\xB5s");
    row("kelvin takes none", 294.15, "K", "294 K");
    row("tiny without prefix", 1.23456789e-7, "",
        "1.23 \xC3\x97"
        "10^-7");
    row("huge without prefix", 4.5e8, "K",
        "4.50 \xC3\x97"
        "10^8 K");
    row("beyond giga", 5e13, "Hz", "50000 GHz");
}

void TestRounding::rounded_noUncertainty_threeDigits()
{
    QFETCH(double, value);
    QFETCH(QString, unit);
    for (const double none : {kNan, 0.0, -1.0})
        QTEST(QString::fromStdString(roundedText(value, none, unit.toStdString())), "text");
}

void TestRounding::workingView_mayAskForMoreDigits()
{
    QCOMPARE(roundedValue(434498.068, kNan, "Pa", 5).value, "434.50");
    QCOMPARE(roundedValue(434498.068, 260.0, "Pa", 5).value, "434.50"); // u decides where known
}

void TestRounding::setting_hasTheDigitsOfItself_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, double value, const char *unit, const char *text) {
        QTest::newRow(name) << value << QString(unit) << QString::fromUtf8(text);
    };
    row("round", 10e6, "Hz", "10 MHz");
    row("tens", 250e6, "Hz", "250 MHz");
    row("hundreds", 100e6, "Hz", "100 MHz");
    row("two digits", 1.25e6, "Hz", "1.25 MHz");
    row("four digits", 101100.0, "Pa", "101.1 kPa");
    row("rounded to four", 294.18, "K", "294.2 K");
    row("carry", 999.96, "K", "1000 K");
    row("third octave", 125892.54, "Hz", "125.9 kHz");
    row("small", 1.5e-6, "s", "1.5 \xC2\xB5s");
    row("negative", -0.25, "V", "-250 mV");
    row("no unit", 0.5, "", "0.5");
    row("zero", 0.0, "s", "0 s");
    row("none", kNan, "s", "\xE2\x80\x93");
}

void TestRounding::setting_hasTheDigitsOfItself()
{
    QFETCH(double, value);
    QFETCH(QString, unit);
    QTEST(QString::fromStdString(settingText(value, unit.toStdString())), "text");
}

void TestRounding::bound_staysTrueWhenRounded()
{
    QCOMPARE(boundText(1.9953e6, BoundSide::Lower, "Hz"), "1.99 MHz");
    QCOMPARE(boundText(1.9953e6, BoundSide::Upper, "Hz"), "2.00 MHz");
    // A bound of three digits is itself, whatever the last bit of the double says.
    for (const double bound : {4e6, 0.4 * 1e7, 0.4 * 12.5e6, 1e6 * (1.0 - 1e-15), 3.0 * 0.1e6}) {
        QCOMPARE(boundText(bound, BoundSide::Lower, "Hz"), roundedText(bound, kNan, "Hz"));
        QCOMPARE(boundText(bound, BoundSide::Upper, "Hz"), roundedText(bound, kNan, "Hz"));
    }
    std::mt19937 random(11);
    std::uniform_real_distribution<double> decade(-8.0, 8.0);
    for (int i = 0; i < 5000; ++i) {
        const double bound = std::pow(10.0, decade(random));
        const double grain = std::pow(10.0, std::floor(std::log10(bound)) - 2.0);
        const auto read = [](const std::string &text) {
            const auto blank = text.find("\xC3\x97"
                                         "10^");
            const double scale = blank == std::string::npos
                ? 1.0
                : std::pow(10.0, std::stoi(text.substr(blank + 5)));
            return *dyncal::parseNumber(text.substr(0, text.find(' '))) * scale;
        };
        const double low = read(boundText(bound, BoundSide::Lower, "K"));
        const double high = read(boundText(bound, BoundSide::Upper, "K"));
        QVERIFY(low <= bound * (1.0 + 1e-11) && low > bound - grain * (1.0 + 1e-6));
        QVERIFY(high >= bound * (1.0 - 1e-11) && high < bound + grain * (1.0 + 1e-6));
    }
    QCOMPARE(boundText(0.0, BoundSide::Lower, "Hz"), "0 Hz");
    QCOMPARE(boundText(kNan, BoundSide::Upper, "Hz"), "\xE2\x80\x93");
}

void TestRounding::neverBelow_isTheNextTwoDigitsUp()
{
    const auto printed = [](double u, double least) {
        return QString::fromStdString(roundedValue(1.0, neverBelow(u, least), "").u);
    };
    QCOMPARE(printed(0.01534, 0.01534), "0.016"); // 0.015 would be less than the CMC
    QCOMPARE(printed(0.01534, 0.0), "0.015");
    QCOMPARE(printed(0.0154, 0.015), "0.015"); // enough as it is rounded
    QCOMPARE(printed(0.0156, 0.0151), "0.016");
    QCOMPARE(printed(0.015, 0.015), "0.015"); // no digit more by rounding errors
    QCOMPARE(printed(0.0991, 0.0991), "0.10");
    QCOMPARE(printed(0.02, 0.01), "0.020");
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const double least = std::pow(10.0, -6.0 + 5.0 * share(random));
        const double u = least * (1.0 + 0.1 * share(random));
        QVERIFY(printed(u, least).toDouble() >= least * (1.0 - 1e-9));
        QVERIFY(neverBelow(u, least) <= 1.1 * u);
    }
}

void TestRounding::textWithU_bothInOneUnitWithEqualDecimals()
{
    QCOMPARE(roundedTextWithU(2329980.4, 12.04, "Hz"), "2.329980 MHz (u = 0.000012 MHz)");
    QCOMPARE(roundedTextWithU(0.02, 5e-6, ""), "0.0200000 (u = 0.0000050)");
    QCOMPARE(roundedTextWithU(0.02, kNan, ""), "0.0200");
}

void TestRounding::rounded_randomValues_isWithinHalfOfLastDigit()
{
    // Property: what is printed reads back within half a unit of the last digit of value and u.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> decade(-12.0, 9.0);
    std::uniform_real_distribution<double> mantissa(-9.999, 9.999);
    // Printing and reading each round once more.
    constexpr double kSlack = 1.0 + 1e-9;
    for (int i = 0; i < 20000; ++i) {
        const double value = mantissa(random) * std::pow(10.0, decade(random));
        const double u = std::abs(value) * std::pow(10.0, -6.0 + 7.0 * (i % 1000) / 1000.0);
        const RoundedValue rounded = roundedValue(value, u, "K");
        const double factor = rounded.unit == "K"
            ? 1.0
            : std::pow(10.0, std::stoi(rounded.unit.substr(rounded.unit.find('^') + 1)));
        const double shown = *dyncal::parseNumber(rounded.value) * factor;
        const double shownU = *dyncal::parseNumber(rounded.u) * factor;
        const double lastDigit = std::pow(10.0, std::floor(std::log10(u)) - 1.0);
        QVERIFY(std::abs(shown - value) <= 5.0 * lastDigit * kSlack);
        QVERIFY(
            std::abs(shownU - u) <= 0.5 * lastDigit * kSlack || std::abs(shownU - u) <= 0.05 * u);
        std::string digits;
        for (const char c : rounded.u)
            if (c >= '0' && c <= '9' && !(digits.empty() && c == '0'))
                digits += c;
        const bool whole = rounded.u.find('.') == std::string::npos;
        QVERIFY2(digits.size() == 2 || (whole && digits.size() >= 2), rounded.u.c_str());
    }
}

void TestRounding::fixed_negativeZero_hasNoSign()
{
    QCOMPARE(fixedText(-0.001, 2), std::string("0.00"));
    QCOMPARE(fixedText(-0.0, 0), std::string("0"));
    QCOMPARE(fixedText(-0.006, 2), std::string("-0.01"));
}

void TestRounding::fixed_negativeDecimals_roundsToTens()
{
    QCOMPARE(fixedText(1234.0, -1), std::string("1230"));
    QCOMPARE(fixedText(1250.0, -2), std::string("1300"));
    QCOMPARE(fixedText(-4.0, -1), std::string("0"));
}

void TestRounding::fixed_largestDouble_isWritten()
{
    QCOMPARE(fixedText(std::numeric_limits<double>::max(), 3).size(), std::size_t(313));
}

DYNCAL_TEST(TestRounding)
#include "tst_rounding.moc"
