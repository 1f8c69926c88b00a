// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/short_capture.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

#include <csignal>
#include <functional>
#include <memory>

/// Signals to the program and to the processes that it reads files in.
class TestSignals : public QObject
{
    Q_OBJECT

private:
    static constexpr int kLongest_ms = 60000;

    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    static std::unique_ptr<QProcess> started(
        const QStringList &arguments, const std::function<void()> &prepare)
    {
        auto process = std::make_unique<QProcess>();
        process->setChildProcessModifier(prepare);
        process->start(qEnvironmentVariable("DYNCAL_BINARY"), arguments);
        return process->waitForStarted() ? std::move(process) : nullptr;
    }

    /// A process that the program has started; 0 if it ended without.
    static pid_t helperOf(const QProcess &process)
    {
        const QString tasks = QString("/proc/%1/task").arg(process.processId());
        for (QElapsedTimer timer = running(); timer.elapsed() < kLongest_ms;) {
            const QStringList threads = QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
            if (threads.isEmpty())
                return 0;
            for (const QString &thread : threads) {
                const QByteArray children = bytesOf(tasks + '/' + thread + "/children");
                if (const int child = children.split(' ').front().toInt(); child > 0)
                    return child;
            }
        }
        return 0;
    }

    static bool ignoresInterrupt(pid_t process) { return hasSignalIn("SigIgn", process, SIGINT); }

    static QElapsedTimer running()
    {
        QElapsedTimer timer;
        timer.start();
        return timer;
    }

    QStringList run() const { return {"run", path("capture.h5"), "-o", path("out")}; }

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(path("capture.h5"), 1)); }
    void cleanup() { QDir(path("out")).removeRecursively(); }

    void wholeGroupSignalled_isStoppedOnRequest_data()
    {
        QTest::addColumn<int>("number");
        QTest::newRow("INT") << SIGINT;
        QTest::newRow("TERM") << SIGTERM;
        QTest::newRow("HUP") << SIGHUP;
    }

    /// As Ctrl+C in a terminal does, while a helper reads the file.
    void wholeGroupSignalled_isStoppedOnRequest()
    {
        QFETCH(int, number);
        for (int i = 0; i < 5; ++i) {
            const auto process = started(run(), [] { ::setpgid(0, 0); });
            QVERIFY(process);
            QVERIFY(helperOf(*process) > 0);
            ::kill(-static_cast<pid_t>(process->processId()), number);
            QVERIFY(process->waitForFinished(kLongest_ms));
            QCOMPARE(process->readAllStandardError(), QByteArray("Stopped on request.\n"));
            QCOMPARE(process->exitCode(), 130);
        }
    }

    void helperKilled_isNotTheFilesFault()
    {
        QByteArray err; // empty where the helper was done before it could be killed
        int exitCode = 0;
        for (int attempt = 0; attempt < 50 && err.isEmpty(); ++attempt) {
            const auto process = started(run(), [] {});
            QVERIFY(process);
            const pid_t helper = helperOf(*process);
            QVERIFY(helper > 0);
            ::kill(helper, SIGKILL);
            QVERIFY(process->waitForFinished(kLongest_ms));
            err = process->readAllStandardError();
            exitCode = process->exitCode();
        }
        QCOMPARE(exitCode, 5);
        QVERIFY2(err.contains("ended the helper process") && !err.contains("damaged"), err);
    }

    void stoppedHelper_endsWithItsProgram()
    {
        const auto process = started(run(), [] {});
        QVERIFY(process);
        pid_t helper = helperOf(*process);
        while (helper > 0 && !ignoresInterrupt(helper)) // which it does once it is set up
            helper = helperOf(*process);
        QVERIFY(helper > 0);
        QCOMPARE(::kill(helper, SIGSTOP), 0);
        process->kill();
        QVERIFY(process->waitForFinished(kLongest_ms));
        const QString status = QString("/proc/%1/status").arg(helper);
        QTRY_VERIFY(!QFile::exists(status) || bytesOf(status).contains("State:\tZ"));
    }

    void endOfChildrenIgnoredByTheCaller_filesAreRead()
    {
        const auto process
            = started({"info", path("capture.h5")}, [] { ::signal(SIGCHLD, SIG_IGN); });
        QVERIFY(process && process->waitForFinished(kLongest_ms));
        QVERIFY2(process->exitCode() <= 1, process->readAllStandardError());
    }

    /// As under nohup, and beside a shell.
    void signalIgnoredByTheCaller_staysIgnored()
    {
        for (const int number : {SIGHUP, SIGINT}) {
            const auto process = started(run(), [number] { ::signal(number, SIG_IGN); });
            QVERIFY(process);
            QVERIFY(helperOf(*process) > 0);
            ::kill(static_cast<pid_t>(process->processId()), number);
            QVERIFY(process->waitForFinished(kLongest_ms));
            QVERIFY2(process->exitCode() <= 1, process->readAllStandardError());
            cleanup();
        }
    }
};

DYNCAL_TEST(TestSignals)
#include "tst_signals.moc"
