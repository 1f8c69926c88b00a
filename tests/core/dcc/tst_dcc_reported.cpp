// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Reported values and those of Monte Carlo: a list for each unit, and read back by the reader of
// other laboratories' certificates.

#include "core/dcc/dcc_reported.h"
#include "core/dcc_reading/dcc_contents.h"
#include "core/monte_carlo/chain_monte_carlo.h"
#include "core/results/pole_json.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/made_monte_carlo.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace dyncal;
using testing::ExampleSource;
using testing::quantityPath;
using testing::ReadXml;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

ReportedValue reported(const char *of, double value, const char *unit, double u)
{
    ReportedValue one{of, value, unit};
    one.u = u;
    one.k = 2.5;
    one.dof = 4.0;
    return one;
}

ReadXml readOf(const std::vector<XmlElement> &results)
{
    return ReadXml(XmlElement{"results", {}, {}, results});
}

/// Of the results alone: the pages have no part in it.
ReadXml reportedOnly(const UncertaintyReport &report)
{
    ExampleSource example;
    example.results = {};
    example.results.uncertainty = std::make_shared<UncertaintyReport>(report);
    return readOf(dccReportedValues({example.certificate, example.results, example.recipe}));
}

ReadXml drawn(const ChainMonteCarlo &made)
{
    ExampleSource example;
    example.results.uncertainty = nullptr;
    example.results.chainMonteCarlo = std::make_shared<ChainMonteCarlo>(made);
    return readOf(dccDrawnValues(example.source()));
}

/// Levels, shots and model; in V/Pa, Hz, s, % and 1.
UncertaintyReport manyValues()
{
    UncertaintyReport report;
    report.sensitivity = reported("sensitivity", 5.0244886239647644e-06, "V/Pa", 1.0 / 3e7);
    report.perLevel = {reported("sensitivity", 5e-6, "V/Pa", 2e-8)};
    report.ofShots = {reported("sensitivity", 4e-6, "V/Pa", 3e-8)};
    report.ofModel = {reported("f0_hz", 318000.0 / 7.0, "Hz", 12.0 / 7.0),
        reported("damping_ratio", 0.02, "", 1e-4), reported("overshoot", 93.9, "%", 0.7),
        reported("rise_time_s", 7.2e-8, "s", 1e-9), reported("resonance_hz", 3e5, "Hz", 10.0)};
    report.ofModel[1].dof = kInf;
    report.ofModel[3].k = 1.959963984540054;
    return report;
}

std::string keysOf(const CalibrationResults &results)
{
    std::string keys;
    for (const auto &[key, value] : dccValues(results))
        keys += key + ' ';
    return keys;
}

const StatedQuantity *columnWith(const StatedTable &table, const char *refType)
{
    const auto found = std::ranges::find_if(
        table.columns, [&](const StatedQuantity &one) { return one.hasRefType(refType); });
    return found == table.columns.end() ? nullptr : &*found;
}

/// Value, u, k and degrees of freedom as the reader has them, by their keys.
using ReadValues = std::map<std::string, std::array<double, 4>>;

void addRows(const StatedTable &table, ReadValues &read)
{
    const StatedQuantity *values = columnWith(table, "dyncal_reportedValue");
    const StatedQuantity *k = columnWith(table, "dyncal_coverageFactor");
    const StatedQuantity *dof = columnWith(table, "dyncal_degreesOfFreedom");
    if (!values || !k || !dof || table.words.size() != 1)
        return;
    const StatedValues &stated = values->stated.values;
    for (std::size_t i = 0; i < stated.values.size(); ++i)
        read[table.words.front().entries.at(i)] = {stated.values[i], stated.u.at(i),
            k->stated.values.values.at(i), dof->stated.values.values.at(i)};
}

ReadValues readBack(const std::string &dcc)
{
    ReadValues read;
    const Result<DccContents> contents = readDcc(dcc);
    if (!contents)
        return read;
    for (const StatedTable &table : contents->tables)
        if (std::ranges::find(table.refTypes, "dyncal_reportedValues") != table.refTypes.end()
            && table.notUnderstood.empty())
            addRows(table, read);
    return read;
}

bool isSame(double a, double b)
{
    return std::isfinite(b) ? a == b : std::isnan(a);
}

} // namespace

class TestDccReported : public QObject
{
    Q_OBJECT

private slots:
    void keys_areThoseOfResultsJson()
    {
        CalibrationResults results;
        results.uncertainty = std::make_shared<UncertaintyReport>(manyValues());
        QCOMPARE(keysOf(results),
            std::string("sensitivity sensitivity.per_level[0] shots[0].sensitivity f0_hz "
                        "damping_ratio overshoot rise_time_s resonance_hz "));
        results.uncertainty = nullptr;
        QCOMPARE(keysOf(results), std::string());
    }

    /// A pair of poles has one amplitude; every shot has its velocity and its step.
    void polesAndShots_haveTheirs()
    {
        CalibrationResults results = example::calibration();
        auto shock = std::make_shared<ShockConditionsSet>(*results.shock);
        shock->shots.resize(2);
        shock->shots[0].uncertainty.reset();
        shock->shots[1].uncertainty = uncertaintyOfTypedStep(
            2e5, {true, {{"step_relative", 0.01, Distribution::Normal, {}}}});
        results.shock = shock;
        UncertaintyReport report;
        report.amplitudes.assign(
            polesOf(*results.model, nullptr).size(), reported("amplitude", 1.0, "V", 0.1));
        results.uncertainty = std::make_shared<UncertaintyReport>(report);
        results.assessment = nullptr;
        std::string wanted;
        std::size_t listed = 0;
        for (const std::size_t i : listedPoles(results.model->poles)) {
            if (results.model->poles[i].z.imag() >= 0.0)
                wanted += "model.poles[" + std::to_string(listed) + "].amplitude ";
            ++listed;
        }
        QVERIFY(!wanted.empty());
        QCOMPARE(keysOf(results), wanted + "shock[1].velocity_m_s shock[1].step_pa ");
        const auto values = dccValues(results);
        QVERIFY(!values[values.size() - 2].second.u); // nobody knows the velocity
        QCOMPARE(values.back().second.value, 2e5);
        QVERIFY(std::abs(*values.back().second.u - 2e3) < 1e-9);
    }

    void values_areAllOfThem_unitByUnit()
    {
        const ReadXml xml = reportedOnly(manyValues());
        QCOMPARE(xml.texts("//dcc:result/@refType"), QStringList("dyncal_reportedValues"));
        const auto values = [&](const char *refType, const char *list) {
            return xml.texts(quantityPath(refType, std::string("//si:") + list));
        };
        QCOMPARE(xml.texts(quantityPath("dyncal_reportedName", "//dcc:noQuantity/dcc:content")),
            QStringList({"sensitivity", "sensitivity.per_level[0]", "shots[0].sensitivity", "f0_hz",
                "resonance_hz", "damping_ratio", "overshoot", "rise_time_s"}));
        QCOMPARE(values("dyncal_reportedValue", "unitXMLList"),
            QStringList(
                {"\\volt\\pascal\\tothe{-1}", "\\hertz", "\\one", "\\percent", "\\second"}));
        QCOMPARE(values("dyncal_reportedValue", "valueXMLList").front(),
            QString("5.0244886239647644e-06 5e-06 4e-06"));
        QCOMPARE(values("dyncal_reportedValue", "valueStandardMUXMLList").mid(2),
            QStringList({"1e-04", "0.7", "1e-09"}));
        QCOMPARE(values("dyncal_coverageFactor", "valueXMLList"),
            QStringList({"2.5 2.5 2.5", "2.5 2.5", "2.5", "2.5", "1.959963984540054"}));
        QCOMPARE(values("dyncal_degreesOfFreedom", "valueXMLList"),
            QStringList({"4 4 4", "4 4", "NaN", "4", "4"}));
    }

    /// Whatever other lists have: in these a unit stands once, and so for all.
    void eachList_hasOneUnit()
    {
        const ReadXml xml = reportedOnly(manyValues());
        QCOMPARE(xml.count("//dcc:list"), 5);
        for (const QString &unit : xml.texts("//si:unitXMLList"))
            QVERIFY2(!unit.contains(' '), qPrintable(unit));
    }

    /// The reader of certificates understands every list, and has every number to the last bit: U
    /// is k u of the same two. One in percent is 1/100 of it, which is rounded once.
    void reader_hasEveryValueToTheDigit()
    {
        CalibrationResults results = example::calibration();
        results.uncertainty = std::make_shared<UncertaintyReport>(manyValues());
        const ReadValues read
            = readBack(testing::dccOfRecipe(results, testing::exampleDccRecipe()));
        std::size_t complete = 0;
        for (const auto &[key, value] : dccValues(results)) {
            if (!value.u)
                continue;
            ++complete;
            QVERIFY2(read.contains(key), key.c_str());
            const auto &[number, u, k, dof] = read.at(key);
            const double factor = value.unit == "%" ? 0.01 : 1.0;
            QVERIFY2(isSame(number, value.value * factor), key.c_str());
            QVERIFY2(isSame(u, *value.u * factor), key.c_str());
            QVERIFY2(isSame(k, value.k) && isSame(dof, value.dof), key.c_str());
        }
        QCOMPARE(read.size(), complete);
    }

    /// The same of the example as it is, by the program's own order of things.
    void reader_hasEveryValueOfTheExample()
    {
        const CalibrationResults results = example::calibration();
        const ReadValues read = readBack(testing::exampleDcc());
        std::size_t complete = 0;
        for (const auto &[key, value] : dccValues(results)) {
            if (!value.u || !std::isfinite(value.value))
                continue;
            ++complete;
            QVERIFY2(read.contains(key), key.c_str());
            QVERIFY2(isSame(read.at(key)[0], value.value), key.c_str());
            QVERIFY2(isSame(read.at(key)[1], *value.u), key.c_str());
            QVERIFY2(isSame(read.at(key)[2], value.k), key.c_str());
        }
        QCOMPARE(read.size(), complete);
        QVERIFY(complete >= 2);
    }

    void valueWithoutU_orUnit_isLeftOut()
    {
        UncertaintyReport report;
        report.ofModel = {reported("a", 1.0, "Hz", 0.1), reported("b", kUnknown, "Hz", 0.1),
            reported("c", 1.0, "g", 0.1), {"d", 1.0, "Hz"}};
        QCOMPARE(reportedOnly(report).text(
                     quantityPath("dyncal_reportedName", "//dcc:noQuantity/dcc:content")),
            QString("a"));
        report.ofModel.erase(report.ofModel.begin());
        QVERIFY(reportedOnly(report).parts().isEmpty());
    }

    void nothing_isNoResult()
    {
        ExampleSource example;
        example.results = {};
        QVERIFY(dccReportedValues(example.source()).empty());
        QVERIFY(dccDrawnValues(example.source()).empty());
    }

    /// Values, u and intervals in the order of the trials; what does not exist in some is NaN.
    void drawnValues_areThoseOfTheTrials()
    {
        const ReadXml xml = drawn(testing::madeMonteCarlo());
        QCOMPARE(xml.texts(quantityPath("dyncal_reportedName", "/dcc:noQuantity/dcc:content")),
            QStringList({"sensitivity", "sensitivity.per_level[0]", "f0_hz", "within_5_percent_hz",
                "settling_time_s"}));
        const std::string value = "[../../@refType='dyncal_reportedValue']";
        QCOMPARE(xml.texts("//si:valueXMLList" + value),
            QStringList({"5e-06 5.1e-06", "1e+05 20000", "1e-05"}));
        QCOMPARE(xml.texts("//si:unitXMLList" + value),
            QStringList({"\\volt\\pascal\\tothe{-1}", "\\hertz", "\\second"}));
        QCOMPARE(xml.texts("//dcc:list/@refType"), QStringList(3, "dyncal_monteCarloValues"));
        QCOMPARE(xml.texts("//si:valueStandardMUXMLList")[1], QString("100 290"));
        QCOMPARE(xml.texts("//si:intervalMinXMLList")[1], QString("99800 19420"));
        QCOMPARE(xml.texts("//si:intervalMaxXMLList")[1], QString("100200 20580"));
        for (const char *list : {"valueStandardMU", "intervalMin", "intervalMax"})
            QCOMPARE(xml.texts(std::string("//si:") + list + "XMLList").back(), QString("NaN"));
        QCOMPARE(xml.texts("//si:coverageProbabilityXMLList"), QStringList(3, "0.95"));
    }

    /// f0 agrees, the 5 % edge does not (2.4 % against 2.9 %), what has no trials cannot.
    void agreement_isOneOrZero()
    {
        const ChainMonteCarlo made = testing::madeMonteCarlo();
        const QStringList found
            = drawn(made).texts(quantityPath("dyncal_monteCarloValidated", "//si:valueXMLList"));
        QCOMPARE(found.size(), 3);
        QCOMPARE(found[1], QString("1 0")); // both in Hz
        QCOMPARE(found[2], QString("0"));
    }

    void coverageOfTheTrials_isStated()
    {
        ChainMonteCarlo made = testing::madeMonteCarlo();
        made.coverage = 0.99;
        QCOMPARE(drawn(made).texts("//si:coverageProbabilityXMLList"), QStringList(3, "0.99"));
    }

    /// What somebody typed as a unit takes its own value away only.
    void unknownUnit_leavesTheOthers()
    {
        ChainMonteCarlo made = testing::madeMonteCarlo();
        made.values.front().unit = "g/Pa";
        QCOMPARE(drawn(made).texts("//si:valueXMLList[../../@refType='dyncal_reportedValue']"),
            QStringList({"5.1e-06", "1e+05 20000", "1e-05"}));
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

DYNCAL_TEST(TestDccReported)
#include "tst_dcc_reported.moc"
