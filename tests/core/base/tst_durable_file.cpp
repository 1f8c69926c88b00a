// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/durable_file.h"
#include "tests/support/scratch_folder.h"

#include <QTest>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>

using dyncal::moveIntoPlace;
using dyncal::testing::contentOf;
using dyncal::testing::ScratchFolder;
namespace fs = std::filesystem;

namespace {

std::string written(const ScratchFolder &folder, const char *name, const std::string &text)
{
    return folder.write(name, text.data(), text.size());
}

} // namespace

class TestDurableFile : public QObject
{
    Q_OBJECT

private slots:
    void newPlace_getsTheFileWhole()
    {
        const ScratchFolder folder;
        const std::string bytes("a\0b\n", 4);
        QVERIFY(moveIntoPlace(written(folder, "t", bytes), folder.file("out")));
        QCOMPARE(contentOf(folder.file("out")), bytes);
        QVERIFY(!fs::exists(folder.file("t")));
    }

    void whatWasThere_isReplacedNotOverwritten()
    {
        // Who has the old file open, or linked, keeps it as it was.
        const ScratchFolder folder;
        const std::string out = written(folder, "out", "old and longer");
        fs::create_hard_link(out, folder.file("link"));
        std::ifstream open(out);
        QVERIFY(moveIntoPlace(written(folder, "t", "new"), out));
        QCOMPARE(contentOf(out), std::string("new"));
        QCOMPARE(contentOf(folder.file("link")), std::string("old and longer"));
        QCOMPARE(
            std::string(std::istreambuf_iterator<char>(open), {}), std::string("old and longer"));
    }

    void symbolicLink_isReplacedByTheFile()
    {
        const ScratchFolder folder;
        const std::string target = written(folder, "target", "untouched");
        fs::create_symlink(target, folder.file("out"));
        QVERIFY(moveIntoPlace(written(folder, "t", "new"), folder.file("out")));
        QCOMPARE(contentOf(target), std::string("untouched"));
        QVERIFY(!fs::is_symlink(folder.file("out")));
    }

    void temporaryThatIsNotThere_leavesTheOldFile()
    {
        const ScratchFolder folder;
        const std::string out = written(folder, "out", "old");
        QVERIFY(!moveIntoPlace(folder.file("t"), out));
        QCOMPARE(contentOf(out), std::string("old"));
    }

    void folderInTheWay_orNoFolder_fails()
    {
        const ScratchFolder folder;
        const std::string t = written(folder, "t", "new");
        fs::create_directory(folder.file("out"));
        written(folder, "out/inside", "x");
        QVERIFY(!moveIntoPlace(t, folder.file("out")));
        QVERIFY(!moveIntoPlace(t, folder.file("nowhere/out")));
        QCOMPARE(contentOf(t), std::string("new")); // nothing is lost
        QCOMPARE(contentOf(folder.file("out/inside")), std::string("x"));
    }

    void nameWithoutFolder_isThatOfTheWorkingFolder()
    {
        const ScratchFolder folder;
        written(folder, "t", "new");
        const fs::path before = fs::current_path();
        fs::current_path(fs::path(folder.file("t")).parent_path());
        const bool moved = moveIntoPlace("t", "out");
        fs::current_path(before);
        QVERIFY(moved);
        QCOMPARE(contentOf(folder.file("out")), std::string("new"));
    }
};

QTEST_APPLESS_MAIN(TestDurableFile)
#include "tst_durable_file.moc"
