// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/recording_search.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// A run whose recordings had these names and these seeds of content.
EarlierRun runOf(
    const ScratchFolder &scratch, const std::vector<std::pair<std::string, int>> &recordings)
{
    EarlierRun run;
    run.folder = scratch.file("lab/out");
    std::filesystem::create_directories(run.folder);
    for (const auto &[name, seed] : recordings)
        run.inputs.push_back({name, sha256Hex(std::string_view(recordingBytes(seed)))});
    return run;
}

std::vector<std::string> foundIn(const ScratchFolder &scratch, const EarlierRun &run,
    const std::vector<std::string> &folders = {})
{
    std::vector<std::string> paths;
    for (const std::string &folder : folders)
        paths.push_back(scratch.file(folder));
    auto search = RecordingSearch::in(paths);
    if (!search)
        return {english(search.error().message)};
    const auto found = search->find(run);
    if (found)
        return *found;
    std::vector<std::string> why{english(found.error().message)};
    for (const Error &further : found.error().further)
        why.push_back(english(further.message));
    return why;
}

using Paths = std::vector<std::string>;

} // namespace

class TestRecordingSearch : public QObject
{
    Q_OBJECT

private slots:
    void places_areTheFolder_besideIt_andTheGivenOnes_data()
    {
        QTest::addColumn<QString>("place");
        for (const char *place : {"lab/out/a.csv", "lab/out/sources/a.csv", "lab/a.csv",
                 "archive/a.csv", "archive/2025/deep/a.csv"})
            QTest::newRow(place) << QString(place);
    }
    void places_areTheFolder_besideIt_andTheGivenOnes()
    {
        QFETCH(QString, place);
        const ScratchFolder scratch;
        const std::string path = put(scratch, place.toStdString(), recordingBytes(1));
        std::filesystem::create_directories(scratch.file("archive"));
        QCOMPARE(foundIn(scratch, runOf(scratch, {{"a.csv", 1}}), {"archive"}), Paths{path});
    }

    void elsewhere_isNotLookedAt()
    {
        const ScratchFolder scratch;
        put(scratch, "lab/other/a.csv", recordingBytes(1)); // below what is beside
        put(scratch, "a.csv", recordingBytes(1));
        put(scratch, "archive/.hidden/a.csv", recordingBytes(1));
        const Paths why = foundIn(scratch, runOf(scratch, {{"a.csv", 1}}), {"archive"});
        QVERIFY2(why.front().find("was not found there nor beside") != std::string::npos,
            why.front().c_str());
    }

    void renamed_isFoundByContent()
    {
        const ScratchFolder scratch;
        put(scratch, "archive/other.csv", recordingBytes(5));
        const std::string path = put(scratch, "archive/night shift.bin", recordingBytes(1));
        QCOMPARE(foundIn(scratch, runOf(scratch, {{"a.csv", 1}}), {"archive"}), Paths{path});
    }

    void nameAlone_isNoProof()
    {
        const ScratchFolder scratch;
        put(scratch, "archive/1/a.csv", recordingBytes(5));
        const std::string path = put(scratch, "archive/2/a.csv", recordingBytes(1));
        QCOMPARE(foundIn(scratch, runOf(scratch, {{"a.csv", 1}}), {"archive"}), Paths{path});
    }

    void several_comeInTheirOrder()
    {
        const ScratchFolder scratch;
        const std::string a = put(scratch, "archive/a.csv", recordingBytes(1));
        const std::string b = put(scratch, "archive/b.csv", recordingBytes(2));
        const std::string c = put(scratch, "archive/x.csv", recordingBytes(3));
        QCOMPARE(foundIn(scratch, runOf(scratch, {{"c.csv", 3}, {"a.csv", 1}, {"b.csv", 2}}),
                     {"archive"}),
            (Paths{c, a, b}));
    }

    void oneSearch_servesManyRuns()
    {
        const ScratchFolder scratch;
        Paths paths;
        for (int i = 0; i < 5; ++i)
            paths.push_back(
                put(scratch, "archive/x" + std::to_string(i) + ".csv", recordingBytes(i)));
        auto search = RecordingSearch::in({scratch.file("archive")});
        QVERIFY(search.has_value());
        for (int i : {4, 0, 3, 1, 2, 4}) {
            const auto found = search->find(runOf(scratch, {{"a.csv", i}}));
            QVERIFY(found.has_value());
            QCOMPARE(found->front(), paths[static_cast<std::size_t>(i)]);
        }
    }

    void missing_isNamedWithItsHash()
    {
        const ScratchFolder scratch;
        const Paths why = foundIn(scratch, runOf(scratch, {{"a.csv", 1}, {"b.csv", 2}}));
        QCOMPARE(why.size(), std::size_t(2)); // both are told
        QVERIFY(why[0].starts_with("The recording a.csv (SHA-256 "));
        QVERIFY(why[0].find(sha256Hex(std::string_view(recordingBytes(1)))) != std::string::npos);
        QVERIFY(why[0].find("with --recordings") != std::string::npos);
        QVERIFY(why[1].starts_with("The recording b.csv"));
    }

    void changed_isNamedWithBothHashes()
    {
        const ScratchFolder scratch;
        const std::string path = put(scratch, "lab/a.csv", recordingBytes(7));
        const std::string why = foundIn(scratch, runOf(scratch, {{"a.csv", 1}})).front();
        QVERIFY2(why.starts_with("The recording " + path), why.c_str());
        QVERIFY(why.find("was changed since") != std::string::npos);
        for (int seed : {1, 7})
            QVERIFY(
                why.find(sha256Hex(std::string_view(recordingBytes(seed)))) != std::string::npos);
    }

    void noFolder_isAnError()
    {
        const ScratchFolder scratch;
        put(scratch, "file", "x");
        for (const char *name : {"file", "nowhere"}) {
            const auto search = RecordingSearch::in({scratch.file(name)});
            QVERIFY(!search && search.error().kind == ErrorKind::FileUnreadable);
            QVERIFY(english(search.error().message).find("is no folder of recordings")
                != std::string::npos);
        }
    }

    void request_stopsTheSearch()
    {
        const ScratchFolder scratch;
        put(scratch, "lab/a.csv", recordingBytes(1));
        auto search = RecordingSearch::in({});
        std::stop_source stop;
        stop.request_stop();
        const auto found = search->find(runOf(scratch, {{"a.csv", 1}}), {stop.get_token(), {}});
        QVERIFY(!found && found.error().kind == ErrorKind::Cancelled);
        QVERIFY(search->find(runOf(scratch, {{"a.csv", 1}})).has_value()); // nothing half is kept
    }
};

DYNCAL_TEST(TestRecordingSearch)
#include "tst_recording_search.moc"
