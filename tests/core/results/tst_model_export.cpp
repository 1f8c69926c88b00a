// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/model_response.h"
#include "core/results/model_export.h"
#include "tests/core/results/exported_model.h"
#include "tests/support/test_program.h"

#include "core/results/mat_writer.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/python_answer.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::calibratedModel;
using testing::writeModelFiles;

namespace {

/// Sums of a few hundred terms of order one, by another program.
constexpr double kSameResponse = 1e-9;

const ModelFile &named(const std::vector<ModelFile> &files, const char *name)
{
    return *std::find_if(
        files.begin(), files.end(), [name](const ModelFile &file) { return file.name == name; });
}

QJsonObject jsonOf(const CalibrationResults &results)
{
    const std::string text = named(modelFiles(results), "model.json").bytes;
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

/// Reads what was written with numpy, scipy and json alone, and compares it in all three forms.
const char *const kSameInAllForms = R"py(
import json, sys
from pathlib import Path
import numpy as np
from scipy.io import loadmat
folder = Path(sys.argv[1])
mat, js = loadmat(folder / "model.mat"), json.loads((folder / "model.json").read_text())
def rows(name): return np.loadtxt(folder / name, delimiter=",", ndmin=2)
def listed(name): return np.array([v["re"] + 1j * v["im"] for v in js[name]])
for name in "ABCD":
    assert np.array_equal(mat[name], np.array(js[name])), name
    assert np.array_equal(mat[name], rows(name + ".csv")), name
assert mat["Ts"].item() == js["dt_s"] and mat["c0"].item() == js["c0"]
assert np.array_equal(mat["c"].ravel(), listed("c"))
assert np.array_equal(mat["s"].ravel(), listed("s_rad_s"))
table = np.loadtxt(folder / "exponentials.csv", delimiter=",", skiprows=1, ndmin=2)
assert np.array_equal(table[1:, 0] + 1j * table[1:, 1], listed("s_rad_s"))
assert np.array_equal(table[1:, 2] + 1j * table[1:, 3], listed("c"))
assert table[0, 2] == js["c0"] and mat["y"].shape == mat["y_model"].shape
assert mat["A"].shape[0] == js["order"]
print(repr(float(mat["y_model"][7, 0])), repr(float(mat["y"][5, -1])))
)py";

} // namespace

class TestModelExport : public QObject
{
    Q_OBJECT

private slots:
    void forms_agreeWithEachOtherAndTheModel_data()
    {
        QTest::addColumn<int>("treatment");
        QTest::addColumn<int>("order");
        QTest::newRow("step") << int(ResponseTreatment::StepDeflated) << 2;
        QTest::newRow("step, higher order") << int(ResponseTreatment::StepDeflated) << 9;
        QTest::newRow("thesis") << int(ResponseTreatment::StepAsImpulse) << 3;
        QTest::newRow("decay") << int(ResponseTreatment::Impulse) << 3;
    }

    void forms_agreeWithEachOtherAndTheModel()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy and scipy is missing: exports are not read back.");
        QFETCH(int, treatment);
        QFETCH(int, order);
        const CalibrationResults results
            = calibratedModel(static_cast<ResponseTreatment>(treatment), order);
        QVERIFY(results.model && !results.model->diverges);
        const QTemporaryDir folder;
        writeModelFiles(modelFiles(results), folder.path());
        const testing::PythonAnswer forms = testing::python({"-c", kSameInAllForms, folder.path()});
        QVERIFY2(forms.ran, forms.err);
        const QList<QByteArray> numbers = forms.out.simplified().split(' ');
        QCOMPARE(numbers[0].toDouble(), results.model->series.front().simulated[7]);
        QCOMPARE(numbers[1].toDouble(), results.input->series.back().y[5]);

        const testing::PythonAnswer script = testing::python({folder.filePath("model.py")});
        QVERIFY2(script.ran, script.err);
        const double difference = script.out.simplified().split(' ').back().toDouble();
        QVERIFY2(script.out.startsWith("largest difference:"), script.out);
        QVERIFY2(difference < kSameResponse, script.out);
    }

    void frequencyResponse_ofTheScript_isTheModels()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy and scipy is missing: the script is not run.");
        const CalibrationResults results = calibratedModel(ResponseTreatment::StepDeflated, 2);
        const QTemporaryDir folder;
        writeModelFiles(modelFiles(results), folder.path());
        const testing::PythonAnswer answer = testing::python({"-c",
            "import sys; sys.path.insert(0, sys.argv[1]); import model\n"
            "g = model.frequency_response([1e5, 2.33e6])\n"
            "print(repr(g[0].real), repr(g[0].imag), repr(g[1].real), repr(g[1].imag))",
            folder.path()});
        QVERIFY2(answer.ran, answer.err);
        QByteArray text = answer.out;
        text.replace("np.float64(", "").replace(")", "");
        const QList<QByteArray> numbers = text.simplified().split(' ');
        const auto check = [&](int at, double frequency_Hz) {
            const std::complex<double> expected
                = modelResponse(*results.model, ResponseTreatment::StepDeflated, frequency_Hz);
            QVERIFY(std::abs(numbers[at].toDouble() - expected.real()) < kSameResponse * 100.0);
            QVERIFY(std::abs(numbers[at + 1].toDouble() - expected.imag()) < kSameResponse * 100.0);
        };
        check(0, 1e5);
        check(2, 2.33e6);
    }

    void matlabScript_simulatesWhatTheTreatmentMeans()
    {
        const auto text = [](ResponseTreatment treatment, Index order) {
            return QByteArray::fromStdString(
                named(modelFiles(calibratedModel(treatment, order)), "model.m").bytes);
        };
        const QByteArray step = text(ResponseTreatment::StepDeflated, 2);
        QVERIFY(step.contains("y(k) = m.C * x + m.D;") && step.contains("m.c0 + real("));
        QVERIFY(step.contains("2i * pi * f(:) - m.s.'"));
        QCOMPARE(step.count("for k"), step.count("\nend\n"));
        const QByteArray thesis = text(ResponseTreatment::StepAsImpulse, 3);
        QVERIFY(thesis.contains("x = m.B;") && thesis.contains("expected = m.y_model(:, 1);"));
    }

    void divergingModel_orNone_isNotExported()
    {
        QVERIFY(modelFiles({}).empty());
        CalibrationResults results = calibratedModel(ResponseTreatment::StepDeflated, 2);
        QCOMPARE(modelFiles(results).size(), modelFileNames().size());
        SensorModel model = *results.model;
        model.diverges = true;
        results.model = std::make_shared<const SensorModel>(model);
        QVERIFY(modelFiles(results).empty());
        model.diverges = false;
        model.stateSpace.A(0, 0) = kUnknown;
        results.model = std::make_shared<const SensorModel>(model);
        QVERIFY(modelFiles(results).empty());
    }

    void names_andFormats_areThoseListed()
    {
        const auto files = modelFiles(calibratedModel(ResponseTreatment::StepDeflated, 2));
        QCOMPARE(files.size(), modelFileNames().size());
        for (std::size_t i = 0; i < files.size(); ++i) {
            QCOMPARE(files[i].name, modelFileNames()[i]);
            QCOMPARE(std::count(modelFormats().begin(), modelFormats().end(), files[i].format),
                std::ptrdiff_t(1));
        }
    }

    void json_isExplainedWhereNothingIs()
    {
        CalibrationResults results = calibratedModel(ResponseTreatment::StepDeflated, 2);
        results.response = nullptr;
        const QJsonObject root = jsonOf(results);
        QCOMPARE(root["schema"].toString(), QString("dyncal-model/1"));
        QVERIFY(root["sensitivity"].isNull());
        QVERIFY(root["sensitivity_reason"].toString().size() > 5);
    }

    void json_holdsTheUncertainties()
    {
        const CalibrationResults results
            = calibratedModel(ResponseTreatment::StepDeflated, 2, StageId::Uncertainty);
        const QJsonObject root = jsonOf(results);
        const QJsonArray poles = root["poles"].toArray(), s = root["s_rad_s"].toArray();
        QVERIFY(std::cmp_equal(poles.size(), results.assessment->poles.size()));
        for (int i = 0; i < s.size(); ++i) { // in the same order
            const double abs = std::hypot(s[i]["re"].toDouble(), s[i]["im"].toDouble());
            QCOMPARE(poles[i]["frequency_hz"].toDouble() * 2.0 * M_PI, abs);
            const Pole &assessed = results.assessment->poles[static_cast<std::size_t>(i)];
            QVERIFY(assessed.u_frequency_Hz > 0.0);
            QCOMPARE(poles[i]["u_frequency_hz"].toDouble(), assessed.u_frequency_Hz);
            QCOMPARE(poles[i]["u_damping_ratio"].toDouble(), assessed.u_dampingRatio);
            QCOMPARE(poles[i]["coverage_factor"].toDouble(), assessed.coverageFactor);
            const double u_Hz = poles[i]["u_complete_frequency_hz"].toDouble();
            QVERIFY(u_Hz > assessed.u_frequency_Hz); // with the sample clock's
            QVERIFY(poles[i]["k_frequency"].toDouble() > 1.9);
        }
        const ReportedValue *f0 = results.uncertainty->find("f0_hz");
        QCOMPARE(poles[0]["u_complete_frequency_hz"].toDouble(), *f0->u);
        const auto &mean = results.uncertainty->sensitivity;
        QVERIFY(mean && mean->u);
        QCOMPARE(root["u_sensitivity"].toDouble(), *mean->u);
        QCOMPARE(root["k_sensitivity"].toDouble(), mean->k);
        const QJsonArray series = root["series"].toArray();
        QVERIFY(std::cmp_equal(series.size(), results.model->series.size()));
        for (int i = 0; i < series.size(); ++i) {
            const SeriesFit &fit = results.model->series[static_cast<std::size_t>(i)];
            QCOMPARE(series[i]["shot"].toInt(), int(fit.shot));
            QCOMPARE(series[i]["u_c0"].toDouble(), fit.u_plateauGain);
            QCOMPARE(series[i]["u_onset_level"].toDouble(), fit.u_level());
            QCOMPARE(series[i]["u_onset_s"].toDouble(), fit.u_onset_s);
        }
    }

    void json_unknownUncertainties_haveTheirReason()
    {
        const QJsonObject root = jsonOf(calibratedModel(ResponseTreatment::StepDeflated, 2));
        const QJsonObject pole = root["poles"].toArray().first().toObject(); // not assessed
        QVERIFY(pole["u_frequency_hz"].isNull());
        QVERIFY(pole["u_frequency_hz_reason"].toString().size() > 5);
        QVERIFY(pole["u_complete_frequency_hz"].isNull());
        const QJsonObject decay = jsonOf(calibratedModel(ResponseTreatment::Impulse, 3));
        QVERIFY(decay["u_sensitivity"].isNull() && decay["k_sensitivity"].isNull());
        QVERIFY(decay["u_sensitivity_reason"].toString().size() > 5);
    }

    void matFile_isLaidOutAsTheFormatSays()
    {
        MatWriter writer;
        writer.add("abc", Eigen::MatrixXd((Eigen::MatrixXd(1, 2) << 1.0, -2.5).finished()));
        const QByteArray bytes = QByteArray::fromStdString(writer.bytes());
        QVERIFY(bytes.startsWith("MATLAB 5.0 MAT-file"));
        QCOMPARE(bytes.mid(124, 4), QByteArray("\0\1IM", 4));
        // tag 8, flags 16, dimensions 16, name 16, numbers 8 + 16
        QCOMPARE(bytes.size(), 128 + 8 + 16 + 16 + 16 + 24);
        QCOMPARE(int(bytes[128]), 14);
        QCOMPARE(int(bytes[132]), 72);
        QCOMPARE(bytes.mid(128 + 8 + 16 + 16 + 8, 3), QByteArray("abc"));
        QCOMPARE(bytes.right(8), QByteArray("\0\0\0\0\0\0\4\xC0", 8)); // -2.5
    }

    void matFile_emptyComplexAndLongName_areReadByScipy()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy and scipy is missing: MAT files are not read back.");
        MatWriter writer;
        writer.add("none", Eigen::MatrixXd(0, 3));
        Eigen::MatrixXcd z(2, 1);
        z << std::complex<double>(1.0, 2.0), std::complex<double>(-3.0, 1e-300);
        writer.add("a_name_of_exactly_32_characters_", z);
        writer.add("x", 0.1);
        const QTemporaryDir folder;
        QFile file(folder.filePath("a.mat"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(writer.bytes()));
        file.close();
        const testing::PythonAnswer answer = testing::python({"-c",
            "import sys; from scipy.io import loadmat; m = loadmat(sys.argv[1])\n"
            "z = m['a_name_of_exactly_32_characters_']\n"
            "assert m['none'].shape == (0, 3) and z.shape == (2, 1)\n"
            "assert z[0, 0] == 1 + 2j and z[1, 0] == -3 + 1e-300j and m['x'].item() == 0.1",
            file.fileName()});
        QVERIFY2(answer.ran, answer.err);
    }
};

DYNCAL_TEST(TestModelExport)
#include "tst_model_export.moc"
