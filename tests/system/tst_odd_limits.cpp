// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits, masks and outputs that a caller may set: the work is done, or one true sentence says why
// not.

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"
#include "tests/system/short_capture.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>

class TestOddLimits : public QObject
{
    Q_OBJECT

private:
    /// The Monte Carlo takes longer than all else and meets no limit that is meant here.
    static constexpr const char *kRun = "run capture.h5 --recipe quick.json -o out";

    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    /// Calls the program by a shell, after `before`.
    Answer after(const QString &before, const QString &arguments) const
    {
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.start("/bin/bash", {"-c", before + "; exec \"$DYNCAL_BINARY\" " + arguments});
        Answer answer;
        if (shell.waitForFinished(120000) && shell.exitStatus() == QProcess::NormalExit)
            answer.exitCode = shell.exitCode();
        answer.out = shell.readAllStandardOutput();
        answer.err = shell.readAllStandardError();
        return answer;
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(path("capture.h5"), 1));
        QVERIFY(writeBytes(path("quick.json"), kQuickRecipe));
    }
    void cleanup() { QDir(path("out")).removeRecursively(); }

    void littleStack_isEnlargedWhereItMayBe()
    {
        const Answer answer = after("ulimit -S -s 64", kRun);
        QVERIFY2(answer.exitCode >= 0 && answer.exitCode <= 2, answer.err);
        QVERIFY(QFile::exists(path("out/results.json")));
    }

    void littleStackForGood_isSaid()
    {
        for (const char *kilobytes : {"64", "256", "1024"}) {
            const Answer answer = after(QString("ulimit -s %1").arg(kilobytes), kRun);
            QCOMPARE(answer.exitCode, 5);
            QVERIFY2(answer.err.startsWith("The stack may not grow"), answer.err);
            QCOMPARE(answer.complaints().size(), 1);
        }
    }

    void fewOpenFiles_areSaidOrDo()
    {
        for (int files = 6; files <= 30; ++files) {
            const Answer answer = after(QString("ulimit -n %1").arg(files), kRun);
            const bool isDone = answer.exitCode >= 0 && answer.exitCode <= 2;
            QVERIFY2(isDone || answer.err.contains("ulimit -n"), answer.err);
            QVERIFY2(isDone || answer.complaints().size() == 1, answer.err);
            QCOMPARE(QFile::exists(path("out")), isDone);
            cleanup();
        }
    }

    void maskOfOwnRights_leavesFilesThatCanBeOpened()
    {
        for (const char *mask : {"777", "377", "700"}) {
            const Answer answer = after(QString("umask %1").arg(mask), kRun);
            QVERIFY2(answer.exitCode >= 0 && answer.exitCode <= 2, answer.err);
            const auto rights = QFileInfo(path("out/results.json")).permissions();
            QVERIFY(rights & QFile::ReadOwner && rights & QFile::WriteOwner);
            QVERIFY(QFileInfo(path("out")).permissions() & QFile::ExeOwner);
            cleanup();
        }
    }

    /// Whoever read the answer has stopped reading.
    void fullPipe_doesNotHoldUpTheEnd()
    {
        std::array<int, 2> ends{};
        QCOMPARE(::pipe2(ends.data(), O_CLOEXEC), 0);
        QVERIFY(::fcntl(ends[1], F_SETPIPE_SZ, 4096) > 0);
        const QByteArray filling(4096, 'x');
        QCOMPARE(::write(ends[1], filling.data(), 4096), ssize_t(4096));
        QProcess process;
        process.setChildProcessModifier([&] { ::dup2(ends[1], STDOUT_FILENO); });
        process.start(qEnvironmentVariable("DYNCAL_BINARY"), {"info", path("capture.h5")});
        QVERIFY(process.waitForStarted());
        QVERIFY(!process.waitForFinished(3000)); // it waits
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGTERM), 0);
        const bool ended = process.waitForFinished(10000);
        process.kill();
        process.waitForFinished();
        ::close(ends[0]);
        ::close(ends[1]);
        QVERIFY(ended);
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(process.readAllStandardError(), QByteArray("Stopped on request.\n"));
    }

    void linkToWhatIsOpen_isNotReplaced()
    {
        const QString link = path("stdout");
        QVERIFY(QFile::link("/proc/self/fd/1", link));
        const Answer answer = after("exec > taken", "simulate -o stdout --replace");
        QCOMPARE(answer.exitCode, 4);
        QVERIFY2(answer.err.contains("no regular file"), answer.err);
        QCOMPARE(QFile(link).symLinkTarget(), QString("/proc/self/fd/1"));
        QVERIFY(bytesOf(path("taken")).isEmpty());
    }
};

DYNCAL_TEST(TestOddLimits)
#include "tst_odd_limits.moc"
