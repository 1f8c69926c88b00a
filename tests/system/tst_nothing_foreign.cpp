// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever lies in and around the folders that the program writes to, it changes nothing that is
// not its own; and a program that is killed leaves the old or the new, whole.

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/own_files.h"
#include "tests/system/quick_recipe.h"
#include "tests/system/random_layout.h"
#include "tests/system/short_capture.h"

#include "tests/support/trial_count.h"

#include <QtTest>

#include <chrono>
#include <csignal>
#include <thread>

using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

constexpr unsigned kSeed = 20260101;
constexpr int kLongest_ms = 120000;
const QStringList kFixedClock{"SOURCE_DATE_EPOCH=1700000000"};

/// A short capture of its own seed.
std::string simulated(const ScratchFolder &folder, const std::string &name, int seed)
{
    const QString path = QString::fromStdString(folder.file(name));
    if (!simulateShortCapture(path, seed))
        qFatal("There is no capture %s to work with.", qPrintable(path));
    return path.toStdString();
}

/// A call of the program: its arguments, and what it may leave.
struct Call
{
    QStringList arguments;
    fs::path target; ///< file or folder
};

Call randomCall(RandomLayout &layout, const fs::path &root)
{
    const QString recording = QString::fromStdString(layout.recording().string());
    const std::string name
        = layout.pick({"out/new.h5", "out/shot1.h5", "rec/new.h5", "out/results.json", "new.h5"});
    const fs::path folder = layout.pick({"out", "out", "out", "out/sub", "rec", "."});
    const QString file = QString::fromStdString((root / name).string());
    const QString into = QString::fromStdString((root / folder).string());
    switch (layout.number(0, 5)) {
    case 0:
        return {{"simulate", "-o", file, "--duration-s", "0.003", "--sample-rate-hz", "1e7",
                    "--preset", "piezo", "--shots", "low"},
            root / name};
    case 1:
        return {{"import", recording, "-o", file}, root / name};
    case 2:
        return {QStringList{"export", recording, "-o", into} + quickly(), root / folder};
    default:
        return {QStringList{"run", recording, "-o", into} + quickly(), root / folder};
    }
}

/// A call that is repeated with two inputs and killed at random moments.
struct Killed
{
    const char *name;
    QStringList first;
    QStringList second;
    fs::path target;
};

Snapshot stateOf(const fs::path &target)
{
    if (fs::is_directory(target))
        return snapshotOf(target);
    return fs::exists(target) ? Snapshot{{"", contentOf(target.string())}} : Snapshot{};
}

bool hasStaging(const fs::path &folder)
{
    std::error_code error;
    for (const auto &entry : fs::directory_iterator(folder, error))
        if (entry.path().filename().string().starts_with(".dyncal-")
            && !entry.path().string().ends_with(".claim"))
            return true;
    return false;
}

/// Starts the call and kills it: at a random moment, or soon after it begins to write.
void killedCall(const Killed &what, bool isSecond, std::mt19937 &random, qint64 usual_ms)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("SOURCE_DATE_EPOCH", "1700000000");
    environment.remove("QT_QPA_PLATFORM");
    process.setProcessEnvironment(environment);
    const auto begin = std::chrono::steady_clock::now();
    process.start(qEnvironmentVariable("DYNCAL_BINARY"), isSecond ? what.second : what.first);
    process.waitForStarted();
    const auto passed_ms = [&] {
        return std::chrono::duration_cast<std::chrono::milliseconds>(
            std::chrono::steady_clock::now() - begin)
            .count();
    };
    const bool waitsForWriting = std::uniform_int_distribution<int>(0, 3)(random) > 0;
    const auto longest = std::uniform_int_distribution<qint64>(0, usual_ms)(random);
    while (process.state() != QProcess::NotRunning
        && (waitsForWriting ? !hasStaging(what.target.parent_path()) && passed_ms() < kLongest_ms
                            : passed_ms() < longest)) {
        process.waitForFinished(0);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    if (waitsForWriting)
        std::this_thread::sleep_for(
            std::chrono::microseconds(std::uniform_int_distribution<int>(0, 60000)(random)));
    process.kill();
    process.waitForFinished(kLongest_ms);
}

} // namespace

class TestNothingForeign : public QObject
{
    Q_OBJECT

private slots:
    void randomLayouts_noForeignByteChanges()
    {
        const int layouts = dyncal::trials::count(8, 200);
        const ScratchFolder captures;
        const std::string capture = simulated(captures, "c.h5", 1);
        int refused = 0, written = 0;
        for (int i = 0; i < layouts; ++i) {
            const ScratchFolder place;
            const fs::path root = place.file("");
            RandomLayout layout(root, capture, kSeed + static_cast<unsigned>(i));
            for (int calls = 0; calls < 2; ++calls) {
                const Snapshot before = snapshotOf(root);
                const std::set<std::string> own = ownFiles(root, {"out", "out/sub"});
                const Call call = randomCall(layout, root);
                const Answer answer = runDyncal(call.arguments, kFixedClock);
                const QString what
                    = QString("layout %1: %2\n%3").arg(i).arg(call.arguments.join(' '), answer.err);
                QVERIFY2(answer.exitCode == 0 || answer.exitCode == 1 || answer.exitCode == 4
                        || answer.exitCode == 3,
                    qPrintable(QString::number(answer.exitCode) + ' ' + what));
                (answer.exitCode == 4 ? refused : written) += 1;
                const Snapshot now = snapshotOf(root);
                const std::string harmed = firstHarmed(before, now, own);
                QVERIFY2(harmed.empty(), qPrintable(QString::fromStdString(harmed) + ' ' + what));
                if (answer.exitCode == 4)
                    QVERIFY2(now == before, qPrintable(what));
            }
        }
        qInfo("%d layouts: %d calls refused, %d not", layouts, refused, written);
        QVERIFY(refused > 0 && written > 0);
    }

    void killedAtRandomMoments_leavesTheOldOrTheNewWhole()
    {
        const int kills = dyncal::trials::count(12, 500);
        const ScratchFolder place;
        const auto text = [](const std::string &path) { return QString::fromStdString(path); };
        const QString a = text(simulated(place, "a.h5", 1));
        const QString b = text(simulated(place, "b.h5", 2));
        const auto target = [&](const char *name) { return fs::path(place.file(name)); };
        const QStringList simulate{"simulate", "--duration-s", "0.003", "--sample-rate-hz", "1e7",
            "--preset", "piezo", "--replace", "-o", text(place.file("s/s.h5")), "--seed"};
        std::vector<Killed> calls{
            {"run", QStringList{"run", a, "-o", text(place.file("r/out"))} + quickly(),
                QStringList{"run", b, "-o", text(place.file("r/out"))} + quickly(),
                target("r/out")},
            {"export", QStringList{"export", a, "-o", text(place.file("e/out"))} + quickly(),
                QStringList{"export", b, "-o", text(place.file("e/out"))} + quickly(),
                target("e/out")},
            {"import", {"import", a, "--replace", "-o", text(place.file("i/i.h5"))},
                {"import", b, "--replace", "-o", text(place.file("i/i.h5"))}, target("i/i.h5")},
            {"simulate", simulate + QStringList("1"), simulate + QStringList("2"),
                target("s/s.h5")},
        };
        std::mt19937 random(kSeed);
        for (const Killed &call : calls) {
            fs::create_directories(call.target.parent_path());
            QElapsedTimer clock;
            QVERIFY(runDyncal(call.second, kFixedClock).exitCode <= 1);
            const Snapshot second = stateOf(call.target);
            clock.start();
            QVERIFY(runDyncal(call.first, kFixedClock).exitCode <= 1);
            const Snapshot first = stateOf(call.target);
            const qint64 usual_ms = clock.elapsed();
            QVERIFY(first != second && !first.empty());
            int changes = 0;
            Snapshot last = first;
            for (int i = 0; i < kills / static_cast<int>(calls.size()); ++i) {
                killedCall(call, i % 2 == 0, random, usual_ms);
                const Snapshot now = stateOf(call.target);
                QVERIFY2(now == first || now == second,
                    qPrintable(QString("%1, kill %2").arg(call.name).arg(i)));
                changes += now == last ? 0 : 1;
                last = now;
            }
            QVERIFY(runDyncal(call.first, kFixedClock).exitCode <= 1);
            QVERIFY(stateOf(call.target) == first);
            QCOMPARE(straysIn(call.target.parent_path()), 0);
            qInfo("%s: %d kills, %d of them behind the exchange", call.name,
                kills / static_cast<int>(calls.size()), changes);
        }
    }

    /// INT, TERM and HUP end a run in order: nothing changed, nothing left. The recording is long:
    /// a quick machine is through with a short one before the signal comes.
    void signals_endInOrder()
    {
        const ScratchFolder place;
        const QString a = QString::fromStdString(place.file("a.h5"));
        QCOMPARE(runDyncal({"simulate", "-o", a, "--preset", "piezo", "--duration-s", "0.02",
                               "--sample-rate-hz", "5e7"})
                     .exitCode,
            0);
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            QProcess process;
            process.start(qEnvironmentVariable("DYNCAL_BINARY"),
                {"run", a, "-o", QString::fromStdString(place.file("r/out"))});
            QVERIFY(process.waitForStarted());
            QVERIFY(waitUntilAwaited(process, number));
            std::this_thread::sleep_for(std::chrono::milliseconds(100)); // into the work
            ::kill(static_cast<pid_t>(process.processId()), number);
            QVERIFY(process.waitForFinished(kLongest_ms));
            QCOMPARE(process.exitStatus(), QProcess::NormalExit);
            QCOMPARE(process.exitCode(), 130);
            QVERIFY(!fs::exists(place.file("r")));
        }
    }

    /// A limit on the size of files ends no program by a signal, and leaves what was there.
    void limitOnFileSizes_isSaidAndChangesNothing()
    {
        const ScratchFolder place;
        const QString a = QString::fromStdString(simulated(place, "a.h5", 1));
        const QString out = QString::fromStdString(place.file("out"));
        QVERIFY(runDyncal(QStringList{"run", a, "-o", out} + quickly(), kFixedClock).exitCode <= 1);
        const Snapshot before = snapshotOf(place.file(""));
        for (const int blocks : {0, 1, 20, 100, 200}) {
            QProcess process;
            process.start("bash",
                {"-c",
                    QString("ulimit -f %1; exec \"$DYNCAL_BINARY\" run '%2' -o '%3' --recipe '%4'")
                        .arg(blocks)
                        .arg(a, out, quickly().last())});
            QVERIFY(process.waitForFinished(kLongest_ms));
            const QByteArray said = process.readAllStandardError();
            QCOMPARE(process.exitStatus(), QProcess::NormalExit);
            QVERIFY2(process.exitCode() == 5, said.constData());
            QVERIFY2(said.contains("cannot be written: File too large"), said.constData());
            QVERIFY(snapshotOf(place.file("")) == before);
        }
    }
};

DYNCAL_TEST(TestNothingForeign)
#include "tst_nothing_foreign.moc"
