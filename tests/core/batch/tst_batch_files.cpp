// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_files.h"
#include "core/batch/batch_summary.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// Done, failed, missing, not planned.
struct FourSensors
{
    ScratchFolder folder;
    BatchPlan plan{plannedSensor("done"), plannedSensor("failed"), plannedSensor("missing"),
        plannedSensor("other")};

    FourSensors()
    {
        plan[3].obstacle = "No recording.";
        const bool isWritten = writeResults(folder.file(""), plan[0], doneRecord(plan[0]))
            && keepFailure(folder.file(""), plan[1], {"It crashed."}).has_value();
        if (!isWritten)
            qFatal("The results of the test could not be written.");
    }
};

QList<SensorState> statesOf(const std::vector<SensorStanding> &standings)
{
    QList<SensorState> states;
    for (const SensorStanding &standing : standings)
        states << standing.record.state;
    return states;
}

} // namespace

/// Plan and summary as files, and what a summary is made from.
class TestBatchFiles : public QObject
{
    Q_OBJECT

private slots:
    void standings_areInTheOrderOfThePlan();
    void merge_needsAll();
    void merge_ofPart();
    void merge_ofResultsThatAreGone_isMissing();
    void summary_isReplacedByASummaryOnly();
    void plan_isReplacedByAPlanOnly();
    void linksAndFolders_areNotReplaced();
    void summary_cannotBeWritten_isSaid();
};

void TestBatchFiles::standings_areInTheOrderOfThePlan()
{
    const FourSensors four;
    const auto standings = standingsOf(four.folder.file(""), four.plan);
    using enum SensorState;
    QCOMPARE(statesOf(standings), QList<SensorState>({Done, Failed, Missing, Failed}));
    QCOMPARE(standings[3].record.reason, std::string("No recording."));
    QCOMPARE(standings[2].id, std::string("missing"));
}

void TestBatchFiles::merge_needsAll()
{
    FourSensors four;
    const auto refused = standingsToMerge(four.folder.file(""), four.plan, false);
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, ErrorKind::DataBlocked);
    QVERIFY(english(refused.error().message)
                .starts_with("1 of 4 sensors are missing, the first is missing"));
    QVERIFY(writeResults(four.folder.file(""), four.plan[2], doneRecord(four.plan[2])));
    QVERIFY(standingsToMerge(four.folder.file(""), four.plan, false));
}

void TestBatchFiles::merge_ofPart()
{
    const FourSensors four;
    const auto standings = standingsToMerge(four.folder.file(""), four.plan, true);
    QVERIFY(standings);
    using enum SensorState;
    QCOMPARE(statesOf(*standings), QList<SensorState>({Done, Failed, Missing, Failed}));
}

void TestBatchFiles::merge_ofResultsThatAreGone_isMissing()
{
    const FourSensors four;
    fs::remove(four.folder.file("plan.out/done/calibration/results.json"));
    const auto standings = standingsToMerge(four.folder.file(""), four.plan, true);
    QVERIFY(standings);
    QCOMPARE(standings->front().record.state, SensorState::Missing);
    QVERIFY(standings->front().record.results.empty());
}

void TestBatchFiles::summary_isReplacedByASummaryOnly()
{
    const FourSensors four;
    const auto standings = standingsOf(four.folder.file(""), four.plan);
    const std::string path = four.folder.file("night.csv");
    QVERIFY(writeSummaryFile(path, {}));
    QVERIFY(writeSummaryFile(path, standings));
    QCOMPARE(contentOf(path), batchSummaryCsv(standings));
    writeText(path, "time,dut\n0,1\n");
    const Result<void> refused = writeSummaryFile(path, standings);
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, ErrorKind::Usage);
    QCOMPARE(contentOf(path), std::string("time,dut\n0,1\n"));
}

void TestBatchFiles::plan_isReplacedByAPlanOnly()
{
    const FourSensors four;
    const std::string path = four.folder.file("night.jsonl");
    QVERIFY(writePlanFile(path, {four.plan[0]}));
    QVERIFY(writePlanFile(path, four.plan));
    const Result<BatchPlan> read = readPlan(path);
    QVERIFY(read);
    QVERIFY(read->size() == four.plan.size());
    writeRecording(path, 1);
    QVERIFY(!writePlanFile(path, four.plan));
    QCOMPARE(contentOf(path), recordingText(1));
}

void TestBatchFiles::linksAndFolders_areNotReplaced()
{
    const FourSensors four;
    fs::create_symlink("nowhere", four.folder.file("link.jsonl"));
    fs::create_directory(four.folder.file("folder.jsonl"));
    for (const char *name : {"link.jsonl", "folder.jsonl"})
        QVERIFY(!writePlanFile(four.folder.file(name), four.plan));
    QVERIFY(fs::is_symlink(four.folder.file("link.jsonl")));
}

void TestBatchFiles::summary_cannotBeWritten_isSaid()
{
    const FourSensors four;
    const Result<void> refused = writeSummaryFile(four.folder.file("none/night.csv"), {});
    QVERIFY(!refused);
    QVERIFY(english(refused.error().message).find("night.csv") != std::string::npos);
}

DYNCAL_TEST(TestBatchFiles)
#include "tst_batch_files.moc"
