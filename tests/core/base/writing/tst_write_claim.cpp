// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Who may write, and what becomes of what others left: claims in one process, and in several.

#include "core/base/writing/write_claim.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/test_program.h"

#include "core/base/writing/claim_file.h"
#include "core/base/writing/stray_cleaning.h"
#include "core/base/writing/temporary_name.h"

#include <QTest>

#include <sys/file.h>
#include <sys/stat.h>

#include <atomic>
#include <thread>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

const std::string kTemporary = ".dyncal-" + std::string(32, 'a');

Result<WriteClaim> taken(const ScratchFolder &place, const std::string &target)
{
    return WriteClaim::take(place.file(""), target, ClaimKind::File, "shown/" + target);
}

bool mayWriteAny(const std::string &)
{
    return true;
}

/// A claim whose program is gone, with its temporary file.
void leave(const ScratchFolder &place, const std::string &target)
{
    Result<WriteClaim> claim = taken(place, target);
    if (!claim)
        qFatal("no claim");
    put(place.file(claim->temporary()), "half");
    claim->leaveBehind();
}

} // namespace

class TestWriteClaim : public QObject
{
    Q_OBJECT

private slots:
    void claim_isThereWhileItLives()
    {
        const ScratchFolder place;
        {
            const Result<WriteClaim> claim = taken(place, "out");
            QVERIFY(claim);
            QVERIFY(isTemporaryName(claim->temporary()));
            QVERIFY(!fs::exists(place.file(claim->temporary())));
            QCOMPARE(entriesOf(place.file("")),
                (std::set<std::string>{claimFileName(claim->temporary())}));
            const auto again = taken(place, "out");
            QVERIFY(!again && again.error().kind == ErrorKind::Usage);
            QVERIFY(english(again.error().message).starts_with("shown/out is being written"));
            QVERIFY(taken(place, "out2")); // only the whole name counts
            QVERIFY(taken(place, "ou"));
        }
        QVERIFY(entriesOf(place.file("")).empty());
        QVERIFY(taken(place, "out"));
    }

    void movedClaim_isHeldOnceAndReleasedOnce()
    {
        const ScratchFolder place;
        Result<WriteClaim> first = taken(place, "first");
        Result<WriteClaim> second = taken(place, "second");
        QVERIFY(first && second);
        const std::string name = second->temporary();
        {
            WriteClaim moved = std::move(*second);
            QCOMPARE(moved.temporary(), name);
            QVERIFY(!taken(place, "second"));
            moved = std::move(*first); // the two change places; none is lost
        }
        const std::size_t left = entriesOf(place.file("")).size();
        first = tl::unexpected(Error{});
        second = tl::unexpected(Error{});
        QCOMPARE(left, std::size_t(1));
        QVERIFY(entriesOf(place.file("")).empty());
    }

    void whatWasLeftBehind_goesWithTheNextClaim()
    {
        const ScratchFolder place;
        put(place.file("out"), "kept");
        {
            std::vector<Result<WriteClaim>> claims;
            for (const char *target : {"out", "other", "third"}) {
                claims.push_back(taken(place, target));
                QVERIFY(claims.back());
                put(place.file(claims.back()->temporary()), "half");
            }
            for (Result<WriteClaim> &claim : claims) // killed at the same time
                claim->leaveBehind();
        }
        QCOMPARE(entriesOf(place.file("")).size(), std::size_t(7));
        {
            const auto claim = taken(place, "new");
            QVERIFY(claim);
            QCOMPARE(entriesOf(place.file("")).size(), std::size_t(2));
        }
        QCOMPARE(entriesOf(place.file("")), (std::set<std::string>{"out"}));
        QCOMPARE(contentOf(place.file("out")), std::string("kept"));
    }

    void stray_ofAnotherKindThanItsClaim_isLeftAlone_data()
    {
        QTest::addColumn<bool>("claimsFolder");
        QTest::addColumn<QByteArray>("thing");
        QTest::addColumn<bool>("goes");
        for (const bool claimsFolder : {false, true})
            for (const char *thing : {"nothing", "file", "folder", "link", "pipe"}) {
                const bool goes = thing == QByteArray(claimsFolder ? "folder" : "file");
                QTest::addRow("%s claimed, %s there", claimsFolder ? "folder" : "file", thing)
                    << claimsFolder << QByteArray(thing) << goes;
            }
    }
    void stray_ofAnotherKindThanItsClaim_isLeftAlone()
    {
        QFETCH(bool, claimsFolder);
        QFETCH(QByteArray, thing);
        QFETCH(bool, goes);
        const ScratchFolder place;
        put(place.file("target/inside"), "kept");
        const std::string path = place.file(kTemporary);
        if (thing == "file")
            put(path, "half");
        else if (thing == "folder")
            put(path + "/tree/file", "half");
        else if (thing == "link")
            fs::create_symlink("target", path);
        else if (thing == "pipe")
            ::mkfifo(path.c_str(), 0600);
        Snapshot wanted = snapshotOf(place.file(""));
        if (goes)
            std::erase_if(
                wanted, [](const auto &entry) { return entry.first.starts_with(kTemporary); });
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(clearStray(folder.get(),
            {kTemporary, claimsFolder ? ClaimKind::Folder : ClaimKind::File, "target"},
            mayWriteAny));
        QVERIFY(snapshotOf(place.file("")) == wanted);
    }

    void clearing_looksAtItsOwnTarget()
    {
        const ScratchFolder place;
        const auto living = taken(place, "living");
        QVERIFY(living);
        leave(place, "dead");
        const auto busy = clearClaims(place.file(""), "living", "shown", mayWriteAny);
        QVERIFY(!busy && busy.error().kind == ErrorKind::Usage);
        QVERIFY(clearClaims(place.file(""), "dead", "shown", mayWriteAny));
        QVERIFY(clearClaims(place.file(""), "none", "shown", mayWriteAny));
        QCOMPARE(
            entriesOf(place.file("")), (std::set<std::string>{claimFileName(living->temporary())}));
        QVERIFY(!clearClaims(place.file("none"), "x", "shown", mayWriteAny));
    }

    void liveClaims_areThoseOfOthers()
    {
        const ScratchFolder place;
        leave(place, "dead");
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(!hasLiveClaims(folder.get(), kTemporary));
        const auto own = taken(place, "own");
        QVERIFY(own && !hasLiveClaims(folder.get(), own->temporary()));
        QVERIFY(hasLiveClaims(folder.get(), kTemporary));
        const auto other = taken(place, "other");
        QVERIFY(other && hasLiveClaims(folder.get(), own->temporary()));
    }

    /// Names that are all taken must end the search, with nothing changed.
    void noFreeName_isSaid()
    {
        const ScratchFolder place;
        put(place.file(kTemporary), "theirs");
        setTemporaryNames([] { return kTemporary; });
        const auto claim = taken(place, "out");
        setTemporaryNames({});
        QVERIFY(!claim && !english(claim.error().message).empty());
        QCOMPARE(entriesOf(place.file("")), (std::set<std::string>{kTemporary}));
        QCOMPARE(contentOf(place.file(kTemporary)), std::string("theirs"));
    }

    /// While one waits for the lock the folder is replaced: a lock on the old one guards nothing.
    void lock_isOnTheFolderThatHasTheNameNow()
    {
        const ScratchFolder place;
        const std::string path = place.file("folder");
        fs::create_directory(path);
        std::atomic<bool> waits = false;
        ino_t locked = 0;
        {
            FileDescriptor holder = opened(path);
            QCOMPARE(::flock(holder.get(), LOCK_EX), 0);
            const std::jthread waiter([&] {
                waits = true;
                const FolderLock lock(path);
                struct stat status = {};
                if (lock.valid() && ::fstat(lock.folder(), &status) == 0)
                    locked = status.st_ino;
            });
            while (!waits)
                std::this_thread::yield();
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            fs::rename(path, place.file("moved away"));
            fs::create_directory(path);
            holder.close();
        }
        struct stat now = {};
        QCOMPARE(::stat(path.c_str(), &now), 0);
        QCOMPARE(locked, now.st_ino);
    }

    void lock_ofAFolderThatGoes_isInvalid()
    {
        const ScratchFolder place;
        const std::string path = place.file("folder");
        fs::create_directory(path);
        bool valid = true;
        {
            FileDescriptor holder = opened(path);
            QCOMPARE(::flock(holder.get(), LOCK_EX), 0);
            const std::jthread waiter([&] { valid = FolderLock(path).valid(); });
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            fs::remove(path);
            holder.close();
        }
        QVERIFY(!valid);
    }

    void manyWriters_ofDifferentFilesDoNotHinderEachOther()
    {
        const ScratchFolder place;
        std::atomic<int> failures = 0;
        {
            std::vector<std::jthread> writers;
            for (int writer = 0; writer < 8; ++writer)
                writers.emplace_back([&, writer] {
                    for (int i = 0; i < 25; ++i)
                        failures += taken(place, "file" + std::to_string(writer)) ? 0 : 1;
                });
        }
        QCOMPARE(failures.load(), 0);
        QVERIFY(entriesOf(place.file("")).empty());
    }

    void claimOfAnotherProcess_countsUntilItEnds()
    {
        const ScratchFolder place;
        const auto mine = taken(place, "mine");
        QVERIFY(mine);
        QCOMPARE(exitCodeOf([&] { return taken(place, "mine") ? 1 : 7; }), 7);
        QCOMPARE(exitCodeOf([&] {
            const auto theirs = taken(place, "theirs");
            ::_exit(theirs ? 7 : 1); // killed: nothing is released
            return 1;
        }),
            7);
        QVERIFY(taken(place, "theirs"));
        QCOMPARE(
            entriesOf(place.file("")), (std::set<std::string>{claimFileName(mine->temporary())}));
    }
};

DYNCAL_TEST(TestWriteClaim)
#include "tst_write_claim.moc"
