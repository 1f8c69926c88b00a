// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

namespace {

/// A pressure pulse as the simulated sensor of second order records it: the pulse is slow against
/// the sensor, so its answer is S0 (p - 2 zeta/w0 p' - p''/w0^2 ...) to 1e-6.
QByteArray pulseCsv(double f0_Hz, double zeta, double S0, double peak_Pa, double at_s)
{
    constexpr double kRate_Hz = 20e6, kWidth_s = 2e-6;
    const double w0 = 2.0 * std::numbers::pi * f0_Hz;
    QByteArray text("time (s),DUT (V)\n");
    for (int n = 0; n < 12000; ++n) {
        const double t = n / kRate_Hz;
        const double x = (t - at_s) / kWidth_s;
        const double p = peak_Pa * std::exp(-0.5 * x * x);
        const double first = -x / kWidth_s * p;
        const double second = (x * x - 1.0) / (kWidth_s * kWidth_s) * p;
        const double volt
            = S0 * (p - 2.0 * zeta / w0 * first + (4.0 * zeta * zeta - 1.0) / (w0 * w0) * second);
        const double rounded = 0.25 + 1e-5 * std::round((volt + 3e-6 * std::sin(1e3 * n)) / 1e-5);
        text += QByteArray::number(t, 'g', 12) + "," + QByteArray::number(rounded, 'g', 12) + "\n";
    }
    return text;
}

} // namespace

/// `dyncal correct` as a customer uses it, with the results of a calibration.
class TestCorrect : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    Answer correct(const QStringList &more, const QString &out = "pressure") const
    {
        return runDyncal(QStringList{"correct", path("pulse.csv"), "--recipe", path("pulse.json"),
                             "--with", path("run"), "-o", path(out)}
            + more);
    }

private slots:
    void initTestCase()
    {
        QCOMPARE(
            runDyncal({"simulate", "-o", path("calibration.h5"), "--duration-s", "0.004"}).exitCode,
            0);
        QVERIFY(runDyncal(QStringList{"run", path("calibration.h5"), "-o", path("run")} + quickly())
                    .exitCode
            <= 1);
        QVERIFY(writeBytes(path("pulse.csv"), pulseCsv(2.33e6, 0.02, 5e-6, 2e5, 400e-6)));
        QVERIFY(writeBytes(
            path("pulse.json"), R"({"import": {"columns": {"time": 0, "dut": 1}, "unit": "V"}})"));
    }

    void pulse_hasItsPressureWithinU()
    {
        const Answer answer = correct({"--band", "1e6"});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        QVERIFY(answer.out.contains("Band                    0 to 1 MHz"));
        const QJsonObject shot = fileJson(path("pressure/correction.json"))["shots"][0].toObject();
        const double U = shot["k_largest"].toDouble() * shot["u_largest_pa"].toDouble();
        QVERIFY2(std::abs(shot["largest_pa"].toDouble() - 2e5) < U, qPrintable(QString::number(U)));
        QVERIFY(U < 0.03 * 2e5);
        QVERIFY(std::abs(shot["at_s"].toDouble() - 400e-6) < 0.1e-6);
        QVERIFY(std::abs(shot["level"].toDouble() - 0.25) < 1e-4);
        for (const char *file :
            {"pressure_shot_001.csv", "filter.json", "filter.csv", "filter_errors.csv",
                "filter.mat", "filter.py", "calibration.json", "written.json"})
            QVERIFY2(QFile::exists(path("pressure/") + file), file);
    }

    /// Twice the same bytes.
    void correction_isTheSameTwice()
    {
        QVERIFY(correct({"--band", "1e6"}, "once").exitCode <= 1);
        QVERIFY(correct({"--band", "1e6"}, "twice").exitCode <= 1);
        const QStringList files = QDir(path("once")).entryList(QDir::Files);
        QCOMPARE(files.size(), 9);
        for (const QString &file : files) {
            QFile a(path("once/" + file)), b(path("twice/" + file));
            QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
            QVERIFY2(a.readAll() == b.readAll(), qPrintable(file));
        }
    }

    /// A run and its correction may share a folder; neither takes the other's files.
    void runAndCorrection_shareAFolder()
    {
        QVERIFY(correct({"--band", "1e6"}, "run").exitCode <= 1);
        QVERIFY(QFile::exists(path("run/results.json")) && QFile::exists(path("run/filter.mat")));
        QVERIFY(runDyncal(QStringList{"run", path("calibration.h5"), "-o", path("run")} + quickly())
                    .exitCode
            <= 1);
        QVERIFY(QFile::exists(path("run/filter.mat")));
    }

    /// The import section holds for a correction as for a calibration.
    void importSettings_count()
    {
        const auto largest = [this](const QByteArray &import) {
            QFile::remove(path("other.json"));
            if (!writeBytes(path("other.json"),
                    R"({"import": {"columns": {"time": 0, "dut": 1}, "unit": "V", )" + import
                        + "}}"))
                return 0.0;
            const Answer answer = runDyncal({"correct", path("pulse.csv"), "--recipe",
                path("other.json"), "--with", path("run"), "--band", "1e6", "-o", path("other")});
            return answer.exitCode > 1
                ? 0.0
                : fileJson(path("other/correction.json"))["shots"][0]["largest_pa"].toDouble();
        };
        QVERIFY(std::abs(largest(R"("polarity": 1)") / 2e5 - 1.0) < 0.03);
        QVERIFY(std::abs(largest(R"("polarity": -1)") / -2e5 - 1.0) < 0.03);
        QVERIFY(std::abs(largest(R"("scale": 0.5)") / 1e5 - 1.0) < 0.03);
    }

    /// What is kept beside the pressures makes the same again.
    void keptCalibration_repeatsTheCorrection()
    {
        QVERIFY(correct({"--band", "1e6"}, "first").exitCode <= 1);
        const Answer answer
            = runDyncal({"correct", path("pulse.csv"), "--recipe", path("pulse.json"), "--with",
                path("first/calibration.json"), "--band", "1e6", "-o", path("second")});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        for (const char *file : {"pressure_shot_001.csv", "filter.json", "calibration.json"}) {
            QFile a(path("first/") + file), b(path("second/") + file);
            QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
            QVERIFY2(a.readAll() == b.readAll(), file);
        }
    }

    void wrongRequests_areRefusedWithTheReason_data()
    {
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("band beyond")
            << QStringList{"--band", "9e6"} << 4 << QByteArray("was measured from");
        QTest::newRow("not a number")
            << QStringList{"--band", "wide"} << 4 << QByteArray("Wrong usage");
        QTest::newRow("delay") << QStringList{"--band", "1e6", "--delay", "1e-9"} << 4
                               << QByteArray("needs at least");
        QTest::newRow("window") << QStringList{"--window", "2,1"} << 4
                                << QByteArray("the earlier first");
        QTest::newRow("nothing there")
            << QStringList{"--window", "5,6"} << 4 << QByteArray("has 0 samples");
        QTest::newRow("quiet") << QStringList{"--quiet", "0,1e-6"} << 4
                               << QByteArray("at least 256");
        QTest::newRow("beyond") << QStringList{"--beyond", "nan"} << 4 << QByteArray("at least 0");
        QTest::newRow("form") << QStringList{"--low-pass", "brick"} << 4
                              << QByteArray("Wrong usage");
    }

    void wrongRequests_areRefusedWithTheReason()
    {
        QFETCH(QStringList, more);
        QFETCH(int, code);
        QFETCH(QByteArray, says);
        const Answer answer = correct(more, "refused");
        QCOMPARE(answer.exitCode, code);
        QVERIFY2(answer.err.contains(says), answer.err);
        QCOMPARE(answer.complaints().size(), 1);
        QVERIFY(answer.out.isEmpty());
        QVERIFY(!QFile::exists(path("refused")));
    }

    void wrongResults_areRefused()
    {
        for (const QString &with :
            {path("nothing"), path("pulse.csv"), path("run/recipe.json"), m_folder.path()}) {
            const Answer answer = runDyncal(
                {"correct", path("calibration.h5"), "--with", with, "-o", path("refused")});
            QVERIFY2(answer.exitCode == 3 || answer.exitCode == 4, answer.err);
            QCOMPARE(answer.complaints().size(), 1);
        }
        const Answer missing
            = runDyncal({"correct", path("calibration.h5"), "-o", path("refused")});
        QCOMPARE(missing.exitCode, 4);
    }
};

DYNCAL_TEST(TestCorrect)
#include "tst_correct.moc"
