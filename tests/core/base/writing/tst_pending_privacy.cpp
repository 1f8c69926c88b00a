// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Who may read a file while it is being written: nobody who may not read what it replaces.

#include "core/base/writing/pending_file.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

mode_t modeOf(const std::string &path)
{
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
}

/// The one temporary file in the folder.
std::string temporaryIn(const ScratchFolder &place)
{
    for (const std::string &name : entriesOf(place.file("")))
        if (name.starts_with(".dyncal-") && !name.ends_with(".claim"))
            return place.file(name);
    return {};
}

} // namespace

class TestPendingPrivacy : public QObject
{
    Q_OBJECT

private slots:
    void privateFile_isPrivateWhileItIsReplaced()
    {
        const mode_t umaskBefore = ::umask(022);
        for (const mode_t mode : {0600U, 0640U, 0644U, 0664U, 0400U, 0000U}) {
            const ScratchFolder place;
            put(place.file("job"), "old");
            QCOMPARE(::chmod(place.file("job").c_str(), mode), 0);
            Result<PendingFile> file = PendingFile::create(place.file("job"), {});
            QVERIFY(file && file->write("secret"));
            const mode_t meanwhile = modeOf(temporaryIn(place));
            QVERIFY2((meanwhile & 077U & ~mode) == 0, qPrintable(QString::number(meanwhile, 8)));
            QVERIFY(file->commit());
            QCOMPARE(modeOf(place.file("job")), mode);
        }
        ::umask(umaskBefore);
    }

    void newFile_isAsTheUmaskSays()
    {
        for (const mode_t mask : {0022U, 0027U, 0077U, 0002U}) {
            const ScratchFolder place;
            const mode_t umaskBefore = ::umask(mask);
            Result<PendingFile> file = PendingFile::create(place.file("new"), {});
            ::umask(umaskBefore);
            QVERIFY(file);
            QCOMPARE(modeOf(temporaryIn(place)), 0666U & ~mask);
            QVERIFY(file->commit());
            QCOMPARE(modeOf(place.file("new")), 0666U & ~mask);
        }
    }

    /// A link is replaced, and what it led to says nothing of who may read the new file.
    void link_isReplacedByANewFile()
    {
        const ScratchFolder place;
        put(place.file("target"), "kept");
        QCOMPARE(::chmod(place.file("target").c_str(), 0600), 0);
        fs::create_symlink("target", place.file("link"));
        const mode_t umaskBefore = ::umask(022);
        Result<PendingFile> file = PendingFile::create(place.file("link"), {});
        ::umask(umaskBefore);
        QVERIFY(file && file->write("new") && file->commit());
        QCOMPARE(contentOf(place.file("target")), std::string("kept"));
        QVERIFY(!fs::is_symlink(place.file("link")));
        QCOMPARE(modeOf(place.file("link")), 0644U);
    }

    void openPath_isTheFileWhateverItsName()
    {
        const ScratchFolder place;
        Result<PendingFile> file = PendingFile::create(place.file("out"), {});
        QVERIFY(file && file->write("one"));
        std::ofstream(file->openPath(), std::ios::app) << " two";
        QCOMPARE(contentOf(file->openPath()), std::string("one two"));
        {
            PendingFile moved = std::move(*file);
            QVERIFY(moved.commit());
        }
        QCOMPARE(contentOf(place.file("out")), std::string("one two"));
        QCOMPARE(entriesOf(place.file("")), (std::set<std::string>{"out"}));
    }
};

DYNCAL_TEST(TestPendingPrivacy)
#include "tst_pending_privacy.moc"
