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

    /// Of several in hertz the marked one has the frequencies, in the order of the marks.
    void marks_chooseTheFrequencies()
    {
        const auto at = [](const std::string &value, const char *mark) {
            return dccMarked(dccQuantity(value, "\\hertz"), mark);
        };
        const std::string magnitude = dccQuantity("4", kUnit);
        QCOMPARE(responseIn(at("1", "x") + at("2", "basic_tableIndex0") + magnitude).frequency_Hz,
            std::vector<double>{2});
        QCOMPARE(responseIn(at("1", "basic_tableIndex0") + at("2", "vib_frequency") + magnitude)
                     .frequency_Hz,
            std::vector<double>{2});
        QCOMPARE(responseIn(at("1", "dyncal_frequency") + at("2", "vib_frequency") + magnitude)
                     .frequency_Hz,
            std::vector<double>{1});
        const std::string fault
            = faultOf(tableOf(at("1", "vib_frequency") + at("2", "vib_frequency") + magnitude));
        QVERIFY2(fault.find("several quantities in hertz") != std::string::npos, fault.c_str());
        // a width of a band that states an uncertainty is not marked, and is not taken for it
        QCOMPARE(
            responseIn(dccQuantity("9", "\\hertz", "0.1") + at("2", "vib_frequency") + magnitude)
                .frequency_Hz,
            std::vector<double>{2});
    }

    /// Marked, else the only one that states an uncertainty; real ones go before complex ones.
    void marksAndUncertainties_chooseTheMagnitudes()
    {
        const std::string f = dccQuantity("1 2", "\\hertz"), plain = dccQuantity("4 5", kUnit),
                          stated = dccQuantity("6 7", kUnit, "0.2"),
                          complex = dccComplex("3 3", "4 4", kUnit, {"1", "0", "1"}, kUnit + kUnit);
        const auto first = [&](const std::string &quantities) {
            return responseIn(f + quantities).magnitude.values[0];
        };
        QCOMPARE(first(plain + stated), 6.0);
        QCOMPARE(first(stated + dccMarked(plain, "basic_measuredValue")), 4.0);
        QCOMPARE(
            first(dccMarked(plain, "basic_measuredValue") + dccMarked(stated, "vib_magnitude")),
            6.0);
        QCOMPARE(first(complex + plain), 4.0);
        QVERIFY(!responseIn(f + complex + plain).phase_rad);
        QCOMPARE(first(complex), 5.0);
        QVERIFY(isNear(responseIn(f + complex).phase_rad->values[1], std::atan2(4, 3), 1e-12));
        for (const std::string &both : {plain + plain, stated + stated, complex + complex})
            QVERIFY(faultOf(tableOf(f + both)).find("several") != std::string::npos);
    }

    void marks_chooseThePhases()
    {
        const std::string two = dccQuantity("1", "\\hertz") + dccQuantity("4", kUnit),
                          angle = dccQuantity("90", "\\degree"),
                          other = dccQuantity("1", "\\radian");
        QVERIFY(!responseIn(two).phase_rad);
        QVERIFY(isNear(responseIn(two + angle).phase_rad->values[0], std::acos(0.0), 1e-14));
        QCOMPARE(responseIn(two + angle + dccMarked(other, "vib_phase")).phase_rad->values[0], 1.0);
        QVERIFY(faultOf(tableOf(two + angle + other)).find("several angles") != std::string::npos);
    }

    void lengthsThatDiffer_areRefused_withBoth()
    {
        const std::string f = dccQuantity("1 2 3", "\\hertz");
        for (const std::string &more :
            {dccQuantity("4 5", kUnit), dccQuantity("4", kUnit), dccQuantity("4 5 6 7", kUnit),
                dccQuantity("4 5 6", kUnit) + dccQuantity("1 2", "\\radian"),
                dccComplex("3 3", "4 4", kUnit, {"1", "0", "1"}, kUnit + kUnit)}) {
            const std::string fault = faultOf(tableOf(f + more));
            QVERIFY2(fault.find("has 3 frequencies and") != std::string::npos, fault.c_str());
        }
        // what is no part of the response may have its own length
        QCOMPARE(responseIn(f + dccQuantity("4 5 6", kUnit) + dccQuantity("20", "\\kelvin"))
                     .frequency_Hz.size(),
            std::size_t(3));
    }

    void frequenciesThatAreNone_areRefused()
    {
        for (const char *f : {"0 1", "1 -2", "1 NaN"})
            QVERIFY2(faultOf(tableOf(dccQuantity(f, "\\hertz") + dccQuantity("4 5", kUnit)))
                         .find("not all above 0")
                    != std::string::npos,
                f);
        QVERIFY(faultOf(tableOf(dccQuantity("1 2", "\\hertz") + dccQuantity("NaN", kUnit)))
                    .find("has 2 frequencies")
            != std::string::npos);
        QVERIFY(faultOf(tableOf(dccQuantity("1 2", "\\hertz") + dccQuantity("NaN NaN", kUnit)))
                    .find("NaN only")
            != std::string::npos);
        QVERIFY(faultOf(tableOf(dccQuantity("4 5", kUnit))).find("no frequencies")
            != std::string::npos);
        QVERIFY(faultOf(tableOf(dccQuantity("4 5", "\\hertz"))).find("no magnitudes in the unit")
            != std::string::npos);
    }

    /// Where the meant quantity is not understood, its neighbour is not taken for it.
    void neighboursOfUnreadOnes_areNotTaken()
    {
        const std::string f = dccQuantity("1 2", "\\hertz"), m = dccQuantity("4 5", kUnit, "0.2"),
                          noK = dccQuantity("4 5", kUnit, "0.2", "");
        const auto isUnread = [](const std::string &quantities, const char *what) {
            const std::string fault = faultOf(tableOf(quantities));
            return fault.find("not understood and may be the " + std::string(what))
                != std::string::npos;
        };
        for (const std::string &bad :
            {dccQuantity("1,5 2", "\\hertz"), dccQuantity("1 2", "\\hertzz")})
            QVERIFY(isUnread(bad + f + m, "frequencies"));
        for (const std::string &bad :
            {dccQuantity("4,5 5", kUnit), noK, dccQuantity("-9 -8", "\\decibel")})
            QVERIFY(isUnread(dccMarked(f, "vib_frequency") + bad + m, "magnitudes"));
        QVERIFY(isUnread(
            f + dccMarked(m, "vib_magnitude") + dccMarked(noK, "vib_magnitude"), "magnitudes"));
        QVERIFY(isUnread(f + dccMarked(m, "basic_measuredValue") + dccMarked(noK, "vib_magnitude"),
            "magnitudes"));
        const std::string angle = dccQuantity("1 1", "\\degree");
        const CertifiedResponse without
            = responseIn(f + m + dccQuantity("1,5 1", "\\degree") + angle);
        QVERIFY(!without.phase_rad && without.whyNoPhases);
        QVERIFY(english(*without.whyNoPhases).find("1,5") != std::string::npos);
        QVERIFY(responseIn(f + m + dccQuantity("1,5 1", "\\degree")).whyNoPhases.has_value());
    }

    /// Marks say which is meant; what is about a value, marked for something else or of another
    /// unit is not it.
    void unreadOnes_thatAreSomethingElse_doNotHinder()
    {
        const std::string f = dccQuantity("1 2", "\\hertz"), m = dccQuantity("4 5", kUnit, "0.2"),
                          noK = dccQuantity("4 5", kUnit, "0.2", "");
        for (const std::string &other : {dccMarked(noK, "", "Expanded uncertainty"),
                 dccMarked(noK, "basic_nominalValue"), dccMarked(noK, "vib_phase"),
                 dccQuantity("20 21", "\\degreecelsius"), dccQuantity("4,5 5", "\\volt"),
                 dccMarked(dccQuantity("4 5", "\\furlong"), "basic_temperature")}) {
            const CertifiedResponse response = responseIn(f + m + other);
            QCOMPARE(response.magnitude.values, (std::vector<double>{4, 5}));
            QVERIFY(!response.whyNoPhases);
        }
        QCOMPARE(
            responseIn(dccMarked(f, "vib_frequency") + dccMarked(m, "basic_measuredValue") + noK)
                .magnitude.values,
            (std::vector<double>{4, 5}));
    }

    void whatIsAboutAValue_isNotTheValue()
    {
        const std::string f = dccQuantity("1 2", "\\hertz"), m = dccQuantity("4 5", kUnit);
        for (const char *type : {"basic_measurementError", "basic_nominalValue",
                 "basic_referenceValue", "basic_lowerLimit", "basic_upperLimit"}) {
            const std::string fault = faultOf(tableOf(f + dccMarked(m, type)));
            QVERIFY2(fault.find("no magnitudes") != std::string::npos, type);
            QVERIFY2(fault.find("by its name or its refType") != std::string::npos, type);
        }
        QVERIFY(!faultOf(tableOf(f + dccMarked(m, "", "Deviation"))).empty());
        QVERIFY(!faultOf(tableOf(dccMarked(f, "", "Resolution bandwidth") + m)).empty());
        QCOMPARE(
            responseIn(dccMarked(f, "basic_nominalValue", "Nominal frequency") + m).frequency_Hz,
            (std::vector<double>{1, 2}));
    }

    void listsThatMightBeResponses_areTold()
    {
        const std::string f = dccQuantity("1 2", "\\hertz"), m = dccQuantity("4 5", kUnit),
                          bad = dccQuantity("1,5 2", "\\hertz"),
                          worse = dccQuantity("1", "\\furlong");
        const auto might = [](const std::string &quantities, const char *unit = "V/Pa") {
            return mightBeResponse(tableOf(quantities), unitOfSymbol(unit));
        };
        QVERIFY(might(bad + m) && might(f + worse) && might(worse + m) && might(f + m + worse));
        QVERIFY(
            !might(f + m) && !might(worse + worse) && !might(f + dccQuantity("1,2 3", "\\volt")));
        QVERIFY(!might(bad + m, "V/N"));
    }
};

DYNCAL_TEST(TestDccResponse)
#include "tst_dcc_response.moc"
