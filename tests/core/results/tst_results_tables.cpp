// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The files of csv/ read back as tables: the numbers of the results, each under its name.

#include "core/results/results_csv.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <map>
#include <set>

using namespace dyncal;

namespace {

/// Columns by their names; NaN for an empty cell. Fails where a row has another number of cells.
std::map<std::string, std::vector<double>> columnsOf(const std::string &text)
{
    const QList<QByteArray> lines = QByteArray::fromStdString(text).split('\n');
    const QList<QByteArray> names = lines[0].split(',');
    std::map<std::string, std::vector<double>> columns;
    for (const QByteArray &name : names)
        columns[name.toStdString()];
    if (columns.size() != std::size_t(names.size()) || !lines.back().isEmpty())
        return {};
    for (const QByteArray &line : lines.mid(1, lines.size() - 2)) {
        const QList<QByteArray> cells = line.split(',');
        if (cells.size() != names.size())
            return {};
        for (qsizetype i = 0; i < names.size(); ++i)
            columns[names[i].toStdString()].push_back(
                cells[i].isEmpty() ? kUnknown : std::strtod(cells[i].constData(), nullptr));
    }
    return columns;
}

const std::string &textOf(const std::vector<CsvFile> &files, const std::string &name)
{
    static const std::string none;
    const auto found = std::ranges::find(files, name, &CsvFile::name);
    return found == files.end() ? none : found->text;
}

bool areSame(const std::vector<double> &column, const Eigen::VectorXd &values)
{
    return std::equal(column.begin(), column.end(), values.begin(), values.end());
}

CalibrationResults exampleWithEvidence()
{
    CalibrationResults results = example::calibration();
    OrderEvidence evidence;
    evidence.fit_percent = Eigen::Vector4d(10.0, 98.0, kUnknown, 97.0);
    evidence.crossShot_percent = Eigen::Vector2d(9.0, 97.5);
    evidence.poles = {{2, 2.33e6, 0.02, PoleStability::New, true, 5.0},
        {3, 2.34e6, -0.01, PoleStability::Unstable, false, 0.5}};
    results.evidence = std::make_shared<const OrderEvidence>(evidence);
    return results;
}

} // namespace

class TestResultsTables : public QObject
{
    Q_OBJECT

private slots:
    void everyFile_isARectangleUnderItsOwnName()
    {
        const std::vector<CsvFile> files = resultsCsv(exampleWithEvidence());
        std::set<std::string> names;
        for (const CsvFile &file : files) {
            QVERIFY2(names.insert(file.name).second, file.name.c_str());
            QVERIFY2(!columnsOf(file.text).empty(), file.name.c_str());
            QVERIFY2(file.text.find("nan") == std::string::npos, file.name.c_str());
            QVERIFY2(file.text.find("inf") == std::string::npos, file.name.c_str());
        }
        // Three shots, four files each, and one of each of the others.
        QCOMPARE(names.size(), std::size_t(4 * 3 + 7));
    }

    void numbers_areThoseOfTheResults()
    {
        const CalibrationResults results = exampleWithEvidence();
        const std::vector<CsvFile> files = resultsCsv(results);
        const WindowedResponse &response = results.window->responses[1];
        auto table = columnsOf(textOf(files, "response_shot_002.csv"));
        QVERIFY(areSame(table["value"], response.window()));
        QCOMPARE(table["time_s"][0], 0.0); // the start, not the begin of the record
        QCOMPARE(table["time_s"][500], 500.0 / response.sampleRate_Hz);
        table = columnsOf(textOf(files, "spectrum_shot_003.csv"));
        QVERIFY(areSame(table["psd_per_hz"], results.spectrum->perShot[2].psd));
        QVERIFY(areSame(table["frequency_hz"], results.spectrum->perShot[2].frequency_Hz));
        table = columnsOf(textOf(files, "components.csv"));
        QVERIFY(areSame(table["shot_002_response"], results.components->responses.col(1)));
        QVERIFY(areSame(table["average"], results.components->average));
        table = columnsOf(textOf(files, "model_input_shot_001.csv"));
        QVERIFY(areSame(table["value"], results.input->series[0].y));
        QCOMPARE(table["time_s"][0], results.input->series[0].first_s);
        table = columnsOf(textOf(files, "model_shot_003.csv"));
        QVERIFY(areSame(table["model"], results.model->series[2].simulated));
        for (std::size_t i = 0; i < table["error"].size(); ++i)
            QVERIFY(std::abs(table["measured"][i] - table["model"][i] - table["error"][i]) < 1e-15);
        table = columnsOf(textOf(files, "singular_values.csv"));
        QVERIFY(areSame(table["singular_value"], results.decomposition->hankel.singularValues));
        QCOMPARE(table["order"].back(), 40.0);
    }

    void poles_liftTheirRateOutOfTheCircle()
    {
        // |ln z| / (2 pi dt) is the frequency beside it, |z| < 1 of what decays.
        auto table = columnsOf(textOf(resultsCsv(example::calibration()), "poles.csv"));
        QCOMPARE(table["z_re"].size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            const std::complex<double> s
                = std::log(std::complex<double>(table["z_re"][i], table["z_im"][i]))
                * example::kModelRate_Hz;
            QVERIFY(std::abs(std::abs(s) / (2.0 * M_PI) / table["frequency_hz"][i] - 1.0) < 1e-12);
            QVERIFY(std::abs(-s.real() / std::abs(s) - table["damping_ratio"][i]) < 1e-12);
        }
    }

    void orders_leaveACellEmptyForWhatTheyHaveNot()
    {
        const std::vector<CsvFile> files = resultsCsv(exampleWithEvidence());
        QCOMPARE(textOf(files, "orders.csv"),
            std::string(
                "order,fit_percent,leave_one_out_percent\n1,10,9\n2,98,97.5\n3,,\n4,97,\n"));
        QCOMPARE(textOf(files, "stability.csv"),
            std::string("order,frequency_hz,damping_ratio,stability,stands_out\n"
                        "2,2330000,0.02,0,1\n3,2340000,-0.01,3,0\n"));
    }

    void silence_hasNoDecibels()
    {
        CalibrationResults results = example::calibration({});
        SpectrumResult spectrum = *results.spectrum;
        spectrum.perShot[0].psd.setZero();
        spectrum.perShot[0].psd[7] = 1e-3;
        results.spectrum = std::make_shared<const SpectrumResult>(spectrum);
        auto table = columnsOf(textOf(resultsCsv(results), "spectrum_shot_001.csv"));
        QCOMPARE(table["psd_db"][7], -30.0);
        QVERIFY(std::isnan(table["psd_db"][6])); // an empty cell, not "-inf"
        QCOMPARE(table["psd_per_hz"][6], 0.0);
    }

    void numbersOfShots_sortAndNeverMeet()
    {
        WindowResult window;
        for (const Index shot : {1, 10, 100, 999, 1000, 12345}) {
            WindowedResponse response;
            response.shot = shot;
            response.sampleRate_Hz = 1.0;
            response.length = 1;
            response.values = Eigen::VectorXd::Ones(1);
            window.responses.push_back(response);
        }
        CalibrationResults results;
        results.window = std::make_shared<const WindowResult>(window);
        std::set<std::string> names;
        for (const CsvFile &file : resultsCsv(results))
            names.insert(file.name);
        QCOMPARE(names.size(), std::size_t(6));
        QVERIFY(names.contains("response_shot_001.csv"));
        QVERIFY(names.contains("response_shot_12345.csv"));
    }

    void fewerSpectraThanShots_giveThoseThatAreThere()
    {
        CalibrationResults results = example::calibration({});
        SpectrumResult spectrum = *results.spectrum;
        spectrum.perShot.resize(1);
        results.spectrum = std::make_shared<const SpectrumResult>(spectrum);
        const std::vector<CsvFile> files = resultsCsv(results);
        QVERIFY(!textOf(files, "spectrum_shot_001.csv").empty());
        QVERIFY(textOf(files, "spectrum_shot_002.csv").empty());
    }
};

DYNCAL_TEST(TestResultsTables)
#include "tst_results_tables.moc"
