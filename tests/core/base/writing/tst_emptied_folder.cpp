// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the next program makes of a write that was interrupted: nothing of anybody's is lost.

#include "core/base/writing/folder_recovery.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/base/writing/folder_plan.h"

#include <QTest>

#include <sys/stat.h>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

WrittenFile ours(const std::string &name, const std::string &content)
{
    return {name, "run", sha256Hex(content)};
}

bool mayWrite(const std::string &name)
{
    return name == "results";
}

ino_t inodeOf(const fs::path &path)
{
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

const WrittenList kRetired{ours("results", "old"), ours("csv/a", "old a"), ours("csv/b", "old b")};

/// The old folder as the exchange left it, and the new one in its place.
struct Exchanged
{
    Exchanged()
    {
        put(old / "results", "old");
        put(old / "csv/a", "old a");
        put(folder / "results", "new");
        put(folder / "csv/a", "new a");
        put(folder / "notes", "theirs");
        fs::create_hard_link(folder / "notes", old / "notes");
    }
    bool empty() const { return emptyOldTree(opened(old).get(), opened(folder).get(), kRetired); }

    ScratchFolder place;
    fs::path old = place.file("old");
    fs::path folder = place.file("new");
};

std::multiset<std::string> contentsOf(const fs::path &folder)
{
    std::multiset<std::string> contents;
    for (const auto &[name, content] : snapshotOf(folder))
        if (content != "/")
            contents.insert(content);
    return contents;
}

} // namespace

class TestEmptiedFolder : public QObject
{
    Q_OBJECT

private slots:
    void oldFolder_isEmptiedAndTheNewOneIsAsItWas()
    {
        const Exchanged laid;
        const Snapshot before = snapshotOf(laid.folder);
        for (int again = 0; again < 2; ++again)
            QVERIFY(laid.empty());
        QVERIFY(fs::is_empty(laid.old));
        QVERIFY(snapshotOf(laid.folder) == before);
    }

    void whatCameInMeanwhile_isMovedOver()
    {
        const Exchanged laid;
        put(laid.old / "late", "late");
        put(laid.old / "csv/late", "late in csv");
        put(laid.old / "photos/1", "photo");
        fs::create_symlink("late", laid.old / "link");
        fs::create_symlink("nowhere", laid.old / "csv/dangling");
        Snapshot wanted = snapshotOf(laid.folder);
        wanted.insert({{"late", "late"}, {"csv/late", "late in csv"}, {"photos", "/"},
            {"photos/1", "photo"}, {"link", "-> late"}, {"csv/dangling", "-> nowhere"}});
        QVERIFY(laid.empty());
        QVERIFY(fs::is_empty(laid.old));
        QVERIFY(snapshotOf(laid.folder) == wanted);
    }

    void whatHasTheNameOfANewFile_isKeptBesideIt()
    {
        const Exchanged laid;
        put(laid.old / "results", "edited");
        put(laid.old / "csv/a", "edited a");
        put(laid.folder / "csv/a.kept-1", "kept before");
        fs::remove(laid.old / "notes");
        put(laid.old / "notes/inside", "a folder now");
        Snapshot wanted = snapshotOf(laid.folder);
        wanted.insert({{"results.kept-1", "edited"}, {"csv/a.kept-2", "edited a"},
            {"notes.kept-1", "/"}, {"notes.kept-1/inside", "a folder now"}});
        QVERIFY(laid.empty());
        QVERIFY(fs::is_empty(laid.old));
        QVERIFY(snapshotOf(laid.folder) == wanted);
    }

    void folderThatTheNewOneLacks_isMadeOnlyForWhatIsKept()
    {
        for (const bool isKept : {false, true}) {
            const Exchanged laid;
            fs::remove_all(laid.folder / "csv");
            if (isKept)
                put(laid.old / "csv/theirs", "theirs");
            QVERIFY(laid.empty());
            QCOMPARE(fs::exists(laid.folder / "csv"), isKept);
            QVERIFY(!isKept || contentOf(laid.folder / "csv/theirs") == "theirs");
        }
    }

    void linkInPlaceOfAFolder_isNotGoneThrough()
    {
        const Exchanged laid;
        put(laid.place.file("elsewhere/a"), "precious");
        fs::remove_all(laid.folder / "csv");
        fs::create_directory_symlink(laid.place.file("elsewhere"), laid.folder / "csv");
        put(laid.old / "csv/theirs", "theirs");
        const Snapshot elsewhere = snapshotOf(laid.place.file("elsewhere"));
        QVERIFY(!laid.empty()); // it has to stay, and is said
        QVERIFY(snapshotOf(laid.place.file("elsewhere")) == elsewhere);
        QCOMPARE(contentOf(laid.old / "csv/theirs"), std::string("theirs"));
    }

    /// Whatever lies in the two: nothing in the new folder changes, nothing foreign is lost.
    void randomFolders_loseNothing()
    {
        std::mt19937 random(20260101);
        const auto one
            = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
        int kept = 0;
        for (int trial = 0; trial < 300; ++trial) {
            const ScratchFolder place;
            const fs::path old = place.file("old");
            const fs::path folder = place.file("new");
            fs::create_directory(old);
            fs::create_directory(folder);
            WrittenList retired;
            std::multiset<std::string> wanted;
            for (const char *name : {"a", "b", "csv/a", "csv/b", "csv/in/c", "other/d"}) {
                const std::string content = std::to_string(trial) + name;
                const int fate = one(4); // not there, retired, changed, of somebody else
                if (fate > 0)
                    put(old / name, content);
                if (fate == 1 || fate == 2)
                    retired.push_back(ours(name, fate == 1 ? content : "before"));
                if (fate > 1)
                    wanted.insert(content);
                if (one(2) == 0)
                    put(folder / name, "new " + content);
            }
            const Snapshot before = snapshotOf(folder);
            wanted.merge(contentsOf(folder));
            QVERIFY(emptyOldTree(opened(old).get(), opened(folder).get(), retired));
            QVERIFY(contentsOf(folder) == wanted);
            QVERIFY(fs::is_empty(old));
            const Snapshot after = snapshotOf(folder);
            for (const auto &[name, content] : before)
                QVERIFY2(after.contains(name) && after.at(name) == content, name.c_str());
            kept += static_cast<int>(after.size() - before.size());
        }
        QVERIFY(kept > 300);
    }

    void stagingWithoutAPlan_goesAndTheFolderStays()
    {
        const ScratchFolder place;
        put(place.file("out/results"), "old");
        put(place.file("staging/tree/results"), "half");
        put(place.file("staging/moves.part"), "{");
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(recoverFolder(folder.get(), "none", "out", mayWrite));
        QVERIFY(recoverFolder(folder.get(), "staging", "out", mayWrite));
        QCOMPARE(snapshotOf(place.file("")), (Snapshot{{"out", "/"}, {"out/results", "old"}}));
    }

    void exchange_isKnownByTheFolderThatLiesInTheStaging()
    {
        for (const bool wasExchanged : {false, true}) {
            const ScratchFolder place;
            put(place.file("out/results"), "old");
            put(place.file("staging/tree/results"), "new");
            const FileDescriptor staging = opened(place.file("staging"));
            QVERIFY(writePlan(staging.get(), kExchangePlan,
                {inodeOf(place.file("staging/tree")), inodeOf(place.file("out")),
                    {ours("results", "old")}, {ours("results", "new")}}));
            if (wasExchanged) {
                fs::rename(place.file("out"), place.file("aside"));
                fs::rename(place.file("staging/tree"), place.file("out"));
                fs::rename(place.file("aside"), place.file("staging/tree"));
                put(place.file("staging/tree/late"), "late");
            }
            const FileDescriptor folder = opened(place.file(""));
            QVERIFY(recoverFolder(folder.get(), "staging", "out", mayWrite));
            Snapshot wanted{{"out", "/"}, {"out/results", wasExchanged ? "new" : "old"}};
            if (wasExchanged)
                wanted["out/late"] = "late";
            QVERIFY(snapshotOf(place.file("")) == wanted);
        }
    }

    void movesThatCannotBeCompleted_staysAsItIsAndSaysWhere()
    {
        const ScratchFolder place;
        put(place.file("out/results"), "edited since");
        put(place.file("staging/tree/results"), "new");
        const std::string list = writtenListText({ours("results", "old")});
        put(place.file("out/written.json"), list);
        const FileDescriptor staging = opened(place.file("staging"));
        QVERIFY(writePlan(staging.get(), kMovesPlan,
            {1, inodeOf(place.file("out")),
                {ours("results", "old"), {kWrittenList, {}, sha256Hex(list)}},
                {ours("results", "new")}}));
        const Snapshot before = snapshotOf(place.file(""));
        const FileDescriptor folder = opened(place.file(""));
        const auto done = recoverFolder(folder.get(), "staging", "out", mayWrite);
        QVERIFY(!done && done.error().kind == ErrorKind::Usage);
        const std::string sentence = english(done.error().message);
        QVERIFY(sentence.find("into out was") != std::string::npos);
        QVERIFY(sentence.find("lies in staging") != std::string::npos);
        QVERIFY(snapshotOf(place.file("")) == before);
        fs::remove(place.file("out/results")); // as the sentence says
        QVERIFY(recoverFolder(folder.get(), "staging", "out", mayWrite));
        QCOMPARE(snapshotOf(place.file("")), (Snapshot{{"out", "/"}, {"out/results", "new"}}));
    }
};

DYNCAL_TEST(TestEmptiedFolder)
#include "tst_emptied_folder.moc"
