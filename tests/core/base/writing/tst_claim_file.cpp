// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Claim files: what is one, whose program lives, and that none is ever half there.

#include "core/base/writing/claim_file.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/failing_calls.h"
#include "tests/support/test_program.h"

#include "core/base/writing/temporary_name.h"

#include <QTest>

#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

bool refusesModes = false; // as memory cards do

} // namespace

extern "C" int fchmod(int file, mode_t mode) noexcept
{
    static auto *const real = realCall<int(int, mode_t)>("fchmod");
    if (refusesModes)
        errno = EPERM;
    return refusesModes ? -1 : real(file, mode);
}

namespace {

const std::string kTemporary = ".dyncal-" + std::string(32, 'a');

/// What a claim must look like to programs of every version.
std::string bytesOf(const std::string &kind, const std::string &target)
{
    return "dyncal-claim/1\n" + kTemporary + '\n' + kind + '\n' + target;
}

/// Names that a file system takes and a careless reader of lines does not.
std::vector<std::string> oddNames()
{
    return {".", "a", "file", "folder\n", "\nfile\n", "two\nlines", " ", "\xC3\xA5\xE2\x84\x96",
        "\xff\xfe", "...", "..x", std::string(255, 'n')};
}

FileDescriptor madeInTwoSteps(int folder, const ClaimText &text)
{
    FailingCalls::arm(0, EOPNOTSUPP); // a file system without nameless files
    FileDescriptor file = createClaimFile(folder, text);
    FailingCalls::disarm();
    return file;
}

} // namespace

class TestClaimFile : public QObject
{
    Q_OBJECT

private slots:
    void claims_areFoundAsTheyWereMade()
    {
        for (const std::string &target : oddNames())
            for (const ClaimKind kind : {ClaimKind::File, ClaimKind::Folder})
                for (const bool plain : {true, false}) {
                    const ScratchFolder place;
                    const FileDescriptor folder = opened(place.file(""));
                    const ClaimText text{kTemporary, kind, target};
                    FileDescriptor file = plain ? createClaimFile(folder.get(), text)
                                                : madeInTwoSteps(folder.get(), text);
                    QVERIFY2(file.valid(), target.c_str());
                    QCOMPARE(contentOf(place.file(kTemporary + ".claim")),
                        bytesOf(kind == ClaimKind::File ? "file" : "folder", target));
                    for (const bool lives : {true, false}) {
                        const auto found = findClaims(folder.get());
                        QCOMPARE(found.size(), std::size_t(1));
                        QCOMPARE(found[0].isLive, lives);
                        QCOMPARE(found[0].text.target, target);
                        QCOMPARE(found[0].text.kind, kind);
                        QCOMPARE(found[0].text.temporary, kTemporary);
                        file.close(); // as the end of its program does
                    }
                }
    }

    void whatIsNoClaim_isPassedOver_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char *name, const std::string &bytes) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes);
        };
        row("empty", "");
        row("half a first line", "dyncal-claim");
        row("another version", "dyncal-claim/2\n" + kTemporary + "\nfile\na");
        row("no temporary", "dyncal-claim/1\nfile\na");
        row("of another temporary",
            "dyncal-claim/1\n.dyncal-" + std::string(32, 'b') + "\nfile\na");
        row("a longer temporary", "dyncal-claim/1\n" + kTemporary + "b\nfile\na");
        row("no kind", "dyncal-claim/1\n" + kTemporary + "\na");
        row("unknown kind", bytesOf("link", "a"));
        row("no target", bytesOf("file", ""));
        row("the folder above", bytesOf("folder", ".."));
        row("a way out", bytesOf("file", "../a"));
        row("from the root", bytesOf("file", "/etc/passwd"));
        row("a way in", bytesOf("folder", "a/b"));
        row("zeros", std::string(5000, '\0'));
    }
    void whatIsNoClaim_isPassedOver()
    {
        QFETCH(QByteArray, bytes);
        const ScratchFolder place;
        put(place.file(kTemporary + ".claim"), bytes.toStdString());
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(findClaims(folder.get()).empty());
    }

    void everyCutClaim_isNoneOrNamesAPart()
    {
        const std::string whole = bytesOf("folder", "target");
        const std::size_t head = whole.size() - 6;
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const ScratchFolder place;
            put(place.file(kTemporary + ".claim"), whole.substr(0, size));
            const FileDescriptor folder = opened(place.file(""));
            QCOMPARE(findClaims(folder.get()).size(), std::size_t(size > head ? 1 : 0));
        }
    }

    void claimsUnderOtherNames_orThatAreNoFiles_arePassedOver()
    {
        const ScratchFolder place;
        const std::string bytes = bytesOf("file", "a");
        put(place.file("elsewhere"), bytes);
        for (const std::string &name :
            {std::string("x.claim"), std::string(".claim"), kTemporary + ".claim2", kTemporary,
                kTemporary + "b.claim", ".dyncal-" + std::string(31, 'a') + "G.claim"})
            put(place.file(name), bytes);
        const auto claimNamed = [&](char digit) {
            return place.file(".dyncal-" + std::string(32, digit) + ".claim");
        };
        fs::create_symlink(place.file("elsewhere"), claimNamed('1'));
        fs::create_symlink("nowhere", claimNamed('2'));
        QCOMPARE(::mkfifo(claimNamed('3').c_str(), 0600), 0);
        fs::create_directory(claimNamed('4'));
        const FileDescriptor folder = opened(place.file(""));
        const std::size_t files = openFiles();
        QVERIFY(findClaims(folder.get()).empty());
        QCOMPARE(openFiles(), files);
    }

    void takenName_isSaidAndWhatHasItStays()
    {
        for (const bool plain : {true, false}) {
            const ScratchFolder place;
            const FileDescriptor folder = opened(place.file(""));
            const auto make = [&](const std::string &target) {
                const ClaimText text{kTemporary, ClaimKind::File, target};
                return plain ? createClaimFile(folder.get(), text)
                             : madeInTwoSteps(folder.get(), text);
            };
            const FileDescriptor first = make("first");
            QVERIFY(first.valid());
            errno = 0;
            QVERIFY(!make("second").valid());
            QCOMPARE(errno, EEXIST);
            const auto found = findClaims(folder.get());
            QVERIFY(found.size() == 1 && found[0].isLive && found[0].text.target == "first");
        }
    }

    void everyFailingCall_leavesNoClaimOrAWholeOne()
    {
        bool wasReached = true;
        int failures = 0;
        for (int call = 0; wasReached; ++call) {
            const ScratchFolder place;
            const FileDescriptor folder = opened(place.file(""));
            FailingCalls::arm(call, ENOSPC);
            const FileDescriptor file
                = createClaimFile(folder.get(), {kTemporary, ClaimKind::File, "a"});
            const int problem = errno;
            wasReached = FailingCalls::countdown < 0;
            FailingCalls::disarm();
            failures += file.valid() ? 0 : 1;
            QVERIFY(file.valid() || problem == ENOSPC);
            QCOMPARE(entriesOf(place.file("")).size(), std::size_t(file.valid() ? 1 : 0));
        }
        QCOMPARE(failures, 3); // opened, written, named
    }

    void endedAnywhere_noHalfClaimStays()
    {
        for (int call = 0; call < 3; ++call) {
            const ScratchFolder place;
            const FileDescriptor folder = opened(place.file(""));
            const int code = exitCodeOf([&] {
                FailingCalls::arm(call, 0);
                return createClaimFile(folder.get(), {kTemporary, ClaimKind::File, "a"}).valid();
            });
            QCOMPARE(code, kEndedThere);
            QVERIFY(entriesOf(place.file("")).empty());
        }
    }

    /// Whoever found a claim of a dead program holds it, so that two do not clear up at once.
    void aDeadProgramsClaim_isHeldByWhoFoundItFirst()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        QCOMPARE(exitCodeOf([&] {
            const FileDescriptor file
                = createClaimFile(folder.get(), {kTemporary, ClaimKind::File, "a"});
            ::_exit(file.valid() ? kEndedThere : 1);
            return 0;
        }),
            kEndedThere);
        auto first = findClaims(folder.get());
        QVERIFY(first.size() == 1 && !first[0].isLive);
        const auto second = findClaims(folder.get());
        QVERIFY(second.size() == 1 && second[0].isLive);
        first.clear();
        const auto third = findClaims(folder.get());
        QVERIFY(third.size() == 1 && third[0].isLive == false);
    }

    /// In a folder that several users write to, a claim that only its maker can read tells nobody.
    void claims_canBeReadByOthersWhateverTheUmask()
    {
        for (const bool plain : {true, false})
            for (const mode_t mask : {mode_t(0), mode_t(022), mode_t(077), mode_t(0777)}) {
                const ScratchFolder place;
                const FileDescriptor folder = opened(place.file(""));
                const ClaimText text{kTemporary, ClaimKind::File, "a"};
                const mode_t before = ::umask(mask);
                const FileDescriptor file = plain ? createClaimFile(folder.get(), text)
                                                  : madeInTwoSteps(folder.get(), text);
                ::umask(before);
                struct stat status = {};
                QVERIFY(file.valid() && ::fstat(file.get(), &status) == 0);
                QCOMPARE(status.st_mode & 0777U, 0644U);
            }
    }

    void claims_areMadeWhereFilesHaveNoModes()
    {
        for (const bool plain : {true, false}) {
            const ScratchFolder place;
            const FileDescriptor folder = opened(place.file(""));
            const ClaimText text{kTemporary, ClaimKind::File, "a"};
            refusesModes = true;
            const FileDescriptor file
                = plain ? createClaimFile(folder.get(), text) : madeInTwoSteps(folder.get(), text);
            refusesModes = false;
            QVERIFY(file.valid());
            QCOMPARE(findClaims(folder.get()).size(), std::size_t(1));
        }
    }
};

DYNCAL_TEST(TestClaimFile)
#include "tst_claim_file.moc"
