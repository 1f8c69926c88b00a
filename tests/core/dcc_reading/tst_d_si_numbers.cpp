// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers and units of the D-SI's elements, one or a list of them.

#include "core/dcc_reading/d_si_numbers.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <string>

using namespace dyncal;

namespace {

ParsedElement element(const std::string &text, const std::string &name = "valueXMLList")
{
    return readXml("<si:" + name + ">" + text + "</si:" + name + ">").value();
}

template <typename T>
std::string faultOf(const Result<T> &result)
{
    return result ? std::string() : english(result.error().message);
}

} // namespace

class TestDSiNumbers : public QObject
{
    Q_OBJECT

private slots:
    void numbers_areRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QList<double>>("numbers");
        QTest::newRow("one") << "1" << QList<double>{1};
        QTest::newRow("signs") << "-1 +2" << QList<double>{-1, 2};
        QTest::newRow("points") << ".5 5." << QList<double>{0.5, 5};
        QTest::newRow("exponents") << "1e3 1E-3 1.5e+2" << QList<double>{1000, 0.001, 150};
        QTest::newRow("blanks") << "\n 1\t2\r\n  3 " << QList<double>{1, 2, 3};
        QTest::newRow("small") << "1e-300" << QList<double>{1e-300};
    }
    void numbers_areRead()
    {
        QFETCH(QString, text);
        QFETCH(QList<double>, numbers);
        const auto read = numbersIn(element(text.toStdString()));
        QVERIFY2(read.has_value(), faultOf(read).c_str());
        QCOMPARE(*read, std::vector<double>(numbers.begin(), numbers.end()));
    }

    void otherWords_areRefused()
    {
        for (const char *text :
            {"", " ", "1 two", "1;2", "Inf", "-INF", "infinity", "nan", "1_000", "0x1p3", "1e400",
                "\xE2\x88\x92"
                "1",
                "--1", "1-2"})
            QVERIFY2(!numbersIn(element(text)), text);
        for (const char *text : {"1,5", "1.234,5", "1,2,3"})
            QVERIFY2(faultOf(numbersIn(element(text))).find("comma") != std::string::npos, text);
    }

    /// NaN is a word of lists only.
    void noValue_isAWordOfLists()
    {
        const auto list = numbersIn(element("1 NaN"));
        QVERIFY(list && std::isnan((*list)[1]));
        QVERIFY(!numbersIn(element("NaN", "value")));
    }

    void oneStandsForAll_otherwiseEachHasItsOwn()
    {
        QCOMPARE(*numbersIn(element("2"), 3), (std::vector<double>{2, 2, 2}));
        QCOMPARE(*numbersIn(element("2 3"), 2), (std::vector<double>{2, 3}));
        const std::string fault = faultOf(numbersIn(element("2 3"), 3));
        QVERIFY2(fault.find("2 entries for 3 values") != std::string::npos, fault.c_str());
        QVERIFY(!numbersIn(element("1 2 3 4"), 3));
    }

    void children_areNeededOnce()
    {
        const ParsedElement parent = readXml("<a>\n<b>1</b><c>2</c><c>3</c></a>").value();
        QCOMPARE((*neededChild(parent, "b"))->text, std::string("1"));
        QVERIFY(faultOf(neededChild(parent, "c")).find("more than once") != std::string::npos);
        QCOMPARE(faultOf(neededChild(parent, "d")),
            std::string("Line 1, a: it lacks the element d, without which it says nothing."));
        QCOMPARE(*numbersOfChild(parent, "b", 2), (std::vector<double>{1, 1}));
        QVERIFY(!numbersOfChild(parent, "d", 1));
    }

    void units_areOfOneQuantity()
    {
        const auto one = unitIn(element("\\milli\\volt", "unitXMLList"), 2);
        QVERIFY(one->unit.isOf("V"));
        QCOMPARE(one->factors, (std::vector<double>{1e-3, 1e-3}));
        const auto each = unitIn(element("\\milli\\volt \\volt", "unitXMLList"), 2);
        QCOMPARE(each->factors, (std::vector<double>{1e-3, 1}));
        const auto faultOfUnit = [](const char *text, std::size_t count) {
            return faultOf(unitIn(element(text, "unitXMLList"), count));
        };
        QVERIFY(faultOfUnit("\\volt \\ampere", 2).find("one list") != std::string::npos);
        QVERIFY(faultOfUnit("\\volt \\volt", 3).find("2 entries") != std::string::npos);
        QVERIFY(faultOfUnit("", 3).find("0 entries") != std::string::npos);
        QVERIFY(faultOfUnit("V/Pa", 1).find("'V/Pa'") != std::string::npos);
    }

    void units_ofRecipes_areKnown()
    {
        QCOMPARE(unitOfSymbol("V/Pa")->factor, 1.0);
        QVERIFY(std::abs(unitOfSymbol("pC/Pa")->factor / 1e-12 - 1) < 1e-12);
        QVERIFY(std::abs(unitOfSymbol("mV/kPa")->factor / 1e-6 - 1) < 1e-12);
        QVERIFY(unitOfSymbol("1")->powers.empty() && unitOfSymbol("Pa/Pa")->powers.empty());
        QCOMPARE(unitOfSymbol("m")->powers.at("m"), 1); // metre, no prefix
        for (const char *text : {"", "/", "V/", "/Pa", "xV", "k", "V Pa", "V//Pa"})
            QVERIFY2(!unitOfSymbol(text), text);
        QVERIFY(std::abs(*unitRatio("pC/Pa", "C/Pa") / 1e-12 - 1) < 1e-12);
        QVERIFY(!unitRatio("V/Pa", "V/N") && !unitRatio("g/Pa", "g/Pa"));
    }

    void elementsAmongNumbers_areRefused()
    {
        for (const char *name : {"value", "valueXMLList"}) {
            const auto numbers = numbersIn(
                readXml("<" + std::string(name) + ">5<x/>0e-6</" + std::string(name) + ">")
                    .value());
            QVERIFY(!numbers
                && english(numbers.error().message).find("element x") != std::string::npos);
        }
        QVERIFY(!unitIn(readXml("<unit>\\vo<x/>lt</unit>").value(), 1));
    }
};

DYNCAL_TEST(TestDSiNumbers)
#include "tst_d_si_numbers.moc"
