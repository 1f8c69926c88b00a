// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_write.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/folder_cases.h"
#include "tests/support/failing_calls.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

/// The folder that is written is renamed, or its parent is, and another takes the name, between
/// any two steps of the write.
class TestFolderMoved : public QObject
{
    Q_OBJECT

private slots:
    void folderRenamed_beforeEveryCall_losesNothing();
    void folderRenamed_thenKilled_losesNothing();
    void folderRenamed_nothingInItsPlace_isSaid();
    void parentRenamed_beforeEveryCall_losesNothing();
    void parentRenamed_whileComputing_isRefused();
};

namespace {

void renameAndReplace(const Laid &laid)
{
    std::error_code error;
    fs::rename(laid.out, laid.place.file("monday"), error);
    if (!error)
        put(laid.out / "precious.csv", "precious");
}

void renameParent(const ScratchFolder &place)
{
    fs::rename(place.file("job"), place.file("job-old"));
    put(place.file("job/out/precious.csv"), "precious");
}

/// Whether both are whole: the renamed one old or new, the one in its place with what was put
/// there.
bool isNothingLost(const Laid &laid, const fs::path &renamed)
{
    const Snapshot old = snapshotOf(renamed);
    return (old == laid.before || old == laid.after)
        && contentOf((laid.out / "precious.csv").string()) == "precious";
}

void report(const Snapshot &snapshot)
{
    for (const auto &[name, content] : snapshot)
        qInfo("%s: %s", name.c_str(), content.substr(0, 40).c_str());
}

} // namespace

void TestFolderMoved::folderRenamed_beforeEveryCall_losesNothing()
{
    int refused = 0;
    for (const Case &wanted : cases()) {
        bool wasReached = wanted.exists;
        for (int call = 0; wasReached; ++call) {
            Laid laid;
            lay(laid, wanted);
            FailingCalls::armAction(call, [&] { renameAndReplace(laid); });
            const auto done = write(requestFor(laid.out.string()), kNew);
            wasReached = FailingCalls::countdown < 0;
            FailingCalls::disarm();
            if (!wasReached)
                continue;
            const auto where = QString("%1, call %2: %3")
                                   .arg(wanted.name)
                                   .arg(call)
                                   .arg(QString::fromStdString(sentenceOf(done)));
            const bool kept = isNothingLost(laid, laid.place.file("monday"));
            if (!kept)
                report(snapshotOf(laid.place.file("")));
            QVERIFY2(kept, qPrintable(where));
            QVERIFY2(done || done.error().kind == ErrorKind::Usage, qPrintable(where));
            if (!done)
                QVERIFY2(snapshotOf(laid.place.file("monday")) == laid.before, qPrintable(where));
            QVERIFY2(straysIn(laid.place.file("")) == 0, qPrintable(where));
            refused += done ? 0 : 1;
        }
    }
    QVERIFY2(refused > 20, qPrintable(QString::number(refused)));
}

/// Within the exchange: what the next program finds then. The moves cannot be completed where the
/// folder is no longer there, but nothing of it goes.
void TestFolderMoved::folderRenamed_thenKilled_losesNothing()
{
    const int stride = dyncal::trials::count(4, 1);
    int kills = 0;
    for (const Case &wanted : cases()) {
        bool wasReached = wanted.exists;
        for (int call = 0; wasReached; call += dyncal::trials::count(3, 1)) {
            for (int later = 0; wasReached && later < 8; later += stride) {
                Laid laid;
                lay(laid, wanted);
                const int ended = exitCodeOf([&] {
                    FailingCalls::armAction(call, [&] {
                        renameAndReplace(laid);
                        FailingCalls::arm(later, 0);
                    });
                    (void)write(requestFor(laid.out.string()), kNew).has_value();
                    return 0;
                });
                wasReached = fs::exists(laid.place.file("monday"));
                if (!wasReached)
                    continue;
                kills += ended == kEndedThere ? 1 : 0;
                const auto where
                    = QString("%1, call %2 and %3").arg(wanted.name).arg(call).arg(later);
                const Result<FolderWrite> next = FolderWrite::begin(requestFor(laid.out.string()));
                const auto now = snapshotOf(laid.place.file(""));
                bool kept = false, old = false, mine = true;
                for (const auto &[name, content] : now) {
                    kept = kept || content == "precious";
                    old = old || content == "old" || content == "new";
                }
                for (const auto &[name, content] : laid.before)
                    mine = mine && (content != "mine" || now.contains("monday/" + name));
                if (!kept || !old || !mine || !next)
                    report(now);
                QVERIFY2(kept && old && mine, qPrintable(where));
                QVERIFY2(next, qPrintable(where));
            }
        }
    }
    QVERIFY2(kills > 50, qPrintable(QString::number(kills)));
}

void TestFolderMoved::folderRenamed_nothingInItsPlace_isSaid()
{
    for (const Case &wanted : cases()) {
        if (!wanted.exists)
            continue;
        Laid laid;
        lay(laid, wanted);
        Result<FolderWrite> folder = FolderWrite::begin(requestFor(laid.out.string()));
        QVERIFY(folder);
        const JobControl control{{}, [&](double done) {
                                     if (done >= 1.0)
                                         fs::rename(laid.out, laid.place.file("monday"));
                                 }};
        const auto done = folder->commit(kNew, control);
        QVERIFY2(!done && done.error().kind == ErrorKind::Usage, wanted.name);
        QVERIFY2(sentenceOf(done).find("was renamed, moved or replaced") != std::string::npos,
            sentenceOf(done).c_str());
        QVERIFY(snapshotOf(laid.place.file("monday")) == laid.before);
        QVERIFY(!fs::exists(laid.out));
        QCOMPARE(straysIn(laid.place.file("")), 0);
    }
}

void TestFolderMoved::parentRenamed_beforeEveryCall_losesNothing()
{
    int refused = 0;
    for (const Case &wanted : cases()) {
        bool wasReached = wanted.exists;
        for (int call = 0; wasReached; ++call) {
            Laid laid;
            laid.out = laid.place.file("job/out");
            fs::create_directory(laid.place.file("job"));
            lay(laid, wanted);
            FailingCalls::armAction(call, [&] { renameParent(laid.place); });
            const auto done = write(requestFor(laid.out.string()), kNew);
            wasReached = FailingCalls::countdown < 0;
            FailingCalls::disarm();
            if (!wasReached)
                continue;
            const auto where = QString("%1, call %2: %3")
                                   .arg(wanted.name)
                                   .arg(call)
                                   .arg(QString::fromStdString(sentenceOf(done)));
            const bool kept = isNothingLost(laid, laid.place.file("job-old/out"));
            if (!kept)
                report(snapshotOf(laid.place.file("")));
            QVERIFY2(kept, qPrintable(where));
            QVERIFY2(done || done.error().kind == ErrorKind::Usage, qPrintable(where));
            if (!done)
                QVERIFY2(
                    snapshotOf(laid.place.file("job-old/out")) == laid.before, qPrintable(where));
            QVERIFY2(straysIn(laid.place.file("")) == 0, qPrintable(where));
            refused += done ? 0 : 1;
        }
    }
    QVERIFY2(refused > 20, qPrintable(QString::number(refused)));
}

/// The claim is older than the hour that the run takes.
void TestFolderMoved::parentRenamed_whileComputing_isRefused()
{
    for (const bool exists : {true, false}) {
        const ScratchFolder place;
        const std::string out = place.file("job/out");
        fs::create_directory(place.file("job"));
        if (exists) {
            QVERIFY(write(requestFor(out), kOld));
            put(out + "/notes/monday.txt", "mine");
        }
        const Snapshot before = snapshotOf(place.file("job"));
        Result<FolderWrite> folder = FolderWrite::begin(requestFor(out));
        QVERIFY(folder);
        renameParent(place);
        const auto done = folder->commit(kNew);
        QVERIFY(!done);
        QCOMPARE(done.error().kind, ErrorKind::Usage);
        QVERIFY2(sentenceOf(done).find("was renamed, moved or replaced") != std::string::npos,
            sentenceOf(done).c_str());
        QVERIFY(snapshotOf(place.file("job-old")) == before);
        QCOMPARE(contentOf(out + "/precious.csv"), std::string("precious"));
        QCOMPARE(straysIn(place.file("")), 0);
    }
}

DYNCAL_TEST(TestFolderMoved)
#include "tst_folder_moved.moc"
