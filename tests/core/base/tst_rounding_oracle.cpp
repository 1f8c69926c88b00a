// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounding against exact decimal arithmetic: Python's decimal module reads what is printed, knows
// every double exactly, and has no part in how the texts are made.

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

// value, u, unit, printed value, printed u, printed unit: GUM 7.2.6 in exact arithmetic. What is
// scaled by a power of ten in doubles may turn a tie: hence the hair beyond half a digit.
const char *const kOracle = R"PY(
import sys, re
from decimal import Decimal, getcontext
getcontext().prec = 800
PREFIX = {'f': -15, 'p': -12, 'n': -9, '\u00b5': -6, 'm': -3, '': 0, 'k': 3, 'M': 6, 'G': 9}
PREFIXED = {'Hz', 'V', 's', 'Pa', 'V/Pa'}
bad = 0
for line in open(sys.argv[1], encoding='utf-8'):
    value, u, unit, text, utext, shown = line.rstrip('\n').split('\t')
    value, u = Decimal(float(value)), float(u)
    power = re.match('\u00d710\\^(-?[0-9]+) ?', shown)
    if power:
        exponent, rest = int(power.group(1)), shown[power.end():]
    else:
        rest = unit
        exponent = PREFIX.get(shown[:len(shown) - len(unit)], 99)
    problems = []
    if rest != unit or exponent == 99:
        problems.append('unit')
    scale = Decimal(10) ** exponent
    decimals = lambda t: len(t.split('.')[1]) if '.' in t else 0
    known = u > 0 and u == u and u != float('inf') and u > 1e-12 * abs(float(value))
    if known:
        u = Decimal(u)
        # Place of the second digit of u, after rounding: 0.0996 is 0.10.
        place = Decimal(10) ** (u.adjusted() - 1)
        if (u / place).quantize(Decimal(1)) >= 100:
            place *= 10
        ties = (u / place) % 1 == Decimal('0.5')
        if not ties and abs(Decimal(utext) * scale - u) > place * Decimal('0.5000000001'):
            problems.append('u')
        if abs(Decimal(text) * scale - value) > place * Decimal('0.5000000001') and not ties:
            problems.append('value')
        if decimals(text) != decimals(utext):
            problems.append('decimals')
        digits = utext.replace('.', '').lstrip('0')
        if len(digits) != 2 and ('.' in utext or digits[2:].strip('0')):
            problems.append('digits of u')
        larger = max(abs(Decimal(text)), Decimal(utext))
    else:
        if utext:
            problems.append('u from nowhere')
        if value != 0:
            place = Decimal(10) ** (value.adjusted() - 2)
            if abs(Decimal(text) * scale - value) > place * Decimal('0.5000000001'):
                problems.append('value')
            digits = text.replace('.', '').lstrip('-0')
            if len(digits) != 3 and '.' in text:
                problems.append('digits')
        larger = abs(Decimal(text))
    if text.startswith('-0') and not text.strip('-0.'):
        problems.append('minus zero')
    if unit in PREFIXED and larger != 0 and not power and -15 < exponent < 9:
        if not 1 <= larger < 1000:
            problems.append('prefix')
    if problems:
        bad += 1
        if bad < 20:
            print(line.rstrip(), problems)
print(bad, 'bad')
sys.exit(1 if bad else 0)
)PY";

/// One line of the oracle's table.
QByteArray line(double value, double u, const char *unit)
{
    const RoundedValue shown = roundedValue(value, u, unit);
    std::string text
        = exactNumber(value) + "\t" + exactNumber(u) + "\t" + unit + "\t" + shown.value;
    text += "\t" + shown.u + "\t" + shown.unit + "\n";
    return QByteArray::fromStdString(text);
}

const std::vector<const char *> kUnits{"Hz", "V", "s", "Pa", "V/Pa", "", "K", "%", "mV/Pa"};

QByteArray randomCases()
{
    std::mt19937_64 random(20261121);
    std::uniform_real_distribution<double> decade(-20.0, 20.0);
    std::uniform_real_distribution<double> relative(-9.0, 3.0);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    QByteArray table;
    for (std::size_t i = 0; i < 6000; ++i) {
        const double value = mantissa(random) * std::pow(10.0, decade(random));
        const double u = std::abs(value) * std::pow(10.0, relative(random));
        table += line(value, i % 4 == 0 ? std::nan("") : u, kUnits[i % kUnits.size()]);
    }
    return table;
}

/// 9.95, 99.5, 0.0995 and their neighbours, alone and beside each other.
QByteArray edgeCases()
{
    QByteArray table;
    std::vector<double> edges;
    for (const double mantissa : {1.0, 1.05, 9.5, 9.949999, 9.95, 9.950001, 9.99, 9.995, 9.99949,
             9.9995, 9.99995, 9.999995, 5.0}) {
        for (const int exponent : {-19, -18, -15, -6, -4, -3, -1, 0, 2, 3, 5, 6, 11, 17, 18}) {
            const double edge = mantissa * std::pow(10.0, exponent);
            for (const double near : {edge, std::nextafter(edge, 0.0), std::nextafter(edge, 1e99)})
                edges.push_back(near);
        }
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double value = edges[i];
        for (const char *unit : {"Hz", "K", ""}) {
            table += line(value, 0.0, unit);
            table += line(-value, 0.0996 * value, unit);
            table += line(value, 12345.0 * value, unit);
            table += line(value, edges[(7 * i + 3) % edges.size()], unit);
            table += line(0.0, value, unit);
        }
    }
    return table;
}

} // namespace

class TestRoundingOracle : public QObject
{
    Q_OBJECT

private slots:
    void whatIsPrinted_isTheExactRounding_data()
    {
        QTest::addColumn<QByteArray>("table");
        QTest::newRow("random") << randomCases();
        QTest::newRow("edges") << edgeCases();
    }
    void whatIsPrinted_isTheExactRounding()
    {
        QFETCH(QByteArray, table);
        QTemporaryDir folder;
        QFile file(folder.filePath("cases.tsv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(table), table.size());
        file.close();
        const testing::PythonAnswer answer = testing::python({"-c", kOracle, file.fileName()});
        QVERIFY2(answer.ran, (answer.out + answer.err).constData());
    }

    void readAgain_valueAndItsUncertaintyDescribeTheSame()
    {
        // Rounding what was rounded changes nothing: nobody may round twice by chance.
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> mantissa(1.0, 10.0);
        for (int i = 0; i < 2000; ++i) {
            const double value = mantissa(random);
            const double u = mantissa(random) * std::pow(10.0, -(i % 7));
            const RoundedValue once = roundedValue(value, u, "");
            const RoundedValue twice
                = roundedValue(*parseNumber(once.value), *parseNumber(once.u), "");
            QCOMPARE(twice.value, once.value);
            QCOMPARE(twice.u, once.u);
        }
    }

    void notFinite_isADashWithoutUnit()
    {
        for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
            for (const double u : {0.1, std::nan(""), HUGE_VAL}) {
                QCOMPARE(roundedText(value, u, "Hz"), std::string("\xE2\x80\x93"));
                QCOMPARE(roundedTextWithU(value, u, "Hz"), std::string("\xE2\x80\x93"));
            }
        }
    }
};

DYNCAL_TEST(TestRoundingOracle)
#include "tst_rounding_oracle.moc"
