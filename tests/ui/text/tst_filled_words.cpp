// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How documents write numbers: the decimal mark of their language, groups of digits, and nothing of
// what was typed.

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "tests/support/test_program.h"
#include "ui/text/core_text.h"
#include "ui/text/filled_words.h"
#include "ui/text/number_locale.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

QString sameText(const char *text)
{
    return QString::fromUtf8(text);
}

QString inCommas(const Message &message)
{
    return filledWords(message, sameText, ',');
}

QString numbers(const std::string &text)
{
    return inCommas({"%L1", {text}});
}

/// Back to the writing of core.
std::string undone(QString shown)
{
    return shown.remove(QChar(0x202f)).replace(',', '.').toStdString();
}

} // namespace

class TestFilledWords : public QObject
{
    Q_OBJECT

private slots:
    void number_hasTheMarkAndGroupsOfThree_data();
    void number_hasTheMarkAndGroupsOfThree();
    void numbers_ofAnySize_readBackTheSame();
    void point_changesNothing();
    void foreign_staysAsItIs();
    void sentence_hasTheMark_inWhatIsWhollyNumbers();
    void window_leavesForeignPlaces();
    void sentenceWithin_isTranslatedAndMarked();
    void locale_isThatOfTheLanguage();
};

void TestFilledWords::number_hasTheMarkAndGroupsOfThree_data()
{
    QTest::addColumn<QString>("core");
    QTest::addColumn<QString>("shown");
    const auto row = [](const char *core, const char *shown) {
        QTest::newRow(core) << QString::fromUtf8(core)
                            << QString::fromUtf8(shown).replace('~', QChar(0x202f));
    };
    row("2.33 MHz", "2,33 MHz");
    row("0.1234", "0,1234"); // four digits are not grouped
    row("0.02000", "0,020~00");
    row("0.123456", "0,123~456");
    row("0.1234567", "0,123~456~7");
    row("1234", "1234");
    row("20000", "20~000");
    row("1234567.89 Pa", "1~234~567,89 Pa");
    row("2.3301 MHz \u00b1 0.0024 MHz (k = 4.30)", "2,3301 MHz \u00b1 0,0024 MHz (k = 4,30)");
    row("0.98765 \u00b1 j0.12345", "0,987~65 \u00b1 j0,123~45");
    row("1.5 \u00d710^-7 mV/Pa", "1,5 \u00d710^-7 mV/Pa");
    row("1.5e-07", "1,5e-07");
    row("-0.5 \u00b0", "-0,5 \u00b0");
    row("\u00b15.2 %", "\u00b15,2 %");
    row("3.4 N/mm2", "3,4 N/mm2");
    row("97.5 \u2026 101.3 kPa", "97,5 \u2026 101,3 kPa");
    row("sensitivity 0.5 %, phase_rad 0.01 rad (10 Hz ... 2.5 kHz)",
        "sensitivity 0,5 %, phase_rad 0,01 rad (10 Hz ... 2,5 kHz)");
    row("\u2013", "\u2013");
    row("1.2.3", "1.2.3"); // no number
    row("", "");
}

void TestFilledWords::number_hasTheMarkAndGroupsOfThree()
{
    QFETCH(const QString, core);
    QFETCH(const QString, shown);
    QCOMPARE(numbers(core.toStdString()), shown);
}

void TestFilledWords::numbers_ofAnySize_readBackTheSame()
{
    std::mt19937 random(20261);
    std::uniform_real_distribution<double> exponent(-9.0, 9.0);
    for (int i = 0; i < 2000; ++i) {
        const double value = (i % 2 ? -1.0 : 1.0) * std::pow(10.0, exponent(random));
        const double u = std::abs(value) * std::pow(10.0, -std::abs(exponent(random)));
        for (const std::string &text : {roundedTextWithU(value, u, "Hz"), numberText(value, 9),
                 settingText(value, "Pa"), fixedText(value, 6)}) {
            const QString shown = numbers(text);
            QVERIFY2(!shown.contains('.'), qPrintable(shown));
            QCOMPARE(undone(shown), text);
        }
    }
}

void TestFilledWords::point_changesNothing()
{
    for (const char *text : {"%L1", "%1", "%V1", "A value of %1.", "A value of %L1."})
        QCOMPARE(filledWords({text, {"20000.12345 Hz"}}, sameText, '.'),
            QString(text).replace(QRegularExpression("%[LV]?1"), "20000.12345 Hz"));
}

void TestFilledWords::foreign_staysAsItIs()
{
    QCOMPARE(inCommas({"%1", {"2.10"}}), QString("2.10")); // a serial number
    QCOMPARE(inCommas({"%V1, version %V2: %3", {"1.5", "2.0", "3.25"}}),
        QString("1.5, version 2.0: 3,25"));
    QCOMPARE(inCommas({"%L1: %V2", {"1.5 kHz", "7.5"}}), QString("1,5 kHz: 7.5"));
}

void TestFilledWords::sentence_hasTheMark_inWhatIsWhollyNumbers()
{
    const auto filled = [](const char *argument) { return inCommas({"It is %1.", {argument}}); };
    QCOMPARE(filled("1.5 kHz"), QString("It is 1,5 kHz."));
    QCOMPARE(filled("12 to 12.5 kHz"), QString("It is 12 to 12,5 kHz."));
    QCOMPARE(filled("a2.5.csv"), QString("It is a2.5.csv."));
    QCOMPARE(filled("results.json"), QString("It is results.json."));
    QCOMPARE(filled("2.5.1"), QString("It is 2.5.1."));
    Message two{"It is %1.", {"0.5"}};
    two.below = {{"%L1 more.", {"0.25"}}};
    QCOMPARE(inCommas(two), QString("It is 0,5.\n0,25 more."));
}

void TestFilledWords::window_leavesForeignPlaces()
{
    const QLocale before;
    QLocale::setDefault(numberLocale("sv"));
    QCOMPARE(
        translated({"Version %V1 of %2.", {"1.5", "2.5 kHz"}}), QString("Version 1.5 of 2,5 kHz."));
    QCOMPARE(printed({"%L1", {"2.5 kHz"}}), QString("2,5 kHz"));
    QLocale::setDefault(before);
    QCOMPARE(english({"Version %V1 of %L2.", {"1.5", "2.5 kHz"}}),
        std::string("Version 1.5 of 2.5 kHz."));
}

void TestFilledWords::locale_isThatOfTheLanguage()
{
    QCOMPARE(numberLocale("en").decimalPoint(), QString("."));
    QCOMPARE(numberLocale("").decimalPoint(), QString("."));
    for (const char *code : {"sv", "de"}) {
        QCOMPARE(numberLocale(code).decimalPoint(), QString(","));
        QCOMPARE(numberLocale(code).toString(123456.5, 'f', 1), QString("123456,5"));
    }
}

void TestFilledWords::sentenceWithin_isTranslatedAndMarked()
{
    const Message reason{"Shot %1 has %2.", {"2", "1.5 kHz"}};
    const Message whole{"Not known (%M1); see %1.", {"%M1"}, {reason}};
    QCOMPARE(english(whole), std::string("Not known (Shot 2 has 1.5 kHz.); see %M1."));
    QCOMPARE(inCommas(whole), QString("Not known (Shot 2 has 1,5 kHz.); see %M1."));
    QCOMPARE(filledWords(
                 whole,
                 [](const char *text) {
                     return QString::fromUtf8(text).replace("has", "har").replace("Not", "Ej");
                 },
                 ','),
        QString("Ej known (Shot 2 har 1,5 kHz.); see %M1."));
    QCOMPARE(english({"%M2 and %M1", {}, {reason}}), // a place without a sentence stays
        std::string("%M2 and Shot 2 has 1.5 kHz."));
    QVERIFY(!(whole == Message{whole.text, whole.arguments}));
}

DYNCAL_TEST(TestFilledWords)
#include "tst_filled_words.moc"
