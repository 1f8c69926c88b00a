// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Quantities of the D-SI in each of its forms: what was written is read, what is no quantity is
// refused with line and element.

#include "core/dcc_reading/d_si_quantity.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <string>

using namespace dyncal;
using testing::isNear;

namespace {

std::string tag(const std::string &name, const std::string &content)
{
    return "<si:" + name + ">" + content + "</si:" + name + ">";
}

Result<DSiQuantity> read(const std::string &name, const std::string &content)
{
    return readXml(tag(name, content)).and_then(readDSiQuantity);
}

std::string faultOf(const std::string &name, const std::string &content)
{
    const Result<DSiQuantity> quantity = read(name, content);
    return quantity ? std::string() : english(quantity.error().message);
}

bool isRefused(const std::string &name, const std::string &content, const std::string &word)
{
    const std::string fault = faultOf(name, content);
    return fault.starts_with("Line ") && fault.find(word) != std::string::npos;
}

const std::string kMilliVolt = tag("value", "2.5") + tag("unit", "\\milli\\volt");
const std::string kList = tag("valueXMLList", "1 2 4") + tag("unitXMLList", "\\volt");

std::string expandedList(const std::string &U, const std::string &k)
{
    return tag("measurementUncertaintyUnivariateXMLList",
        tag("expandedMUXMLList",
            tag("valueExpandedMUXMLList", U) + tag("coverageFactorXMLList", k)));
}

/// 2 x 2, as it stands in complex values: names with or without XMLList.
std::string covariance(const std::string &list, const std::array<std::string, 4> &entries,
    const std::array<std::string, 4> &units)
{
    std::string columns;
    for (std::size_t column = 0; column < 2; ++column) {
        std::string rows;
        for (std::size_t row = 0; row < 2; ++row)
            rows += tag("covariance" + list,
                tag("value" + list, entries[2 * column + row])
                    + tag("unit" + list, units[2 * column + row]));
        columns += tag("column" + list, rows);
    }
    return tag("covarianceMatrix" + list, columns);
}

const std::array<std::string, 4> kSquareVolts{
    "\\volt\\volt", "\\volt\\volt", "\\volt\\volt", "\\volt\\tothe{2}"};

} // namespace

class TestDSiQuantity : public QObject
{
    Q_OBJECT

private slots:
    /// u = U/k of the forms with k, u itself of the others.
    void oneValue_inEachForm()
    {
        const auto statement = [](const std::string &form, const std::string &value, bool hasK) {
            return tag(form, tag(value, "0.5") + (hasK ? tag("coverageFactor", "2.5") : ""));
        };
        const auto held = [](const std::string &inner) {
            return tag("measurementUncertaintyUnivariate", inner);
        };
        const std::vector<std::pair<std::string, bool>> forms{
            {held(statement("expandedMU", "valueExpandedMU", true)), true},
            {statement("expandedUnc", "uncertainty", true), true},
            {held(statement("standardMU", "valueStandardMU", false)), false},
            {held(statement("coverageIntervalMU", "valueStandardMU", false)), false},
            {statement("coverageInterval", "standardUnc", false), false}};
        for (const auto &[form, hasK] : forms) {
            const auto one = read("real", kMilliVolt + form);
            QVERIFY2(one.has_value(), form.c_str());
            QVERIFY(one->values.unit.isOf("V"));
            QVERIFY(isNear(one->values.values[0], 2.5e-3, 1e-14));
            QVERIFY(isNear(one->values.u[0], hasK ? 0.2e-3 : 0.5e-3, 1e-14));
            QCOMPARE(std::isnan(one->values.k[0]), !hasK);
        }
        QVERIFY(read("real", kMilliVolt)->values.u.empty());
    }

    void constants_haveTheirStandardUncertainty()
    {
        for (const char *name : {"valueStandardMU", "uncertainty"}) {
            const auto one = read("constant", kMilliVolt + tag(name, "0.5"));
            QVERIFY(isNear(one->values.u.at(0), 0.5e-3, 1e-14));
            QVERIFY(std::isnan(one->values.k.at(0)));
        }
        QVERIFY(read("constant", kMilliVolt)->values.u.empty());
        QVERIFY(isRefused("constant", kMilliVolt + tag("uncertainty", "-1"), "below 0"));
    }

    void xmlLists_haveOneForAllOrOneForEach()
    {
        const auto each = read("realListXMLList", kList + expandedList("0.2 0.4 0.6", "2 2 3"));
        QCOMPARE(each->values.u, (std::vector<double>{0.1, 0.2, 0.6 / 3}));
        QCOMPARE(each->values.k, (std::vector<double>{2, 2, 3}));
        const auto all = read("realListXMLList", kList + expandedList("0.2", "2"));
        QCOMPARE(all->values.u, (std::vector<double>{0.1, 0.1, 0.1}));
        const auto deprecated = read("realListXMLList",
            kList
                + tag("expandedUncXMLList",
                    tag("uncertaintyXMLList", "0.2") + tag("coverageFactorXMLList", "2")));
        QCOMPARE(deprecated->values.u, all->values.u);
        const auto standard = read("realListXMLList",
            kList
                + tag("measurementUncertaintyUnivariateXMLList",
                    tag("standardMUXMLList", tag("valueStandardMUXMLList", "0.1"))));
        QCOMPARE(standard->values.u, all->values.u);
    }

    void lengthsThatDiffer_areRefused()
    {
        for (const std::string &more : {expandedList("0.2 0.4", "2"), expandedList("0.2", "2 2"),
                 expandedList("1 2 3 4", "2")})
            QVERIFY(isRefused("realListXMLList", kList + more, "entries for 3 values"));
        QVERIFY(isRefused("realListXMLList",
            tag("valueXMLList", "1 2 4") + tag("unitXMLList", "\\volt \\volt"), "2 entries"));
    }

    void unclearUncertainties_areRefused()
    {
        const auto of = [](const std::string &inner) {
            return kMilliVolt + tag("measurementUncertaintyUnivariate", tag("expandedMU", inner));
        };
        const std::string U = tag("valueExpandedMU", "0.5"), k = tag("coverageFactor", "2");
        QVERIFY(isRefused("real", of(U), "coverageFactor")); // no k
        QVERIFY(isRefused("real", of(k), "valueExpandedMU")); // no U
        QVERIFY(isRefused("real", of(U + tag("coverageFactor", "0")), "not above 0"));
        QVERIFY(isRefused("real", of(U + tag("coverageFactor", "-2")), "not above 0"));
        QVERIFY(isRefused("real", of(tag("valueExpandedMU", "-0.5") + k), "below 0"));
        QVERIFY(isRefused("real", of(U + k + k), "more than once"));
        QVERIFY(isRefused("real", of(U + k) + tag("expandedUnc", ""), "second one"));
        QVERIFY(isRefused(
            "real", kMilliVolt + tag("measurementUncertaintyUnivariate", ""), "not under"));
        QVERIFY(isRefused("real", kMilliVolt + tag("rectangularRegion", ""), "not understood"));
        QVERIFY(isRefused("realListXMLList",
            kList + tag("measurementUncertaintyMultivariateXMLList", ""), "not understood"));
    }

    void whatIsNoNumber_isRefused()
    {
        const std::string unit = tag("unit", "\\volt");
        QVERIFY(isRefused("real", tag("value", "2,5") + unit, "comma"));
        for (const char *word : {"NaN", "INF", "inf", "nan", "two", "", "1e999", "0x10", "1.2.3"})
            QVERIFY2(isRefused("real", tag("value", word) + unit, "finite number"), word);
        QVERIFY(isRefused("real", unit, "value"));
        QVERIFY(isRefused("real", tag("value", "1"), "unit"));
        QVERIFY(isRefused("real", tag("value", "1") + tag("value", "2") + unit, "more than once"));
        QCOMPARE(read("real", tag("value", " +1.5E-3\n") + unit)->values.values[0], 1.5e-3);
    }

    void whatIsBeyondNumbers_isRefused()
    {
        QVERIFY(isRefused(
            "real", tag("value", "1e308") + tag("unit", "\\kilo\\volt"), "beyond 1e308 in V"));
        QVERIFY(isRefused("real",
            kMilliVolt
                + tag("expandedUnc", tag("uncertainty", "1") + tag("coverageFactor", "1e-320")),
            "beyond 1e308"));
        QVERIFY(isRefused("complex",
            tag("valueReal", "1e307") + tag("valueImag", "1") + tag("unit", "\\kilo\\volt"),
            "beyond"));
    }

    /// The D-SI's word for no value, in lists.
    void noValues_areNoNumbers()
    {
        const auto some = read("realListXMLList",
            tag("valueXMLList", "1 NaN 4") + tag("unitXMLList", "\\volt")
                + expandedList("0.2 NaN NaN", "2 2 2"));
        QVERIFY(some.has_value());
        QVERIFY(std::isnan(some->values.values[1]) && std::isnan(some->values.u[2]));
        QCOMPARE(some->values.u[0], 0.1);
    }

    void units_areHeldToOneQuantity()
    {
        QVERIFY(isRefused("real", tag("value", "1") + tag("unit", "\\furlong"), "\\furlong"));
        QVERIFY(
            isRefused("realListXMLList",
                tag("valueXMLList", "1 2") + tag("unitXMLList", "\\volt \\metre"), "several units")
            || isRefused("realListXMLList",
                tag("valueXMLList", "1 2") + tag("unitXMLList", "\\volt \\metre"), "one list"));
        const auto prefixes = read("realListXMLList",
            tag("valueXMLList", "1 2") + tag("unitXMLList", "\\volt \\milli\\volt")
                + expandedList("0.2", "2"));
        QCOMPARE(prefixes->values.values, (std::vector<double>{1, 2e-3}));
        QCOMPARE(prefixes->values.u, (std::vector<double>{0.1, 0.1e-3}));
    }

    void realLists_takeWhatTheListSays()
    {
        const std::string listed = tag("listUnit", "\\milli\\volt")
            + tag("listUnivariateUnc",
                tag("expandedUnc", tag("uncertainty", "0.4") + tag("coverageFactor", "2")))
            + tag("real", tag("value", "1"))
            + tag("real", tag("value", "2") + tag("unit", "\\volt"));
        const auto both = read("realList", listed);
        QVERIFY(both.has_value());
        QCOMPARE(both->values.values, (std::vector<double>{1e-3, 2}));
        QCOMPARE(both->values.u, (std::vector<double>{0.2e-3, 0.2}));
        QVERIFY(isRefused("realList",
            listed + tag("real", tag("value", "3") + tag("unit", "\\metre")), "as in the entries"));
        QVERIFY(isRefused("realList", "", "empty"));
    }

    void polarValues_areTakenAsTheyAre()
    {
        const std::string polar = tag("valueMagnitude", "2") + tag("valuePhase", "-90")
            + tag("unit", "\\milli\\volt") + tag("unitPhase", "\\degree");
        const auto one = read("complex",
            polar
                + tag("ellipsoidalRegion",
                    covariance("", {"0.04", "0", "0", "0.25"},
                        {"\\milli\\volt\\milli\\volt", "\\milli\\volt\\degree",
                            "\\degree\\milli\\volt", "\\degree\\degree"})));
        QVERIFY(one.has_value());
        constexpr double kDegree = std::numbers::pi / 180.0;
        QVERIFY(isNear(one->values.values[0], 2e-3, 1e-14));
        QVERIFY(isNear(one->values.u[0], 0.2e-3, 1e-14));
        QVERIFY(isNear(one->phases_rad->values[0], -90 * kDegree, 1e-14));
        QVERIFY(isNear(one->phases_rad->u[0], 0.5 * kDegree, 1e-14));
        QVERIFY(isRefused("complex",
            tag("valueMagnitude", "2") + tag("valuePhase", "1") + tag("unit", "\\volt")
                + tag("unitPhase", "\\metre"),
            "in m"));
    }

    /// r e^(j phi) with a diagonal covariance that is turned into Re and Im by hand, and back.
    void rectangularValues_areTurnedToPolar()
    {
        constexpr double kMagnitude = 3, kPhase = 2.5, kU = 0.02, kUPhase = 0.01;
        const double x = std::cos(kPhase), y = std::sin(kPhase), tangential = kMagnitude * kUPhase;
        const auto text
            = [](double value) { return QByteArray::number(value, 'g', 17).toStdString(); };
        const double xx = kU * kU * x * x + tangential * tangential * y * y;
        const double yy = kU * kU * y * y + tangential * tangential * x * x;
        const double xy = (kU * kU - tangential * tangential) * x * y;
        const auto one = read("complexListXMLList",
            tag("valueRealXMLList", text(kMagnitude * x))
                + tag("valueImagXMLList", text(kMagnitude * y)) + tag("unitXMLList", "\\volt")
                + tag("measurementUncertaintyBivariateXMLList",
                    tag("rectangularRegionMUXMLList",
                        covariance(
                            "XMLList", {text(xx), text(xy), text(xy), text(yy)}, kSquareVolts))));
        QVERIFY(one.has_value());
        QVERIFY(isNear(one->values.values[0], kMagnitude, 1e-12));
        QVERIFY(isNear(one->values.u[0], kU, 1e-10));
        QVERIFY(isNear(one->phases_rad->values[0], kPhase, 1e-12));
        QVERIFY(isNear(one->phases_rad->u[0], kUPhase, 1e-10));
    }

    void phases_ofRectangularValues_areUnwrapped()
    {
        const auto turn = read("complexListXMLList",
            tag("valueRealXMLList", "1 -1 -1 0") + tag("valueImagXMLList", "0 -0.1 0.1 1")
                + tag("unitXMLList", "\\volt"));
        QVERIFY(turn.has_value());
        const std::vector<double> &phases = turn->phases_rad->values;
        for (std::size_t i = 1; i < phases.size(); ++i)
            QVERIFY(phases[i] < phases[i - 1]);
        QVERIFY(isNear(phases.back(), -1.5 * std::numbers::pi, 1e-12));
    }

    void complexLists_takeWhatTheListSays()
    {
        const std::string listed = tag("listUnit", "\\volt")
            + tag("listBivariateUnc",
                tag("ellipsoidalRegion", covariance("", {"0.04", "0", "0", "0.04"}, kSquareVolts)))
            + tag("complex", tag("valueReal", "3") + tag("valueImag", "4"))
            + tag("complex", tag("valueReal", "5") + tag("valueImag", "12"));
        const auto both = read("complexList", listed);
        QVERIFY(both.has_value());
        QCOMPARE(both->values.values, (std::vector<double>{5, 13}));
        QVERIFY(isNear(both->values.u[1], 0.2, 1e-12));
        QVERIFY(isNear(both->phases_rad->u[1], 0.2 / 13, 1e-12));
    }

    void whatIsNoCovariance_isRefused()
    {
        const auto with = [](const std::array<std::string, 4> &entries) {
            return tag("valueReal", "3") + tag("valueImag", "4") + tag("unit", "\\volt")
                + tag("ellipsoidalRegion", covariance("", entries, kSquareVolts));
        };
        QVERIFY(faultOf("complex", with({"1", "0.5", "0.5", "1"})).empty());
        for (const std::array<std::string, 4> &entries :
            {std::array<std::string, 4>{"1", "0.5", "0.4", "1"}, {"-1", "0", "0", "1"},
                {"1", "2", "2", "1"}})
            QVERIFY(isRefused("complex", with(entries), "no covariance"));
        const std::string parts
            = tag("valueReal", "3") + tag("valueImag", "4") + tag("unit", "\\volt");
        QVERIFY(isRefused("complex", parts + tag("ellipsoidalRegion", ""), "covarianceMatrix"));
        QVERIFY(isRefused("complex",
            parts + tag("ellipsoidalRegion", tag("covarianceMatrix", "<si:column/>")),
            "two columns"));
        QVERIFY(isRefused("complex",
            parts
                + tag("ellipsoidalRegion",
                    covariance("", {"1", "0", "0", "1"}, {"\\volt", "\\volt", "\\volt", "\\volt"})),
            "covariance is in V"));
        QVERIFY(isRefused("complex",
            tag("valueReal", "0") + tag("valueImag", "0") + tag("unit", "\\volt"), "is 0"));
    }

    void hybrids_giveTheirFirstKnownUnit()
    {
        const auto list = [](const std::string &values, const std::string &unit) {
            return tag("realListXMLList", tag("valueXMLList", values) + tag("unitXMLList", unit));
        };
        const auto known
            = read("hybrid", list("1", "\\degreecelsius") + list("274.15", "\\kelvin"));
        QCOMPARE(known->values.values[0], 274.15);
        QVERIFY(isRefused("hybrid", list("1", "\\degreecelsius") + list("1", "\\knot"), "celsius"));
        QVERIFY(isRefused("hybrid", "", "empty"));
    }

    void otherForms_areRefused()
    {
        QVERIFY(isRefused("list", "", "not understood"));
        QVERIFY(isRefused("quantity", "", "not understood"));
    }
};

DYNCAL_TEST(TestDSiQuantity)
#include "tst_d_si_quantity.moc"
