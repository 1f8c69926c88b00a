// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/json_text.h"
#include "core/base/writing/written_list.h"
#include "core/correction/correction_files.h"
#include "core/correction/filter_files.h"
#include "tests/support/file_bytes.h"
#include "tests/support/known_sensor.h"
#include "tests/support/near.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>

using namespace dyncal;
using namespace dyncal::testing;
using Json = nlohmann::json;

namespace {

constexpr double kRate_Hz = 5e6;
constexpr Index kCount = 6000;

KnownResponse calibratedSensor()
{
    KnownResponse response = TrueSensor().known();
    response.errors = {{"gain_relative", Eigen::VectorXcd::Constant(27, 0.005)},
        {"=cmd|noise", Eigen::VectorXcd::Zero(27), 12.0}};
    response.errors[1].atKnots[8] = {0.001, 0.0};
    return response;
}

CaptureSet recordings(const QString &file)
{
    Eigen::VectorXd record
        = TrueSensor().recordOf(1e5 * burst(kCount, kRate_Hz, 700e-6, 20e-6, 0.0), kRate_Hz);
    for (Index i = 0; i < kCount; ++i)
        record[i] += 1e-7 * double(i % 7 - 3);
    Channel channel;
    channel.name = "blast";
    channel.role = ChannelRole::Dut;
    channel.sampleRate_Hz = kRate_Hz;
    channel.samples = RawSamples(std::vector<double>(record.begin(), record.end()));
    CaptureSet set;
    set.inputs.push_back({file.toStdString(), "blast.csv", "0123", "text"});
    set.shots.resize(2);
    for (Shot &shot : set.shots)
        shot.channels = {channel};
    return set;
}

CorrectionOutcome outcomeOf(const CaptureSet &set)
{
    CorrectionOutcome outcome;
    outcome.calibration.says.response = calibratedSensor();
    outcome.calibration.says.fLow_Hz = 700.0;
    outcome.calibration.says.cautions = {"RSP-001"};
    outcome.calibration.file = "results.json";
    outcome.calibration.sha256 = "abcd";
    outcome.calibration.text = "{}";
    outcome.recordings = set.inputs;
    outcome.filter = designCorrection(outcome.calibration.says.response, kRate_Hz, {150e3}).value();
    for (Index shot = 1; shot <= 2; ++shot)
        outcome.shots.push_back({shot, "blast",
            recordPressure(set.shots[0].channels[0], shot, outcome.filter).value()});
    return outcome;
}

Json jsonAt(const QString &path)
{
    return Json::parse(bytesOf(path).toStdString(), nullptr, false);
}

/// Reads what was written with numpy and scipy alone.
const char *const kSameFilter = R"py(
import json, sys
from pathlib import Path
import numpy as np
folder = Path(sys.argv[1])
sys.path.insert(0, str(folder))
import filter as f
js = json.loads((folder / "filter.json").read_text())
table = np.loadtxt(folder / "filter.csv", delimiter=",", skiprows=1)
errors = np.loadtxt(folder / "filter_errors.csv", delimiter=",", skiprows=1, ndmin=2)
assert np.array_equal(f.h, js["taps"]) and np.array_equal(f.h, table[:, 0])
assert np.array_equal(f.E, errors)
assert np.allclose(np.sqrt((f.E ** 2).sum(axis=1)), js["u_taps"], rtol=1e-12)
assert f.delay == js["delay_samples"] and f.fs == js["sample_rate_hz"] and f.band == js["band_hz"]
assert abs(f.h.sum() / js["gain"] - 1) < 1e-12
x = np.loadtxt(folder / "record.txt")
p, u = f.correct(x)
shot = np.genfromtxt(folder / "pressure_shot_001.csv", delimiter=",", names=True)
first = len(f.h) - 1 - f.delay
at = int(round(shot["time_s"][0] * f.fs)) - first
n = len(shot)
assert np.abs(p[at:at + n] - shot["pressure_pa"]).max() < 1e-9 * np.abs(p).max()
assert np.abs(u[at:at + n] - shot["u_response_pa"]).max() < 1e-7 * np.abs(p).max()
H = f.frequency_response([0.0, 5e4])
assert abs(H[0] / js["gain"] - 1) < 1e-12
print("same")
)py";

} // namespace

class TestCorrectionFiles : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath("out/" + name); }

    Result<std::vector<std::string>> write(const CorrectionOutcome &outcome, const CaptureSet &set)
    {
        auto folder
            = FolderWrite::begin(correctionFolder(m_folder.filePath("out").toStdString(), set, {}));
        if (!folder)
            return tl::unexpected<Error>(folder.error());
        return writeCorrection(outcome, *folder);
    }

private slots:
    void folder_holdsWhatIsPromised()
    {
        const CaptureSet set = recordings(m_folder.filePath("blast.csv"));
        const auto paths = write(outcomeOf(set), set);
        QVERIFY2(paths.has_value(), paths ? "" : english(paths.error().message).c_str());
        QCOMPARE(paths->size(), std::size_t(9));
        for (const std::string &written : *paths)
            QVERIFY(std::filesystem::exists(written));
        const auto list = parseWrittenList(bytesOf(path("written.json")).toStdString());
        QVERIFY(list && list->size() == 9);
        QCOMPARE(list->front().by, std::string("correct"));
    }

    void summary_saysWhatWasDone()
    {
        const Json json = jsonAt(path("correction.json"));
        QCOMPARE(json["schema"], "dyncal-correction/1");
        QCOMPARE(json["calibration"]["sha256"], "abcd");
        QCOMPARE(json["calibration"]["cautions"], Json::array({"RSP-001"}));
        QCOMPARE(json["inputs"][0]["file"], "blast.csv");
        QCOMPARE(json["band_hz"], 150e3);
        QCOMPARE(json["edge_hz"], 225e3);
        QCOMPARE(json["coverage"], 0.95);
        QVERIFY(json["assumptions"].size() >= 4);
        QCOMPARE(json["shots"].size(), std::size_t(2));
        const Json &shot = json["shots"][1];
        QCOMPARE(shot["file"], "pressure_shot_002.csv");
        QVERIFY(std::abs(double(shot["largest_pa"]) / 1e5 - 1.0) < 1e-3);
        QVERIFY(std::abs(double(shot["at_s"]) - 700e-6) < 1e-6);
        QVERIFY(std::abs(double(shot["u_largest_pa"]) / 500.0 - 1.0) < 0.1); // the gain's
    }

    /// With it and the recordings the correction can be repeated.
    void calibration_isKeptAsItWas()
    {
        QCOMPARE(bytesOf(path("calibration.json")), QByteArray("{}"));
    }

    void filterJson_saysWhatTheTapsAre()
    {
        const Json json = jsonAt(path("filter.json"));
        QCOMPARE(json["schema"], "dyncal-filter/1");
        QCOMPARE(json["unit"], "Pa/V");
        QCOMPARE(json["low_pass"], "gaussian");
        QVERIFY(isNear(double(json["delay_s"]), double(json["delay_samples"]) / kRate_Hz));
        QVERIFY(std::abs(double(json["gain"]) * TrueSensor().S0 - 1.0) < 2.0 * kLargestPassError);
        QVERIFY(double(json["pass_error"]) <= kLargestPassError);
    }

    /// A name from elsewhere is no formula of a spreadsheet.
    void errorNames_areSafeInTables()
    {
        const QByteArray header = bytesOf(path("filter_errors.csv")).split('\n').front();
        QVERIFY(!header.startsWith('='));
        QCOMPARE(header.split(',').size(), 2);
    }

    /// All forms by another program, and the script's pressure is the program's.
    void python_makesTheSamePressure()
    {
        QVERIFY2(hasNumericalPython(), "python3-numpy and python3-scipy are needed");
        const CaptureSet set = recordings("");
        const auto record = recordPressure(set.shots[0].channels[0], 1,
            designCorrection(calibratedSensor(), kRate_Hz, {150e3}).value());
        QFile file(path("record.txt"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const Eigen::VectorXd values
            = physicalValues(set.shots[0].channels[0], 0, kCount).array() - record->level;
        for (const double value : values)
            file.write(QByteArray::number(value, 'g', 17) + "\n");
        file.close();
        const PythonAnswer answer = python({"-c", kSameFilter, m_folder.filePath("out")});
        QVERIFY2(answer.ran, answer.err.constData());
        QFile::remove(path("record.txt"));
    }

    /// The second correction takes the place of the first, and a shot that it lacks is gone.
    void earlierCorrection_isReplaced()
    {
        const CaptureSet set = recordings(m_folder.filePath("blast.csv"));
        CorrectionOutcome outcome = outcomeOf(set);
        outcome.shots.pop_back();
        outcome.isBoundStated = true;
        const auto paths = write(outcome, set);
        QVERIFY2(paths.has_value(), paths ? "" : english(paths.error().message).c_str());
        QVERIFY(!QFile::exists(path("pressure_shot_002.csv")));
        const std::string text = bytesOf(path("correction.json")).toStdString();
        QVERIFY(text.find("stated by the customer") != std::string::npos);
    }

    void foreignFiles_areNotTouched()
    {
        const CaptureSet set = recordings(m_folder.filePath("blast.csv"));
        QFile changed(path("filter.json"));
        QVERIFY(changed.open(QIODevice::WriteOnly));
        changed.write("mine");
        changed.close();
        const auto paths = write(outcomeOf(set), set);
        QVERIFY(!paths && paths.error().kind == ErrorKind::Usage);
        QCOMPARE(bytesOf(path("filter.json")), QByteArray("mine"));
        QVERIFY(QFile::remove(path("filter.json")));
        const CaptureSet inside = recordings(path("blast.csv")); // a recording in the folder
        QFile recording(path("blast.csv"));
        QVERIFY(recording.open(QIODevice::WriteOnly));
        recording.close();
        QVERIFY(!write(outcomeOf(inside), inside));
    }
};

DYNCAL_TEST(TestCorrectionFiles)
#include "tst_correction_files.moc"
