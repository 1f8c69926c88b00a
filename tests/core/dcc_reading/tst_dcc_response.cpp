// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists that are responses: rows, degrees of freedom, the unit that is asked for.

#include "core/dcc_reading/dcc_response.h"
#include "tests/support/made_dcc.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <string>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const std::string kUnit = "\\volt\\pascal\\tothe{-1}";

StatedTable tableOf(const std::string &quantities)
{
    return readDcc(dccOf(dccList(quantities)))->tables.at(0);
}

CertifiedResponse responseIn(const std::string &quantities)
{
    return responseOf(tableOf(quantities), std::nullopt).value();
}

std::string faultOf(const StatedTable &table, const std::optional<DSiUnit> &unit = std::nullopt)
{
    const auto response = responseOf(table, unit);
    return response ? std::string() : english(response.error().message);
}

} // namespace

class TestDccResponse : public QObject
{
    Q_OBJECT

private slots:
    void rows_standSideBySide()
    {
        const CertifiedResponse response = responseIn(dccQuantity("1 2 3", "\\kilo\\hertz")
            + dccQuantity("4 5 6", kUnit, "0.2 0.4 0.6", "2 2 3")
            + dccQuantity("-1 -2 -3", "\\radian", "0.2"));
        QCOMPARE(response.frequency_Hz, (std::vector<double>{1000, 2000, 3000}));
        QCOMPARE(response.magnitude.values, (std::vector<double>{4, 5, 6}));
        QCOMPARE(response.magnitude.k, (std::vector<double>{2, 2, 3}));
        QVERIFY(isNear(response.magnitude.u[2], 0.2, 1e-12));
        QCOMPARE(response.phase_rad->values, (std::vector<double>{-1, -2, -3}));
        QCOMPARE(response.phase_rad->u, (std::vector<double>{0.1, 0.1, 0.1}));
        for (const double dof : response.dof)
            QVERIFY(std::isinf(dof));
        QCOMPARE(response.withoutValue, Index(0));
    }

    void rowsWithoutMagnitude_areLeftOutOfEverything()
    {
        const CertifiedResponse response = responseIn(dccQuantity("1 2 3", "\\hertz")
            + dccQuantity("NaN 5 6", kUnit, "NaN 0.4 NaN") + dccQuantity("-1 -2 -3", "\\radian"));
        QCOMPARE(response.frequency_Hz, (std::vector<double>{2, 3}));
        QCOMPARE(response.phase_rad->values, (std::vector<double>{-2, -3}));
        QCOMPARE(response.magnitude.u.size(), std::size_t(2));
        QVERIFY(isNear(response.magnitude.u[0], 0.2, 1e-12));
        QVERIFY(std::isnan(response.magnitude.u[1])); // stated for none
        QCOMPARE(response.dof.size(), std::size_t(2));
        QCOMPARE(response.withoutValue, Index(1));
    }

    /// k that is stated goes before one that follows; of many degrees of freedom it is the
    /// normal's.
    void degreesOfFreedom_giveStudentsFactor()
    {
        const std::string dof
            = dccMarked(dccQuantity("5 50 NaN", "\\one"), "dyncal_degreesOfFreedom");
        const CertifiedResponse stated = responseIn(
            dccQuantity("1 2 3", "\\hertz") + dccQuantity("4 5 6", kUnit, "0.2") + dof);
        QCOMPARE(stated.magnitude.k, (std::vector<double>{2, 2, 2}));
        QCOMPARE(stated.dof[0], 5.0);
        QVERIFY(std::isinf(stated.dof[2]));
        const std::string complex = dccComplex(
            "3 3 3", "4 4 4", kUnit, {"0.04 0.04 0.04", "0 0 0", "0.04 0.04 0.04"}, kUnit + kUnit);
        const CertifiedResponse found = responseIn(dccQuantity("1 2 3", "\\hertz") + complex + dof);
        QVERIFY(isNear(found.magnitude.k[0], 2.5705818, 1e-7)); // tables of Student's t, 95 %
        QVERIFY(isNear(found.magnitude.k[1], 2.0085591, 1e-7));
        QVERIFY(std::isnan(found.magnitude.k[2]));
        QVERIFY(isNear(found.magnitude.u[0], 0.2, 1e-12));
        QVERIFY(isNear(found.phase_rad->u[0], 0.2 / 5, 1e-12));
    }

    void degreesOfFreedom_ofAnotherLength_areNoneOfTheRows()
    {
        const CertifiedResponse response
            = responseIn(dccQuantity("1 2 3", "\\hertz") + dccQuantity("4 5 6", kUnit)
                + dccMarked(dccQuantity("5 50", "\\one"), "dyncal_degreesOfFreedom"));
        QVERIFY(std::isinf(response.dof[0]));
    }

    void unitAskedFor_choosesTheMagnitudes()
    {
        const StatedTable table
            = tableOf(dccQuantity("1 2", "\\hertz") + dccQuantity("4 5", kUnit, "0.2")
                + dccQuantity("7 8", "\\volt\\newton\\tothe{-1}", "0.2"));
        QCOMPARE(responseOf(table, unitOfSymbol("V/Pa"))->magnitude.values[0], 4.0);
        QCOMPARE(responseOf(table, unitOfSymbol("mV/N"))->magnitude.values[0], 7.0); // in V/N
        QVERIFY(faultOf(table, unitOfSymbol("C/Pa")).find("no magnitudes in C/Pa")
            != std::string::npos);
        QVERIFY(faultOf(table).find("several") != std::string::npos);
    }

    void ratios_areMagnitudesWhereTheyAreAskedFor()
    {
        const StatedTable table
            = tableOf(dccQuantity("1 2", "\\hertz") + dccQuantity("1 0.9", "\\one", "0.02"));
        QCOMPARE(responseOf(table, unitOfSymbol("1"))->magnitude.values[1], 0.9);
        QVERIFY(!faultOf(table).empty());
    }

    void listsOverFrequency_areFound()
    {
        const auto contents = readDcc(dccOf(dccList(dccQuantity("1", "\\hertz"), "a")
            + dccList(dccQuantity("1", "\\kelvin"), "b")
            + dccList(dccQuantity("1", "\\mega\\hertz"), "c")));
        const auto tables = tablesOverFrequency(*contents);
        QCOMPARE(tables.size(), std::size_t(2));
        QCOMPARE(tables[1]->id, std::string("c"));
        QVERIFY(!isOverFrequency(contents->tables[1]));
    }

    void sentences_nameTheLines()
    {
        const std::string two = dccQuantity("1 2", "\\hertz") + "\n" + dccQuantity("4 5", kUnit)
            + "\n" + dccQuantity("4 5", kUnit);
        const StatedTable table = tableOf(two);
        const std::string fault = faultOf(table);
        const std::string lines
            = "lines " + std::to_string(table.line + 1) + ", " + std::to_string(table.line + 2);
        QVERIFY2(fault.find(lines) != std::string::npos, fault.c_str());
    }
};

DYNCAL_TEST(TestDccResponse)
#include "tst_dcc_response.moc"
