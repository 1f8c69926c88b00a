// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <QDir>
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

    PythonAnswer audit(const QString &preset, const QString &script = "recompute.py") const
    {
        const QDir folder(qEnvironmentVariable("DYNCAL_SOURCE_DIR", ".") + "/tests/audit");
        return python({folder.filePath(script), path(preset + ".h5"), path(preset)});
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
        QVERIFY2(compared >= 300, answer.out);
    }

    /// Velocity, step and sensitivity by 3e-4; u of sensitivity, f0, rows of S(f) and lines of
    /// budgets by 1 %.
    void numberThatWasMoved_isFound()
    {
        if (!QFile::exists(path("optic3/results.json")))
            calibrate("optic3", 4);
        const PythonAnswer answer = audit("optic3", "moved_numbers.py");
        QVERIFY2(answer.ran, answer.out + answer.err);
        QVERIFY2(answer.out.count("\nok ") >= 25, answer.out);
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
