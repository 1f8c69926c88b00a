// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The moves that replace files one by one where folders cannot be exchanged: from every state that
// a killed program may leave, past everything that may stand in the way.

#include "core/base/writing/folder_moves.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/base/writing/folder_paths.h"

#include <QTest>

#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

using Files = std::map<std::string, std::string>;

const Files kOld{{"results", "old"}, {"csv/a", "old a"}, {"gone/b", "old b"}};
const Files kNew{{"results", "new"}, {"csv/a", "new a"}, {"deep/er/c", "new c"}, {"last", "new"}};

WrittenList listOf(const Files &files)
{
    WrittenList list;
    for (const auto &[name, content] : files)
        list.push_back({name, "run", sha256Hex(content)});
    return list;
}

/// A folder with old files and two of somebody else's, and new ones staged.
struct Laid
{
    Laid()
    {
        for (const auto &[name, content] : kOld)
            put(out / name, content);
        put(out / "csv/theirs", "theirs");
        fs::create_directory(out / "empty");
        for (const auto &[name, content] : kNew)
            put(staging / "tree" / name, content);
    }

    bool carryOut() const { return carryOutMoves(opened(staging).get(), opened(out).get(), plan); }

    ScratchFolder place;
    fs::path out = place.file("out");
    fs::path staging = place.file("staging");
    FolderPlan plan{1, 2, listOf(kOld), listOf(kNew)};
};

void move(const fs::path &from, const fs::path &to)
{
    fs::create_directories(to.parent_path());
    fs::rename(from, to);
}

/// The first moves of the plan, done by hand as the killed program had done them.
void doFirst(const Laid &laid, std::size_t moves)
{
    for (const WrittenFile &file : laid.plan.retired)
        if (moves > 0 && moves-- > 0)
            move(laid.out / file.file, laid.staging / "old" / file.file);
    for (const WrittenFile &file : laid.plan.placed)
        if (moves > 0 && moves-- > 0)
            move(laid.staging / "tree" / file.file, laid.out / file.file);
}

const Snapshot kAfter{{"csv", "/"}, {"csv/a", "new a"}, {"csv/theirs", "theirs"}, {"deep", "/"},
    {"deep/er", "/"}, {"deep/er/c", "new c"}, {"empty", "/"}, {"last", "new"}, {"results", "new"}};

} // namespace

class TestFolderMoves : public QObject
{
    Q_OBJECT

private slots:
    void moves_areCompletedFromEveryState()
    {
        for (std::size_t done = 0; done <= kOld.size() + kNew.size(); ++done)
            for (int times = 1; times <= 2; ++times) { // and again where all is done
                const Laid laid;
                doFirst(laid, done);
                for (int i = 0; i < times; ++i)
                    QVERIFY2(laid.carryOut(), qPrintable(QString::number(done)));
                QVERIFY2(snapshotOf(laid.out) == kAfter, qPrintable(QString::number(done)));
                for (const auto &[name, content] : kOld)
                    QCOMPARE(contentOf(laid.staging / "old" / name), content);
            }
    }

    void filesThatAreGoneAlready_areNoObstacle()
    {
        const Laid laid;
        fs::remove(laid.out / "results");
        fs::remove_all(laid.out / "gone");
        QVERIFY(laid.carryOut());
        QVERIFY(snapshotOf(laid.out) == kAfter);
    }

    void whatStandsInTheWay_takesEverythingBack_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("kind");
        for (const char *name : {"results", "csv/a", "gone/b"})
            QTest::addRow("%s changed", name) << QByteArray(name) << QByteArray("changed");
        for (const char *name : {"deep/er/c", "deep/er", "deep", "last"})
            for (const char *kind : {"file", "link", "dangling"})
                QTest::addRow("%s at %s", kind, name) << QByteArray(name) << QByteArray(kind);
        for (const char *name : {"deep/er/c", "last"})
            QTest::addRow("folder at %s", name) << QByteArray(name) << QByteArray("folder");
    }
    void whatStandsInTheWay_takesEverythingBack()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, kind);
        const Laid laid;
        const fs::path target = laid.out / name.toStdString();
        put(laid.place.file("elsewhere/file"), "precious");
        if (kind == "changed" || kind == "file")
            put(target, "theirs");
        else
            fs::create_directories(kind == "folder" ? target : target.parent_path());
        if (kind == "link" || kind == "dangling")
            fs::create_symlink(laid.place.file(kind == "link" ? "elsewhere" : "nowhere"), target);
        const Snapshot before = snapshotOf(laid.out);
        const Snapshot elsewhere = snapshotOf(laid.place.file("elsewhere"));
        errno = 0;
        QVERIFY(!laid.carryOut());
        QVERIFY(errno != 0);
        QVERIFY(snapshotOf(laid.place.file("elsewhere")) == elsewhere);
        for (const auto &[file, content] : kNew)
            QCOMPARE(contentOf(laid.staging / "tree" / file), content);
        QVERIFY(snapshotOf(laid.out) == before);
    }

    /// It was put there after the program was killed between two moves.
    void afterHalfOfTheMoves_whatStandsInTheWayIsStillKept()
    {
        for (std::size_t done = 0; done <= kOld.size() + 2; ++done) {
            const Laid laid;
            doFirst(laid, done);
            put(laid.out / "last", "theirs");
            QVERIFY(!laid.carryOut());
            QCOMPARE(contentOf(laid.out / "last"), std::string("theirs"));
            for (const auto &[name, content] : kOld) // and no old file is lost
                QCOMPARE(contentOf(laid.out / name), content);
            fs::remove(laid.out / "last");
            QVERIFY(laid.carryOut());
            QVERIFY(snapshotOf(laid.out) == kAfter);
        }
    }

    void folders_areMadeWithoutFollowingLinks()
    {
        const ScratchFolder place;
        fs::create_directory(place.file("elsewhere"));
        fs::create_directory(place.file("out"));
        fs::create_directory_symlink("../elsewhere", place.file("out/link"));
        const FileDescriptor folder = opened(place.file("out"));
        QVERIFY(makeFoldersFor(folder.get(), "a/b/c"));
        QVERIFY(makeFoldersFor(folder.get(), "a/b/d/e"));
        QVERIFY(makeFoldersFor(folder.get(), "plain"));
        QVERIFY(!makeFoldersFor(folder.get(), "link/b/c"));
        QVERIFY(fs::is_empty(place.file("elsewhere")));
        fs::create_directories(place.file("elsewhere/b"));
        removeEmptyFoldersOf(folder.get(), "link/b/c");
        QVERIFY(fs::exists(place.file("elsewhere/b")));
        put(place.file("out/a/file"), "x");
        removeEmptyFoldersOf(folder.get(), "a/b/d/e");
        QCOMPARE(snapshotOf(place.file("out")),
            (Snapshot{{"a", "/"}, {"a/file", "x"}, {"link", "-> ../elsewhere"}}));
        QVERIFY(syncFolders(folder.get(), {{"a/file", {}, {}}, {"plain", {}, {}}}));
        QVERIFY(!syncFolders(folder.get(), {{"none/file", {}, {}}}));
        QVERIFY(!syncFolders(folder.get(), {{"link/b/file", {}, {}}}));
    }

    void linkKept_givesEverythingElseASecondName()
    {
        const Laid laid;
        put(laid.out / "notes", "theirs");
        fs::create_symlink("/etc/hostname", laid.out / "link");
        QCOMPARE(::mkfifo((laid.out / "csv/pipe").c_str(), 0640), 0);
        fs::remove(laid.out / "empty");
        QCOMPARE(::chmod((laid.out / "csv").c_str(), 02750), 0);
        const Snapshot before = snapshotOf(laid.out);
        for (int again = 0; again < 2; ++again)
            QVERIFY(linkKept(
                opened(laid.out).get(), opened(laid.staging / "tree").get(), laid.plan.retired));
        QVERIFY(snapshotOf(laid.out) == before);
        for (const char *name : {"notes", "link", "csv/pipe", "csv/theirs"}) {
            struct stat one = {};
            struct stat two = {};
            QCOMPARE(::lstat((laid.out / name).c_str(), &one), 0);
            QCOMPARE(::lstat((laid.staging / "tree" / name).c_str(), &two), 0);
            QVERIFY2(one.st_ino == two.st_ino && one.st_dev == two.st_dev, name);
        }
        QCOMPARE(contentOf(laid.staging / "tree/results"), std::string("new"));
        QVERIFY(!fs::exists(laid.staging / "tree/gone/b"));
        struct stat status = {};
        QCOMPARE(::stat((laid.staging / "tree/csv").c_str(), &status), 0);
        QCOMPARE(status.st_mode & 07777U, 02750U);
    }

    void linkKept_whatCannotHaveASecondName_isLeftToTheMoves()
    {
        { // folders of others have no second names, not even empty ones
            const Laid laid;
            QVERIFY(!linkKept(
                opened(laid.out).get(), opened(laid.staging / "tree").get(), laid.plan.retired));
        }
        const Laid laid; // a new file has the name of one that is kept
        fs::remove(laid.out / "empty");
        put(laid.out / "last", "theirs");
        QVERIFY(!linkKept(
            opened(laid.out).get(), opened(laid.staging / "tree").get(), laid.plan.retired));
        QCOMPARE(contentOf(laid.staging / "tree/last"), std::string("new"));
        QCOMPARE(contentOf(laid.out / "last"), std::string("theirs"));
    }
};

DYNCAL_TEST(TestFolderMoves)
#include "tst_folder_moves.moc"
