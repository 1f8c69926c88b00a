// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers of results.json in the DCC: written down, read back, without a digit lost.

#include "core/dcc/dcc_exact.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/made_comparison.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <numbers>

using namespace dyncal;
using testing::ExampleSource;
using testing::quantityPath;
using testing::ReadXml;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Of the results alone: the pages have no part in it.
ReadXml readOf(const ExampleSource &example)
{
    XmlElement root{"results"};
    for (XmlElement &result :
        dccExactResults({example.certificate, example.results, example.recipe}))
        root.add(std::move(result));
    return ReadXml(root);
}

/// 2 V/Pa at 0, 90 and -180 degrees, then a row that is withheld.
ResponseResult quarterTurns()
{
    ResponseResult made;
    made.unit = "V/Pa";
    made.frequency_Hz = Eigen::Vector4d(100.0, 200.0, 300.0, 1.0 / 3.0);
    made.magnitude = Eigen::Vector4d(2.0, 2.0, 2.0, kUnknown);
    made.phase_rad = Eigen::Vector4d(0.0, std::numbers::pi / 2, -std::numbers::pi, kUnknown);
    made.modelMagnitude = Eigen::Vector4d(2.5, 2.5, 2.5, 2.5);
    made.modelPhase_rad = Eigen::Vector4d(0.1, 0.2, 0.3, 0.4);
    made.withheld.assign(4, WithheldReason::None);
    made.withheld[3] = WithheldReason::End;
    return made;
}

/// u of the magnitude 0.03, of the phase 0.02 rad, which is 0.04 V/Pa across the value.
RowUncertainty rowsOf(double dof = kInf)
{
    RowUncertainty rows;
    rows.u_magnitude = Eigen::Vector4d(0.03, 0.03, 0.03, kUnknown);
    rows.u_phase_rad = Eigen::Vector4d(0.02, 0.02, 0.02, kUnknown);
    rows.dof_magnitude = rows.dof_phase = Eigen::Vector4d::Constant(dof);
    rows.covarianceReIm = Eigen::MatrixX3d::Zero(4, 3);
    rows.u_modelMagnitude = Eigen::Vector4d::Constant(0.01);
    rows.u_modelPhase_rad = Eigen::Vector4d::Constant(kUnknown);
    return rows;
}

ExampleSource exampleOf(const ResponseResult &response, const RowUncertainty &rows = rowsOf())
{
    ExampleSource example;
    example.results = {};
    example.results.response = std::make_shared<ResponseResult>(response);
    UncertaintyReport report;
    report.rows = report.rowsAtMarks = rows;
    example.results.uncertainty = std::make_shared<UncertaintyReport>(report);
    return example;
}

void near(const std::vector<double> &found, const std::vector<double> &expected)
{
    QCOMPARE(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        QVERIFY2(std::isnan(expected[i]) ? std::isnan(found[i])
                                         : std::abs(found[i] - expected[i]) < 1e-12,
            qPrintable(QString("%1: %2, not %3").arg(i).arg(found[i]).arg(expected[i])));
}

} // namespace

class TestDccExact : public QObject
{
    Q_OBJECT

private slots:
    void nothing_isNoResult()
    {
        ExampleSource example;
        example.results = {};
        QVERIFY(readOf(example).parts().isEmpty());
    }

    void complexValues_areMagnitudeAndPhase()
    {
        const ReadXml xml = readOf(exampleOf(quarterTurns()));
        near(xml.numbers("//si:valueRealXMLList"), {2.0, 0.0, -2.0, kUnknown});
        near(xml.numbers("//si:valueImagXMLList"), {0.0, 2.0, 0.0, kUnknown});
        QCOMPARE(xml.list(quantityPath("basic_tableIndex0 dyncal_frequency", "//si:valueXMLList")),
            QStringList({"100", "200", "300", "0.3333333333333333"}));
        QCOMPARE(
            xml.list(quantityPath("basic_measuredValue dyncal_magnitude", "//si:valueXMLList")),
            QStringList({"2", "2", "2", "NaN"}));
    }

    /// Along the value 0.03 squared, across it (2 * 0.02) squared: at a quarter turn they change
    /// places.
    void covariance_turnsWithTheValue()
    {
        const ReadXml xml = readOf(exampleOf(quarterTurns()));
        const auto part = [&](int column, int row) {
            return xml.numbers("//si:columnXMLList[" + std::to_string(column)
                + "]/si:covarianceXMLList[" + std::to_string(row) + "]/si:valueXMLList");
        };
        near(part(1, 1), {0.0009, 0.0016, 0.0009, kUnknown});
        near(part(2, 2), {0.0016, 0.0009, 0.0016, kUnknown});
        near(part(1, 2), {0.0, 0.0, 0.0, kUnknown});
        near(part(2, 1), part(1, 2));
        for (const QString &unit : xml.texts("//si:covarianceXMLList/si:unitXMLList"))
            QCOMPARE(unit, QString("\\volt\\pascal\\tothe{-1}\\volt\\pascal\\tothe{-1}"));
    }

    /// sqrt(-2 ln 0.05) = 2.4477; with 5 degrees of freedom sqrt(2 * 5 / 4 * F(2, 4)) with
    /// F = 6.9443 is 4.1666.
    void factor_isThatOfTheEllipse()
    {
        QCOMPARE(readOf(exampleOf(quarterTurns())).list("//si:coverageFactorXMLList"),
            QStringList({"2.4477", "2.4477", "2.4477", "NaN"}));
        const auto k
            = readOf(exampleOf(quarterTurns(), rowsOf(5.0))).numbers("//si:coverageFactorXMLList");
        QVERIFY(std::abs(k[0] - 4.1666) < 2e-4);
        QCOMPARE(readOf(exampleOf(quarterTurns(), rowsOf(1.0))).list("//si:coverageFactorXMLList"),
            QStringList({"NaN", "NaN", "NaN", "NaN"}));
    }

    void standardUncertainties_standWithTheirValues()
    {
        const ReadXml xml = readOf(exampleOf(quarterTurns()));
        const auto u = [&](const char *refType) {
            return xml.list(quantityPath(refType, "//si:valueStandardMUXMLList"));
        };
        QCOMPARE(u("basic_measuredValue dyncal_magnitude"),
            QStringList({"0.03", "0.03", "0.03", "NaN"}));
        QCOMPARE(
            u("basic_measuredValue dyncal_phase"), QStringList({"0.02", "0.02", "0.02", "NaN"}));
        QCOMPARE(u("dyncal_modelMagnitude"), QStringList({"0.01", "0.01", "0.01", "0.01"}));
        QCOMPARE(xml.count(quantityPath("dyncal_modelPhase", "//si:valueStandardMUXMLList")), 0);
        QCOMPARE(xml.list(quantityPath("dyncal_degreesOfFreedom", "//si:valueXMLList")),
            QStringList({"NaN", "NaN", "NaN", "NaN"}));
    }

    void everyList_hasAsManyValuesAsRows()
    {
        const ReadXml xml = readOf(exampleOf(quarterTurns()));
        for (const char *name : {"valueXMLList", "valueRealXMLList", "valueImagXMLList",
                 "coverageFactorXMLList", "valueStandardMUXMLList"})
            for (const QString &list : xml.texts(std::string("//si:") + name))
                QCOMPARE(list.split(' ').size(), 4);
        QCOMPARE(xml.count("//dcc:quantity"), 7);
        QCOMPARE(xml.count("//dcc:quantity[not(dcc:name)]"), 0);
        QCOMPARE(xml.count("//dcc:quantity[not(.//si:unitXMLList)]"), 0);
    }

    void withheldRows_areCounted()
    {
        const QString said = "//dcc:result/dcc:description/dcc:content";
        QCOMPARE(readOf(exampleOf(quarterTurns())).text(said.toStdString()),
            QString("Of 4 rows 1 are withheld and have no value (NaN)."));
        ResponseResult whole = quarterTurns();
        whole.withheld.clear();
        QCOMPARE(readOf(exampleOf(whole)).count(said.toStdString()), 0);
    }

    /// What has no rows of u, has its values alone.
    void noUncertainty_leavesTheValues()
    {
        const ReadXml xml = readOf(exampleOf(quarterTurns(), RowUncertainty()));
        near(xml.numbers("//si:valueRealXMLList"), {2.0, 0.0, -2.0, kUnknown});
        QCOMPARE(xml.count("//si:valueStandardMUXMLList"), 0);
        QCOMPARE(xml.list("//si:coverageFactorXMLList"), QStringList({"NaN", "NaN", "NaN", "NaN"}));
        ExampleSource example = exampleOf(quarterTurns());
        example.results.uncertainty = nullptr;
        QCOMPARE(readOf(example).count("//si:valueRealXMLList"), 1);
    }

    void relativeResponse_isOfUnitOne()
    {
        ResponseResult relative = quarterTurns();
        relative.unit = "1";
        const ReadXml xml = readOf(exampleOf(relative));
        for (const QString &unit : xml.texts("//si:covarianceXMLList/si:unitXMLList"))
            QCOMPARE(unit, QString("\\one"));
    }

    void freeDecayOrUnknownUnit_hasNoResponse()
    {
        ResponseResult decay = quarterTurns();
        decay.magnitude.resize(0);
        QVERIFY(readOf(exampleOf(decay)).parts().isEmpty());
        ResponseResult typed = quarterTurns();
        typed.unit = "g/Pa";
        QVERIFY(readOf(exampleOf(typed)).parts().isEmpty());
    }

    /// The whole response alone has the id that the printed one refers to.
    void marks_areAResultOfTheirOwn()
    {
        ResponseResult response = quarterTurns();
        response.atMarks = std::make_shared<ResponseResult>(quarterTurns());
        const ReadXml xml = readOf(exampleOf(response));
        QCOMPARE(xml.texts("//dcc:result/@refType"),
            QStringList({"dyncal_complexResponse", "dyncal_complexResponseAtMarks"}));
        QCOMPARE(xml.texts("//@id"), QStringList("response"));
        QCOMPARE(xml.text("//*[@id='response']/../../@refType"), QString("dyncal_complexResponse"));
    }

    /// Beside the response by the step; against a transducer it would stand there twice.
    void comparison_standsBesideTheStep()
    {
        ExampleSource example = exampleOf(quarterTurns());
        const auto made = testing::comparisonOf({3.0, 3.0}, {2.0, 2.0}, {0.1, 0.1});
        example.results.comparison = std::make_shared<ComparisonResult>(made);
        const ReadXml xml = readOf(example);
        QCOMPARE(xml.texts("//dcc:result/@refType"),
            QStringList({"dyncal_complexResponse", "dyncal_comparisonResponse"}));
        QCOMPARE(xml.list("//dcc:result[2]"
                     + quantityPath("basic_measuredValue dyncal_magnitude", "//si:valueXMLList")),
            QStringList({"3", "3"}));
        ResponseResult byTransducer = quarterTurns();
        byTransducer.isByTransducer = true;
        example.results.response = std::make_shared<ResponseResult>(byTransducer);
        QCOMPARE(readOf(example).count("//dcc:result"), 1);
    }
};

DYNCAL_TEST(TestDccExact)
#include "tst_dcc_exact.moc"
