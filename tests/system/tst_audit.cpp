// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
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

    PythonAnswer audit(const QString &preset) const
    {
        return scriptOf("recompute.py", {path(preset + ".h5"), path(preset)});
    }

    static PythonAnswer scriptOf(const QString &script, const QStringList &arguments)
    {
        const QDir folder(qEnvironmentVariable("DYNCAL_SOURCE_DIR", ".") + "/tests/audit");
        return python(QStringList{folder.filePath(script)} + arguments);
    }

    static Answer simulate(const QString &preset, const QString &noise, int seed,
        const QString &capture, const QStringList &more = {})
    {
        return runDyncal(QStringList{"simulate", "--preset", preset, "--noise", noise, "--seed",
                             QString::number(seed), "-o", capture}
            + more);
    }

    void calibrate(const QString &preset, int seed)
    {
        const QString capture = path(preset + ".h5");
        QCOMPARE(simulate(preset, "0.01", seed, capture).exitCode, 0);
        // Nothing is recomputed of the Monte Carlo, which takes longest.
        QVERIFY(writeBytes(path("quick.json"), R"({"uncertainty": {"monte_carlo_trials": 1000}})"));
        const QStringList quick{"--recipe", path("quick.json")};
        QVERIFY(runDyncal(QStringList{"run", capture, "-o", path(preset)} + quick).exitCode <= 1);
    }

    /// Recordings, tables and recipes of tests/audit/cases.py: a DUT with a reference transducer
    /// beside it, and a free decay.
    bool makeCases()
    {
        const QStringList brief{"--duration-s", "0.006"};
        return QFile::exists(path("both.h5"))
            || (simulate("optic3", "0.01", 3, path("dut.h5"), brief).exitCode == 0
                && simulate("optic1", "0.002", 3, path("reference.h5"), brief).exitCode == 0
                && scriptOf("cases.py", {path("dut.h5"), path("reference.h5"), m_folder.path()})
                       .ran);
    }

    /// Numbers that were moved one by one, of which `count` there are: every thirtieth here, all
    /// of them in the long form.
    void tellsMoved(
        const QString &capture, const QString &name, int count, const QStringList &words) const
    {
        const int every = dyncal::trials::count(30, 1);
        const PythonAnswer told = scriptOf("moved_numbers.py",
            QStringList{"--every", QString::number(every), path(capture), path(name)} + words);
        QVERIFY2(told.ran, told.out + told.err);
        QVERIFY2(told.out.count("\nok ") >= count / every, told.out);
    }

    Answer runCase(const QString &capture, const QString &name)
    {
        if (!makeCases())
            return {};
        return runDyncal(
            {"run", path(capture), "--recipe", path(name + ".json"), "-o", path(name)});
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
        if (dyncal::trials::count(0, 1) > 0)
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
        tellsMoved("optic3.h5", "optic3", 45, {});
    }

    /// Comparison by table and by model, chain, CMC relative and absolute, each decision rule, free
    /// decay: everything recomputed, and numbers told that were moved whose names have one of the
    /// words.
    void everySection_isRecomputed_andTellsMovedNumbers_data()
    {
        QTest::addColumn<QString>("capture");
        QTest::addColumn<QStringList>("said");
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("moved");
        const QString verdict = "ok   verdict of conformity                        ";
        QTest::newRow("table") << "both.h5" << QStringList{verdict + "conforms", "E_n of the means"}
                               << QStringList{"comparison", "conformity"} << 40;
        QTest::newRow("model") << "both.h5" << QStringList{verdict + "does-not-conform"}
                               << QStringList{"reference", "conformity", "k_sensitivity"} << 14;
        QTest::newRow("chain") << "both.h5" << QStringList{"its reason names 'between them'"}
                               << QStringList{"chain", "onset_s", "comparison.e_n"} << 10;
        QTest::newRow("chain_transducer")
            << "both.h5" << QStringList{"its reason names 'measured'"} << QStringList() << 0;
        QTest::newRow("high_table")
            << "both.h5" << QStringList{"sensitivity: reference_sensitivity_relative"}
            << QStringList() << 0;
        QTest::newRow("cmc") << "both.h5" << QStringList{verdict, "U below the CMC"}
                             << QStringList{"cmc", "u_model", "k_"} << 20;
        QTest::newRow("decay") << "decay.h5" << QStringList{"lines of q", "U below the CMC"}
                               << QStringList() << 0;
    }
    void everySection_isRecomputed_andTellsMovedNumbers()
    {
        QFETCH(QString, capture);
        QFETCH(QStringList, said);
        QFETCH(QStringList, words);
        QFETCH(int, moved);
        const QString name = QTest::currentDataTag();
        const Answer run = runCase(capture, name);
        QVERIFY2(run.exitCode == 0 || run.exitCode == 1, run.err);
        const PythonAnswer answer = scriptOf("recompute.py", {path(capture), path(name)});
        QVERIFY2(answer.ran, answer.out + answer.err);
        for (const QString &line : said)
            QVERIFY2(answer.out.contains(line.toUtf8()), answer.out);
        if (moved > 0)
            tellsMoved(capture, name, moved, words);
    }

    void freeDecay_hasNothingToCompare()
    {
        const Answer answer = runCase("decay.h5", "decay_compared");
        QCOMPARE(answer.exitCode, 4);
        QCOMPARE(answer.complaints().size(), 1);
        QVERIFY(answer.complaints().first().contains("needs the response to a step"));
    }

    /// Without the recording: every kind of calibration that the cases before have run.
    void everyBudget_standsByItself()
    {
        QStringList folders;
        for (const char *name :
            {"optic3", "table", "model", "chain", "chain_transducer", "cmc", "decay"})
            if (QFile::exists(path(QString(name) + "/results.json")))
                folders.append(path(name));
        if (folders.isEmpty())
            QSKIP("No case has run before.");
        const PythonAnswer answer = scriptOf("check_budgets.py", folders);
        QVERIFY2(answer.ran, answer.out + answer.err);
        QCOMPARE(answer.out.count("values with their lines"), folders.size());
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
