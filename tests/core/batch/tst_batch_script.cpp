// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_script.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/program_answer.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// A name that a shell and make would take apart unless it is quoted.
constexpr const char *kOdd = "/tmp/it's $HOME `x` \"y\" #z/ni ght.jsonl";

std::string scriptFor(
    BatchRunner runner, const std::string &plan = kOdd, std::size_t shards = 3, unsigned jobs = 2)
{
    return batchScript({runner, plan, "/tmp/it's $HOME.csv", shards, jobs}).value_or("(none)");
}

/// Programs that write down what they are called with instead of doing it, and a script.
struct PretendedPrograms
{
    ScratchFolder folder;

    PretendedPrograms()
    {
        program("dyncal", "printf '%s|' \"$@\" >> \"$LOG\"; echo >> \"$LOG\"");
        // sbatch: the job of an array is run for each of its numbers, as a cluster would.
        program("sbatch",
            "printf '%s|' sbatch \"$@\" >> \"$LOG\"; echo >> \"$LOG\"; cat > \"$JOB\"\n"
            "case \"$*\" in *--array=1-3*) for i in 1 2 3; do SLURM_ARRAY_TASK_ID=$i sh \"$JOB\"; done;;\n"
            "*) sh \"$JOB\";; esac; echo '4711;cluster'");
        // parallel: line by line, {} replaced.
        program("parallel",
            "while read -r n; do sh -c \"$(printf '%s' \"$1\" | sed \"s/{}/$n/g\")\"; done");
    }
    void program(const char *name, const std::string &text) const
    {
        writeText(folder.file(name), "#!/bin/sh\n" + text + "\n");
        fs::permissions(folder.file(name), fs::perms::owner_all);
    }
    /// What was called, line by line.
    QStringList calls(const std::string &script, const QString &runWith) const
    {
        writeText(folder.file("job"), script);
        const QString here = QString::fromStdString(folder.file(""));
        answerOf("/usr/bin/env",
            QStringList{"PATH=" + here + ":/usr/bin:/bin", "LOG=" + here + "log",
                "JOB=" + here + "submitted"}
                + runWith.split(' ') + QStringList{here + "job"});
        return QString::fromStdString(contentOf(folder.file("log")))
            .split('\n', Qt::SkipEmptyParts);
    }
};

QString runCall(int shard, const char *plan = kOdd)
{
    return QString("batch|run|%1|--shard|%2/3|--jobs|2|").arg(plan).arg(shard);
}

QString mergeCall()
{
    return QString("batch|merge|%1|--partial|-o|/tmp/it's $HOME.csv|").arg(kOdd);
}

} // namespace

/// Jobs for other machines, run here with programs that only write down their calls.
class TestBatchScript : public QObject
{
    Q_OBJECT

private slots:
    void slurm_submitsAnArrayAndTheMergeBehindIt();
    void parallel_runsAllShardsAndMerges();
    void make_runsAllShardsAndMerges();
    void make_goesOnAfterAShardFailed();
    void scripts_areValidForTheShell();
    void shards_areLimited();
    void runner_byName();
    void lineBreak_isRefused();
};

void TestBatchScript::slurm_submitsAnArrayAndTheMergeBehindIt()
{
    const PretendedPrograms programs;
    const QStringList calls = programs.calls(scriptFor(BatchRunner::Slurm), "sh");
    QCOMPARE(calls.size(), 6);
    QVERIFY(calls[0].startsWith("sbatch|"));
    QVERIFY(calls[0].contains("|--array=1-3|"));
    QVERIFY(calls[0].contains("|--cpus-per-task=2|"));
    for (int shard = 1; shard <= 3; ++shard)
        QCOMPARE(calls[shard], runCall(shard));
    QVERIFY(calls[4].contains("|--dependency=afterany:4711|"));
    QVERIFY(!calls[4].contains("--array"));
    QCOMPARE(calls[5], mergeCall());
}

void TestBatchScript::parallel_runsAllShardsAndMerges()
{
    const PretendedPrograms programs;
    QStringList calls = programs.calls(scriptFor(BatchRunner::Parallel), "sh");
    QCOMPARE(calls, QStringList({runCall(1), runCall(2), runCall(3), mergeCall()}));
}

void TestBatchScript::make_runsAllShardsAndMerges()
{
    const PretendedPrograms programs;
    QStringList calls = programs.calls(scriptFor(BatchRunner::Make), "make -f");
    QCOMPARE(calls, QStringList({runCall(1), runCall(2), runCall(3), mergeCall()}));
}

void TestBatchScript::make_goesOnAfterAShardFailed()
{
    const PretendedPrograms programs;
    programs.program("dyncal",
        "printf '%s|' \"$@\" >> \"$LOG\"; echo >> \"$LOG\"; case \"$*\" in *1/3*) exit 2;; esac");
    const QStringList calls = programs.calls(scriptFor(BatchRunner::Make), "make -f");
    QCOMPARE(calls.size(), 4);
    QCOMPARE(calls.last(), mergeCall());
}

void TestBatchScript::scripts_areValidForTheShell()
{
    const ScratchFolder folder;
    for (const BatchRunner runner : {BatchRunner::Slurm, BatchRunner::Parallel}) {
        writeText(folder.file("job"), scriptFor(runner));
        const ProgramAnswer answer
            = answerOf("sh", {"-n", QString::fromStdString(folder.file("job"))});
        QVERIFY2(answer.ran, answer.err.constData());
    }
}

void TestBatchScript::shards_areLimited()
{
    QCOMPARE(usualShards(0), std::size_t(1));
    QCOMPARE(usualShards(1), std::size_t(1));
    QCOMPARE(usualShards(60), std::size_t(3));
    QCOMPARE(usualShards(1000000), kMostShardsOfScript);
    QVERIFY(scriptFor(BatchRunner::Slurm, "p", usualShards(1000000)).find("--array=1-1000 ")
        != std::string::npos);
}

void TestBatchScript::runner_byName()
{
    QVERIFY(batchRunner("slurm") == BatchRunner::Slurm);
    QVERIFY(batchRunner("parallel") == BatchRunner::Parallel);
    QVERIFY(batchRunner("make") == BatchRunner::Make);
    for (const char *name : {"", "Slurm", "pbs"}) {
        const auto runner = batchRunner(name);
        QVERIFY(!runner);
        QCOMPARE(runner.error().kind, ErrorKind::Usage);
    }
}

void TestBatchScript::lineBreak_isRefused()
{
    for (const BatchScript &script : {BatchScript{BatchRunner::Make, "a\nb", "c", 1, 1},
             BatchScript{BatchRunner::Slurm, "a", "c\nd", 1, 1}}) {
        const auto refused = batchScript(script);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::Usage);
    }
}

DYNCAL_TEST(TestBatchScript)
#include "tst_batch_script.moc"
