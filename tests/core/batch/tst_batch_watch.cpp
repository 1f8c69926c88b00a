// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/write_claim.h"
#include "core/batch/batch_files.h"
#include "core/batch/batch_planning.h"
#include "core/batch/batch_watch.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// Done, failed, missing, not planned; and the plan that says so.
struct WatchedBatch
{
    ScratchFolder folder;
    std::string path = folder.file("night.jsonl");
    BatchPlan plan{plannedSensor("done"), plannedSensor("failed"), plannedSensor("missing"),
        plannedSensor("other")};

    WatchedBatch()
    {
        plan[3].obstacle = "No recording.";
        const bool isWritten = writePlanFile(path, plan).has_value()
            && writeResults(folder.file(""), plan[0], doneRecord(plan[0]))
            && keepFailure(folder.file(""), plan[1], {"It crashed."}).has_value();
        if (!isWritten)
            qFatal("The batch of the test could not be written.");
    }
    BatchMoment now(const BatchMoment &before = {}) const
    {
        return batchNow(path, before).value_or(BatchMoment());
    }
    Result<WriteClaim> claim(std::size_t sensor) const
    {
        const fs::path output = folder.file(plan[sensor].output);
        fs::create_directories(output);
        return WriteClaim::take(output.string(), kCalibrationFolder, ClaimKind::Folder, "shown");
    }
};

SensorNow sensorOf(SensorState state, std::vector<Severity> severities = {}, bool isRunning = false)
{
    SensorNow sensor;
    sensor.standing.record.state = state;
    sensor.isRunning = isRunning;
    for (const Severity severity : severities)
        sensor.standing.record.findings.push_back({"WIN-001", severity, 0});
    return sensor;
}

} // namespace

/// What a batch looks like at one moment.
class TestBatchWatch : public QObject
{
    Q_OBJECT

private slots:
    void states_areThoseOfTheStatus()
    {
        const WatchedBatch batch;
        const BatchMoment now = batch.now();
        const auto standings = standingsOf(batch.folder.file(""), batch.plan);
        QCOMPARE(now.sensors.size(), standings.size());
        for (std::size_t i = 0; i < standings.size(); ++i) {
            QVERIFY(now.sensors[i].standing == standings[i]);
            QVERIFY(!now.sensors[i].isRunning);
        }
        QCOMPARE(tallyText(tallyOf(now)),
            std::string("4 sensors: 1 done, 0 with cautions, 0 blocked, 2 failed, 1 missing"));
    }

    /// A claim of any program says that a sensor is computed; results that stand are never asked.
    void running_isSeenOfWhatIsMissingOrFailed()
    {
        const WatchedBatch batch;
        const Result<WriteClaim> claims[]{batch.claim(0), batch.claim(1), batch.claim(2)};
        QVERIFY(std::ranges::all_of(claims, [](const auto &claim) { return claim.has_value(); }));
        const BatchMoment now = batch.now();
        QVERIFY(!now.sensors[0].isRunning);
        QVERIFY(now.sensors[1].isRunning);
        QVERIFY(now.sensors[2].isRunning);
        QVERIFY(!now.sensors[3].isRunning);
        QVERIFY(now.sensors[2].standing.record.state == SensorState::Missing);
    }

    void plan_isReadAgainOnlyWhenItsFileChanged()
    {
        const WatchedBatch batch;
        const BatchMoment first = batch.now();
        const BatchMoment second = batch.now(first);
        QVERIFY(first.plan == second.plan);
        QCOMPARE(second.sensors.size(), std::size_t(4));
        QVERIFY(writePlanFile(batch.path, {batch.plan[2], batch.plan[0]}));
        const BatchMoment third = batch.now(second);
        QVERIFY(third.plan != first.plan);
        QCOMPARE(third.sensors.size(), std::size_t(2));
        QCOMPARE(third.sensors[1].standing.id, std::string("done"));
        QVERIFY(third.sensors[1].standing.record.state == SensorState::Done);
    }

    void planThatIsGone_isSaid()
    {
        const WatchedBatch batch;
        const BatchMoment first = batch.now();
        fs::remove(batch.path);
        const Result<BatchMoment> now = batchNow(batch.path, first);
        QVERIFY(!now);
        QCOMPARE(now.error().kind, ErrorKind::FileUnreadable);
    }

    void stopped_isCancelled()
    {
        const WatchedBatch batch;
        std::stop_source stop;
        stop.request_stop();
        const Result<BatchMoment> now = batchNow(batch.path, {}, {stop.get_token(), {}});
        QVERIFY(!now);
        QCOMPARE(now.error().kind, ErrorKind::Cancelled);
    }

    /// In every order of the same sensors the worst is first, and none is worse than itself.
    void worse_isAStrictOrder()
    {
        using enum SensorState;
        using enum Severity;
        const std::vector<SensorNow> sorted{sensorOf(Failed), sensorOf(Blocked, {Block, Block}),
            sensorOf(Blocked, {Block, Caution}), sensorOf(Blocked, {Block}),
            sensorOf(Cautions, {Caution, Caution}), sensorOf(Cautions, {Info, Info, Caution}),
            sensorOf(Failed, {}, true), sensorOf(Missing), sensorOf(Done, {Info})};
        for (std::size_t i = 0; i < sorted.size(); ++i)
            for (std::size_t j = 0; j < sorted.size(); ++j)
                QCOMPARE(isWorse(sorted[i], sorted[j]), i < j);
        QVERIFY(!isWorse(sensorOf(Done, {Info}), sensorOf(Done)));
        QVERIFY(!isWorse(sensorOf(Done), sensorOf(Done, {Info})));
    }

    void worstFinding_isTheFirstOfTheWorst()
    {
        SensorOutcome record;
        QVERIFY(!worstFinding(record));
        record.findings = {{"CAP-017", Severity::Info, 0}, {"WIN-001", Severity::Caution, 2},
            {"MOD-001", Severity::Caution, 1}};
        QCOMPARE(worstFinding(record)->id, std::string("WIN-001"));
        QCOMPARE(worstFinding(record)->shot, Index(2));
        record.findings.push_back({"CAP-001", Severity::Block, 3});
        QCOMPARE(worstFinding(record)->id, std::string("CAP-001"));
    }

    void methods_ofAPlan()
    {
        BatchPlan plan{plannedSensor("a"), plannedSensor("b")};
        plan[0].methods = plan[1].methods = methodVersions();
        QVERIFY(checkMethods(plan));
        plan[1].methods["model"] += 1;
        const Result<void> refused = checkMethods(plan);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::Usage);
        QCOMPARE(refused.error().message.arguments, std::vector<std::string>{"b"});
        plan[1].obstacle = "No recording.";
        QVERIFY(checkMethods(plan));
    }
};

DYNCAL_TEST(TestBatchWatch)
#include "tst_batch_watch.moc"
