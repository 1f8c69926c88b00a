// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/text/quantity_format.h"

#include <QHash>
#include <QLocale>
#include <QtTest>

#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;

namespace {

const QString kDash = QStringLiteral("–");

/// The number that a person reads: digits times prefix. NaN if it is none.
double readBack(const QString &shown, const QString &unit)
{
    static const QHash<QString, double> prefixes{{"", 1.0}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9},
        {"T", 1e12}, {"m", 1e-3}, {"µ", 1e-6}, {"n", 1e-9}, {"p", 1e-12}};
    const QString number = shown.section(' ', 0, 0);
    QString prefix = shown.section(' ', 1);
    if (!prefix.endsWith(unit))
        return std::nan("");
    prefix.chop(unit.size());
    if (!prefixes.contains(prefix))
        return std::nan("");
    return typedNumber(number).value_or(std::nan("")) * prefixes[prefix];
}

int decimalsOf(const QString &shown)
{
    return static_cast<int>(shown.section(' ', 0, 0).section(QLocale().decimalPoint(), 1).size());
}

} // namespace

/// Numbers as they are shown and typed, against the numbers they stand for.
class TestShownNumbers : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void quantity_readsBackToItsDigits();
    void quantity_roundedUpToAThousand_getsTheNextPrefix();
    void quantity_ofAnOddUnit_keepsIt();
    void number_typedBack_isTheSame_inBothLanguages();
    void typed_nonsense_isNoNumber_data();
    void typed_nonsense_isNoNumber();
    void typed_asPeopleType();
    void result_hasTheDecimalsOfItsUncertainty();
    void result_isNeverFurtherThanHalfADigit();
    void result_withoutAKnownU_hasADash();
    void beside_isInTheUnitOfTheValue();
    void resultBeside_hasItsPrefixAndThePlaceOfU();
    void swedish_thousandsAreNotGrouped();
    void brackets_holdTheLastDigits();
    void swedish_boundHasADecimalComma();
    void figures_keepTheirZeros();
    void notFinite_isADash();
};

void TestShownNumbers::quantity_readsBackToItsDigits()
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> mantissa(1.0, 10.0);
    std::uniform_int_distribution<int> exponent(-11, 10);
    for (int i = 0; i < 2000; ++i) {
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        const double value = sign * mantissa(random) * std::pow(10.0, exponent(random));
        for (const int digits : {3, 4, 7}) {
            const QString shown = shownQuantity(value, "Hz", digits);
            const double read = readBack(shown, "Hz");
            QVERIFY2(std::abs(read / value - 1.0) <= 0.5001 * std::pow(10.0, 1 - digits),
                qPrintable(shown));
            const double number = std::abs(typedNumber(shown.section(' ', 0, 0)).value());
            QVERIFY2(number >= 1.0 && number < 1000.0, qPrintable(shown));
        }
    }
}

void TestShownNumbers::quantity_roundedUpToAThousand_getsTheNextPrefix()
{
    // To four digits these are a thousand: "1000 Hz" beside "1.001 kHz" would read as less exact.
    for (const auto &[value, shown] : {std::pair(999.96, "1 kHz"), std::pair(999.94, "999.9 Hz"),
             std::pair(999.96e3, "1 MHz"), std::pair(-999.96, "-1 kHz")})
        QCOMPARE(shownQuantity(value, "Hz", 4), QString(shown));
}

void TestShownNumbers::quantity_ofAnOddUnit_keepsIt()
{
    QCOMPARE(shownQuantity(0.0, "Hz"), QString("0 Hz"));
    QCOMPARE(shownQuantity(0.5, "1"), QString("0.5"));
    const test::InSwedish swedish;
    // The unit may hold a point of its own, which is no decimal mark.
    const QString shown = shownQuantity(1.5, "arb. units");
    QVERIFY2(shown.startsWith("1,5 ") && shown.endsWith("arb. units"), qPrintable(shown));
}

void TestShownNumbers::number_typedBack_isTheSame_inBothLanguages()
{
    const auto check = [] {
        std::mt19937_64 random(11);
        std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
        std::uniform_int_distribution<int> exponent(-30, 30);
        for (int i = 0; i < 2000; ++i) {
            const double value = mantissa(random) * std::pow(10.0, exponent(random));
            const std::optional<double> typed = typedNumber(shownNumber(value, 17));
            QVERIFY2(typed && *typed == value, qPrintable(shownNumber(value, 17)));
        }
    };
    check();
    const test::InSwedish swedish;
    QVERIFY(shownNumber(0.25, 3).contains(','));
    check();
}

void TestShownNumbers::typed_nonsense_isNoNumber_data()
{
    QTest::addColumn<QString>("typed");
    for (const char *typed : {"", " ", "abc", "1.2.3", "1,000.5", "1 000", "nan", "inf", "-inf",
             "1e999", "0x1A", "12 kPa", "--1", "1-", "e5", ".", ",", "½", "１２"})
        QTest::newRow(typed) << QString::fromUtf8(typed);
}

void TestShownNumbers::typed_nonsense_isNoNumber()
{
    QFETCH(QString, typed);
    const std::optional<double> number = typedNumber(typed);
    QVERIFY2(!number, qPrintable(QString::number(number.value_or(0.0))));
}

void TestShownNumbers::typed_asPeopleType()
{
    QCOMPARE(*typedNumber(" 101,1 "), 101.1);
    QCOMPARE(*typedNumber("−3.5"), -3.5); // the minus sign of a document
    QCOMPARE(*typedNumber("1E-3"), 1e-3);
    QCOMPARE(*typedNumber("007"), 7.0);
    QCOMPARE(*typedNumber("-0"), 0.0);
}

void TestShownNumbers::result_hasTheDecimalsOfItsUncertainty()
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> logU(-7.0, -0.5);
    std::uniform_real_distribution<double> logValue(-5.0, 8.0);
    for (int i = 0; i < 2000; ++i) {
        const double value = std::pow(10.0, logValue(random));
        const double u = value * std::pow(10.0, logU(random));
        const ShownResult shown = shownResult(value, u, "Hz");
        QVERIFY2(decimalsOf(shown.value) == decimalsOf(shown.u),
            qPrintable(shown.value + " / " + shown.u));
        QCOMPARE(shown.value.section(' ', 1), shown.u.section(' ', 1)); // one unit for both
        // Two digits of u (GUM 7.2.6).
        QVERIFY(std::abs(readBack(shown.u, "Hz") / u - 1.0) <= 0.0501);
    }
}

void TestShownNumbers::result_isNeverFurtherThanHalfADigit()
{
    for (const double u : {0.0994, 0.0996, 0.00995, 0.5, 9.96, 94.0})
        for (const double value : {1.2345678, 12.345678, 999.99, 123.456}) {
            const ShownResult shown = shownResult(value, u, {});
            const double last = std::pow(10.0, -decimalsOf(shown.value));
            const double limit = decimalsOf(shown.value) > 0 ? 0.5001 * last : 5.001;
            QVERIFY2(std::abs(typedNumber(shown.value).value() - value) <= limit,
                qPrintable(shown.value));
        }
}

void TestShownNumbers::result_withoutAKnownU_hasADash()
{
    for (const double u : {std::nan(""), 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        const ShownResult shown = shownResult(2.33e6, u, "Hz");
        QCOMPARE(shown.u, kDash);
        QCOMPARE(shown.value, QString("2.3300 MHz"));
        QCOMPARE(shownWithU(2.33e6, u, "Hz"), QString("2.3300 MHz"));
    }
}

void TestShownNumbers::beside_isInTheUnitOfTheValue()
{
    for (const double value : {1.5e-6, 0.3, 434.36e3, 2.33e9}) {
        for (const double part : {1e-4, 0.02, 3.0}) {
            const QString unit = shownQuantity(value, "Pa").section(' ', 1);
            const QString shown = shownQuantityBeside(part * value, value, "Pa", 3);
            QCOMPARE(shown.section(' ', 1), unit);
            QVERIFY2(
                std::abs(readBack(shown, "Pa") / (part * value) - 1.0) < 6e-3, qPrintable(shown));
        }
    }
}

void TestShownNumbers::resultBeside_hasItsPrefixAndThePlaceOfU()
{
    const ShownResult small = shownResultBeside(2.6e-6, 1.234e-6, 1.5e-3, "s");
    QCOMPARE(small.value, QString("0.0026 ms"));
    QCOMPARE(small.u, QString("0.0012 ms"));
    const ShownResult plain = shownResultBeside(0.0123, 0.00456, 1.2, "1");
    QCOMPARE(plain.value + ' ' + plain.u, QString("0.0123 0.0046"));
    QCOMPARE(shownResultBeside(std::nan(""), 1.0, 1e3, "Pa").value, kDash);
    QCOMPARE(shownResultBeside(1.0, 0.1, 0.0, "Pa").value, QString("1.00 Pa"));
}

void TestShownNumbers::swedish_thousandsAreNotGrouped()
{
    const test::InSwedish swedish;
    QCOMPARE(shownNumber(1234567.5, 9), QString("1234567,5"));
    QCOMPARE(shownQuantity(1234.5, "Hz", 6), QString("1,2345 kHz"));
    QCOMPARE(shownWithU(1.0, 0.012, "1"), QString("1,000 ± 0,012"));
    QCOMPARE(shownWithStandardU(1.0, 0.012, "1"), QString("1,000 (u = 0,012)"));
    QCOMPARE(shownWithStandardU(2.33e6, 130.0, "Hz"), QString("2,33000 MHz (u = 0,00013 MHz)"));
    QCOMPARE(shownWithStandardU(1.5, std::nan(""), "Hz", 3), QString("1,50 Hz"));
}

void TestShownNumbers::brackets_holdTheLastDigits()
{
    QCOMPARE(shownConcisely(2.329980e6, 68.0, "Hz"), QString("2.329980(68) MHz"));
    QCOMPARE(shownConcisely(0.0200042, 5.0e-6, {}), QString("0.0200042(50)"));
    QCOMPARE(shownConcisely(432.04e3, 3.72e3, "Pa"), QString("432.0(3.7) kPa"));
    QCOMPARE(shownConcisely(101.3e3, 120e3, "Pa"), QString("100(120) kPa"));
    QCOMPARE(shownConcisely(-0.5, 0.02, "V"), QString("-500(20) mV"));
    QCOMPARE(shownConcisely(5.0182e-6, 0.053e-6, "V/Pa"), QString::fromUtf8("5.018(53) µV/Pa"));
    QCOMPARE(shownConcisely(12.5, std::nan(""), "Hz", 3), QString("12.5 Hz"));
    QCOMPARE(shownConcisely(std::nan(""), 1.0, "Hz"), kDash);
    const test::InSwedish swedish;
    QCOMPARE(shownConcisely(432.04e3, 3.72e3, "Pa"), QString("432,0(3,7) kPa"));
    QCOMPARE(shownConcisely(2.33e6, 130.0, "Hz"), QString("2,33000(13) MHz"));
}

void TestShownNumbers::swedish_boundHasADecimalComma()
{
    const test::InSwedish swedish;
    QCOMPARE(inDecimalMark("< 0.001"), QString("< 0,001"));
    QCOMPARE(inDecimalMark("≥ 2.5 kHz"), QString("≥ 2,5 kHz"));
    QCOMPARE(inDecimalMark("<file 2.5.1>"), QString("<file 2.5.1>"));
}

void TestShownNumbers::figures_keepTheirZeros()
{
    QCOMPARE(shownFigures(7.0, 2), QString("7.0"));
    QCOMPARE(shownFigures(7.44, 2), QString("7.4"));
    QCOMPARE(shownFigures(0.996, 2), QString("1.0"));
    QCOMPARE(shownFigures(9.96, 2), QString("10"));
    QCOMPARE(shownFigures(99.6, 2), QString("100"));
    QCOMPARE(shownFigures(-0.05, 2), QString("-0.050"));
    QCOMPARE(shownFigures(123.0, 2), QString("123"));
    QCOMPARE(shownFigures(0.0, 2), QString("0"));
    QCOMPARE(shownFigures(1e-7, 2), shownNumber(1e-7, 2));
    QCOMPARE(shownFigures(std::nan(""), 2), kDash);
}

void TestShownNumbers::notFinite_isADash()
{
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double value : {std::nan(""), infinite, -infinite}) {
        QCOMPARE(shownNumber(value), kDash);
        QCOMPARE(shownQuantity(value, "Hz"), kDash);
        QCOMPARE(shownResult(value, 1.0, "Hz").value, kDash);
        QVERIFY(shownQuantityBeside(value, 1.0, "Pa", 2).startsWith(kDash));
    }
    QCOMPARE(shownQuantity(std::optional<double>(), "Hz"), kDash);
}

DYNCAL_TEST(TestShownNumbers)
#include "tst_shown_numbers.moc"
