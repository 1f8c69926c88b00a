// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a name stands for, without ever going through a link; checked against the file system's own
// calls, Qt's hash and trees that were laid out by hand.

#include "core/base/writing/file_identity.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/failing_calls.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QTest>

#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

/// A folder with a file below and links in every part of the way to it.
void layLinks(const ScratchFolder &place)
{
    put(place.file("real/deep/file"), "content");
    fs::create_directory_symlink("real", place.file("link"));
    fs::create_directory_symlink("deep", place.file("real/linked"));
    fs::create_symlink("file", place.file("real/deep/alias"));
    fs::create_symlink("nowhere", place.file("real/deep/dangling"));
}

/// Makes something of that kind; "free" makes nothing.
void make(const std::string &kind, const std::string &path)
{
    if (kind == "file")
        put(path, "bytes of " + fs::path(path).filename().string());
    else if (kind == "folder")
        put(path + "/inside", "below");
    else if (kind == "empty folder")
        fs::create_directory(path);
    else if (kind == "link")
        fs::create_symlink("/etc/hostname", path);
    else if (kind == "dangling")
        fs::create_symlink("nowhere", path);
    else if (kind == "pipe")
        ::mkfifo(path.c_str(), 0600);
}

} // namespace

class TestFileIdentity : public QObject
{
    Q_OBJECT

private slots:
    void identity_isWhatTheSystemSays()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        for (const char *kind : {"file", "folder", "link", "dangling", "pipe"})
            make(kind, place.file(kind));
        for (const auto &[name, type] : {std::pair("file", FileType::Regular),
                 std::pair("folder", FileType::Folder), std::pair("link", FileType::Other),
                 std::pair("dangling", FileType::Other), std::pair("pipe", FileType::Other),
                 std::pair("folder/inside", FileType::Regular)}) {
            struct stat status = {};
            QCOMPARE(::lstat(place.file(name).c_str(), &status), 0);
            const auto found = identityOf(folder.get(), name);
            QVERIFY2(found, name);
            QCOMPARE(found->type, type);
            QCOMPARE(found->inode, status.st_ino);
            QCOMPARE(found->bytes, std::uint64_t(status.st_size));
        }
        fs::create_hard_link(place.file("file"), place.file("second"));
        const auto first = identityOf(folder.get(), "file");
        QVERIFY(first->isSameFile(*identityOf(folder.get(), "second")));
        QVERIFY(!first->isSameFile(*identityOf(folder.get(), "folder/inside")));
    }

    /// A change within the same second, or of a file dated before 1970, must be seen.
    void modificationTime_isToTheNanosecond()
    {
        const ScratchFolder place;
        put(place.file("file"), "x");
        const FileDescriptor folder = opened(place.file(""));
        for (const timespec time : {timespec{1700000000, 1}, timespec{1700000000, 2},
                 timespec{-5, 250000000}, timespec{0, 0}}) {
            const timespec both[2] = {time, time};
            QCOMPARE(::utimensat(AT_FDCWD, place.file("file").c_str(), both, 0), 0);
            QCOMPARE(identityOf(folder.get(), "file")->modified_ns,
                std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec);
        }
    }

    void links_areFollowedInNoPart()
    {
        const ScratchFolder place;
        layLinks(place);
        const FileDescriptor folder = opened(place.file(""));
        QCOMPARE(
            textAt(folder.get(), "real/deep/file", 100), std::optional<std::string>("content"));
        for (const char *name : {"link/deep/file", "real/linked/file"}) {
            QVERIFY2(!identityOf(folder.get(), name), name);
            QVERIFY2(sha256At(folder.get(), name).empty(), name);
            QVERIFY2(!textAt(folder.get(), name, 100), name);
        }
        for (const char *name : {"real/deep/alias", "real/deep/dangling"}) {
            QCOMPARE(identityOf(folder.get(), name)->type, FileType::Other);
            QVERIFY2(sha256At(folder.get(), name).empty(), name);
            QVERIFY2(!textAt(folder.get(), name, 100), name);
        }
        for (const char *name : {"link", "link/deep", "real/linked", "real/deep/file", "none"})
            QCOMPARE(openFolderAt(folder.get(), name), -1);
        const FileDescriptor deep(openFolderAt(folder.get(), "real/deep"));
        QVERIFY(deep.valid());
        QCOMPARE(entriesOf(place.file("real/deep")).size(), namesIn(deep.get()).size());
    }

    void namesWithoutALastPart_areNothing()
    {
        const ScratchFolder place;
        layLinks(place);
        const FileDescriptor folder = opened(place.file(""));
        for (const char *name :
            {"", "/", "real/", "real//deep", "/etc/hostname", "real/deep//file"}) {
            QVERIFY2(!identityOf(folder.get(), name), name);
            QVERIFY2(sha256At(folder.get(), name).empty(), name);
            QCOMPARE(openFolderAt(folder.get(), name), -1);
        }
    }

    void hash_ofEveryLengthAroundABlock_isQts()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        constexpr int kBlock = 1 << 18;
        for (const int size : {0, 1, 63, 64, kBlock - 1, kBlock, kBlock + 1, 2 * kBlock}) {
            QByteArray bytes(size, '\0');
            for (int i = 0; i < size; ++i)
                bytes[i] = static_cast<char>((static_cast<unsigned>(i) * 7919U) >> 3U);
            place.write("file", bytes.data(), static_cast<std::size_t>(size));
            const QByteArray wanted = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
            QCOMPARE(QByteArray::fromStdString(sha256At(folder.get(), "file")), wanted.toHex());
        }
    }

    void text_ofJustTheLimit_isReadAndOneMoreIsNot()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        for (const std::size_t size : {0U, 1U, 99U, 100U, 101U, 5000U}) {
            const std::string bytes(size, 'x');
            put(place.file("file"), bytes);
            const auto text = textAt(folder.get(), "file", 100);
            QCOMPARE(text.has_value(), size <= 100);
            QVERIFY(!text || *text == bytes);
        }
        put(place.file("file"), "short"); // the limit is not what it takes in memory
        QVERIFY(textAt(folder.get(), "file", 32U << 20U)->capacity() < 1U << 20U);
        put(place.file("file"), std::string("a\0b", 3));
        QCOMPARE(textAt(folder.get(), "file", 3)->size(), std::size_t(3));
    }

    /// Whoever opens a pipe to look at it waits until somebody writes, which may be never.
    void pipes_areNotWaitedFor()
    {
        const ScratchFolder place;
        make("pipe", place.file("pipe"));
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(sha256At(folder.get(), "pipe").empty());
        QVERIFY(!textAt(folder.get(), "pipe", 10));
        QCOMPARE(openFolderAt(folder.get(), "pipe"), -1);
    }

    void renameToFree_replacesNothing_data()
    {
        QTest::addColumn<bool>("lacksIt"); // the file system knows no rename without replacing
        QTest::newRow("by the system") << false;
        QTest::newRow("in two steps") << true;
    }
    void renameToFree_replacesNothing()
    {
        QFETCH(bool, lacksIt);
        for (const char *from : {"file", "folder", "empty folder", "link", "dangling", "pipe"})
            for (const char *to :
                {"free", "file", "folder", "empty folder", "link", "dangling", "pipe"}) {
                const ScratchFolder place;
                make(from, place.file("source"));
                make(to, place.file("target"));
                const Snapshot before = snapshotOf(place.file(""));
                const FileDescriptor folder = opened(place.file(""));
                if (lacksIt)
                    FailingCalls::arm(0, EINVAL);
                const bool moved = renameToFree(folder.get(), "source", folder.get(), "target");
                const int problem = errno;
                FailingCalls::disarm();
                const bool isFree = std::string(to) == "free";
                QVERIFY2(moved == isFree, from);
                Snapshot wanted;
                for (const auto &[name, content] : before)
                    wanted[isFree ? "target" + name.substr(6) : name] = content;
                QVERIFY2(snapshotOf(place.file("")) == wanted, to);
                QVERIFY(moved || problem == EEXIST);
            }
    }

    void removeTree_takesLinksAndNotWhatTheyLeadTo()
    {
        const ScratchFolder place;
        put(place.file("precious/file"), "precious");
        const Snapshot precious = snapshotOf(place.file("precious"));
        std::string deep = "tree";
        for (int i = 0; i < 200; ++i)
            deep += "/d";
        put(place.file(deep + "/file"), "x");
        for (const char *kind : {"file", "folder", "empty folder", "dangling", "pipe"})
            make(kind, place.file(std::string("tree/") + kind));
        fs::create_directory_symlink(place.file("precious"), place.file("tree/link"));
        fs::create_hard_link(place.file("precious/file"), place.file("tree/second"));
        const std::size_t files = openFiles();
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(removeTree(folder.get(), "tree"));
        QVERIFY(removeTree(folder.get(), "tree")); // gone is gone
        fs::create_directory_symlink("precious", place.file("alone"));
        QVERIFY(removeTree(folder.get(), "alone"));
        QCOMPARE(entriesOf(place.file("")), (std::set<std::string>{"precious"}));
        QVERIFY(snapshotOf(place.file("precious")) == precious);
        QCOMPARE(openFiles(), files + 1);
    }

    void manyNames_areAllThereAndNothingStaysOpen()
    {
        const ScratchFolder place;
        std::set<std::string> wanted;
        for (int i = 0; i < 3000; ++i) {
            const std::string name
                = std::to_string(i) + std::string(static_cast<std::size_t>(i % 200), 'n');
            put(place.file(name), "");
            wanted.insert(name);
        }
        const FileDescriptor folder = opened(place.file(""));
        const std::size_t files = openFiles();
        for (int again = 0; again < 2; ++again) { // the place in the folder is not shared
            const std::vector<std::string> names = namesIn(folder.get());
            QCOMPARE(names.size(), wanted.size());
            QVERIFY(std::set<std::string>(names.begin(), names.end()) == wanted);
        }
        QVERIFY(namesIn(-1).empty());
        (void)sha256At(folder.get(), "none");
        (void)textAt(folder.get(), "none/of/these", 10);
        (void)identityOf(folder.get(), "none/of/these");
        QCOMPARE(openFiles(), files);
    }
};

DYNCAL_TEST(TestFileIdentity)
#include "tst_file_identity.moc"
