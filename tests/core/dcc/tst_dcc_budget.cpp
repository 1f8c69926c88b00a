// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Budgets that are written down, read back number by number.

#include "core/dcc/dcc_budget.h"
#include "core/shock/shock_uncertainty.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace dyncal;
using testing::ExampleSource;
using testing::quantityPath;
using testing::ReadXml;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// 3-4-5: contributions of 3 Hz and -4 Hz make u of 5 Hz, shares of 36 % and 64 %.
ReportedValue frequency()
{
    ReportedValue value{"f0_hz", 1e5, "Hz"};
    UncertaintyLine noise;
    noise.quantity = "noise";
    noise.shot = 2;
    noise.u = noise.contribution = 3.0;
    noise.dof = 7.0;
    UncertaintyLine temperature;
    temperature.quantity = "t1_k";
    temperature.u = 0.5;
    temperature.sensitivity = -8.0;
    temperature.contribution = -4.0;
    temperature.distribution = Distribution::Rectangular;
    value.lines = {noise, temperature};
    value.u = 5.0;
    return value;
}

ExampleSource exampleOf(const UncertaintyReport &report)
{
    ExampleSource example;
    example.results.shock = nullptr; // its steps have budgets of their own
    example.results.uncertainty = std::make_shared<UncertaintyReport>(report);
    return example;
}

ReadXml readOf(ExampleSource example)
{
    XmlElement root{"results"};
    for (XmlElement &result : dccBudgets(example.source()))
        root.add(std::move(result));
    return ReadXml(root);
}

ReadXml ofModel(const ReportedValue &value)
{
    UncertaintyReport report;
    report.ofModel = {value};
    return readOf(exampleOf(report));
}

/// The unit of a source's u, by its name alone.
QString unitOf(const std::string &name, double sensitivity = 2.0)
{
    ReportedValue value = frequency();
    value.lines.resize(1);
    value.lines.front().quantity = name;
    value.lines.front().sensitivity = sensitivity;
    return ofModel(value).text(quantityPath("dyncal_budgetUncertainty", "//si:unitXMLList"));
}

} // namespace

class TestDccBudget : public QObject
{
    Q_OBJECT

private slots:
    void line_isReadBackNumberByNumber()
    {
        const ReadXml xml = ofModel(frequency());
        const auto values = [&](const char *refType) {
            return xml.list(quantityPath(refType, "//si:valueXMLList"));
        };
        QCOMPARE(xml.text("//dcc:list/dcc:name/dcc:content"), QString("f0_hz"));
        QCOMPARE(xml.texts(quantityPath("dyncal_budgetSource", "/dcc:noQuantity/dcc:content")),
            QStringList({"noise", "t1_k"}));
        QCOMPARE(values("dyncal_budgetSourceShot"), QStringList({"2", "0"}));
        QCOMPARE(values("dyncal_budgetUncertainty"), QStringList({"3", "0.5"}));
        QCOMPARE(values("dyncal_budgetCoefficient"), QStringList({"1", "-8"}));
        QCOMPARE(values("dyncal_budgetContribution"), QStringList({"3", "-4"}));
        QCOMPARE(values("dyncal_degreesOfFreedom"), QStringList({"7", "NaN"}));
        QCOMPARE(
            xml.texts(quantityPath("dyncal_budgetDistribution", "/dcc:noQuantity/dcc:content")),
            QStringList({"normal", "rectangular"}));
    }

    void units_areOfEachLineOrOnce()
    {
        const ReadXml xml = ofModel(frequency());
        const auto units = [&](const char *refType) {
            return xml.list(quantityPath(refType, "//si:unitXMLList"));
        };
        QCOMPARE(units("dyncal_budgetUncertainty"), QStringList({"\\hertz", "\\kelvin"}));
        QCOMPARE(units("dyncal_budgetCoefficient"),
            QStringList({"\\one", "\\hertz\\kelvin\\tothe{-1}"}));
        QCOMPARE(units("dyncal_budgetContribution"), QStringList("\\hertz"));
        QCOMPARE(units("dyncal_budgetShare"), QStringList("\\percent"));
        QCOMPARE(units("dyncal_degreesOfFreedom"), QStringList("\\one"));
    }

    /// Shares are those of the variance and make 100 %; contributions make u.
    void shares_areOfTheVariance()
    {
        const ReadXml xml = ofModel(frequency());
        const auto shares = xml.numbers(quantityPath("dyncal_budgetShare", "//si:valueXMLList"));
        QCOMPARE(shares.size(), std::size_t(2));
        QVERIFY(std::abs(shares[0] - 36.0) < 1e-12);
        QVERIFY(std::abs(shares[1] - 64.0) < 1e-12);
        const auto parts
            = xml.numbers(quantityPath("dyncal_budgetContribution", "//si:valueXMLList"));
        QCOMPARE(std::hypot(parts[0], parts[1]), 5.0);
    }

    /// GUM 5.1.2: a contribution is the coefficient times u, in number and in unit.
    void coefficientTimesU_isTheContribution()
    {
        const ReadXml xml = ofModel(frequency());
        const auto numbers = [&](const char *refType) {
            return xml.numbers(quantityPath(refType, "//si:valueXMLList"));
        };
        const auto u = numbers("dyncal_budgetUncertainty");
        const auto c = numbers("dyncal_budgetCoefficient");
        const auto parts = numbers("dyncal_budgetContribution");
        QCOMPARE(c.size(), parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            QCOMPARE(c[i] * u[i], parts[i]);
    }

    void unitOfASource_isWhatItsNameSays_data()
    {
        QTest::addColumn<QString>("unit");
        const auto row = [](const char *name, const char *unit) { QTest::newRow(name) << unit; };
        row("p1_pa", "\\pascal");
        row("t1_k", "\\kelvin");
        row("gamma", "\\one");
        row("molar_mass_kg_mol", "\\kilogram\\mole\\tothe{-1}");
        row("relative_humidity", "\\one");
        row("carbon_dioxide_fraction", "\\one");
        row("velocity_m_s", "\\metre\\second\\tothe{-1}");
        row("velocity_m_s[2]", "\\metre\\second\\tothe{-1}");
        row("distance_m", "\\metre");
        row("distance_m[Side 1]", "\\metre");
        row("distance_m[in_k]", "\\metre"); // a place may be called anything
        row("arrival_s", "\\second");
        row("attenuation_per_m", "\\metre\\tothe{-1}");
        row("gain_relative", "\\one");
        row("onset_hz", "\\hertz");
        row("onset_rad", "\\radian");
    }
    void unitOfASource_isWhatItsNameSays()
    {
        QFETCH(QString, unit);
        QCOMPARE(unitOf(QTest::currentDataTag()), unit);
    }

    /// Whatever a budget may state has a unit, so that its u is never left out.
    void everyStatedQuantity_hasAUnit()
    {
        for (const std::string &name : statedQuantities()) {
            ReportedValue value = frequency();
            value.lines.resize(1);
            value.lines.front().quantity = name;
            value.lines.front().sensitivity = 2.0;
            QVERIFY2(
                ofModel(value).text(quantityPath("dyncal_budgetUncertainty", "//si:valueXMLList"))
                    == "3",
                name.c_str());
        }
    }

    /// Without a unit in the name: that of the value where the source moves it one to one, else its
    /// u would be a number of nobody knows what.
    void sourceWithoutAUnit_hasNoU()
    {
        QCOMPARE(unitOf("weak_mode", 1.0), QString("\\hertz"));
        QCOMPARE(unitOf("weak_mode", 2.0), QString("\\one"));
        ReportedValue value = frequency();
        value.lines.resize(1);
        value.lines.front().sensitivity = 2.0;
        const ReadXml xml = ofModel(value);
        QCOMPARE(xml.text(quantityPath("dyncal_budgetUncertainty", "//si:valueXMLList")),
            QString("NaN"));
        QCOMPARE(xml.text(quantityPath("dyncal_budgetCoefficient", "//si:valueXMLList")),
            QString("NaN"));
        QCOMPARE(
            xml.text(quantityPath("dyncal_budgetContribution", "//si:valueXMLList")), QString("3"));
    }

    void everyReportedValue_hasItsList()
    {
        UncertaintyReport report;
        report.sensitivity = report.ofShots.emplace_back(frequency());
        report.perLevel = {frequency(), frequency()};
        report.ofModel = {frequency()};
        QCOMPARE(readOf(exampleOf(report)).texts("//dcc:list/dcc:name/dcc:content"),
            QStringList({"sensitivity", "sensitivity.per_level[0]", "sensitivity.per_level[1]",
                "shots[0].sensitivity", "f0_hz"}));
    }

    void everyStep_hasItsList()
    {
        ExampleSource example = exampleOf(UncertaintyReport());
        ShockConditionsSet shock;
        shock.shots.resize(2);
        shock.shots[1].shot = 7;
        shock.shots[1].uncertainty = uncertaintyOfTypedStep(
            2e5, {true, {{"step_relative", 0.01, Distribution::Normal, {}}}});
        example.results.shock = std::make_shared<ShockConditionsSet>(shock);
        const ReadXml xml = readOf(std::move(example));
        QCOMPARE(xml.texts("//dcc:list/dcc:name/dcc:content"), QStringList("shock[1].step_pa"));
        QCOMPARE(xml.texts(quantityPath("dyncal_budgetSource", "/dcc:noQuantity/dcc:content")),
            QStringList("step_relative"));
        QVERIFY(
            std::abs(xml.numbers(quantityPath("dyncal_budgetContribution", "//si:valueXMLList"))[0]
                - 2000.0)
            < 1e-6);
        QCOMPARE(xml.text(quantityPath("dyncal_budgetContribution", "//si:unitXMLList")),
            QString("\\pascal"));
    }

    void valueWithoutABudget_hasNoList_data()
    {
        QTest::addColumn<int>("missing");
        QTest::newRow("no u") << 0;
        QTest::newRow("no lines") << 1;
        QTest::newRow("unit of nobody knows what") << 2;
    }
    void valueWithoutABudget_hasNoList()
    {
        QFETCH(int, missing);
        ReportedValue value = frequency();
        if (missing == 0)
            value.u = {};
        else if (missing == 1)
            value.lines.clear();
        else
            value.unit = "g";
        QVERIFY(ofModel(value).parts().isEmpty());
    }

    void columnsOfAList_areOfOneLength()
    {
        const ReadXml xml = ofModel(frequency());
        QCOMPARE(xml.count("//dcc:list/dcc:quantity"), 8);
        for (const QString &list : xml.texts("//si:valueXMLList"))
            QCOMPARE(list.split(' ').size(), 2);
        QCOMPARE(xml.count("//dcc:noQuantity"), 2);
        QCOMPARE(xml.count("//dcc:noQuantity/dcc:content"), 4);
    }

    void hostileName_isText()
    {
        for (const std::string &hostile : test::hostileTexts()) {
            ReportedValue value = frequency();
            value.of = value.lines.front().quantity = hostile;
            const ReadXml xml = ofModel(value);
            QVERIFY2(xml.isWellFormed(), hostile.c_str());
            QCOMPARE(xml.count("//dcc:list/dcc:quantity"), 8);
            QCOMPARE(xml.count("//dcc:list/dcc:name/dcc:content"), 1);
        }
    }

    void nothingKnown_isNoResult()
    {
        ExampleSource example;
        example.results.uncertainty = nullptr;
        QVERIFY(readOf(example).parts().isEmpty());
        QVERIFY(readOf(exampleOf(UncertaintyReport())).parts().isEmpty());
    }
};

DYNCAL_TEST(TestDccBudget)
#include "tst_dcc_budget.moc"
