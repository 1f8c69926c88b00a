// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/base/writing/atomic_file.h"
#include "core/base/writing/folder_plan.h"
#include "core/base/writing/folder_write.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/folder_cases.h"
#include "tests/support/failing_calls.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <fcntl.h>
#include <sys/stat.h>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

/// What an earlier program left, or somebody planted to look so.
class TestFolderRecovery : public QObject
{
    Q_OBJECT

private slots:
    void forgedMoves_ofASibling_areNotCarriedOut();
    void forgedMoves_ofTheFolder_areNotCarriedOut();
    void forgedExchange_isNotCarriedOut();
    void folderGoneAfterAKill_isWrittenAnew_data();
    void folderGoneAfterAKill_isWrittenAnew();
};

namespace {

const std::string kForged = ".dyncal-0123456789abcdef0123456789abcdef";

ino_t inodeOf(const std::string &path)
{
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

/// A claim of a program that is gone, and its staging folder with a plan that takes "shot.csv" and
/// "csv/shot.csv" away and puts others in their place.
void forge(const ScratchFolder &place, const std::string &target, const char *kind,
    const WrittenList &retired, const WrittenList &placed)
{
    put(place.file(kForged + ".claim"), "dyncal-claim/1\n" + kForged + "\nfolder\n" + target);
    const std::string staging = place.file(kForged);
    fs::create_directories(staging + "/tree");
    for (const WrittenFile &file : placed)
        put(staging + "/tree/" + file.file, "planted");
    const int folder = ::open(staging.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    // The worst case: it knows the inodes, which no archive does.
    const ino_t tree = std::string(kind) == kMovesPlan ? inodeOf(staging + "/tree") : 1;
    const bool written
        = writePlan(folder, kind, {tree, inodeOf(place.file(target)), retired, placed});
    ::close(folder);
    if (!written)
        qFatal("the plan cannot be forged");
}

WrittenFile entry(const std::string &name, const std::string &bytes)
{
    return {name, "run", sha256Hex(bytes)};
}

} // namespace

void TestFolderRecovery::forgedMoves_ofASibling_areNotCarriedOut()
{
    const ScratchFolder place;
    put(place.file("measurements/csv/shot.csv"), "recording");
    put(place.file("measurements/results.json"), "mine");
    forge(place, "measurements", kMovesPlan,
        {entry("csv/shot.csv", "recording"), entry("results.json", "mine")},
        {entry("certificate.pdf", "planted")});
    const Snapshot before = snapshotOf(place.file("measurements"));
    QVERIFY(write(requestFor(place.file("out")), kNew));
    QVERIFY(snapshotOf(place.file("measurements")) == before);
    QVERIFY(writeFileAtomically(place.file("measurements.txt"), "x"));
    QVERIFY(snapshotOf(place.file("measurements")) == before);
}

void TestFolderRecovery::forgedMoves_ofTheFolder_areNotCarriedOut()
{
    const std::vector<std::pair<WrittenList, WrittenList>> plans{
        {{entry("shot.csv", "recording")}, {}}, // a name that is not ours
        {{}, {entry(".profile", "planted")}},
        {{entry("csv/shot.csv", "recording")}, {}}, // ours by its name, but not on the list
        {{entry("csv/shot.csv", "recording"), entry(kWrittenList, "no such list")}, {}},
    };
    for (const auto &[retired, placed] : plans) {
        const ScratchFolder place;
        const std::string out = place.file("out");
        QVERIFY(write(requestFor(out), kOld));
        put(out + "/shot.csv", "recording");
        put(out + "/csv/shot.csv", "recording");
        const Snapshot before = snapshotOf(out);
        forge(place, "out", kMovesPlan, retired, placed);
        (void)FolderWrite::begin(requestFor(out)).has_value(); // refused or not
        QVERIFY(snapshotOf(out) == before);
    }
}

void TestFolderRecovery::forgedExchange_isNotCarriedOut()
{
    const ScratchFolder place;
    const std::string out = place.file("out");
    QVERIFY(write(requestFor(out), kOld));
    put(out + "/shot.csv", "recording");
    const Snapshot before = snapshotOf(out);
    forge(place, "out", kExchangePlan, {}, {entry("csv/planted.csv", "planted")});
    QVERIFY(FolderWrite::begin(requestFor(out)));
    QVERIFY(snapshotOf(out) == before);
}

void TestFolderRecovery::folderGoneAfterAKill_isWrittenAnew_data()
{
    QTest::addColumn<bool>("isDeleted");
    QTest::newRow("deleted") << true;
    QTest::newRow("renamed") << false;
}

/// Killed at any call; then the user moves the folder away or deletes it and writes once more.
void TestFolderRecovery::folderGoneAfterAKill_isWrittenAnew()
{
    QFETCH(bool, isDeleted);
    const int stride = dyncal::trials::count(3, 1);
    for (const Case &wanted : cases()) {
        for (int call = 0, ended = kEndedThere; wanted.exists && ended == kEndedThere;
             call += stride) {
            Laid laid;
            lay(laid, wanted);
            ended = exitCodeOf([&] {
                FailingCalls::arm(call, 0);
                const bool done = write(requestFor(laid.out.string()), kNew).has_value();
                FailingCalls::disarm();
                return done ? 0 : 1;
            });
            const auto where = QString("%1, call %2").arg(wanted.name).arg(call);
            const Snapshot left = snapshotOf(laid.out);
            if (isDeleted)
                fs::remove_all(laid.out);
            else
                fs::rename(laid.out, laid.place.file("monday"));
            const auto done = write(requestFor(laid.out.string()), kNew);
            QVERIFY2(done, qPrintable(where + QString::fromStdString(sentenceOf(done))));
            QCOMPARE(contentOf((laid.out / "results.json").string()), std::string("new"));
            if (!isDeleted)
                QVERIFY2(snapshotOf(laid.place.file("monday")) == left, qPrintable(where));
            QVERIFY2(straysIn(laid.place.file("")) == 0, qPrintable(where));
        }
    }
}

DYNCAL_TEST(TestFolderRecovery)
#include "tst_folder_recovery.moc"
