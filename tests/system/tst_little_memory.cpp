// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"
#include "tests/system/window_process.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

namespace {

constexpr std::uint64_t kMiB = std::uint64_t(1) << 20U;
constexpr std::uint64_t kPlenty = 4096;

} // namespace

/// The program under ever larger limits on its address space: whatever the limit, it ends with its
/// work done or with one sentence about memory, and never by a signal. The long form takes every
/// MiB.
class TestLittleMemory : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::uint64_t m_lowest_MiB = 0; ///< at which --version answers
    QByteArray m_what;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QString capture() const { return path("shot.h5"); }
    QString table() const { return path("shot.csv"); }

    /// One sentence about memory.
    static bool saysMemory(const QByteArray &err)
    {
        return err.count('\n') == 1 && err.toLower().contains("not enough memory")
            && err.endsWith(".\n");
    }

    /// Just below what it needs, a library may wait for ever in its own start, before main, where
    /// no sentence is possible: that is no answer either.
    static bool answersItsVersion(std::uint64_t limit_MiB)
    {
        QProcess process;
        process.start("sh",
            {"-c",
                QString("ulimit -v %1; timeout 10 \"$DYNCAL_BINARY\" --version > /dev/null 2>&1")
                    .arg(limit_MiB * 1024)});
        return process.waitForFinished(30000) && process.exitCode() == 0;
    }

    /// The smallest limit of [low, kPlenty] at which `works`.
    template <typename Works>
    static std::uint64_t smallest_MiB(std::uint64_t low, const Works &works)
    {
        std::uint64_t high = kPlenty;
        while (low < high) {
            const std::uint64_t middle = (low + high) / 2;
            if (works(middle))
                high = middle;
            else
                low = middle + 1;
        }
        return high;
    }

    enum class Outcome { Done, Refused, Wrong };

    /// Tries ever larger limits until it has worked often enough, as the need of threads differs
    /// from time to time. False at the first wrong outcome; m_what is the last one.
    template <typename Try>
    bool forEachLimit(std::uint64_t lowest_MiB, int shortStep_MiB, const Try &tryLimit)
    {
        const int often = dyncal::trials::count(1, 12);
        const auto step = static_cast<std::uint64_t>(dyncal::trials::count(shortStep_MiB, 1));
        std::uint64_t first = 0;
        int done = 0, refused = 0;
        for (std::uint64_t limit = lowest_MiB; done < often && limit < kPlenty; limit += step) {
            const Outcome outcome = tryLimit(limit);
            if (outcome == Outcome::Wrong)
                return false;
            first = outcome == Outcome::Done && first == 0 ? limit : first;
            (outcome == Outcome::Done ? done : refused) += 1;
        }
        qInfo("%d limits from %d MiB on refused, %d done, the first at %d MiB", refused,
            int(lowest_MiB), done, int(first));
        return done == often;
    }

    /// What the window says in the end of an export under this limit; "" if it has died.
    QString exportAt(std::uint64_t limit_MiB)
    {
        WindowProcess window(path("home"), {capture()}, limit_MiB * kMiB);
        return exportIn(window);
    }

    QString exportIn(WindowProcess &window)
    {
        QDir(path("exported")).removeRecursively();
        QDir().mkpath(path("exported"));
        QString said = "nothing";
        QString state;
        bool asked = false;
        QElapsedTimer time;
        for (time.start(); time.elapsed() < 60000; QTest::qWait(50)) {
            const QString box = window.ask("accept");
            if (!window.isRunning())
                return refused(window);
            if (box.contains("memory")) {
                said = box;
                break;
            }
            if (box.size() > 1) { // no results, or none yet
                said = window.ask("list findingsPanel");
                if (said.contains("memory"))
                    break;
            }
            if (const QString status = window.ask("text statusMessage");
                status.startsWith("Written")) {
                said = status;
                break;
            }
            if (const QString problem = window.ask("text problemSummary"); problem.size() > 1) {
                said = window.ask("list problemTable");
                break;
            }
            asked = askForExport(window, asked && box.size() <= 1);
            state = box + '|' + window.ask("text statusMessage") + '|'
                + window.ask("text progressBar") + '|' + window.ask("list findingsPanel");
        }
        if (said == "nothing")
            said += " within a minute: " + state;
        window.ask("title"); // it still answers
        return window.isRunning() ? said : refused(window);
    }

    /// Until the folder is asked for, which happens once there are results.
    bool askForExport(WindowProcess &window, bool asked) const
    {
        if (window.ask("text fileNameEdit") != "-")
            return window.ask("type fileNameEdit " + path("exported")) == "done";
        if (!asked && window.ask("text progressBar") == "-")
            window.ask("start exportResultsAction");
        return asked;
    }

    static QString refused(WindowProcess &window)
    {
        const auto [exitCode, err] = window.end();
        return exitCode == 5 && saysMemory(err) ? QString(err) : QString();
    }

private slots:
    void initTestCase()
    {
        QCOMPARE(runDyncal({"simulate", "-o", capture(), "--sample-rate-hz", "2e7", "--duration-s",
                               "0.005", "--shots", "low"})
                     .exitCode,
            0);
        QByteArray text = "Time [s],DUT [V]\n";
        for (int i = 0; i < 20000; ++i) {
            const double t = i < 2000 ? 0.0 : static_cast<double>(i - 2000);
            const double clean = i < 2000 ? 0.0 : 1.0 - std::exp(-t / 300.0) * std::cos(0.3 * t);
            text += QByteArray::number(1e-6 * i, 'f', 6) + ','
                + QByteArray::number(clean + 0.002 * std::sin(12.9898 * i * i), 'f', 9) + '\n';
        }
        QVERIFY(writeBytes(table(), text));
        m_lowest_MiB = smallest_MiB(1, answersItsVersion);
        qInfo("--version starts from %d MiB on", int(m_lowest_MiB));
    }

    void commandLine_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("output");
        const auto row = [this](const char *name, const QStringList &arguments, const char *out) {
            QTest::newRow(name) << arguments << path(out);
        };
        row("run of a capture", QStringList{"run", capture(), "--order", "2"} + quickly(), "out");
        row("run of a table", QStringList{"run", table(), "--order", "2"} + quickly(), "out");
        row("import of a capture", {"import", capture()}, "copy.h5");
        row("import of a table", {"import", table()}, "table.h5");
    }

    void commandLine()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, output);
        const QStringList call = arguments + QStringList{"-o", output};
        const auto clear = [&] { QFile::remove(output) || QDir(output).removeRecursively(); };
        const auto answerAt = [&](std::uint64_t limit) {
            clear();
            return runDyncal(call, {}, limit * kMiB);
        };
        const Answer unlimited = answerAt(kPlenty);
        QVERIFY2(unlimited.exitCode == 0 || unlimited.exitCode == 1, unlimited.err);
        const bool isDone = forEachLimit(m_lowest_MiB, 12, [&](std::uint64_t limit) {
            const Answer answer = answerAt(limit);
            m_what = QByteArray::number(int(limit)) + " MiB: exit "
                + QByteArray::number(answer.exitCode) + ", " + answer.err;
            if (answer.exitCode == unlimited.exitCode && answer.err == unlimited.err)
                return Outcome::Done;
            const bool isClean = !QFileInfo::exists(output) || QDir(output).isEmpty();
            return answer.exitCode == 5 && saysMemory(answer.err) && isClean ? Outcome::Refused
                                                                             : Outcome::Wrong;
        });
        QVERIFY2(isDone, m_what);
    }

    /// Opens the capture, waits until it is computed, exports everything.
    void window()
    {
        const QStringList none;
        const std::uint64_t empty = smallest_MiB(m_lowest_MiB, [&](std::uint64_t limit) {
            WindowProcess window(path("home"), none, limit * kMiB);
            return window.ask("title").contains("Dyncal");
        });
        qInfo("an empty window opens from %d MiB on", int(empty));
        const bool isDone = forEachLimit(empty, 80, [&](std::uint64_t limit) {
            const QString said = exportAt(limit);
            m_what = QByteArray::number(int(limit)) + " MiB: " + said.toUtf8();
            if (said.startsWith("Written"))
                return Outcome::Done;
            return said.contains("memory") ? Outcome::Refused : Outcome::Wrong;
        });
        QVERIFY2(isDone, m_what);
    }

    /// The system gives the window only so many threads, from 0 on until it has done its work; the
    /// long form leaves none out.
    void window_fewThreads()
    {
        QVERIFY(QFile::exists(qEnvironmentVariable("DYNCAL_FEW_THREADS")));
        int refused = 0, done = 0;
        const int step = dyncal::trials::count(9, 1), often = dyncal::trials::count(1, 2);
        for (int threads = 0; done < often; threads += step) {
            WindowProcess window(path("home"), {capture()}, 0,
                {"ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0", // where it is so built
                    "LD_PRELOAD=" + qEnvironmentVariable("DYNCAL_FEW_THREADS"),
                    "DYNCAL_THREADS=" + QString::number(threads)});
            const QString said = exportIn(window);
            const QByteArray what = QByteArray::number(threads) + " threads: " + said.toUtf8();
            QVERIFY2(said.startsWith("Written") || said.contains("memory"), what);
            (said.startsWith("Written") ? done : refused) += 1;
        }
        qInfo("%d numbers of threads refused", refused);
        QVERIFY(refused > 2);
    }
};

DYNCAL_TEST(TestLittleMemory)
#include "tst_little_memory.moc"
