// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Budgets of single frequencies, from parts that are written down.

#include "core/dcc/dcc_row_budget.h"
#include "core/results/results_uncertainty_json.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/core/dcc/read_xml.h"
#include "tests/support/made_comparison.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::ExampleSource;
using testing::ReadXml;

namespace {

/// Rows of a record's noise of 0.3 %, of which the last is withheld; the gain is of all.
struct Rows
{
    ResponseResult response;
    RowUncertainty rows;

    explicit Rows(Index count = 3)
    {
        const Eigen::VectorXd each = Eigen::VectorXd::Ones(count);
        response.unit = "V/Pa";
        response.frequency_Hz = Eigen::VectorXd::LinSpaced(count, 1e3, 3e3);
        response.magnitude = 2.0 * each;
        response.phase_rad = -0.5 * each;
        response.u_noiseMagnitude = 0.006 * each;
        response.u_noisePhase_rad = 0.005 * each;
        response.u_frontMagnitude = 0.0 * each;
        response.boundEnd = response.boundAlias = 0.0 * each;
        response.u_magnitude = 0.006 * each;
        response.dof = 20.0 * each;
        response.magnitude[count - 1] = kUnknown;
        rows = rowUncertainty(response, CommonLines{{directLine("gain_relative", -0.004)}, {}}, {},
            {}, ResponseTreatment::StepDeflated);
    }
};

ExampleSource exampleOf(const Rows &made)
{
    ExampleSource example;
    example.results = {};
    example.results.response = std::make_shared<ResponseResult>(made.response);
    UncertaintyReport report;
    report.rows = report.rowsAtMarks = made.rows;
    example.results.uncertainty = std::make_shared<UncertaintyReport>(report);
    return example;
}

ReadXml readOf(const ExampleSource &example)
{
    return ReadXml(XmlElement{
        "results", {}, {}, dccRowBudgets({example.certificate, example.results, example.recipe})});
}

std::string columnOf(const std::string &list, const std::string &source)
{
    return "//dcc:list[@refType='" + list + "']/dcc:quantity[dcc:name/dcc:content='" + source
        + "']//si:valueXMLList";
}

/// u of a row, as the root of the sum of squares of all its contributions.
double rootOfSquares(const ReadXml &xml, const std::string &list, std::size_t row)
{
    double sum = 0.0;
    for (const QString &column : xml.texts("//dcc:list[@refType='" + list
             + "']/dcc:quantity[@refType='dyncal_budgetContribution']//si:valueXMLList"))
        sum += std::pow(column.split(' ').at(static_cast<qsizetype>(row)).toDouble(), 2);
    return std::sqrt(sum);
}

} // namespace

class TestDccRowBudget : public QObject
{
    Q_OBJECT

private slots:
    /// 0.3 % of 2 V/Pa; the gain's -0.4 % of it, with its sign.
    void contributions_standRowByRow()
    {
        const ReadXml xml = readOf(exampleOf(Rows()));
        QCOMPARE(xml.texts("//dcc:result/@refType"), QStringList("dyncal_responseBudget"));
        QCOMPARE(xml.texts("//dcc:list/@refType"),
            QStringList({"dyncal_magnitudeBudget", "dyncal_phaseBudget"}));
        QCOMPARE(
            xml.text(columnOf("dyncal_magnitudeBudget", "Frequency")), QString("1000 2000 3000"));
        QCOMPARE(xml.text(columnOf("dyncal_magnitudeBudget", "noise")), QString("0.006 0.006 NaN"));
        QCOMPARE(xml.text(columnOf("dyncal_magnitudeBudget", "gain_relative")),
            QString("-0.008 -0.008 NaN"));
        QCOMPARE(xml.text(columnOf("dyncal_phaseBudget", "noise")), QString("0.003 0.003 NaN"));
        QCOMPARE(xml.count(columnOf("dyncal_phaseBudget", "gain_relative")), 0);
    }

    void contributions_makeTheUncertaintyOfTheirRow()
    {
        const Rows made;
        const ReadXml xml = readOf(exampleOf(made));
        for (std::size_t row = 0; row < 2; ++row) {
            const auto at = static_cast<Index>(row);
            QVERIFY(std::abs(rootOfSquares(xml, "dyncal_magnitudeBudget", row)
                            / made.rows.u_magnitude[at]
                        - 1.0)
                < 1e-14);
            QVERIFY(
                std::abs(
                    rootOfSquares(xml, "dyncal_phaseBudget", row) / made.rows.u_phase_rad[at] - 1.0)
                < 1e-14);
        }
    }

    void units_areThoseOfTheValue_andDistributionsAreSaid()
    {
        const ReadXml xml = readOf(exampleOf(Rows()));
        const auto of = [&](const char *list, const char *rest) {
            return xml.texts(std::string("//dcc:list[@refType='") + list
                + "']/dcc:quantity[@refType='dyncal_budgetContribution']" + rest);
        };
        for (const QString &unit : of("dyncal_magnitudeBudget", "//si:unitXMLList"))
            QCOMPARE(unit, QString("\\volt\\pascal\\tothe{-1}"));
        for (const QString &unit : of("dyncal_phaseBudget", "//si:unitXMLList"))
            QCOMPARE(unit, QString("\\radian"));
        const QStringList said = of("dyncal_magnitudeBudget", "/dcc:description/dcc:content");
        QCOMPARE(said.size(), of("dyncal_magnitudeBudget", "").size());
        QVERIFY(said.contains("normal") && said.contains("rectangular"));
    }

    /// Twice the same name of one shot are two sources; of another shot it is said.
    void sourcesOfOneName_areToldApart()
    {
        Rows made;
        UncertaintyLine ofShot = directLine("arrival_s", 0.001);
        ofShot.shot = 2;
        made.rows.common
            = {directLine("gain_relative", 0.003), directLine("gain_relative", 0.004), ofShot};
        const ReadXml xml = readOf(exampleOf(made));
        QCOMPARE(xml.texts(columnOf("dyncal_magnitudeBudget", "gain_relative")),
            QStringList({"0.006 0.006 NaN", "0.008 0.008 NaN"}));
        QCOMPARE(xml.text(columnOf("dyncal_magnitudeBudget", "arrival_s, shot 2")),
            QString("0.002 0.002 NaN"));
    }

    /// The line that brings U up to the laboratory's least stands in the rows that need it.
    void sourceOfSomeRows_isNoneInTheOthers()
    {
        Rows made;
        made.rows.leastExpanded_relative = Eigen::Vector3d(0.02, 0.0, 0.0);
        const QStringList column
            = readOf(exampleOf(made)).list(columnOf("dyncal_magnitudeBudget", kCapability));
        QCOMPARE(column.size(), 3);
        // (0.02 2 / 2)^2 = 0.006^2 + 0.008^2 + cmc^2 but for the front, of which 0 is left
        QVERIFY(column[0].toDouble() >= 0.0 && column[0] != "NaN");
        QCOMPARE(column.mid(1), QStringList({"NaN", "NaN"}));
    }

    void moreRowsThanResultsHave_areLeftOut_andThatIsSaid()
    {
        const ReadXml most = readOf(exampleOf(Rows(kMostBudgetRows)));
        QCOMPARE(most.count("//dcc:list"), 2);
        const ReadXml xml = readOf(exampleOf(Rows(kMostBudgetRows + 1)));
        QCOMPARE(xml.count("//dcc:list"), 0);
        QCOMPARE(xml.text("//dcc:data/dcc:text/dcc:content"),
            QString("The budgets of the single frequencies are left out, because there are more "
                    "than 200."));
    }

    void marksAndComparison_haveTheirOwn()
    {
        const Rows made;
        ExampleSource example = exampleOf(made);
        ResponseResult response = made.response;
        response.atMarks = std::make_shared<ResponseResult>(made.response);
        example.results.response = std::make_shared<ResponseResult>(response);
        QCOMPARE(readOf(example).texts("//dcc:result/@refType"),
            QStringList({"dyncal_responseBudget", "dyncal_responseBudgetAtMarks"}));
        ComparisonResult comparison = testing::comparisonOf({2.0, 2.0, 2.0}, {2.0}, {0.1});
        comparison.byTransducer->response = made.response;
        comparison.byTransducer->report.rows = made.rows;
        example.results.comparison = std::make_shared<ComparisonResult>(comparison);
        QCOMPARE(readOf(example).texts("//dcc:result/@refType"),
            QStringList({"dyncal_responseBudget", "dyncal_responseBudgetAtMarks",
                "dyncal_comparisonBudget"}));
    }

    void withoutPartsOrUnit_thereIsNone_data()
    {
        QTest::addColumn<int>("missing");
        QTest::newRow("report") << 0;
        QTest::newRow("response") << 1;
        QTest::newRow("unit") << 2;
        QTest::newRow("noise") << 3;
        QTest::newRow("u of all rows") << 4;
    }
    void withoutPartsOrUnit_thereIsNone()
    {
        QFETCH(int, missing);
        Rows made;
        if (missing == 2)
            made.response.unit = "g/Pa";
        if (missing == 3)
            made.response.u_noiseMagnitude.resize(0);
        if (missing == 4)
            made.rows.u_magnitude.setConstant(kUnknown),
                made.rows.u_phase_rad.setConstant(kUnknown);
        ExampleSource example = exampleOf(made);
        if (missing == 0)
            example.results.uncertainty = nullptr;
        if (missing == 1)
            example.results.response = nullptr;
        QVERIFY(readOf(example).parts().isEmpty());
    }
};

DYNCAL_TEST(TestDccRowBudget)
#include "tst_dcc_row_budget.moc"
