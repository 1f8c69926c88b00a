// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using dyncal::testing::python;
using dyncal::testing::PythonAnswer;

/// tests/audit/recompute.py goes back from results.json to the raw samples without Dyncal's code.
class TestAudit : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    static QString script()
    {
        return QDir(qEnvironmentVariable("DYNCAL_SOURCE_DIR", "."))
            .filePath("tests/audit/recompute.py");
    }

    PythonAnswer audit(const QString &preset) const
    {
        return python({script(), path(preset + ".h5"), path(preset)});
    }

    void calibrate(const QString &preset, int seed)
    {
        const QString capture = path(preset + ".h5");
        QCOMPARE(runDyncal({"simulate", "--preset", preset, "--noise", "0.01", "--seed",
                               QString::number(seed), "-o", capture})
                     .exitCode,
            0);
        QVERIFY(runDyncal({"run", capture, "-o", path(preset)}).exitCode <= 1);
    }

    /// results.json with one number moved by a share.
    void move(const QString &preset, const QString &section, const QString &key, double share)
    {
        const QString file = path(preset + "/results.json");
        QJsonObject results = fileJson(file);
        QJsonArray shots = results[section].toArray();
        QJsonObject first = shots[0].toObject();
        first[key] = first[key].toDouble() * (1.0 + share);
        shots[0] = first;
        results[section] = shots;
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(QJsonDocument(results).toJson());
    }

private slots:
    void initTestCase()
    {
        if (!python({"-c", "import numpy, scipy, h5py"}).ran)
            QSKIP("python3 with numpy, scipy and h5py is not installed: nothing was recomputed.");
    }

    void everyNumber_isRecomputedFromTheRawSamples_data()
    {
        QTest::addColumn<QString>("preset");
        QTest::newRow("2.33 MHz") << "optic3";
        QTest::newRow("318 kHz") << "piezo";
        QTest::newRow("optic2") << "optic2";
    }
    void everyNumber_isRecomputedFromTheRawSamples()
    {
        QFETCH(QString, preset);
        calibrate(preset, 4);
        const PythonAnswer answer = audit(preset);
        QVERIFY2(answer.ran, answer.out + answer.err);
        const qsizetype compared = answer.out.count("\nok ") + 1;
        QVERIFY2(compared >= 60, answer.out);
    }

    void numberThatWasMoved_isFound_data()
    {
        QTest::addColumn<QString>("section");
        QTest::addColumn<QString>("key");
        QTest::newRow("velocity") << "shock"
                                  << "velocity_m_s";
        QTest::newRow("step") << "shock"
                              << "step_pa";
        QTest::newRow("u of the step") << "shock"
                                       << "u_step_pa";
        QTest::newRow("sensitivity") << "shots"
                                     << "sensitivity";
        QTest::newRow("onset") << "shots"
                               << "onset_s";
    }
    void numberThatWasMoved_isFound()
    {
        QFETCH(QString, section);
        QFETCH(QString, key);
        constexpr double kShare = 3e-4;
        if (!QFile::exists(path("optic3/results.json")))
            calibrate("optic3", 4);
        const QByteArray before = fileBytes(path("optic3/results.json"));
        move("optic3", section, key, kShare);
        const PythonAnswer answer = audit("optic3");
        QFile restored(path("optic3/results.json"));
        QVERIFY(restored.open(QIODevice::WriteOnly));
        restored.write(before);
        QVERIFY(!answer.ran);
        QVERIFY2(answer.out.contains("\nOFF "), answer.out + answer.err);
    }

    void sampleThatWasChanged_isFound()
    {
        if (!QFile::exists(path("optic3/results.json")))
            calibrate("optic3", 4);
        const QString change = QStringLiteral("import h5py, sys\n"
                                              "with h5py.File(sys.argv[1], 'r+') as f:\n"
                                              "    f['shots/002/channels/DUT'][171500] += 1\n");
        QVERIFY(python({"-c", change, path("optic3.h5")}).ran);
        const PythonAnswer answer = audit("optic3");
        QVERIFY(!answer.ran);
        QVERIFY2(answer.out.contains("OFF  SHA-256 of shot 2, DUT"), answer.out + answer.err);
        QVERIFY(answer.out.contains("OFF  SHA-256 of the capture"));
    }
};

DYNCAL_TEST(TestAudit)
#include "tst_audit.moc"
