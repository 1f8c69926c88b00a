// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Units as digital calibration certificates write them.

#include "core/dcc_reading/d_si_unit.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <numbers>
#include <string>
#include <utility>

using namespace dyncal;
using testing::isNear;

namespace {

/// SI brochure, 9th edition, table 7, as decimal text: read by the compiler, not by a power.
constexpr std::array<std::pair<const char *, double>, 20> kPrefixes{
    {{"yotta", 1e24}, {"zetta", 1e21}, {"exa", 1e18}, {"peta", 1e15}, {"tera", 1e12}, {"giga", 1e9},
        {"mega", 1e6}, {"kilo", 1e3}, {"hecto", 1e2}, {"deca", 1e1}, {"deci", 1e-1},
        {"centi", 1e-2}, {"milli", 1e-3}, {"micro", 1e-6}, {"nano", 1e-9}, {"pico", 1e-12},
        {"femto", 1e-15}, {"atto", 1e-18}, {"zepto", 1e-21}, {"yocto", 1e-24}}};

/// Of a text that is a unit.
double factorOf(const std::string &text)
{
    return parseDSiUnit(text).value().factor;
}

std::string repeated(const std::string &text, int times)
{
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

} // namespace

class TestDSiUnit : public QObject
{
    Q_OBJECT

private slots:
    void units_areRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("symbol");
        QTest::addColumn<double>("factor");
        QTest::newRow("V/MPa") << "\\volt\\mega\\pascal\\tothe{-1}"
                               << "V/Pa" << 1e-6;
        QTest::newRow("per") << "\\milli\\volt\\per\\kilo\\pascal"
                             << "V/Pa" << 1e-6;
        QTest::newRow("pC/bar") << "\\pico\\coulomb\\bar\\tothe{-1}"
                                << "C/Pa" << 1e-17;
        QTest::newRow("Hz") << "\\hertz"
                            << "Hz" << 1.0;
        QTest::newRow("kHz") << "\\kilo\\hertz"
                             << "Hz" << 1e3;
        QTest::newRow("degree") << "\\degree"
                                << "rad" << std::numbers::pi / 180.0;
        QTest::newRow("one") << "\\one"
                             << "1" << 1.0;
        QTest::newRow("per first") << "\\per\\mega\\pascal"
                                   << "1/Pa" << 1e-6;
        QTest::newRow("squared") << "\\kilo\\pascal\\tothe{2}"
                                 << "Pa2" << 1e6;
        QTest::newRow("cancels") << "\\pascal\\kilo\\pascal\\tothe{-1}"
                                 << "1" << 1e-3;
    }
    void units_areRead()
    {
        QFETCH(QString, text);
        QFETCH(QString, symbol);
        QFETCH(double, factor);
        const auto unit = parseDSiUnit(text.toStdString());
        QVERIFY(unit.has_value());
        QCOMPARE(unit->symbol(), symbol.toStdString());
        QVERIFY(isNear(unit->factor, factor, 1e-12));
    }

    void malformedOnes_areRefused()
    {
        for (const char *text :
            {"", "V/Pa", "\\furlong", "\\mega", "\\volt\\mega", "\\volt\\tothe{x}", "\\tothe{2}",
                "\\volt\\tothe{0.5}", "\\kilo\\mega\\volt", "\\volt pascal",
                "\\volt\\per\\per\\pascal", "\\volt\\tothe{99}", "\\volt\\per", "\\per",
                "\\per\\per\\pascal", "\\volt\\kilo\\per\\pascal", "\\volt\\per\\tothe{2}\\pascal",
                "\\volt\\kilo\\tothe{2}\\pascal", "\\volt\\tothe{2}\\tothe{3}"})
            QVERIFY2(!parseDSiUnit(text), text);
    }

    /// An exponent is of the unit with its prefix: km2 are 1e6 m2.
    void everyPrefix_inEveryPower()
    {
        for (const auto &[word, factor] : kPrefixes)
            for (const int power : {-4, -3, -2, -1, 1, 2, 3, 4}) {
                double expected = 1.0;
                for (int i = 0; i < std::abs(power); ++i)
                    expected = power > 0 ? expected * factor : expected / factor;
                const std::string text
                    = std::string("\\") + word + "\\second\\tothe{" + std::to_string(power) + "}";
                const auto unit = parseDSiUnit(text);
                QVERIFY2(unit.has_value(), text.c_str());
                QVERIFY2(isNear(unit->factor, expected, 1e-12), text.c_str());
                QCOMPARE(unit->powerOf("s"), power);
                QCOMPARE(unit->powers.size(), std::size_t(1));
            }
    }

    void everyPrefix_hasItsInverse()
    {
        for (std::size_t i = 0; i < kPrefixes.size(); ++i) {
            const std::string up = std::string("\\") + kPrefixes[i].first + "\\volt",
                              down
                = std::string("\\") + kPrefixes[kPrefixes.size() - 1 - i].first + "\\volt";
            QVERIFY2(isNear(factorOf(up) * factorOf(down), 1.0, 1e-14), up.c_str());
            QVERIFY2(isNear(factorOf(up + "\\per" + up), 1.0, 1e-14), up.c_str());
        }
    }

    /// Factors to the SI by hand, from the tables of the brochure.
    void everyUnit_hasItsFactor_data()
    {
        QTest::addColumn<QString>("symbol");
        QTest::addColumn<double>("factor");
        for (const auto &[word, symbol] :
            std::initializer_list<std::pair<const char *, const char *>>{{"volt", "V"},
                {"ampere", "A"}, {"coulomb", "C"}, {"watt", "W"}, {"pascal", "Pa"}, {"hertz", "Hz"},
                {"radian", "rad"}, {"one", "1"}, {"metre", "m"}, {"second", "s"},
                {"kilogram", "kg"}, {"newton", "N"}, {"joule", "J"}, {"kelvin", "K"},
                {"ohm", "ohm"}, {"siemens", "S"}, {"farad", "F"}, {"henry", "H"}, {"tesla", "T"},
                {"weber", "Wb"}, {"mole", "mol"}, {"candela", "cd"}, {"steradian", "sr"}})
            QTest::newRow(word) << symbol << 1.0;
        QTest::newRow("bar") << "Pa" << 100000.0;
        QTest::newRow("percent") << "1" << 0.01;
        QTest::newRow("ppm") << "1" << 0.000001;
        QTest::newRow("minute") << "s" << 60.0;
        QTest::newRow("hour") << "s" << 3600.0;
        QTest::newRow("day") << "s" << 24.0 * 3600.0;
        QTest::newRow("gram") << "kg" << 0.001;
        QTest::newRow("tonne") << "kg" << 1000.0;
        QTest::newRow("degree") << "rad" << 0.017453292519943295;
        QTest::newRow("arcminute") << "rad" << 0.017453292519943295 / 60.0;
        QTest::newRow("arcsecond") << "rad" << 0.017453292519943295 / 3600.0;
    }
    void everyUnit_hasItsFactor()
    {
        QFETCH(QString, symbol);
        QFETCH(double, factor);
        const auto unit = parseDSiUnit(std::string("\\") + QTest::currentDataTag());
        QVERIFY(unit.has_value());
        QCOMPARE(unit->symbol(), symbol.toStdString());
        QVERIFY(isNear(unit->factor, factor, 1e-14));
    }

    /// No multiples of an SI unit, or not of the D-SI: none may pass as another.
    void unitsThatAreNoMultiples_areUnknown()
    {
        for (const char *text :
            {"\\degreecelsius", "\\decibel", "\\deci\\bel", "\\neper", "\\Volt", "\\volts", "\\v",
                "\\meter", "\\kilohertz", "\\kilo hertz", "\\ volt", "\\volt ", "\\", "\\volt\\",
                "\\\\volt", "volt", "x\\volt", "\\volt\\tothe{}", "\\volt\\tothe{1",
                "\\volt\\tothe2", "\\volt\\tothe{-}", "\\volt\\tothe{NaN}", "\\volt\\tothe{10}",
                "\\volt\\tothe{1,0}", "\\kilo\\tothe{2}", "\\kilo\\kilo\\volt"})
            QVERIFY2(!parseDSiUnit(text), text);
    }

    void perAndExponents_sayTheSame()
    {
        for (const auto &[per, exponent] :
            {std::pair{"\\volt\\per\\mega\\pascal", "\\volt\\mega\\pascal\\tothe{-1}"},
                std::pair{"\\metre\\per\\second\\tothe{2}", "\\metre\\second\\tothe{-2}"},
                std::pair{"\\per\\milli\\second\\tothe{-2}", "\\milli\\second\\tothe{2}"},
                std::pair{"\\pico\\coulomb\\per\\metre\\per\\second\\tothe{-2}",
                    "\\pico\\coulomb\\metre\\tothe{-1}\\second\\tothe{2}"}}) {
            const auto first = parseDSiUnit(per), second = parseDSiUnit(exponent);
            QVERIFY2(first && second, per);
            QCOMPARE(first->powers, second->powers);
            QVERIFY2(isNear(first->factor, second->factor, 1e-14), per);
        }
        // only the unit that follows is below the line
        QCOMPARE(parseDSiUnit("\\volt\\per\\pascal\\second")->symbol(), std::string("V s/Pa"));
    }

    /// Units that stand behind each other are multiplied, in whichever order.
    void products_multiplyFactorsAndAddPowers()
    {
        const std::array<std::string, 6> units{"\\milli\\volt", "\\bar\\tothe{-1}",
            "\\kilo\\pascal\\tothe{2}", "\\per\\micro\\second", "\\percent", "\\degree"};
        for (const std::string &a : units)
            for (const std::string &b : units) {
                const auto first = parseDSiUnit(a), second = parseDSiUnit(b),
                           both = parseDSiUnit(a + b), reversed = parseDSiUnit(b + a);
                QVERIFY2(both && reversed, (a + b).c_str());
                QVERIFY(isNear(both->factor, first->factor * second->factor, 1e-14));
                QVERIFY(isNear(both->factor, reversed->factor, 1e-14));
                QCOMPARE(both->powers, reversed->powers);
                for (const char *symbol : {"V", "Pa", "s", "rad"})
                    QCOMPARE(
                        both->powerOf(symbol), first->powerOf(symbol) + second->powerOf(symbol));
                for (const auto &[symbol, power] : both->powers)
                    QVERIFY2(power != 0, symbol.c_str());
            }
    }

    /// 0 of infinitely many volts is no number, and 5 of none is not 0.
    void factorsBeyondNumbers_areNoUnits()
    {
        const std::string large = "\\yotta\\volt\\tothe{9}", small = "\\yocto\\volt\\tothe{9}";
        QVERIFY(isNear(factorOf(large), 1e216, 1e-12));
        for (const std::string &text : {large + large, small + small, large + large + small + small,
                 repeated("\\kilo\\metre", 200), repeated("\\per\\kilo\\metre", 200)})
            QVERIFY2(!parseDSiUnit(text), text.c_str());
        QVERIFY(!unitOfSymbol("1" + repeated("/km", 200)));
        QVERIFY(!unitRatio("1" + repeated("/km", 200), "1" + repeated("/km", 200)));
        QCOMPARE(parseDSiUnit(repeated("\\metre", 1000))->powerOf("m"), 1000);
    }

    void sensitivities_areOutputsPerInput()
    {
        for (const char *text : {"\\volt\\per\\pascal", "\\ampere\\per\\bar",
                 "\\coulomb\\per\\newton", "\\per\\pascal", "\\percent\\per\\bar", "\\per\\newton",
                 "\\volt\\per\\metre\\second\\tothe{2}", "\\per\\metre\\second\\tothe{2}"})
            QVERIFY2(parseDSiUnit(text)->isSensitivity(), text);
        for (const char *text :
            {"\\volt", "\\one", "\\pascal", "\\volt\\pascal", "\\pascal\\per\\volt",
                "\\volt\\tothe{2}\\per\\pascal", "\\volt\\per\\pascal\\tothe{2}",
                "\\volt\\ampere\\per\\pascal", "\\volt\\per\\pascal\\per\\newton",
                "\\volt\\second\\per\\pascal", "\\volt\\per\\metre\\second", "\\volt\\per\\metre",
                "\\watt\\per\\pascal", "\\volt\\per\\pascal\\per\\metre\\second\\tothe{2}",
                "\\volt\\per\\ampere\\per\\pascal"})
            QVERIFY2(!parseDSiUnit(text)->isSensitivity(), text);
    }

    void symbols_haveWhatIsBelowTheLineBehindSlashes()
    {
        for (const auto &[text, symbol] :
            {std::pair{"\\volt\\second\\tothe{2}\\metre\\tothe{-1}", "V s2/m"},
                std::pair{"\\metre\\tothe{-1}\\pascal\\tothe{-2}", "1/Pa2/m"},
                std::pair{"\\pascal\\per\\pascal", "1"}, std::pair{"\\second\\ampere", "A s"}})
            QCOMPARE(parseDSiUnit(text)->symbol(), std::string(symbol));
        const auto unit = parseDSiUnit("\\hertz\\tothe{2}");
        QVERIFY(!unit->isOf("Hz") && unit->powerOf("Hz") == 2 && unit->powerOf("V") == 0);
        QVERIFY(!parseDSiUnit("\\one")->isOf("") && !parseDSiUnit("\\hertz\\second")->isOf("Hz"));
    }

    /// From a to b and back is 1; over c is the same way.
    void ratios_areConsistent()
    {
        const std::array<std::string, 5> units{"V/Pa", "mV/kPa", "uV/Pa", "V/MPa", "\xC2\xB5V/GPa"};
        const std::array<double, 5> factors{1.0, 1e-6, 1e-6, 1e-6, 1e-15};
        for (std::size_t i = 0; i < units.size(); ++i)
            for (std::size_t j = 0; j < units.size(); ++j)
                QVERIFY(
                    isNear(unitRatio(units[i], units[j]).value(), factors[i] / factors[j], 1e-12));
        QVERIFY(!unitRatio("V/Pa", "V") && !unitRatio("V/Pa", "") && !unitRatio("1", "Pa"));
    }
};

DYNCAL_TEST(TestDSiUnit)
#include "tst_d_si_unit.moc"
