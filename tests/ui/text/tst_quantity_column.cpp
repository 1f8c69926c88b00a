// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/text/quantity_column.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

QString unitOf(const QString &shown)
{
    return shown.section(' ', 1);
}
qsizetype decimalsIn(const QString &shown)
{
    return shown.section(' ', 0, 0).section('.', 1).size();
}
double factorOf(const QString &shown, const QString &unit)
{
    QString prefix = unitOf(shown);
    prefix.chop(unit.size());
    return QHash<QString, double>{{"", 1.0}, {"f", 1e-15}, {"p", 1e-12}, {"n", 1e-9}, {"µ", 1e-6},
        {"m", 1e-3}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}}
        .value(prefix, std::nan(""));
}

} // namespace

/// Columns of quantities: one unit, one place, zeros kept.
class TestQuantityColumn : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void column_hasOneUnitAndOnePlace();
    void column_keepsZeros();
    void column_ofUnitsWithoutPrefix();
    void withU_eachToThePlaceOfItsU();
    void swedish_hasCommas();
    void smallNumbers_haveNoProgrammersExponent();
};

void TestQuantityColumn::column_hasOneUnitAndOnePlace()
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> logBase(-8.0, 8.0);
    std::uniform_real_distribution<double> spread(-1.5, 0.0);
    for (int trial = 0; trial < 500; ++trial) {
        const double base = std::pow(10.0, logBase(random));
        std::vector<double> values;
        for (int i = 0; i < 4; ++i)
            values.push_back((i % 2 ? -1.0 : 1.0) * base * std::pow(10.0, spread(random)));
        const QStringList shown = shownColumn(values, "Hz", 4);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const QString &cell = shown[static_cast<qsizetype>(i)];
            QCOMPARE(unitOf(cell), unitOf(shown[0]));
            QCOMPARE(decimalsIn(cell), decimalsIn(shown[0]));
            const double read = typedNumber(cell.section(' ', 0, 0)).value() * factorOf(cell, "Hz");
            const double place = std::pow(10.0, -double(decimalsIn(cell))) * factorOf(cell, "Hz");
            QVERIFY2(std::abs(read - values[i]) <= 0.5001 * place, qPrintable(cell));
        }
    }
}

void TestQuantityColumn::column_keepsZeros()
{
    QCOMPARE(shownColumn(std::vector<double>{2.0e6, 2.3305e6, std::nan("")}, "Hz", 5),
        (QStringList{"2.0000 MHz", "2.3305 MHz", "–"}));
    // The smallest keeps two digits where three more places are enough.
    QCOMPARE(shownColumn(std::vector<double>{434.4e3, 120.0}, "Pa", 4),
        (QStringList{"434.40 kPa", "0.12 kPa"}));
    QCOMPARE(shownColumn(std::vector<double>{0.0, 0.0}, "s", 3), (QStringList{"0 s", "0 s"}));
    QVERIFY(shownColumn(std::vector<double>{}, "s", 3).isEmpty());
}

void TestQuantityColumn::column_ofUnitsWithoutPrefix()
{
    QCOMPARE(
        shownColumn(std::vector<double>{99.5, 1.26}, "%", 3), (QStringList{"99.5 %", "1.3 %"}));
    QCOMPARE(shownColumn(std::vector<double>{294.15, 520.0}, "K", 5),
        (QStringList{"294.15 K", "520.00 K"}));
    QCOMPARE(shownColumn(std::vector<double>{0.02, 0.5}, "1", 3), (QStringList{"0.020", "0.500"}));
}

void TestQuantityColumn::withU_eachToThePlaceOfItsU()
{
    const auto shown = shownColumn(
        std::vector<Estimate>{{2.33e6, 130.0}, {318.27e3, 1.9e3}, {6.8e3, std::nan("")}}, "Hz");
    QCOMPARE(shown[0].value, QString("2.33000 MHz"));
    QCOMPARE(shown[0].u, QString("0.00013 MHz"));
    QCOMPARE(shown[1].value, QString("0.3183 MHz"));
    QCOMPARE(shown[1].u, QString("0.0019 MHz"));
    QCOMPARE(shown[2].value, QString("0.0068000 MHz"));
    QCOMPARE(shown[2].u, QString("–"));
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> logU(-6.0, -1.0);
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<Estimate> values;
        for (const double value : {1.2345678e6, 3.4e5, 7.7e6})
            values.push_back({value, value * std::pow(10.0, logU(random))});
        for (const ShownResult &one : shownColumn(values, "Hz")) {
            QCOMPARE(decimalsIn(one.value), decimalsIn(one.u));
            QCOMPARE(unitOf(one.value), QString("MHz"));
            QCOMPARE(unitOf(one.u), QString("MHz"));
        }
    }
    QCOMPARE(shownColumnWithU({{1.0, 0.012}, {0.98, 0.0021}}, {}),
        (QStringList{"1.000 ± 0.012", "0.9800 ± 0.0021"}));
}

void TestQuantityColumn::swedish_hasCommas()
{
    const test::InSwedish swedish;
    QCOMPARE(shownColumn(std::vector<double>{2.5e3, 1e3}, "Pa", 3),
        (QStringList{"2,50 kPa", "1,00 kPa"}));
    QCOMPARE(
        shownColumn(std::vector<Estimate>{{2.33e6, 130.0}}, "Hz")[0].u, QString("0,00013 MHz"));
}

void TestQuantityColumn::smallNumbers_haveNoProgrammersExponent()
{
    QCOMPARE(shownNumber(5.55e-5, 3), QString("5.55×10⁻⁵"));
    QCOMPARE(shownNumber(-2e20, 3), QString("-2×10²⁰"));
    QCOMPARE(*typedNumber("5.55×10⁻⁵"), 5.55e-5);
    QCOMPARE(*typedNumber("-2×10²⁰"), -2e20);
}

DYNCAL_TEST(TestQuantityColumn)
#include "tst_quantity_column.moc"
