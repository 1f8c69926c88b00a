// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/csv_table.h"
#include "core/results/results_csv.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace dyncal;

class TestResultsCsv : public QObject
{
    Q_OBJECT

private slots:
    void table_writesNumbersThatReadBackTheSame()
    {
        CsvTable table;
        table.add("time_s", Eigen::Vector2d(0.0, 1e-8));
        table.add("value", Eigen::Vector2d(0.1 + 0.2, -1.0));
        QCOMPARE(table.text(), std::string("time_s,value\n0,0.30000000000000004\n1e-08,-1\n"));
    }

    void table_leavesCellsEmptyForWhatIsNotThere()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        CsvTable table;
        table.add("a", Eigen::Vector3d(1.0, nan, 3.0));
        table.add("b", Eigen::VectorXd::Constant(1, 5.0));
        QCOMPARE(table.text(), std::string("a,b\n1,5\n,\n3,\n"));
    }

    void cell_isQuotedOnlyWhereNeeded()
    {
        QCOMPARE(csvCell("time_s"), std::string("time_s"));
        QCOMPARE(csvCell("a,b"), std::string("\"a,b\""));
        QCOMPARE(csvCell("say \"x\""), std::string("\"say \"\"x\"\"\""));
    }

    void emptyTable_isOneEmptyLine() { QCOMPARE(CsvTable().text(), std::string("\n")); }

    void nothingComputed_givesNoFiles() { QVERIFY(resultsCsv({}).empty()); }

    void response_holdsTheWindowFromTheStartOn()
    {
        WindowResult window;
        WindowedResponse response;
        response.shot = 12;
        response.sampleRate_Hz = 2.0;
        response.values = Eigen::Vector4d(9.0, 0.25, 0.5, 9.0);
        response.lead = 1;
        response.length = 2;
        window.responses.push_back(response);
        CalibrationResults results;
        results.window = std::make_shared<WindowResult>(window);
        const std::vector<CsvFile> files = resultsCsv(results);
        QCOMPARE(files.size(), std::size_t(1));
        QCOMPARE(files[0].name, std::string("response_shot_012.csv"));
        QCOMPARE(files[0].text, std::string("time_s,value\n0,0.25\n0.5,0.5\n"));
    }

    void modelOfTheAverage_isNamedSo()
    {
        ModelInput input;
        input.sampleRate_Hz = 1.0;
        ModelSeries series;
        series.y = Eigen::Vector2d(1.0, 2.0);
        series.first_s = 3.0;
        input.series.push_back(series);
        SensorModel model;
        SeriesFit fit;
        fit.simulated = Eigen::Vector2d(0.5, 2.0);
        fit.error = Eigen::Vector2d(0.5, 0.0);
        model.series.push_back(fit);
        CalibrationResults results;
        results.input = std::make_shared<ModelInput>(input);
        results.model = std::make_shared<SensorModel>(model);
        const std::vector<CsvFile> files = resultsCsv(results);
        QCOMPARE(files.size(), std::size_t(3)); // input, model, poles
        QCOMPARE(files[0].name, std::string("model_input_average.csv"));
        QCOMPARE(files[1].name, std::string("model_average.csv"));
        QCOMPARE(files[1].text, std::string("time_s,measured,model,error\n3,1,0.5,0.5\n4,2,2,0\n"));
        QCOMPARE(files[2].name, std::string("poles.csv"));
    }
};

DYNCAL_TEST(TestResultsCsv)
#include "tst_results_csv.moc"
