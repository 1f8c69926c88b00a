// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Budgets and Monte Carlo that are written down, read back number by number.

#include "core/dcc/dcc_budget.h"
#include "core/monte_carlo/chain_monte_carlo.h"
#include "core/shock/shock_uncertainty.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/hostile_text.h"
#include "tests/support/made_monte_carlo.h"
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

ReadXml drawn(const ChainMonteCarlo &made)
{
    ExampleSource example;
    example.results.uncertainty = nullptr;
    example.results.chainMonteCarlo = std::make_shared<ChainMonteCarlo>(made);
    return readOf(example);
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
        QCOMPARE(xml.count("//dcc:list/dcc:quantity"), 7);
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
            QCOMPARE(xml.count("//dcc:list/dcc:quantity"), 7);
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

    /// Values, u and intervals in the order of the trials; what does not exist in some is NaN.
    void drawnValues_areThoseOfTheTrials()
    {
        const ReadXml xml = drawn(testing::madeMonteCarlo());
        QCOMPARE(xml.texts(quantityPath("dyncal_reportedName", "/dcc:noQuantity/dcc:content")),
            QStringList({"sensitivity", "sensitivity.per_level[0]", "f0_hz", "within_5_percent_hz",
                "settling_time_s"}));
        QCOMPARE(xml.numbers("//si:valueXMLList[../../@refType='dyncal_reportedValue']"),
            std::vector<double>({5e-6, 5.1e-6, 1e5, 2e4, 1e-5}));
        QCOMPARE(xml.list("//si:unitXMLList[../../@refType='dyncal_reportedValue']"),
            QStringList({"\\volt\\pascal\\tothe{-1}", "\\volt\\pascal\\tothe{-1}", "\\hertz",
                "\\hertz", "\\second"}));
        const auto u = xml.numbers("//si:valueStandardMUXMLList");
        QCOMPARE(u[2], 100.0);
        QCOMPARE(xml.numbers("//si:intervalMinXMLList")[2], 99800.0);
        QCOMPARE(xml.numbers("//si:intervalMaxXMLList")[2], 100200.0);
        for (const char *list : {"valueStandardMU", "intervalMin", "intervalMax"})
            QCOMPARE(xml.list(std::string("//si:") + list + "XMLList").back(), QString("NaN"));
        QCOMPARE(xml.text("//si:coverageProbabilityXMLList"), QString("0.95"));
    }

    /// f0 agrees, the 5 % edge does not (2.4 % against 2.9 %), what has no trials cannot.
    void agreement_isOneOrZero()
    {
        const ChainMonteCarlo made = testing::madeMonteCarlo();
        const QStringList found
            = drawn(made).list(quantityPath("dyncal_monteCarloValidated", "//si:valueXMLList"));
        QCOMPARE(found.size(), 5);
        QCOMPARE(found[2], QString("1"));
        QCOMPARE(found[3], QString("0"));
        QCOMPARE(found[4], QString("0"));
    }

    void coverageOfTheTrials_isStated()
    {
        ChainMonteCarlo made = testing::madeMonteCarlo();
        made.coverage = 0.99;
        QCOMPARE(drawn(made).text("//si:coverageProbabilityXMLList"), QString("0.99"));
    }

    void noTrials_areNoResult()
    {
        ChainMonteCarlo made = testing::madeMonteCarlo();
        made.trials = 0;
        QVERIFY(drawn(made).parts().isEmpty());
        made = testing::madeMonteCarlo();
        made.values.clear();
        QVERIFY(drawn(made).parts().isEmpty());
    }
};

DYNCAL_TEST(TestDccBudget)
#include "tst_dcc_budget.moc"
