// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/text/typed_quantity.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

/// What people type into a field, against SI values worked out by hand.
class TestTypedQuantity : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void typed_isTheSiValue_data();
    void typed_isTheSiValue();
    void refused_saysWhy_data();
    void refused_saysWhy();
    void everyUnderstoodUnit_isUnderstood();
    void groupMark_isTheOtherLanguagesOnly();
};

void TestTypedQuantity::typed_isTheSiValue_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("unitSi");
    QTest::addColumn<double>("si");
    const auto row = [](const char *typed, const char *unit, double unitSi, double si) {
        QTest::newRow(typed) << QString::fromUtf8(typed) << QString::fromUtf8(unit) << unitSi << si;
    };
    row("21 °C", "K", 1.0, 294.15);
    row("21 C", "K", 1.0, 294.15);
    row("21,5°C", "K", 1.0, 294.65);
    row("−5 ˚C", "K", 1.0, 268.15);
    row("70 F", "K", 1.0, 294.2611111111111);
    row("32 °F", "K", 1.0, 273.15);
    row("-40 f", "K", 1.0, 233.15);
    row("295 K", "K", 1.0, 295.0);
    row("295,25", "K", 1.0, 295.25);
    row("10 MHz", "kHz", 1e3, 1e7);
    row("10MHz", "MHz", 1e6, 1e7);
    row("2.33e6 hz", "kHz", 1e3, 2.33e6);
    row("5 mHz", "kHz", 1e3, 5e-3);
    row("12,5 kS/s", "MHz", 1e6, 12500.0);
    row("1 GHz", "kHz", 1e3, 1e9);
    row("1,5 ms", "µs", 1e-6, 1.5e-3);
    row("1.5 us", "µs", 1e-6, 1.5e-6);
    row("3 μs", "µs", 1e-6, 3e-6); // the Greek letter
    row("-250 ns", "µs", 1e-6, -250e-9);
    row("2 s", "µs", 1e-6, 2.0);
    row("1.2 bar", "kPa", 1e3, 1.2e5);
    row("1013,25 mbar", "kPa", 1e3, 101325.0);
    row("1013.25 hPa", "kPa", 1e3, 101325.0);
    row("0,2 MPa", "kPa", 1e3, 2e5);
    row("50 KPA", "kPa", 1e3, 5e4);
    row("14.5 psi", "kPa", 1e3, 99973.9765);
    row("101300 Pa", "kPa", 1e3, 101300.0);
    row("35 cm", "m", 1.0, 0.35);
    row("2 in", "mm", 1e-3, 0.0508);
    row("0.5 m", "mm", 1e-3, 0.5);
    row("0.4 km/s", "m/s", 1.0, 400.0);
    row("1800 km/h", "m/s", 1.0, 500.0);
    row("45 %", "%", 0.01, 0.45);
    row("450 ppm", "%", 0.01, 4.5e-4);
    row("0.029 kg/mol", "g/mol", 1e-3, 0.029);
    row("2 V/bar", "mV/kPa", 1e-6, 2e-5);
    row("7", "", 1.0, 7.0);
    row("+7,5e-1", "", 1.0, 0.75);
}

void TestTypedQuantity::typed_isTheSiValue()
{
    QFETCH(QString, typed);
    QFETCH(QString, unit);
    QFETCH(double, unitSi);
    QFETCH(double, si);
    const TypedQuantity read = typedQuantity(typed, {unit, unitSi});
    QVERIFY2(read.value, qPrintable(read.fault));
    QVERIFY2(std::abs(*read.value * unitSi - si) <= 1e-14 * std::abs(si),
        qPrintable(QString::number(*read.value * unitSi, 'g', 17)));
    QVERIFY(read.fault.isEmpty());
}

void TestTypedQuantity::refused_saysWhy_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char *typed, const char *unit, const QStringList &words) {
        QTest::newRow(typed) << QString::fromUtf8(typed) << QString::fromUtf8(unit) << words;
    };
    row("12 furlong", "kPa", {"furlong", "kPa", "hPa", "MPa", "mbar", "bar", "psi"});
    row("12 kHz", "K", {"kHz", "K, °C, C, °F, F"});
    row("12 kPa", "", {"kPa", "without a unit"});
    row("5 mhz", "kHz", {"mhz", "kHz", "MHz"}); // milli or mega: nobody knows
    row("1,234", "kHz", {"1,234", "1.234", "1234"});
    row("-1,234 ms", "µs", {"1,234"});
    for (const char *nonsense : {"", " ", "abc", "1.2.3", "1,000.5", "1 000", "nan", "inf", "1e999",
             "0x1A", "--1", "1-", "kPa", "½", "1,234,567"})
        row(nonsense, "kPa", {});
}

void TestTypedQuantity::refused_saysWhy()
{
    QFETCH(QString, typed);
    QFETCH(QString, unit);
    QFETCH(QStringList, words);
    const TypedQuantity read = typedQuantity(typed, {unit, 1.0});
    QVERIFY2(!read.value, qPrintable(QString::number(read.value.value_or(0.0))));
    QVERIFY(!read.fault.isEmpty());
    for (const QString &word : words)
        QVERIFY2(read.fault.contains(word), qPrintable(read.fault));
}

void TestTypedQuantity::everyUnderstoodUnit_isUnderstood()
{
    for (const char *field :
        {"µs", "kHz", "MHz", "kPa", "K", "m", "mm", "m/s", "%", "ppm", "g/mol", "mV/kPa"}) {
        const ShownUnit unit{QString::fromUtf8(field), 1.0};
        QVERIFY2(understoodUnits(unit).size() > 1, field);
        QCOMPARE(understoodUnits(unit).front(), unit.text);
        for (const QString &one : understoodUnits(unit))
            QVERIFY2(typedQuantity("3 " + one, unit).value, qPrintable(one));
    }
}

void TestTypedQuantity::groupMark_isTheOtherLanguagesOnly()
{
    const ShownUnit kHz{"kHz", 1e3};
    QCOMPARE(*typedQuantity("1.234", kHz).value, 1.234);
    QCOMPARE(*typedQuantity("0,125", kHz).value, 0.125); // no group begins with 0
    QCOMPARE(*typedQuantity("1,2345", kHz).value, 1.2345);
    const test::InSwedish swedish;
    QCOMPARE(*typedQuantity("1,234", kHz).value, 1.234); // as the window shows it
    QVERIFY(!typedQuantity("1.234", kHz).value);
    QCOMPARE(*typedQuantity("1.5", kHz).value, 1.5);
}

DYNCAL_TEST(TestTypedQuantity)
#include "tst_typed_quantity.moc"
