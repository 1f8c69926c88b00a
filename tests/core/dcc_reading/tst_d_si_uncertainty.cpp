// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Uncertainties of the D-SI: every element that states one, by today's and by deprecated names, and
// covariances of complex values against closed forms.

#include "core/dcc_reading/d_si_uncertainty.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
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

ParsedElement element(const std::string &name, const std::string &content)
{
    return readXml(tag(name, content)).value();
}

template <typename T>
std::string faultOf(const Result<T> &result)
{
    return result ? std::string() : english(result.error().message);
}

std::string text(double value)
{
    return QByteArray::number(value, 'g', 17).toStdString();
}

using Entries = std::array<std::string, 4>; ///< column by column

/// A matrix 2 x 2 with one unit for all of its entries.
std::string matrix(const Entries &entries, const Entries &units, const std::string &list = "")
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

const std::string kVolt2 = "\\volt\\tothe{2}";
const Entries kVolts2{kVolt2, kVolt2, kVolt2, kVolt2};

Result<std::vector<Eigen::Matrix2d>> covariancesIn(
    const std::string &content, std::size_t count = 1, const std::string &name = "complex")
{
    const DSiUnit volt = parseDSiUnit("\\volt").value();
    return covariancesOf(element(name, content), count, volt, volt);
}

/// Of a value in rectangular form, with the lower half of its covariance in V^2.
DSiQuantity rectangular(double re, double im, double xx, double xy, double yy)
{
    const std::string parts
        = tag("valueReal", text(re)) + tag("valueImag", text(im)) + tag("unit", "\\volt");
    return readDSiQuantity(element("complex",
                               parts
                                   + tag("ellipsoidalRegion",
                                       matrix({text(xx), text(xy), text(xy), text(yy)}, kVolts2))))
        .value();
}

} // namespace

class TestDSiUncertainty : public QObject
{
    Q_OBJECT

private slots:
    /// SI_Format.xsd 2.2.1: holder, form, element of the value, element of k ("" = none).
    void everyForm_isKnown_data()
    {
        QTest::addColumn<QString>("holder");
        QTest::addColumn<QString>("form");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("factor");
        const auto row
            = [](const char *holder, const char *form, const char *value, const char *factor) {
                  QTest::addRow("%s/%s", holder, form) << holder << form << value << factor;
              };
        for (const char *holder : {"measurementUncertaintyUnivariate",
                 "measurementUncertaintyUnivaraite", "listMeasurementUncertaintyUnivariate"}) {
            row(holder, "expandedMU", "valueExpandedMU", "coverageFactor");
            row(holder, "standardMU", "valueStandardMU", "");
            row(holder, "coverageIntervalMU", "valueStandardMU", "");
        }
        for (const char *holder : {"", "listUnivariateUnc"}) {
            row(holder, "expandedUnc", "uncertainty", "coverageFactor");
            row(holder, "coverageInterval", "standardUnc", "");
        }
        const char *listed = "measurementUncertaintyUnivariateXMLList";
        row(listed, "expandedMUXMLList", "valueExpandedMUXMLList", "coverageFactorXMLList");
        row(listed, "standardMUXMLList", "valueStandardMUXMLList", "");
        row(listed, "coverageIntervalMUXMLList", "valueStandardMUXMLList", "");
        row("", "expandedUncXMLList", "uncertaintyXMLList", "coverageFactorXMLList");
        row("", "coverageIntervalXMLList", "standardUncXMLList", "");
    }
    void everyForm_isKnown()
    {
        QFETCH(QString, holder);
        QFETCH(QString, form);
        QFETCH(QString, value);
        QFETCH(QString, factor);
        const auto with = [&](const std::string &U, const std::string &k) {
            const std::string stated = tag(form.toStdString(),
                tag(value.toStdString(), U)
                    + (factor.isEmpty() ? "" : tag(factor.toStdString(), k)));
            return uncertaintyOf(
                element("real", holder.isEmpty() ? stated : tag(holder.toStdString(), stated)), 2);
        };
        const auto stated = with("0.6", "3");
        QVERIFY2(stated.has_value(), faultOf(stated).c_str());
        QCOMPARE(stated->u.size(), std::size_t(2));
        QCOMPARE(stated->k.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(isNear(stated->u[i], factor.isEmpty() ? 0.6 : 0.2, 1e-14));
            QCOMPARE(std::isnan(stated->k[i]), factor.isEmpty());
        }
        QCOMPARE(with("0", "3")->u, (std::vector<double>{0, 0})); // exact, and says so
        QVERIFY(faultOf(with("-0.6", "3")).find("below 0") != std::string::npos);
        QVERIFY(faultOf(with("0,6", "3")).find("comma") != std::string::npos);
        if (!factor.isEmpty())
            for (const char *k : {"0", "-2", "", "two"})
                QVERIFY2(!with("0.6", k), k);
    }

    /// u k = U in every row, whatever k is.
    void expandedOnes_areUOverK_inEachRow()
    {
        std::string U, k;
        for (int i = 1; i <= 50; ++i) {
            U += text(0.013 * i) + " ";
            k += text(1.0 + 0.07 * i) + " ";
        }
        const auto stated = uncertaintyOf(
            element("realListXMLList",
                tag("expandedUncXMLList",
                    tag("uncertaintyXMLList", U) + tag("coverageFactorXMLList", k))),
            50);
        QVERIFY2(stated.has_value(), faultOf(stated).c_str());
        for (int i = 1; i <= 50; ++i) {
            const auto at = static_cast<std::size_t>(i - 1);
            QVERIFY(isNear(stated->u[at] * (1.0 + 0.07 * i), 0.013 * i, 1e-14));
            QVERIFY(isNear(stated->k[at], 1.0 + 0.07 * i, 1e-14));
        }
    }

    /// Probability and distribution stand beside k and change nothing.
    void whatStandsBesideThem_isNoUncertainty()
    {
        const auto stated = uncertaintyOf(
            element("real",
                tag("label", "x") + tag("value", "1") + tag("dateTime", "2025")
                    + tag("measurementUncertaintyUnivariate",
                        tag("expandedMU",
                            tag("valueExpandedMU", "0.5") + tag("coverageFactor", "2")
                                + tag("coverageProbability", "0.95")
                                + tag("distribution", "normal")))),
            1);
        QVERIFY2(stated.has_value(), faultOf(stated).c_str());
        QCOMPARE(stated->u, std::vector<double>{0.25});
        QVERIFY(uncertaintyOf(element("real", tag("value", "1")), 1)->u.empty());
    }

    /// One of two statements is never taken for the other.
    void secondStatements_areRefused()
    {
        const std::string one
            = tag("expandedUnc", tag("uncertainty", "1") + tag("coverageFactor", "2")),
            other = tag(
                "measurementUncertaintyUnivariate", tag("standardMU", tag("valueStandardMU", "3")));
        for (const std::string &both : {one + other, other + one, one + one, other + other})
            QVERIFY(faultOf(uncertaintyOf(element("real", both), 1)).find("second one")
                != std::string::npos);
        const std::string inOne = tag("measurementUncertaintyUnivariate",
            tag("standardMU", tag("valueStandardMU", "3"))
                + tag("standardMU", tag("valueStandardMU", "3")));
        QVERIFY(!uncertaintyOf(element("real", inOne), 1));
        const std::string constant = tag("valueStandardMU", "1") + tag("uncertainty", "2");
        QVERIFY(faultOf(uncertaintyOf(element("constant", constant), 1)).find("second one")
            != std::string::npos);
    }

    /// Both of all values together and of each: each is taken.
    void multivariateOnes_giveWayToThoseOfEach()
    {
        const std::string all = tag("measurementUncertaintyMultivariateXMLList", "");
        const std::string each = tag("measurementUncertaintyUnivariateXMLList",
            tag("standardMUXMLList", tag("valueStandardMUXMLList", "1 2")));
        QCOMPARE(uncertaintyOf(element("realListXMLList", all + each), 2)->u,
            (std::vector<double>{1, 2}));
        QVERIFY(!uncertaintyOf(element("realListXMLList", all), 2));
        QVERIFY(!uncertaintyOf(element("realListXMLList", each), 3)); // of another length
    }

    /// Closed forms of (|z|, arg z) at angles all around: along and across the direction of z.
    void polarCovariance_ofRectangularValues_hasItsClosedForm()
    {
        constexpr double kR = 2.5, kXx = 4e-4, kYy = 9e-4, kXy = 1.5e-4;
        for (int i = -11; i <= 12; ++i) {
            const double phi = std::numbers::pi / 12.0 * i + 0.01, c = std::cos(phi),
                         s = std::sin(phi);
            if (phi > std::numbers::pi)
                continue;
            const DSiQuantity polar = rectangular(kR * c, kR * s, kXx, kXy, kYy);
            const double along = c * c * kXx + 2 * s * c * kXy + s * s * kYy;
            const double across = s * s * kXx - 2 * s * c * kXy + c * c * kYy;
            QVERIFY(isNear(polar.values.values[0], kR, 1e-13));
            QVERIFY(std::abs(polar.phases_rad->values[0] - phi) < 1e-13);
            QVERIFY(isNear(polar.values.u[0], std::sqrt(along), 1e-12));
            QVERIFY(isNear(polar.phases_rad->u[0], std::sqrt(across) / kR, 1e-12));
            // a rotation keeps the trace
            const double u2
                = std::pow(polar.values.u[0], 2) + std::pow(kR * polar.phases_rad->u[0], 2);
            QVERIFY(isNear(u2, kXx + kYy, 1e-12));
        }
    }

    /// The phase knows no unit: a thousandth of the value with its covariance has the same.
    void polarCovariance_scalesWithTheUnit()
    {
        const DSiQuantity one = rectangular(3, -4, 0.01, 0.002, 0.03),
                          small = rectangular(3e-12, -4e-12, 0.01e-24, 0.002e-24, 0.03e-24);
        QVERIFY(isNear(small.values.u[0], 1e-12 * one.values.u[0], 1e-12));
        QVERIFY(isNear(small.phases_rad->u[0], one.phases_rad->u[0], 1e-12));
        const auto milli = readDSiQuantity(element("complex",
            tag("valueReal", "3") + tag("valueImag", "-4") + tag("unit", "\\milli\\volt")
                + tag("rectangularRegion",
                    matrix({"0.01", "0.002", "0.002", "0.03"},
                        {"\\milli\\volt\\tothe{2}", "\\micro\\volt\\volt",
                            "\\milli\\volt\\milli\\volt", "\\micro\\volt\\volt"}))));
        QVERIFY2(milli.has_value(), faultOf(milli).c_str());
        QVERIFY(isNear(milli->values.u[0], 1e-3 * one.values.u[0], 1e-12));
        QVERIFY(isNear(milli->phases_rad->u[0], one.phases_rad->u[0], 1e-12));
    }

    void covariances_areOneForAllOrOneForEach()
    {
        const auto in = [](const Entries &entries) {
            return covariancesIn(
                tag("measurementUncertaintyBivariateXMLList",
                    tag("ellipsoidalRegionMUXMLList", matrix(entries, kVolts2, "XMLList"))),
                3, "complexListXMLList");
        };
        const auto each = in({"1 4 9", "0.5 -1 0", "0.5 -1 0", "16"});
        QVERIFY2(each.has_value(), faultOf(each).c_str());
        QCOMPARE(each->size(), std::size_t(3));
        QCOMPARE((*each)[1], (Eigen::Matrix2d() << 4, -1, -1, 16).finished());
        QCOMPARE((*each)[2], (Eigen::Matrix2d() << 9, 0, 0, 16).finished());
        QVERIFY(faultOf(in({"1 4", "0", "0", "1"})).find("2 entries for 3") != std::string::npos);
        // a row that is not stated is none, beside rows that are
        const auto some = in({"1 NaN 9", "0 NaN 0", "0 NaN 0", "1 NaN 1"});
        QVERIFY(some && std::isnan((*some)[1](0, 0)) && (*some)[2](0, 0) == 9.0);
        // what is stated of such a row is held to what a variance is
        QVERIFY(!in({"-1", "NaN", "NaN", "1"}) && !in({"1", "NaN", "NaN", "-1"}));
    }

    /// Magnitude in V, phase in rad: their covariance is in V rad, and its transpose too.
    void mixedUnits_areHeldAgainstBothParts()
    {
        const auto in = [](const Entries &units) {
            return covariancesOf(
                element("complex", tag("ellipsoidalRegion", matrix({"4", "1", "1", "9"}, units))),
                1, *parseDSiUnit("\\volt"), *parseDSiUnit("\\radian"));
        };
        const std::string cross = "\\volt\\radian", rad2 = "\\radian\\tothe{2}";
        const auto known = in({kVolt2, cross, "\\radian\\volt", rad2});
        QVERIFY2(known.has_value(), faultOf(known).c_str());
        QCOMPARE(known->at(0), (Eigen::Matrix2d() << 4, 1, 1, 9).finished());
        for (const Entries &units : {Entries{rad2, cross, cross, kVolt2}, kVolts2,
                 Entries{kVolt2, kVolt2, cross, rad2}, Entries{kVolt2, cross, "\\one", rad2}})
            QVERIFY(faultOf(in(units)).find("values ask for") != std::string::npos);
    }

    /// A correlation of 1 with rounded digits is one; what is clearly beyond is none, at any scale.
    void correlations_areAtMostOne()
    {
        for (const double scale : {1.0, 1e-34, 1e-180, 1e180, 1e300}) {
            const auto in = [scale](double xx, double xy, double yy) {
                return covariancesIn(tag("ellipsoidalRegion",
                    matrix({text(xx * scale), text(xy * scale), text(xy * scale), text(yy * scale)},
                        kVolts2)));
            };
            for (const double sign : {-1.0, 1.0}) {
                QVERIFY2(in(4, sign * 6, 9).has_value(), text(scale).c_str());
                QVERIFY2(in(4, sign * 6.01, 9).has_value(), text(scale).c_str());
                QVERIFY2(!in(4, sign * 6.2, 9), text(scale).c_str());
                QVERIFY2(!in(0, sign, 9), text(scale).c_str());
            }
            QVERIFY2(in(0, 0, 9).has_value(), text(scale).c_str());
        }
    }

    void regions_areNeededOnce()
    {
        const std::string one = tag("ellipsoidalRegion", matrix({"1", "0", "0", "1"}, kVolts2)),
                          other = tag("rectangularRegion", matrix({"4", "0", "0", "4"}, kVolts2));
        QCOMPARE(covariancesIn(other)->at(0)(0, 0), 4.0);
        for (const std::string &both : {one + other, one + one, other + other})
            QVERIFY(faultOf(covariancesIn(both)).find("second one") != std::string::npos);
        QVERIFY(covariancesIn("")->empty());
        QVERIFY(!covariancesIn(tag("measurementUncertaintyMultivariateXMLList", "")));
        QVERIFY(!covariancesIn(tag("expandedUnc", ""))); // of a real value
    }

    void matricesOfAnotherShape_areRefused()
    {
        const std::string entry = tag("covariance", tag("value", "1") + tag("unit", kVolt2));
        const auto in = [](const std::string &columns) {
            return faultOf(
                covariancesIn(tag("ellipsoidalRegion", tag("covarianceMatrix", columns))));
        };
        const std::string column = tag("column", entry + entry);
        QVERIFY(in(column + column).empty());
        for (const std::string &columns : {std::string(), column, column + column + column,
                 tag("column", entry) + column, column + tag("column", entry + entry + entry)})
            QVERIFY2(in(columns).find("two columns") != std::string::npos, columns.c_str());
        const std::string noUnit = tag("column", entry + tag("covariance", tag("value", "1")));
        QVERIFY(in(noUnit + column).find("unit") != std::string::npos);
    }

    /// Beyond what numbers hold, also where only the phase is.
    void infiniteOnes_areRefused()
    {
        const std::string polar = tag("valueMagnitude", "1") + tag("valuePhase", "1e300")
            + tag("unit", "\\volt") + tag("unitPhase", "\\tera\\radian");
        QVERIFY(faultOf(readDSiQuantity(element("complex", polar))).find("beyond 1e308")
            != std::string::npos);
        QVERIFY(!covariancesIn(tag("ellipsoidalRegion",
            matrix({"1e300", "0", "0", "1"}, {"\\tera\\volt\\volt", kVolt2, kVolt2, kVolt2}))));
        const std::string twice = tag("listUnit", "\\volt") + tag("listUnit", "\\milli\\volt")
            + tag("real", tag("value", "1"));
        QVERIFY(faultOf(readDSiQuantity(element("realList", twice))).find("more than once")
            != std::string::npos);
    }
};

DYNCAL_TEST(TestDSiUncertainty)
#include "tst_d_si_uncertainty.moc"
