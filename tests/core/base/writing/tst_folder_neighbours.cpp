// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What else goes on in the folder while it is written: others that write below it, file systems.

#include "core/base/writing/pending_file.h"
#include "tests/core/base/writing/folder_cases.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

class TestFolderNeighbours : public QObject
{
    Q_OBJECT

private slots:
    void whoWritesBelow_getsHisFile()
    {
        const ScratchFolder place;
        const std::string out = place.file("out");
        QVERIFY(write(requestFor(out), kOld));
        Result<PendingFile> file
            = PendingFile::create(out + "/csv/shot.h5", {Existing::Rule::Refused});
        QVERIFY(file && file->write("record"));
        const auto done = write(requestFor(out), kNew);
        QVERIFY2(done, sentenceOf(done).c_str());
        QVERIFY(file->write("ing"));
        const auto kept = file->commit();
        QVERIFY2(kept, sentenceOf(kept).c_str());
        file = tl::unexpected(Error{});
        Snapshot wanted;
        for (const auto &[name, content] : snapshotOf(out))
            if (name != "written.json")
                wanted[name] = content;
        QCOMPARE(wanted,
            (Snapshot{{"csv", "/"}, {"csv/a.csv", "2"}, {"csv/b.csv", "3"},
                {"csv/shot.h5", "recording"}, {"results.json", "new"}}));
    }

    void anotherFileSystemBelow_isRefusedAtOnce()
    {
        const FileDescriptor root = opened("/");
        FolderPlace place;
        place.shown = place.path = place.claimFolder = "/";
        place.claimTarget = ".";
        FolderRequest request = requestFor("/");
        const auto contents = inspectFolder(place, root.get(), request, {"proc/"});
        QVERIFY(!contents && contents.error().kind == ErrorKind::Usage);
        QVERIFY(english(contents.error().message).starts_with("/proc/ lies on another"));
        QVERIFY(inspectFolder(place, root.get(), request, {"none/"}));
    }

    void filesNotWrittenAgain_goWithTheirFolder()
    {
        const ScratchFolder place;
        const FolderRequest request = requestFor(place.file("out"));
        QVERIFY(write(request, {{"csv/a.csv", "1"}, {"results.json", "old"}}));
        QVERIFY(write(request, {{"results.json", "last"}}));
        Snapshot left = snapshotOf(place.file("out"));
        left.erase("written.json");
        QCOMPARE(left, (Snapshot{{"results.json", "last"}}));
    }
};

DYNCAL_TEST(TestFolderNeighbours)
#include "tst_folder_neighbours.moc"
