// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/batch_folder.h"

#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QtTest>

#include <optional>

#include <csignal>

/// A batch as a laboratory runs it.
class TestBatch : public QObject
{
    Q_OBJECT

private:
    static constexpr int kSensors = 6;
    static constexpr int kSeeds[kSensors]{1, 3, 4, 5, 6, 8}; ///< without cautions, with few trials
    QTemporaryDir m_simulated;
    std::optional<BatchFolder> m_complete; ///< run once: a copy of it is as good as a run

    /// A batch of all simulated sensors, planned; complete if asked for.
    void prepare(const BatchFolder &batch, bool isRun)
    {
        if (isRun && m_complete)
            QVERIFY(copyFolder(m_complete->folder.path(), batch.folder.path()));
        else if (isRun)
            complete(batch);
        else {
            batch.addSensors(m_simulated.path(), kSensors);
            QCOMPARE(batch.plan().exitCode, 0);
        }
    }
    void complete(const BatchFolder &batch)
    {
        prepare(batch, false);
        QCOMPARE(batch.run({"--jobs", "2"}).exitCode, 0);
        m_complete.emplace();
        QVERIFY(copyFolder(batch.folder.path(), m_complete->folder.path()));
    }

private slots:
    void initTestCase()
    {
        for (int i = 1; i <= kSensors; ++i)
            QVERIFY(
                simulateShortCapture(m_simulated.filePath(QString("%1.h5").arg(i)), kSeeds[i - 1]));
    }

    void night_goodClippedAndCorrupt_givesSevenRows();
    void results_areThoseOfRun();
    void shards_giveTheSameSummary();
    void again_keepsWhatIsComplete();
    void changedRecording_isComputedAgainAlone();
    void changedRecording_withoutANewPlan_isSaid();
    void changedRecipe_isComputedAgainWhereItIsUsed();
    void otherMethods_areRefused();
    void damagedResults_areSetAsideAndComputedAgain();
    void otherMountPoint_givesTheSameSummary();
    void killedAtRandom_endsWithTheSameSummary();
    void killedSensor_stopsNoneOther();
    void interrupted_leavesWhatIsCompleteAndNothingElse();
    void twoAtOnce_computeEachSensorOnce();
    void status_whileItRuns();
    void scripts_runTheBatch_data();
    void scripts_runTheBatch();
    void wrongUse_isSaid_data();
    void wrongUse_isSaid();
};

/// Scenario S29.
void TestBatch::night_goodClippedAndCorrupt_givesSevenRows()
{
    const BatchFolder batch;
    batch.addSensors(m_simulated.path(), 5);
    QDir(batch.folder.path()).mkpath("in/clipped");
    QDir(batch.folder.path()).mkpath("in/corrupt");
    QCOMPARE(runDyncal({"simulate", "-o", batch.path("in/clipped/shot.h5"), "--preset", "piezo",
                           "--duration-s", "0.003", "--sample-rate-hz", "1e7", "--shots", "low",
                           "--defect", "clip"},
                 kEpoch)
                 .exitCode,
        0);
    QVERIFY(writeBytes(
        batch.path("in/corrupt/shot.h5"), bytesOf(m_simulated.filePath("1.h5")).left(50000)));
    QCOMPARE(batch.plan().exitCode, 0);
    const Answer answer = batch.run({"--jobs", "2"});
    QCOMPARE(answer.exitCode, 2);
    QVERIFY2(answer.out.startsWith("7 sensors: 5 done, "), answer.out.constData());
    const Answer merged = runDyncal(
        {"batch", "merge", batch.path("night.jsonl"), "-o", batch.path("night.csv")}, kEpoch);
    QCOMPARE(merged.exitCode, 2);
    const QByteArrayList rows = bytesOf(batch.path("night.csv")).trimmed().split('\n');
    QCOMPARE(rows.size(), qsizetype(8));
    QVERIFY(rows[6].startsWith("clipped,"));
    QVERIFY2(!rows[6].startsWith("clipped,done"), rows[6].constData());
    QVERIFY2(rows[7].startsWith("corrupt,failed,"), rows[7].constData());
    for (int i = 1; i <= 5; ++i)
        QVERIFY(fileJson(batch.results(i) + "/results.json").contains("findings"));
    QVERIFY(
        fileJson(batch.path("night.out/clipped/calibration/results.json")).contains("findings"));
}

/// Every file but the record and the list that names it.
void TestBatch::results_areThoseOfRun()
{
    const BatchFolder batch;
    prepare(batch, true);
    QProcess run;
    run.setWorkingDirectory(batch.folder.path());
    run.setEnvironment(QProcess::systemEnvironment() + kEpoch);
    run.start(qEnvironmentVariable("DYNCAL_BINARY"),
        {"run", "in/SN-2", "--recipe", "quick.json", "-o", "plain"});
    QVERIFY(run.waitForFinished(240000));
    QCOMPARE(run.exitCode(), 0);
    const auto ofBatch = filesBelow(batch.results(2));
    const auto ofRun = filesBelow(batch.path("plain"));
    QVERIFY(ofRun.size() > 30);
    QCOMPARE(ofBatch.size(), ofRun.size() + 1);
    for (auto file = ofRun.begin(); file != ofRun.end(); ++file)
        if (file.key() != "written.json")
            QVERIFY2(ofBatch[file.key()].second == file.value().second, qPrintable(file.key()));
}

void TestBatch::shards_giveTheSameSummary()
{
    const BatchFolder whole;
    prepare(whole, true);
    const QByteArray expected = whole.summary();
    QVERIFY(expected.count('\n') == kSensors + 1);
    const BatchFolder parts;
    prepare(parts, false);
    QVERIFY(parts.summary().isEmpty()); // nothing is there yet
    for (const int shard : {4, 1, 3, 2})
        QCOMPARE(parts.run({"--shard", QString("%1/4").arg(shard), "--jobs", "1"}).exitCode, 0);
    QCOMPARE(parts.run({"--shard", "99/100"}).out.left(9), QByteArray("0 sensors"));
    QCOMPARE(parts.summary(), expected);
}

void TestBatch::again_keepsWhatIsComplete()
{
    const BatchFolder batch;
    prepare(batch, true);
    const auto before = filesBelow(batch.path("night.out"));
    const Answer again = batch.run();
    QCOMPARE(again.exitCode, 0);
    QVERIFY2(again.out.endsWith("Computed 0, kept 6\n"), again.out.constData());
    QVERIFY(filesBelow(batch.path("night.out")) == before);
}

void TestBatch::changedRecording_isComputedAgainAlone()
{
    const BatchFolder batch;
    prepare(batch, true);
    const QByteArray summary = batch.summary();
    const auto before = filesBelow(batch.path("night.out"));
    QVERIFY(QFile::remove(batch.path("in/SN-3/shot.h5")));
    QVERIFY(QFile::copy(m_simulated.filePath("5.h5"), batch.path("in/SN-3/shot.h5")));
    QCOMPARE(batch.plan().exitCode, 0);
    QCOMPARE(batch.status()["missing"].toInt(), 1);
    const Answer again = batch.run();
    QVERIFY2(again.out.endsWith("Computed 1, kept 5\n"), again.out.constData());
    const auto after = filesBelow(batch.path("night.out"));
    for (auto file = before.begin(); file != before.end(); ++file)
        QCOMPARE(after[file.key()] == file.value(), !file.key().startsWith("SN-3/"));
    QVERIFY(batch.summary() != summary);
}

void TestBatch::changedRecording_withoutANewPlan_isSaid()
{
    const BatchFolder batch;
    prepare(batch, true);
    QVERIFY(QFile::remove(batch.path("in/SN-3/shot.h5")));
    QVERIFY(QFile::copy(m_simulated.filePath("5.h5"), batch.path("in/SN-3/shot.h5")));
    const Answer again = batch.run();
    QCOMPARE(again.exitCode, 2);
    QVERIFY2(again.err.startsWith("SN-3: failed: in/SN-3/shot.h5 is not as it was"),
        again.err.constData());
    QCOMPARE(batch.status()["failed"].toInt(), 1);
    // As it was, it is what was planned again.
    QVERIFY(QFile::remove(batch.path("in/SN-3/shot.h5")));
    QVERIFY(QFile::copy(m_simulated.filePath("3.h5"), batch.path("in/SN-3/shot.h5")));
    QVERIFY(batch.run().out.endsWith("Computed 0, kept 6\n"));
    QCOMPARE(batch.status()["done"].toInt(), kSensors);
}

void TestBatch::changedRecipe_isComputedAgainWhereItIsUsed()
{
    const BatchFolder batch;
    batch.addSensors(m_simulated.path(), 3);
    const auto ofOrder = [](const char *order) {
        return QByteArray(
            R"({"realization": {"order": %1}, "uncertainty": {"monte_carlo_trials": 100}})")
            .replace("%1", order);
    };
    QVERIFY(writeBytes(batch.path("recipe.json"), ofOrder("2")));
    QVERIFY(writeBytes(batch.path("in/SN-2/recipe.json"), ofOrder("2")));
    const QStringList recipe{"--recipe", batch.path("recipe.json")};
    QCOMPARE(batch.plan(recipe).exitCode, 0);
    QVERIFY(batch.run().out.endsWith("Computed 3, kept 0\n"));
    QVERIFY(writeBytes(batch.path("recipe.json"), ofOrder("4")));
    const Answer unplanned = batch.run();
    QCOMPARE(unplanned.exitCode, 2);
    QVERIFY2(unplanned.out.startsWith("3 sensors: 1 done, 0 with cautions, 0 blocked, 2 failed"),
        unplanned.out.constData());
    QVERIFY(unplanned.err.contains("recipe.json is not as it was"));
    QCOMPARE(batch.plan(recipe).exitCode, 0);
    QVERIFY(batch.run().out.endsWith("Computed 2, kept 1\n"));
    QCOMPARE(fileJson(batch.results(1) + "/results.json").value("model")["order"].toInt(), 4);
    QCOMPARE(fileJson(batch.results(2) + "/results.json").value("model")["order"].toInt(), 2);
}

void TestBatch::otherMethods_areRefused()
{
    const BatchFolder batch;
    prepare(batch, true);
    const QByteArray plan = bytesOf(batch.path("night.jsonl"));
    QVERIFY(writeBytes(
        batch.path("night.jsonl"), QByteArray(plan).replace("\"window\":", "\"window\":9")));
    QCOMPARE(batch.status()["missing"].toInt(), kSensors);
    const Answer refused = batch.run();
    QCOMPARE(refused.exitCode, 4);
    QVERIFY(refused.err.contains("methods"));
    QCOMPARE(batch.plan().exitCode, 0);
    QCOMPARE(bytesOf(batch.path("night.jsonl")), plan);
    QVERIFY(batch.run().out.endsWith("Computed 0, kept 6\n"));
}

void TestBatch::damagedResults_areSetAsideAndComputedAgain()
{
    const BatchFolder batch;
    prepare(batch, true);
    const QByteArray summary = batch.summary();
    const QByteArray results = bytesOf(batch.results(4) + "/results.json");
    QVERIFY(writeBytes(batch.results(4) + "/results.json", "changed by hand"));
    QVERIFY(QFile::remove(batch.results(2) + "/certificate.pdf"));
    const Answer again = batch.run();
    QCOMPARE(again.exitCode, 0);
    QVERIFY2(again.out.endsWith("Computed 2, kept 4\n"), again.out.constData());
    QVERIFY(again.err.contains("SN-4: "));
    QVERIFY(again.err.contains("calibration.damaged-1"));
    QCOMPARE(bytesOf(batch.path("night.out/SN-4/calibration.damaged-1/results.json")),
        QByteArray("changed by hand"));
    QCOMPARE(bytesOf(batch.results(4) + "/results.json"), results);
    QVERIFY(QFile::exists(batch.results(2) + "/certificate.pdf"));
    QCOMPARE(batch.summary(), summary);
}

void TestBatch::otherMountPoint_givesTheSameSummary()
{
    const BatchFolder here;
    prepare(here, false);
    const BatchFolder there;
    QVERIFY(copyFolder(here.folder.path(), there.path("mnt/share")));
    QCOMPARE(here.run().exitCode, 0);
    const QString plan = there.path("mnt/share/night.jsonl");
    QCOMPARE(runDyncal({"batch", "run", plan}, {"SOURCE_DATE_EPOCH=1900000000"}).exitCode, 0);
    QCOMPARE(runDyncal({"batch", "merge", plan, "-o", there.path("there.csv")}).exitCode, 0);
    QCOMPARE(bytesOf(there.path("there.csv")), here.summary());
    // Results computed there are complete here: times differ, content does not.
    const BatchFolder back;
    QVERIFY(copyFolder(there.path("mnt/share"), back.folder.path()));
    QVERIFY(back.run().out.endsWith("Computed 0, kept 6\n"));
}

/// Whatever moment it is killed at.
void TestBatch::killedAtRandom_endsWithTheSameSummary()
{
    const BatchFolder whole;
    prepare(whole, true);
    const QByteArray expected = whole.summary();
    QVERIFY(QDir(whole.results(1)).removeRecursively());
    QElapsedTimer clock;
    clock.start();
    QCOMPARE(whole.run().exitCode, 0);
    const qint64 one_ms = clock.elapsed(); // of a run that has one sensor to do
    const BatchFolder batch;
    prepare(batch, false);
    QRandomGenerator random(20261);
    const int kills = dyncal::trials::count(4, 40);
    int early = 0;
    for (int kill = 0; kill < kills; ++kill) {
        // Something is to be done each time: one sensor begins anew.
        QDir(batch.path(QString("night.out/SN-%1").arg(1 + kill % kSensors))).removeRecursively();
        const auto before = filesBelow(batch.path("night.out"));
        QList<int> complete;
        for (int i = 1; i <= kSensors; ++i)
            if (QFile::exists(batch.results(i) + "/batch.json"))
                complete << i;
        QProcess process;
        start(process, batch);
        QVERIFY(process.waitForStarted());
        QTest::qWait(random.bounded(static_cast<int>(one_ms)));
        process.kill();
        QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished());
        early += process.exitStatus() == QProcess::CrashExit;
        const auto after = filesBelow(batch.path("night.out"));
        for (auto file = before.begin(); file != before.end(); ++file)
            for (const int i : complete)
                if (file.key().startsWith(QString("SN-%1/calibration/").arg(i)))
                    QVERIFY2(after[file.key()] == file.value(), qPrintable(file.key()));
    }
    QVERIFY2(early >= kills / 2, qPrintable(QString("%1 of %2").arg(early).arg(kills)));
    QCOMPARE(batch.run({"--jobs", "2"}).exitCode, 0);
    QCOMPARE(batch.summary(), expected);
    for (const QString &name : filesBelow(batch.path("night.out")).keys())
        QVERIFY2(!name.contains("damaged") && !name.contains("failed"), qPrintable(name));
}

/// One process is ended as the system does when memory runs out.
void TestBatch::killedSensor_stopsNoneOther()
{
    const BatchFolder batch;
    prepare(batch, false);
    QProcess process;
    start(process, batch);
    QVERIFY(process.waitForStarted());
    QList<qint64> children;
    QTRY_VERIFY_WITH_TIMEOUT(!(children = childrenOf(process.processId())).isEmpty(), 10000);
    ::kill(static_cast<pid_t>(children.first()), SIGKILL);
    QVERIFY(process.waitForFinished(240000));
    QCOMPARE(process.exitCode(), 2);
    const QByteArray err = process.readAllStandardError();
    QVERIFY2(err.contains(": failed: The process that computed it was ended by signal 9"),
        err.constData());
    QCOMPARE(batch.status()["done"].toInt(), kSensors - 1);
    QCOMPARE(batch.status()["failed"].toInt(), 1);
    const Answer again = batch.run();
    QCOMPARE(again.exitCode, 0);
    QVERIFY2(again.out.endsWith("Computed 1, kept 5\n"), again.out.constData());
    QCOMPARE(batch.status()["done"].toInt(), kSensors);
}

void TestBatch::interrupted_leavesWhatIsCompleteAndNothingElse()
{
    const BatchFolder batch;
    prepare(batch, false);
    QProcess process;
    start(process, batch);
    QVERIFY(process.waitForStarted());
    QVERIFY(waitUntilAwaited(process, SIGINT));
    QTRY_VERIFY_WITH_TIMEOUT(!childrenOf(process.processId()).isEmpty(), 10000);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 130);
    QCOMPARE(process.readAllStandardError(), QByteArray("Stopped on request.\n"));
    for (const QString &name : filesBelow(batch.path("night.out")).keys())
        QVERIFY2(!name.contains(".dyncal-") && !name.contains("failed.json"), qPrintable(name));
    QCOMPARE(batch.status()["failed"].toInt(), 0);
    QVERIFY(batch.status()["missing"].toInt() > 0);
    QCOMPARE(batch.run({"--jobs", "2"}).exitCode, 0);
}

void TestBatch::twoAtOnce_computeEachSensorOnce()
{
    const BatchFolder batch;
    prepare(batch, false);
    QProcess first, second;
    start(first, batch);
    start(second, batch);
    QVERIFY(first.waitForFinished(240000));
    QVERIFY(second.waitForFinished(240000));
    QCOMPARE(batch.status()["failed"].toInt(), 0);
    QCOMPARE(batch.status()["done"].toInt(), kSensors);
    for (const QString &name : filesBelow(batch.path("night.out")).keys())
        QVERIFY2(!name.contains("damaged"), qPrintable(name));
    QVERIFY(batch.run().out.endsWith("Computed 0, kept 6\n"));
}

void TestBatch::status_whileItRuns()
{
    const BatchFolder batch;
    prepare(batch, false);
    QCOMPARE(batch.status()["missing"].toInt(), kSensors);
    QProcess process;
    start(process, batch);
    int done = 0;
    while (process.state() != QProcess::NotRunning) {
        const QJsonObject now = batch.status();
        QCOMPARE(now["sensors"].toInt(), kSensors);
        QVERIFY(now["done"].toInt() >= done);
        done = now["done"].toInt();
        process.waitForFinished(100);
    }
    QCOMPARE(batch.status()["done"].toInt(), kSensors);
    QCOMPARE(batch.status()["not_done"].toArray().size(), 0);
}

void TestBatch::scripts_runTheBatch_data()
{
    QTest::addColumn<QString>("runner");
    QTest::addColumn<QStringList>("runWith");
    QTest::newRow("parallel") << "parallel" << QStringList{"sh"};
    QTest::newRow("make") << "make" << QStringList{"make", "-j2", "-f"};
}

/// Shards of the script run side by side by GNU parallel and by make; once more they do nothing.
void TestBatch::scripts_runTheBatch()
{
    QFETCH(QString, runner);
    QFETCH(QStringList, runWith);
    const BatchFolder batch;
    prepare(batch, false);
    const Answer script = runDyncal(
        {"batch", "script", batch.path("night.jsonl"), "--for", runner, "--shards", "4"});
    QCOMPARE(script.exitCode, 0);
    QVERIFY(writeBytes(batch.path("job"), script.out));
    for (int time = 0; time < 2; ++time) {
        const auto before = filesBelow(batch.path("night.out"));
        QProcess job;
        job.setEnvironment(QProcess::systemEnvironment()
            + QStringList{"DYNCAL=" + qEnvironmentVariable("DYNCAL_BINARY")} + kEpoch);
        job.start(runWith.first(), runWith.mid(1) + QStringList{batch.path("job")});
        QVERIFY(job.waitForFinished(240000));
        QVERIFY2(job.exitCode() == 0, job.readAllStandardError().constData());
        QCOMPARE(bytesOf(batch.path("night.csv")).count('\n'), kSensors + 1);
        if (time > 0)
            QVERIFY(filesBelow(batch.path("night.out")) == before);
    }
    QCOMPARE(batch.status()["done"].toInt(), kSensors);
}

void TestBatch::wrongUse_isSaid_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QByteArray>("said");
    const auto row
        = [](const char *name, const QStringList &arguments, int exitCode, const char *said) {
              QTest::newRow(name) << arguments << exitCode << QByteArray(said);
          };
    row("no part", {"batch"}, 4, "subcommand");
    row("unknown part", {"batch", "start"}, 4, "subcommand is required");
    row("no plan", {"batch", "run", "%1/none.jsonl"}, 3, "none.jsonl");
    row("plan is a recording", {"batch", "run", "%1/in/SN-1/shot.h5"}, 4, "Line 1");
    row("plan is a folder", {"batch", "status", "%1/in"}, 3, "%1/in");
    row("no shard", {"batch", "run", "%1/night.jsonl", "--shard", "5/4"}, 4, "5/4");
    row("no job", {"batch", "run", "%1/night.jsonl", "--jobs", "0"}, 4, "--jobs");
    row("no root", {"batch", "plan", "%1/none", "-o", "%1/x.jsonl"}, 3, "none");
    row("plan among recordings", {"batch", "plan", "%1/in", "-o", "%1/in/x.jsonl"}, 4, "below");
    row("plan over a recording", {"batch", "plan", "%1/in", "-o", "%1/other.h5"}, 4, "other.h5");
    row("no recipe", {"batch", "plan", "%1/in", "--recipe", "%1/none.json", "-o", "%1/x.jsonl"}, 3,
        "none.json");
    row("summary over a recording",
        {"batch", "merge", "%1/night.jsonl", "--partial", "-o", "%1/other.h5"}, 4, "other.h5");
    row("not all there", {"batch", "merge", "%1/night.jsonl", "-o", "%1/x.csv"}, 2, "missing");
    row("no such runner", {"batch", "script", "%1/night.jsonl", "--for", "pbs"}, 4, "pbs");
    row("too many shards",
        {"batch", "script", "%1/night.jsonl", "--for", "slurm", "--shards", "1001"}, 4, "--shards");
}

void TestBatch::wrongUse_isSaid()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QByteArray, said);
    const BatchFolder batch;
    batch.addSensors(m_simulated.path(), 1);
    QVERIFY(QFile::copy(m_simulated.filePath("1.h5"), batch.path("other.h5")));
    QCOMPARE(batch.plan().exitCode, 0);
    const auto before = filesBelow(batch.folder.path());
    arguments.replaceInStrings("%1", batch.folder.path());
    const Answer answer = runDyncal(arguments);
    QCOMPARE(answer.exitCode, exitCode);
    QCOMPARE(answer.out, QByteArray());
    QCOMPARE(answer.complaints().size(), 1);
    said.replace("%1", batch.folder.path().toUtf8());
    QVERIFY2(answer.err.contains(said), answer.err.constData());
    QVERIFY(filesBelow(batch.folder.path()) == before);
}

DYNCAL_TEST(TestBatch)
#include "tst_batch.moc"
