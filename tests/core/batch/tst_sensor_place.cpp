// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/write_claim.h"
#include "core/batch/sensor_place.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// A folder with a plan's results of one sensor.
struct PlacedSensor
{
    ScratchFolder folder;
    PlannedSensor sensor = plannedSensor("a");
    std::string plan = folder.file("");
    fs::path output = fs::path(plan) / sensor.output;
    fs::path results = output / kCalibrationFolder;

    bool write(const std::string &text = "{}")
    {
        return writeResults(plan, sensor, doneRecord(sensor), text);
    }
    SensorState state() const { return recordOnDisk(plan, sensor).state; }
};

/// Ways in which a folder of results is no longer what was written.
struct Damage
{
    const char *name;
    void (*make)(const fs::path &results);
};

const Damage kDamages[] = {
    {"changed", [](const fs::path &r) { writeText(r / "results.json", "{ }"); }},
    {"cut", [](const fs::path &r) { fs::resize_file(r / "csv/poles.csv", 1); }},
    {"emptied", [](const fs::path &r) { fs::resize_file(r / "results.json", 0); }},
    {"one gone", [](const fs::path &r) { fs::remove(r / "csv/poles.csv"); }},
    {"record gone", [](const fs::path &r) { fs::remove(r / kBatchRecord); }},
    {"list gone", [](const fs::path &r) { fs::remove(r / kWrittenList); }},
    {"list is none", [](const fs::path &r) { writeText(r / kWrittenList, "[]"); }},
    {"a folder instead",
        [](const fs::path &r) {
            fs::remove(r / "results.json");
            fs::create_directory(r / "results.json");
        }},
    {"a link instead",
        [](const fs::path &r) {
            fs::rename(r / "results.json", r / "other.json");
            fs::create_symlink("other.json", r / "results.json");
        }},
    {"all gone",
        [](const fs::path &r) {
            fs::remove_all(r);
            fs::create_directory(r);
        }},
    {"a file instead",
        [](const fs::path &r) {
            fs::remove_all(r);
            writeText(r, "somebody's");
        }},
};

void addDamages()
{
    QTest::addColumn<int>("damage");
    for (int i = 0; i < static_cast<int>(std::size(kDamages)); ++i)
        QTest::newRow(kDamages[i].name) << i;
}

} // namespace

/// What the files of a sensor say.
class TestSensorPlace : public QObject
{
    Q_OBJECT

private slots:
    void nothingThere_isMissing();
    void written_isWhatTheRecordSays();
    void ofAnotherKey_isMissing();
    void unplanned_isFailedWithItsReason();
    void failure_isToldBeforeEarlierResults();
    void failure_isForgottenOnRequest();
    void failure_ofAnotherKey_doesNotCount();
    void failure_thatIsNotOurs_stays();
    void whole_afterWriting();
    void whole_withFurtherFiles();
    void damage_isSeenAndSetAside_data();
    void damage_isSeenAndSetAside();
    void damage_setAsideAgain_getsAnotherName();
    void damage_nothingIsSetAsideOfWhatIsWhole();
    void quickLook_seesWhatIsGone_data();
    void quickLook_seesWhatIsGone();
    void killedWrite_isPutRightFirst();
    void writingNow_isSeen();
    void paths_ofAPlan();
};

void TestSensorPlace::nothingThere_isMissing()
{
    const PlacedSensor one;
    const SensorOutcome record = recordOnDisk(one.plan, one.sensor);
    QCOMPARE(record.state, SensorState::Missing);
    QCOMPARE(record.key, sensorKey(one.sensor));
    QVERIFY(!plannedResults(one.plan, one.sensor));
    QVERIFY(!isWhole(one.results.string()));
    QVERIFY(!looksWhole(one.plan, one.sensor));
    QCOMPARE(setDamagedAside(one.output.string()).value(), std::string());
    QVERIFY(!fs::exists(one.output)); // looking makes nothing
}

void TestSensorPlace::written_isWhatTheRecordSays()
{
    PlacedSensor one;
    QVERIFY(one.write());
    QVERIFY(recordOnDisk(one.plan, one.sensor) == doneRecord(one.sensor));
    QVERIFY(plannedResults(one.plan, one.sensor) == doneRecord(one.sensor));
}

void TestSensorPlace::ofAnotherKey_isMissing()
{
    PlacedSensor one;
    QVERIFY(one.write());
    one.sensor.methods["model"] += 1;
    QCOMPARE(one.state(), SensorState::Missing);
    QVERIFY(!plannedResults(one.plan, one.sensor));
    QVERIFY(isWhole(one.results.string())); // old, but nothing is wrong with it
}

void TestSensorPlace::unplanned_isFailedWithItsReason()
{
    PlacedSensor one;
    QVERIFY(one.write());
    one.sensor.obstacle = "No recording.";
    const SensorOutcome record = recordOnDisk(one.plan, one.sensor);
    QCOMPARE(record.state, SensorState::Failed);
    QCOMPARE(record.reason, std::string("No recording."));
}

void TestSensorPlace::failure_isToldBeforeEarlierResults()
{
    PlacedSensor one;
    QVERIFY(keepFailure(one.plan, one.sensor, {"It crashed."}));
    QCOMPARE(one.state(), SensorState::Failed);
    QVERIFY(one.write());
    QVERIFY(keepFailure(one.plan, one.sensor, {"A recording changed."}));
    const SensorOutcome record = recordOnDisk(one.plan, one.sensor);
    QCOMPARE(record.state, SensorState::Failed);
    QCOMPARE(record.reason, std::string("A recording changed."));
    QVERIFY(plannedResults(one.plan, one.sensor));
    QVERIFY(isWhole(one.results.string()));
}

void TestSensorPlace::failure_isForgottenOnRequest()
{
    PlacedSensor one;
    forgetFailure(one.plan, one.sensor); // none there
    QVERIFY(one.write());
    QVERIFY(keepFailure(one.plan, one.sensor, {"It crashed."}));
    forgetFailure(one.plan, one.sensor);
    QCOMPARE(one.state(), SensorState::Done);
    QVERIFY(!fs::exists(one.output / kFailureRecord));
}

void TestSensorPlace::failure_ofAnotherKey_doesNotCount()
{
    PlacedSensor one;
    QVERIFY(keepFailure(one.plan, one.sensor, {"It crashed."}));
    one.sensor.recipeSha256 = sha256Hex(std::string_view("another"));
    QCOMPARE(one.state(), SensorState::Missing);
}

void TestSensorPlace::failure_thatIsNotOurs_stays()
{
    PlacedSensor one;
    QVERIFY(one.write());
    writeText(one.output / kFailureRecord, "{\"mine\": true}");
    forgetFailure(one.plan, one.sensor);
    QVERIFY(fs::exists(one.output / kFailureRecord));
    QCOMPARE(one.state(), SensorState::Done);
}

void TestSensorPlace::whole_afterWriting()
{
    PlacedSensor one;
    QVERIFY(one.write());
    QVERIFY(isWhole(one.results.string()));
    QVERIFY(looksWhole(one.plan, one.sensor));
    QVERIFY(one.write("{\"again\": 1}"));
    QVERIFY(isWhole(one.results.string()));
}

void TestSensorPlace::whole_withFurtherFiles()
{
    PlacedSensor one;
    QVERIFY(one.write());
    writeText(one.results / "notes.txt", "seen by somebody");
    QVERIFY(isWhole(one.results.string()));
    QVERIFY(one.write("{\"again\": 1}"));
    QCOMPARE(contentOf((one.results / "notes.txt").string()), std::string("seen by somebody"));
}

void TestSensorPlace::damage_isSeenAndSetAside_data()
{
    addDamages();
}

/// Found, under another name as it was, and the place is free for new results.
void TestSensorPlace::damage_isSeenAndSetAside()
{
    QFETCH(int, damage);
    PlacedSensor one;
    QVERIFY(one.write());
    kDamages[damage].make(one.results);
    const bool wasFolder = fs::is_directory(one.results);
    QVERIFY(!isWhole(one.results.string()));
    const Result<std::string> aside = setDamagedAside(one.output.string());
    QVERIFY(aside);
    QCOMPARE(*aside, (one.output / "calibration.damaged-1").string());
    QVERIFY(!fs::exists(one.results));
    QCOMPARE(fs::is_directory(*aside), wasFolder);
    QCOMPARE(one.state(), SensorState::Missing);
    QVERIFY(one.write());
    QCOMPARE(one.state(), SensorState::Done);
    QVERIFY(fs::exists(*aside));
}

void TestSensorPlace::damage_setAsideAgain_getsAnotherName()
{
    PlacedSensor one;
    for (int number = 1; number <= 3; ++number) {
        QVERIFY(one.write());
        writeText(one.results / "results.json", "damage " + std::to_string(number));
        const Result<std::string> aside = setDamagedAside(one.output.string());
        QVERIFY(aside);
        QVERIFY(aside->ends_with("calibration.damaged-" + std::to_string(number)));
    }
    for (int number = 1; number <= 3; ++number)
        QCOMPARE(contentOf((one.output / ("calibration.damaged-" + std::to_string(number))
                     / "results.json")
                               .string()),
            "damage " + std::to_string(number));
}

void TestSensorPlace::damage_nothingIsSetAsideOfWhatIsWhole()
{
    PlacedSensor one;
    QVERIFY(one.write());
    const auto before = fs::last_write_time(one.results / "results.json");
    QCOMPARE(setDamagedAside(one.output.string()).value(), std::string());
    QVERIFY(fs::last_write_time(one.results / "results.json") == before);
    QCOMPARE(one.state(), SensorState::Done);
}

void TestSensorPlace::quickLook_seesWhatIsGone_data()
{
    addDamages();
}

/// It hashes the record only, so a changed table is left to isWhole().
void TestSensorPlace::quickLook_seesWhatIsGone()
{
    QFETCH(int, damage);
    const std::string name = kDamages[damage].name;
    PlacedSensor one;
    QVERIFY(one.write());
    kDamages[damage].make(one.results);
    const bool isOnlyInContent = name == "changed" || name == "cut" || name == "emptied"
        || name == "a folder instead" || name == "a link instead";
    QCOMPARE(looksWhole(one.plan, one.sensor), isOnlyInContent);
}

/// A writer that was killed between its claim and its end leaves its claim and staging folder.
void TestSensorPlace::killedWrite_isPutRightFirst()
{
    PlacedSensor one;
    QVERIFY(one.write());
    Result<WriteClaim> claim
        = WriteClaim::take(one.output.string(), kCalibrationFolder, ClaimKind::Folder, "shown");
    QVERIFY(claim);
    const fs::path staging = one.output / claim->temporary();
    fs::create_directory(staging);
    writeText(staging / "tree/results.json", "half");
    claim->leaveBehind();
    QCOMPARE(setDamagedAside(one.output.string()).value(), std::string());
    QVERIFY(!fs::exists(staging));
    QVERIFY(isWhole(one.results.string()));
    QCOMPARE(one.state(), SensorState::Done);
}

void TestSensorPlace::writingNow_isSeen()
{
    PlacedSensor one;
    QVERIFY(one.write());
    QVERIFY(!isBeingComputed(one.output.string()));
    QVERIFY(!isBeingComputed((one.output / "none").string()));
    const Result<WriteClaim> claim
        = WriteClaim::take(one.output.string(), kCalibrationFolder, ClaimKind::Folder, "shown");
    QVERIFY(claim);
    QVERIFY(isBeingComputed(one.output.string()));
    const Result<std::string> aside = setDamagedAside(one.output.string());
    QVERIFY(!aside);
    QCOMPARE(aside.error().kind, ErrorKind::Usage);
}

void TestSensorPlace::paths_ofAPlan()
{
    QCOMPARE(pathOfPlan(".", "in/a"), std::string("in/a"));
    QCOMPARE(pathOfPlan("x/y", "in/a"), std::string("x/y/in/a"));
    QCOMPARE(pathOfPlan("x/y", "/in/a"), std::string("/in/a"));
}

DYNCAL_TEST(TestSensorPlace)
#include "tst_sensor_place.moc"
