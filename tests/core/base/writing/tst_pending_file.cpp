// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/pending_file.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/folder_snapshot.h"
#include "tests/support/failing_calls.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/base/writing/atomic_file.h"
#include "core/base/writing/temporary_name.h"
#include "core/base/writing/write_problem.h"

#include <QTest>

#include <sys/stat.h>

#include <set>
#include <thread>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

Result<void> write(const std::string &path, const Existing &existing, const std::string &bytes)
{
    Result<PendingFile> file = PendingFile::create(path, existing);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (const Result<void> written = file->write(bytes); !written)
        return written;
    return file->commit();
}

std::string sentenceOf(const Result<void> &done)
{
    return done ? std::string() : english(done.error().message);
}

const Existing kRefused{Existing::Rule::Refused};
const Existing kReplaced{Existing::Rule::Replaced};

Existing unchangedSince(const std::string &bytes)
{
    return {Existing::Rule::ReplacedIfUnchanged, sha256Hex(bytes)};
}

} // namespace

class TestPendingFile : public QObject
{
    Q_OBJECT

private slots:
    void recordings_areNeverReplaced()
    {
        const ScratchFolder place;
        const std::string path = place.file("shot.h5");
        QVERIFY(write(path, kRefused, "first"));
        const auto again = write(path, kRefused, "second");
        QVERIFY(!again);
        QCOMPARE(again.error().kind, ErrorKind::Usage);
        QVERIFY2(
            sentenceOf(again).starts_with(path + " exists already"), sentenceOf(again).c_str());
        fs::create_symlink(place.file("nowhere"), place.file("link.h5"));
        QVERIFY(!write(place.file("link.h5"), kRefused, "x"));
        QVERIFY(fs::is_symlink(place.file("link.h5")) && !fs::exists(place.file("nowhere")));
        QCOMPARE(contentOf(path), std::string("first"));
    }

    /// Somebody puts a file there after it was looked at, and before the new one gets its name.
    void whatAppearsMeanwhile_isNotReplaced()
    {
        const ScratchFolder place;
        const std::string path = place.file("shot.h5");
        for (const Existing &rule : {kRefused, Existing{Existing::Rule::ReplacedIfUnchanged}}) {
            Result<PendingFile> file = PendingFile::create(path, rule);
            QVERIFY(file && file->write("ours"));
            std::ofstream(path) << "theirs";
            const auto done = file->commit();
            QVERIFY(!done && done.error().kind == ErrorKind::Usage);
            QCOMPARE(contentOf(path), std::string("theirs"));
            fs::remove(path);
        }
        QCOMPARE(straysIn(place.file("")), 0);
    }

    void changedMeanwhile_isToldByItsHash()
    {
        const ScratchFolder place;
        const std::string path = place.file("job.dyncal");
        QVERIFY(replaceUnchangedFile(path, "one", std::nullopt));
        QVERIFY(replaceUnchangedFile(path, "two", sha256Hex("one")));
        for (const auto &expected : {std::optional(sha256Hex("one")), std::optional<std::string>(),
                 std::optional(std::string())}) {
            const auto done = replaceUnchangedFile(path, "three", expected);
            QVERIFY(!done);
            QCOMPARE(done.error().findingId, std::string(kChangedMeanwhile));
            QCOMPARE(contentOf(path), std::string("two"));
        }
        fs::remove(path);
        const auto gone = replaceUnchangedFile(path, "three", sha256Hex("two"));
        QVERIFY(!gone && gone.error().findingId == kChangedMeanwhile);
        QVERIFY(!fs::exists(path));
    }

    /// What it led to stays, whatever stands there.
    void linkToAnUnchangedFile_isReplaced()
    {
        const ScratchFolder place;
        const std::string path = place.file("link.dyncal");
        QVERIFY(write(place.file("job.dyncal"), kReplaced, "one"));
        fs::create_symlink("job.dyncal", path);
        const auto other = replaceUnchangedFile(path, "two", sha256Hex("other"));
        QVERIFY(!other && other.error().findingId == kChangedMeanwhile);
        QVERIFY(fs::is_symlink(path));
        QVERIFY(replaceUnchangedFile(path, "two", sha256Hex("one")));
        QVERIFY(!fs::is_symlink(path));
        QCOMPARE(contentOf(path), std::string("two"));
        QCOMPARE(contentOf(place.file("job.dyncal")), std::string("one"));
        fs::create_symlink("nowhere", place.file("dangling"));
        QVERIFY(!replaceUnchangedFile(place.file("dangling"), "two", sha256Hex("one")));
        QVERIFY(!replaceUnchangedFile(place.file("dangling"), "two", std::nullopt));
    }

    void replacedFile_keepsItsPermissions()
    {
        const ScratchFolder place;
        QVERIFY(write(place.file("private"), kReplaced, "one"));
        QCOMPARE(::chmod(place.file("private").c_str(), 0600), 0);
        QVERIFY(write(place.file("private"), kReplaced, "two"));
        struct stat status = {};
        QCOMPARE(::stat(place.file("private").c_str(), &status), 0);
        QCOMPARE(status.st_mode & 0777U, 0600U);
    }

    void names_ofAnyLengthThatTheSystemTakes()
    {
        const ScratchFolder place;
        for (const std::size_t length : {1UL, 240UL, 253UL, 255UL}) {
            const std::string path = place.file(std::string(length, 'n'));
            QVERIFY(write(path, kReplaced, "x"));
            QVERIFY(write(path, kReplaced, "y"));
            QCOMPARE(contentOf(path), std::string("y"));
        }
        const auto tooLong = write(place.file(std::string(256, 'n')), kReplaced, "x");
        QVERIFY(!tooLong && tooLong.error().kind == ErrorKind::Usage);
        QVERIFY2(sentenceOf(tooLong).ends_with("File name too long; choose a shorter name."),
            sentenceOf(tooLong).c_str());
        QCOMPARE(straysIn(place.file("")), 0);
    }

    void endedAtEveryCall_oldOrNewAndNothingAfterTheNextWrite()
    {
        int ends = 0;
        for (const bool exists : {false, true}) {
            const Existing rule = exists ? unchangedSince("old") : kRefused;
            for (int call = 0, code = kEndedThere; code == kEndedThere; ++call) {
                const ScratchFolder place;
                const std::string path = place.file("file");
                if (exists)
                    QVERIFY(write(path, kReplaced, "old"));
                code = exitCodeOf([&] {
                    FailingCalls::arm(call, 0);
                    return write(path, rule, "new") ? 0 : 1;
                });
                ends += code == kEndedThere ? 1 : 0;
                const std::string now = contentOf(path);
                QVERIFY(now == (exists ? "old" : "(none)") || now == "new");
                QVERIFY(write(place.file("other"), kReplaced, "x")); // any write into the folder
                QCOMPARE(straysIn(place.file("")), 0);
                QCOMPARE(contentOf(path), now);
            }
        }
        qInfo("%d ends", ends);
        QVERIFY(ends >= 10);
    }

    void everyFailingCall_leavesTheOldOrTheNew()
    {
        int failures = 0;
        for (const bool exists : {false, true}) {
            for (int call = 0, reached = true; reached; ++call) {
                const ScratchFolder place;
                const std::string path = place.file("file");
                if (exists)
                    QVERIFY(write(path, kReplaced, "old"));
                FailingCalls::arm(call, ENOSPC);
                const auto done = write(path, exists ? kReplaced : kRefused, "new");
                reached = FailingCalls::countdown < 0;
                FailingCalls::disarm();
                failures += done ? 0 : 1;
                const std::string now = contentOf(path);
                QVERIFY(now == "new" || (!done && now == (exists ? "old" : "(none)")));
                QVERIFY(done || !sentenceOf(done).empty());
                QVERIFY(write(place.file("other"), kReplaced, "x"));
                QCOMPARE(straysIn(place.file("")), 0);
            }
        }
        QVERIFY(failures >= 10);
    }

    void races_haveOneWinner()
    {
        constexpr int kRaces = 200;
        for (int race = 0; race < kRaces; ++race) {
            const ScratchFolder place;
            const std::string path = place.file("shot.h5");
            std::atomic<int> ready = 0, winners = 0, told = 0;
            const auto writer = [&](const std::string &bytes) {
                ++ready;
                while (ready < 2) { }
                const auto done = write(path, kRefused, bytes);
                const std::string sentence = sentenceOf(done);
                winners += done ? 1 : 0;
                told += sentence.find("is being written") != std::string::npos
                        || sentence.find("exists already") != std::string::npos
                    ? 1
                    : 0;
            };
            {
                const std::jthread one(writer, "one");
                const std::jthread two(writer, "two");
            }
            QCOMPARE(winners.load(), 1);
            QCOMPARE(told.load(), 1);
            QCOMPARE(straysIn(place.file("")), 0);
        }
    }

    void plantedUnderEveryName_isLeftAlone()
    {
        const auto nameOf = [](int i) {
            return ".dyncal-" + std::string(31, 'a') + std::string(1, static_cast<char>('0' + i));
        };
        const ScratchFolder place;
        std::ofstream(place.file("precious")) << "precious";
        for (const char *suffix : {"", ".claim"}) {
            fs::create_symlink(place.file("precious"), place.file(nameOf(0) + suffix));
            QCOMPARE(::mkfifo(place.file(nameOf(1) + suffix).c_str(), 0600), 0);
            fs::create_directory(place.file(nameOf(2) + suffix));
            std::ofstream(place.file(nameOf(3) + suffix)) << "planted";
        }
        const Snapshot planted = snapshotOf(place.file(""));
        int next = 0;
        setTemporaryNames([&] { return nameOf(next++); });
        const auto done = write(place.file("out"), kReplaced, "ours");
        setTemporaryNames({});
        QVERIFY2(done, sentenceOf(done).c_str());
        Snapshot now = snapshotOf(place.file(""));
        QCOMPARE(now.at("out"), std::string("ours"));
        now.erase("out");
        QVERIFY(now == planted);
    }

    void temporaryNames_cannotBeForeseen()
    {
        std::set<std::string> names;
        for (int i = 0; i < 1000; ++i) {
            const std::string name = newTemporaryName();
            QVERIFY(isTemporaryName(name));
            names.insert(name);
        }
        QCOMPARE(names.size(), std::size_t(1000));
        for (const char *other :
            {".dyncal-", "x.part", ".dyncal-0123", "", ".dyncal-0123456789abcdef0123456789abcdeg",
                ".dyncal-0123456789ABCDEF0123456789abcdef"})
            QVERIFY2(!isTemporaryName(other), other);
    }
};

DYNCAL_TEST(TestPendingFile)
#include "tst_pending_file.moc"
