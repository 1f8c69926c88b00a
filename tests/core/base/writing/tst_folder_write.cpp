// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_write.h"
#include "tests/core/base/guarded_test_child.h"
#include "tests/core/base/writing/folder_cases.h"
#include "tests/support/failing_calls.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include "core/base/content_hash.h"
#include "core/base/writing/temporary_name.h"

#include <QTest>

#include <sys/stat.h>

#include <thread>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

class TestFolderWrite : public QObject
{
    Q_OBJECT

private slots:
    void write_lists_whatItWrote();
    void write_again_replacesItsOwnOnly();
    void foreignNames_areRefusedAndKept_data();
    void foreignNames_areRefusedAndKept();
    void changedFile_isRefused();
    void recordingInside_isRefused();
    void aPlantedList_claimsNothingElse();
    void killedAtEveryCall_isWhollyOldOrNew();
    void everyFailingCall_leavesTheOldOrTheNew();
    void stoppedAnywhere_changesNothing();
    void secondWriter_isToldAtOnce();
    void races_haveOneWinner();
    void plantedUnderEveryName_isLeftAlone();
    void permissions_areKept();
    void claims_areSeenByOthers();
    void foldersAndLinks_areSaid();
};

void TestFolderWrite::write_lists_whatItWrote()
{
    const ScratchFolder place;
    const std::string out = place.file("a/b/out");
    QVERIFY(write(requestFor(out), kOld));
    const auto list = parseWrittenList(contentOf(out + "/written.json"));
    QVERIFY(list);
    QCOMPARE(list->size(), kOld.size());
    for (const WrittenFile &file : *list) {
        QCOMPARE(file.by, std::string("run"));
        QCOMPARE(file.sha256, sha256OfFile(out + '/' + file.file));
    }
    QCOMPARE(straysIn(place.file("")), 0);
}

void TestFolderWrite::write_again_replacesItsOwnOnly()
{
    for (const Case &wanted : cases()) {
        Laid laid;
        lay(laid, wanted);
        QVERIFY2(write(requestFor(laid.out.string()), kNew), wanted.name);
        const Snapshot now = snapshotOf(laid.out);
        QVERIFY2(now == laid.after, wanted.name);
        QCOMPARE(now.at("results.json"), std::string("new"));
        QVERIFY(!now.contains("certificate.pdf"));
        for (const auto &[name, content] : laid.before)
            if (content == "mine" || content.starts_with("-> "))
                QCOMPARE(now.at(name), content);
        QCOMPARE(straysIn(laid.place.file("")), 0);
    }
}

void TestFolderWrite::foreignNames_areRefusedAndKept_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("kind"); // 0 file, 1 folder, 2 link, 3 dangling link
    for (const QString name : {"results.json", "certificate.pdf", "written.json", "csv/a.csv"})
        for (int kind = 0; kind < 4; ++kind)
            QTest::newRow(qPrintable(QString("%1 %2").arg(name).arg(kind))) << name << kind;
    QTest::addRow("csv is a file") << "csv" << 0;
    QTest::addRow("csv is a link") << "csv" << 2;
}

void TestFolderWrite::foreignNames_areRefusedAndKept()
{
    QFETCH(QString, name);
    QFETCH(int, kind);
    const ScratchFolder place;
    const fs::path out = place.file("out");
    const fs::path target = out / name.toStdString();
    fs::create_directories(target.parent_path());
    put(place.file("elsewhere/a.csv"), "precious");
    if (kind == 0)
        put(target, "precious");
    else if (kind == 1)
        fs::create_directory(target);
    else
        fs::create_symlink(place.file(kind == 2 ? "elsewhere" : "nowhere"), target);
    const Snapshot before = snapshotOf(place.file(""));
    const auto done = write(requestFor(out.string()), kNew);
    QVERIFY(!done);
    QCOMPARE(done.error().kind, ErrorKind::Usage);
    QVERIFY2(sentenceOf(done).starts_with((out / name.toStdString()).string() + " is in the way")
            || name.startsWith("csv"),
        sentenceOf(done).c_str());
    QVERIFY(snapshotOf(place.file("")) == before);
}

void TestFolderWrite::changedFile_isRefused()
{
    const ScratchFolder place;
    const std::string out = place.file("out");
    QVERIFY(write(requestFor(out), kOld));
    put(out + "/csv/a.csv", "edited");
    const Snapshot before = snapshotOf(out);
    const auto done = write(requestFor(out), kNew);
    QVERIFY(!done);
    QVERIFY2(sentenceOf(done).find("csv/a.csv was changed") != std::string::npos,
        sentenceOf(done).c_str());
    QVERIFY(snapshotOf(out) == before);
    fs::remove(out + "/csv/a.csv"); // one that is gone is no obstacle
    QVERIFY(write(requestFor(out), kNew));
}

void TestFolderWrite::recordingInside_isRefused()
{
    const ScratchFolder place;
    const std::string out = place.file("out");
    put(out + "/deep/er/shot.csv", "recording");
    put(place.file("other.csv"), "recording");
    fs::create_hard_link(place.file("other.csv"), out + "/second-name.csv");
    fs::create_symlink(out + "/deep/er/shot.csv", place.file("link.csv"));
    for (const std::string &recording : {out + "/deep/er/shot.csv", place.file("other.csv"),
             place.file("link.csv"), place.file("out/../out/deep/er/shot.csv")}) {
        FolderRequest request = requestFor(out);
        request.recordings = {recording};
        const auto done = write(request, kNew);
        QVERIFY2(!done, recording.c_str());
        QCOMPARE(done.error().kind, ErrorKind::Usage);
        QVERIFY(sentenceOf(done).find(recording) != std::string::npos);
    }
    FolderRequest request = requestFor(out);
    put(out + "/recipe.txt", "{}");
    request.settings = {out + "/recipe.txt"};
    QVERIFY(write(request, kNew)); // a recipe may lie there
    request.settings = {out + "/results.json"};
    QVERIFY(!write(request, kNew)); // but not where something is written
}

void TestFolderWrite::aPlantedList_claimsNothingElse()
{
    const ScratchFolder place;
    const std::string out = place.file("out");
    put(out + "/shot.csv", "recording");
    for (const char *name : {"shot.csv", "../out/shot.csv", "/etc/hostname", "csv/../shot.csv"}) {
        put(out + "/written.json", writtenListText({{name, "run", sha256Hex("recording")}}));
        const Snapshot before = snapshotOf(out);
        QVERIFY2(!write(requestFor(out), kNew), name);
        QVERIFY(snapshotOf(out) == before);
    }
}

/// Ended at every single call that changes a file (at every other in the suite): for the cases that
/// are exchanged the folder is wholly old or wholly new at once, for the others after the next
/// program has looked at it.
void TestFolderWrite::killedAtEveryCall_isWhollyOldOrNew()
{
    int kills = 0;
    const int stride = dyncal::trials::count(2, 1);
    for (const Case &wanted : cases()) {
        for (int call = 0, ended = kEndedThere; ended == kEndedThere; call += stride) {
            Laid laid;
            lay(laid, wanted);
            ended = exitCodeOf([&] {
                FailingCalls::arm(call, 0);
                const bool done = write(requestFor(laid.out.string()), kNew).has_value();
                FailingCalls::disarm();
                return done ? 0 : 1;
            });
            QVERIFY2(ended == 0 || ended == kEndedThere, qPrintable(QString::number(ended)));
            kills += ended == kEndedThere ? 1 : 0;
            Snapshot now = snapshotOf(laid.out);
            const auto where = QString("%1, call %2").arg(wanted.name).arg(call);
            if (wanted.isExchanged)
                QVERIFY2(now == laid.before || now == laid.after, qPrintable(where));
            { // the next writer, which writes nothing yet
                const Result<FolderWrite> next = FolderWrite::begin(requestFor(laid.out.string()));
                QVERIFY2(next, qPrintable(where));
            }
            now = snapshotOf(laid.out);
            QVERIFY2(now == laid.before || now == laid.after, qPrintable(where));
            QVERIFY2(straysIn(laid.place.file("")) == 0, qPrintable(where));
        }
    }
    qInfo("%d ends", kills);
    QVERIFY(kills > 200 / stride);
}

void TestFolderWrite::everyFailingCall_leavesTheOldOrTheNew()
{
    int failures = 0;
    const int stride = dyncal::trials::count(4, 1);
    for (const int error : {ENOSPC, EIO}) {
        for (const Case &wanted : cases()) {
            bool wasReached = true;
            for (int call = error == EIO ? 2 : 0; wasReached; call += stride) {
                Laid laid;
                lay(laid, wanted);
                FailingCalls::arm(call, error);
                const auto done = write(requestFor(laid.out.string()), kNew);
                wasReached = FailingCalls::countdown < 0;
                FailingCalls::disarm();
                failures += done ? 0 : 1;
                const auto where = QString("%1, call %2: %3")
                                       .arg(wanted.name)
                                       .arg(call)
                                       .arg(QString::fromStdString(sentenceOf(done)));
                { // what could not be cleared at once
                    const Result<FolderWrite> next
                        = FolderWrite::begin(requestFor(laid.out.string()));
                    QVERIFY2(next, qPrintable(where));
                }
                const Snapshot now = snapshotOf(laid.out);
                QVERIFY2(now == laid.before || now == laid.after, qPrintable(where));
                QVERIFY2(!done || now == laid.after, qPrintable(where));
                QVERIFY2(straysIn(laid.place.file("")) == 0, qPrintable(where));
            }
        }
    }
    qInfo("%d failures", failures);
    QVERIFY(failures > 200 / stride);
}

void TestFolderWrite::stoppedAnywhere_changesNothing()
{
    for (int files = 0; files < 3; ++files) {
        Laid laid;
        lay(laid, cases()[1]);
        std::stop_source stop;
        int reports = 0;
        if (files == 0)
            stop.request_stop();
        const JobControl control{stop.get_token(), [&](double) {
                                     if (++reports == files)
                                         stop.request_stop();
                                 }};
        {
            Result<FolderWrite> folder = FolderWrite::begin(requestFor(laid.out.string()));
            QVERIFY(folder);
            const auto done = folder->commit(kNew, control);
            QVERIFY(!done && done.error().kind == ErrorKind::Cancelled);
        }
        QVERIFY(snapshotOf(laid.out) == laid.before);
        QCOMPARE(straysIn(laid.place.file("")), 0);
    }
    const ScratchFolder place;
    {
        const auto begun = FolderWrite::begin(requestFor(place.file("a/b/c")));
        QVERIFY(begun);
    }
    QVERIFY(!fs::exists(place.file("a"))); // nothing was written, so nothing was made
}

void TestFolderWrite::secondWriter_isToldAtOnce()
{
    const ScratchFolder place;
    fs::create_directory(place.file("there"));
    fs::create_directory_symlink(place.file("there"), place.file("link"));
    for (const auto &[first, second] : {std::pair("new", "new"), std::pair("there", "there"),
             std::pair("there", "link"), std::pair("link", "there")}) {
        Result<FolderWrite> one = FolderWrite::begin(requestFor(place.file(first)));
        QVERIFY(one);
        const auto other = write(requestFor(place.file(second)), kNew);
        QVERIFY(!other);
        QCOMPARE(other.error().kind, ErrorKind::Usage);
        QVERIFY2(sentenceOf(other).find("is being written by another program") != std::string::npos,
            sentenceOf(other).c_str());
        QVERIFY(one->commit(kOld));
    }
}

void TestFolderWrite::races_haveOneWinner()
{
    constexpr int kRaces = 200;
    for (int race = 0; race < kRaces; ++race) {
        const ScratchFolder place;
        std::atomic<int> ready = 0, attempts = 0, winners = 0, told = 0;
        const auto writer = [&](const std::vector<FolderFile> &files) {
            ++ready;
            while (ready < 2) { }
            Result<FolderWrite> folder = FolderWrite::begin(requestFor(place.file("out")));
            ++attempts;
            while (attempts < 2) { } // so that the two overlap for certain
            if (!folder) {
                told
                    += english(folder.error().message).find("is being written") != std::string::npos
                    ? 1
                    : 0;
                return;
            }
            winners += folder->commit(files) ? 1 : 0;
        };
        {
            const std::jthread one(writer, kOld);
            const std::jthread two(writer, kNew);
        }
        QCOMPARE(winners.load(), 1);
        QCOMPARE(told.load(), 1);
        const std::string results = contentOf(place.file("out/results.json"));
        QVERIFY(results == "old" || results == "new");
        QCOMPARE(fs::exists(place.file("out/certificate.pdf")), results == "old");
        QCOMPARE(straysIn(place.file("")), 0);
    }
}

void TestFolderWrite::plantedUnderEveryName_isLeftAlone()
{
    const auto nameOf = [](int i) {
        return ".dyncal-" + std::string(31, '0') + std::string(1, static_cast<char>('0' + i));
    };
    const ScratchFolder place;
    put(place.file("precious"), "precious");
    for (const char *in : {"", "out/"}) {
        fs::create_directories(place.file("out"));
        for (const char *suffix : {"", ".claim"}) {
            const std::string at = place.file(in);
            fs::create_symlink(place.file("precious"), at + nameOf(0) + suffix);
            QCOMPARE(::mkfifo((at + nameOf(1) + suffix).c_str(), 0600), 0);
            put(at + nameOf(2) + suffix + "/inside", "planted");
            put(at + nameOf(3) + suffix, "planted");
            put(at + nameOf(4) + suffix, "");
            fs::create_directory(at + nameOf(5) + suffix);
        }
        put(place.file(in) + nameOf(6) + ".claim",
            "dyncal-claim/1\n" + nameOf(5) + "\nfolder\nout"); // of another name
    }
    const Snapshot planted = snapshotOf(place.file(""));
    int next = 0;
    setTemporaryNames([&] { return nameOf(next++ % 8); });
    const auto first = write(requestFor(place.file("out")), kOld);
    next = 0;
    const auto second = write(requestFor(place.file("out")), kNew);
    setTemporaryNames({});
    QVERIFY2(first, sentenceOf(first).c_str());
    QVERIFY2(second, sentenceOf(second).c_str());
    const Snapshot now = snapshotOf(place.file(""));
    for (const auto &[name, content] : planted)
        QVERIFY2(now.contains(name) && now.at(name) == content, name.c_str());
    QCOMPARE(now.at("out/results.json"), std::string("new"));
}

void TestFolderWrite::permissions_areKept()
{
    const auto modeOf = [](const fs::path &file) { return fs::status(file).permissions(); };
    for (const Case &wanted : cases()) {
        if (!wanted.exists)
            continue;
        Laid laid;
        lay(laid, wanted);
        constexpr auto kOwner = fs::perms::owner_read | fs::perms::owner_write;
        for (const char *name : {"results.json", "written.json", "csv/a.csv"})
            fs::permissions(laid.out / name, kOwner);
        QVERIFY2(write(requestFor(laid.out.string()), kNew), wanted.name);
        for (const char *name : {"results.json", "written.json", "csv/a.csv"})
            QVERIFY2(modeOf(laid.out / name) == kOwner, name);
        QVERIFY(modeOf(laid.out / "csv/b.csv") != kOwner); // new: as the umask says
        QCOMPARE(contentOf((laid.out / "csv/a.csv").string()), std::string("2"));
    }
}

void TestFolderWrite::claims_areSeenByOthers()
{
    const ScratchFolder place;
    const mode_t before = ::umask(077);
    const Result<FolderWrite> begun = FolderWrite::begin(requestFor(place.file("out")));
    ::umask(before);
    QVERIFY(begun);
    int claims = 0;
    for (const auto &entry : fs::directory_iterator(place.file("")))
        if (entry.path().extension() == ".claim") {
            ++claims;
            QVERIFY(fs::status(entry.path()).permissions() == fs::perms(0644));
        }
    QCOMPARE(claims, 1);
}

void TestFolderWrite::foldersAndLinks_areSaid()
{
    const ScratchFolder place;
    put(place.file("file"), "x");
    fs::create_symlink(place.file("nowhere"), place.file("dangling"));
    for (const std::string &folder : {place.file("file"), place.file("file/below"),
             place.file("dangling"), std::string(), std::string("/proc/nothing/here")}) {
        const auto done = write(requestFor(folder), kNew);
        QVERIFY2(!done && done.error().kind == ErrorKind::Usage, folder.c_str());
    }
    QCOMPARE(contentOf(place.file("file")), std::string("x"));
    QVERIFY(write(requestFor(place.file("slash/")), kNew));
    QVERIFY(fs::exists(place.file("slash/results.json")));
}

DYNCAL_TEST(TestFolderWrite)
#include "tst_folder_write.moc"
