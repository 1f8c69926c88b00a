// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/earlier_calibration.h"
#include "tests/core/history/made_history.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

EarlierCalibration of(const EarlierJson &root)
{
    return earlierCalibration({"a/results.json", root, "hash", {}}).value();
}

} // namespace

/// One results.json as a point of a history.
class TestEarlierCalibration : public QObject
{
    Q_OBJECT

private slots:
    void calibration_isWhatTheResultsSay();
    void day_isThatOfTheCalibration_elseOfTheResults();
    void withoutAnyTime_isRefused();
    void blocked_isSaid();
    void recordings_areKnownAllOrNone();
    void methods_mayNotBeRecorded();
    void paths_standForAllResultsBelow();
    void everyResult_isListedOnce();
    void folderWithoutResults_isRefused();
};

void TestEarlierCalibration::calibration_isWhatTheResultsSay()
{
    EarlierResults read = madeRead({.day = "2025-03-01", .serial = "  4711 "}, "c/results.json");
    read.remarks.push_back({"remark", {}});
    const auto one = earlierCalibration(read, 12);
    QVERIFY(one.has_value());
    QCOMPARE(one->file, std::string("c/results.json"));
    QCOMPARE(one->number, Index(12));
    QCOMPARE(one->serial, std::string("4711"));
    QCOMPARE(one->time, std::string("2025-03-01"));
    QCOMPARE(one->createdUtc, std::string("2026-06-01T00:00:00Z"));
    QVERIFY(one->methods == methodVersions());
    QCOMPARE(one->blocked, std::string());
    QCOMPARE(one->recordings.size(), std::size_t(1));
    QCOMPARE(one->remarks.size(), std::size_t(1));
    QVERIFY(one->results == read.results);
}

void TestEarlierCalibration::day_isThatOfTheCalibration_elseOfTheResults()
{
    const EarlierCalibration typed = madeCalibration({.day = "1970-01-03"});
    QVERIFY(typed.isDayOfCalibration);
    QCOMPARE(typed.day, 2.5); // its noon
    for (const char *none : {"", "last week", "2025-02-30", "03.01.1970"}) {
        EarlierJson root = madeResults({.day = none});
        root["created_utc"] = "1970-01-02T18:00:00Z";
        const EarlierCalibration created = of(root);
        QVERIFY(!created.isDayOfCalibration);
        QCOMPARE(created.time, std::string("1970-01-02T18:00:00Z"));
        QCOMPARE(created.day, 1.75);
    }
}

void TestEarlierCalibration::withoutAnyTime_isRefused()
{
    for (const EarlierJson &odd : {EarlierJson(), EarlierJson("yesterday"), EarlierJson(3),
             EarlierJson("2026-13-01T00:00:00Z")}) {
        EarlierJson root = madeResults({});
        root["created_utc"] = odd;
        const auto none = earlierCalibration({"a/results.json", root, "hash", {}});
        QVERIFY(!none);
        QCOMPARE(none.error().kind, ErrorKind::Usage);
        const std::string sentence = english(none.error().message);
        QVERIFY(sentence.starts_with("a/results.json does not say when"));
        QVERIFY(sentence.find("no day of calibration") != std::string::npos);
    }
}

void TestEarlierCalibration::blocked_isSaid()
{
    EarlierJson root = madeResults({.day = "2025-03-01"});
    root["findings"] = {{{"id", "SHK-001"}, {"severity", "block"}, {"message", "No step."}}};
    QCOMPARE(of(root).blocked, std::string("SHK-001: No step."));
}

void TestEarlierCalibration::recordings_areKnownAllOrNone()
{
    EarlierJson root = withInputs(madeResults({.day = "2025-03-01"}), {{"b", "2"}, {"a", "1"}});
    const EarlierJson other
        = withInputs(madeResults({.day = "2025-04-01"}), {{"c", "1"}, {"d", "2"}});
    QCOMPARE(of(root).recordings.size(), std::size_t(2));
    QVERIFY(of(root).recordings == of(other).recordings); // by content, in whatever order
    root["inputs"][0].erase("sha256");
    QVERIFY(of(root).recordings.empty());
    root["inputs"] = "none";
    QVERIFY(of(root).recordings.empty());
    root.erase("inputs");
    QVERIFY(of(root).recordings.empty());
}

void TestEarlierCalibration::methods_mayNotBeRecorded()
{
    EarlierJson root = madeResults({.day = "2025-03-01"});
    root["software"].erase("method");
    QVERIFY(!of(root).methods);
}

void TestEarlierCalibration::paths_standForAllResultsBelow()
{
    const ScratchFolder scratch;
    for (const char *folder : {"issued/10", "issued/9", "issued/.new", "run"})
        putResults(scratch, folder, madeResults({.day = "2025-03-01"}));
    put(scratch, "kept.json", "{}");
    const auto files = resultsFilesOf({scratch.file("issued"), scratch.file("kept.json"),
        scratch.file("run"), scratch.file("is not there")});
    QVERIFY(files.has_value());
    const std::vector<std::string> needed{scratch.file("issued/9/results.json"),
        scratch.file("issued/10/results.json"), scratch.file("kept.json"),
        scratch.file("run/results.json"), scratch.file("is not there")};
    QVERIFY(*files == needed);
}

void TestEarlierCalibration::everyResult_isListedOnce()
{
    const ScratchFolder scratch;
    putResults(scratch, "a/b", madeResults({.day = "2025-03-01"}));
    const auto files = resultsFilesOf({scratch.file("a/b/results.json"), scratch.file("a"),
        scratch.file("a/../a/b"), scratch.file("a/b")});
    QCOMPARE(files->size(), std::size_t(1));
}

void TestEarlierCalibration::folderWithoutResults_isRefused()
{
    const ScratchFolder scratch;
    put(scratch, "empty/note.txt", "nothing");
    const auto none = resultsFilesOf({scratch.file("empty")});
    QVERIFY(!none);
    QCOMPARE(none.error().kind, ErrorKind::FileUnreadable);
}

DYNCAL_TEST(TestEarlierCalibration)
#include "tst_earlier_calibration.moc"
