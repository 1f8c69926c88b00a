// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a folder lies, held against Python's realpath; what is made on the way; and the sentences
// for places that cannot be written to.

#include "core/base/writing/folder_place.h"
#include "core/base/writing/write_problem.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <sys/stat.h>

#include <cstring>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

/// What realpath says of them, one a line.
QList<QByteArray> realPaths(const std::vector<std::string> &paths)
{
    QStringList arguments{
        "-c", "import os, sys\nfor p in sys.argv[1:]: print(os.path.realpath(p))"};
    for (const std::string &path : paths)
        arguments << QString::fromStdString(path);
    return python(arguments).out.split('\n');
}

/// Works in another folder for a while.
class WorkingIn
{
public:
    explicit WorkingIn(const fs::path &folder)
        : m_before(fs::current_path())
    {
        fs::current_path(folder);
    }
    ~WorkingIn() { fs::current_path(m_before); }

private:
    fs::path m_before;
};

} // namespace

class TestFolderPlace : public QObject
{
    Q_OBJECT

private slots:
    void path_isThatOfPythonsRealpath()
    {
        const ScratchFolder place;
        fs::create_directories(place.file("there/deep"));
        fs::create_directory_symlink("there", place.file("link"));
        fs::create_directory_symlink(place.file("link/deep"), place.file("there/twice"));
        const WorkingIn there(place.file("there"));
        const std::vector<std::string> paths{place.file("there"), place.file("there/"),
            place.file("there///"), place.file("link"), place.file("link/deep"),
            place.file("there/twice"), place.file("there/deep/.."), place.file("there/twice/.."),
            ".", "..", "deep", "./deep/.", "../link", place.file("new"), place.file("new/"),
            place.file("link/new"), "new", "./new", "../new", "/", "//"};
        const QList<QByteArray> wanted = realPaths(paths);
        for (std::size_t i = 0; i < paths.size(); ++i) {
            const Result<FolderPlace> found = locateFolder(paths[i]);
            QVERIFY2(found, paths[i].c_str());
            QCOMPARE(QByteArray::fromStdString(found->path), wanted[static_cast<qsizetype>(i)]);
            QCOMPARE(found->shown, paths[i]);
            QCOMPARE(found->exists, fs::exists(paths[i]));
            QVERIFY(found->made.empty());
            const fs::path whole = found->claimTarget == "."
                ? fs::path(found->claimFolder)
                : fs::path(found->claimFolder) / found->claimTarget;
            QCOMPARE(whole.string(), found->path);
            QVERIFY(fs::is_directory(found->claimFolder));
        }
    }

    void missingParents_areMadeAndNamedTheDeepestLast()
    {
        const ScratchFolder place;
        fs::create_directory(place.file("there"));
        const Result<FolderPlace> found = locateFolder(place.file("there/a/b/c/"));
        QVERIFY(found && !found->exists);
        QCOMPARE(found->made,
            (std::vector<std::string>{place.file("there/a"), place.file("there/a/b")}));
        QVERIFY(fs::is_directory(place.file("there/a/b")));
        QVERIFY(!fs::exists(place.file("there/a/b/c")));
    }

    void whatIsNoFolder_isRefusedAndNothingIsMade()
    {
        const ScratchFolder place;
        put(place.file("file"), "x");
        fs::create_symlink("nowhere", place.file("dangling"));
        fs::create_symlink("circle", place.file("circle"));
        const Snapshot before = snapshotOf(place.file(""));
        for (const std::string &folder : {std::string(), place.file("file"), place.file("file/"),
                 place.file("file/below"), place.file("dangling"), place.file("circle"),
                 place.file("circle/below"), place.file(std::string(300, 'n') + "/below")}) {
            const Result<FolderPlace> found = locateFolder(folder);
            QVERIFY2(!found && found.error().kind == ErrorKind::Usage, folder.c_str());
        }
        QVERIFY(snapshotOf(place.file("")) == before);
    }

    /// Files cannot be moved over the border of a mount, nor put beside it without permission.
    void claimsLieInside_whereTheyCannotLieBeside()
    {
        const Result<FolderPlace> mount = locateFolder("/proc");
        QVERIFY(mount);
        QCOMPARE(mount->claimFolder, std::string("/proc"));
        QCOMPARE(mount->claimTarget, std::string("."));
        const ScratchFolder place;
        fs::create_directories(place.file("closed/out"));
        QCOMPARE(::chmod(place.file("").c_str(), 0755), 0);
        QCOMPARE(::chmod(place.file("closed").c_str(), 0555), 0);
        constexpr uid_t kNobody = 65534;
        QCOMPARE(exitCodeOf([&] {
            if (::geteuid() == 0 && ::setuid(kNobody) != 0)
                return 1;
            const Result<FolderPlace> found = locateFolder(place.file("closed/out"));
            const bool isInside = found && found->claimTarget == "."
                && found->claimFolder == found->path && !locateFolder(place.file("closed/a/b"));
            return isInside ? 7 : 2;
        }),
            7);
        QCOMPARE(::chmod(place.file("closed").c_str(), 0755), 0);
    }

    void everyError_isSaidWithItsReasonAndARemedy()
    {
        const std::map<int, const char *> usage{{EACCES, "another place"},
            {ENOENT, "folder exists"}, {ENOTDIR, "folder exists"}, {EISDIR, "another place"},
            {EROFS, "another place"}, {EPERM, "another place"}, {ENAMETOOLONG, "a shorter name"},
            {ELOOP, "another place"}};
        const std::map<int, const char *> internal{{ENOSPC, "make room"}, {EDQUOT, "make room"},
            {EFBIG, "raise the limit"}, {EIO, "another place"}, {ENOMEM, ""},
            {EMFILE, "limit on open files"}};
        for (const auto &[kind, errors] :
            {std::pair(ErrorKind::Usage, usage), std::pair(ErrorKind::Internal, internal)})
            for (const auto &[number, remedy] : errors) {
                const Error error = cannotWrite("/a/b 100%1", number).value();
                const std::string sentence = english(error.message);
                QCOMPARE(error.kind, kind);
                QVERIFY(sentence.starts_with("/a/b 100%1 cannot be written: "));
                QVERIFY2(sentence.find(std::strerror(number)) != std::string::npos, remedy);
                QVERIFY2(sentence.find(remedy) != std::string::npos, sentence.c_str());
                errno = number;
                QCOMPARE(english(cannotWrite("/a/b 100%1").value().message), sentence);
            }
    }
};

DYNCAL_TEST(TestFolderPlace)
#include "tst_folder_place.moc"
