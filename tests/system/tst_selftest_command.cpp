// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

/// `dyncal selftest` as an assessor sees it.
class TestSelftestCommand : public QObject
{
    Q_OBJECT

private:
    static constexpr int kLongest_ms = 60000;

    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

private slots:
    /// The whole of it, as installed: at most a minute.
    void whole_holds()
    {
        QElapsedTimer taken;
        taken.start();
        const Answer answer = runDyncal({"selftest"});
        QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
        QVERIFY(answer.err.isEmpty());
        QVERIFY(answer.out.startsWith("Step "));
        QVERIFY(answer.out.contains("\ncoverage "));
        QVERIFY(answer.out.trimmed().endsWith(
            "checks hold: this installation computes what is known."));
        qInfo("%lld ms", static_cast<long long>(taken.elapsed()));
        QVERIFY(taken.elapsed() < kLongest_ms);
    }

    void json_isTheReport()
    {
        const Answer answer
            = runDyncal({"selftest", "--json", "--calibrations", "0", "-o", path("one")},
                {"SOURCE_DATE_EPOCH=1700000000"});
        QVERIFY2(answer.exitCode == 0, answer.err);
        const QJsonObject json = answer.json();
        QCOMPARE(json["created_utc"].toString(), QString("2023-11-14T22:13:20Z"));
        QVERIFY(json["holds"].toBool());
        QVERIFY(json["checks"].toArray().size() > 80);
        QCOMPARE(bytesOf(path("one/selftest.json")), answer.out);
        const QByteArray pdf = bytesOf(path("one/selftest.pdf"));
        QVERIFY(pdf.startsWith("%PDF-") && pdf.contains("D:20231114221320"));
        QCOMPARE(QDir(path("one")).entryList(QDir::Files | QDir::Hidden),
            (QStringList{"selftest.json", "selftest.pdf", "written.json"}));
    }

    /// The same clock, the same bytes; a second report takes the place of the first.
    void reports_areReproducible()
    {
        const QStringList clock{"SOURCE_DATE_EPOCH=1700000000"};
        const QStringList command{"selftest", "--calibrations", "0", "-o", path("two")};
        QCOMPARE(runDyncal(command, clock).exitCode, 0);
        const QByteArray json = bytesOf(path("two/selftest.json")),
                         pdf = bytesOf(path("two/selftest.pdf"));
        QCOMPARE(runDyncal(command, clock).exitCode, 0);
        QCOMPARE(bytesOf(path("two/selftest.json")), json);
        QCOMPARE(bytesOf(path("two/selftest.pdf")), pdf);
    }

    void wrongUsage_isOneSentence_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QStringList>("extra");
        QTest::newRow("negative") << QStringList{"--calibrations", "-1"} << QStringList{};
        QTest::newRow("too many") << QStringList{"--calibrations", "100000000"} << QStringList{};
        QTest::newRow("no number") << QStringList{"--calibrations", "many"} << QStringList{};
        QTest::newRow("a file") << QStringList{"capture.h5"} << QStringList{};
        QTest::newRow("clock") << QStringList{} << QStringList{"SOURCE_DATE_EPOCH=soon"};
        QTest::newRow("no folder") << QStringList{"-o", "/proc/none"} << QStringList{};
        QTest::newRow("empty") << QStringList{"-o", ""} << QStringList{};
    }
    void wrongUsage_isOneSentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QStringList, extra);
        const Answer answer = runDyncal(QStringList{"selftest"} + arguments, extra);
        QCOMPARE(answer.exitCode, 4);
        QCOMPARE(answer.complaints().size(), 1);
        QVERIFY(answer.out.isEmpty());
    }

    /// Nothing of ours in the folder: it is refused before the work.
    void foreignReport_isNotReplaced()
    {
        QVERIFY(QDir().mkpath(path("foreign")));
        QVERIFY(writeBytes(path("foreign/selftest.pdf"), "somebody's"));
        const Answer answer = runDyncal({"selftest", "-o", path("foreign")});
        QCOMPARE(answer.exitCode, 4);
        QCOMPARE(bytesOf(path("foreign/selftest.pdf")), QByteArray("somebody's"));
    }

    void withoutPlaceForTemporaryFiles_readingDeviates()
    {
        const Answer answer
            = runDyncal({"selftest", "--calibrations", "0", "--json"}, {"TMPDIR=/nonexistent"});
        QCOMPARE(answer.exitCode, 2);
        QVERIFY(answer.json()["verdict"].toString().contains("in the step \"reading\""));
    }

    /// The keys of the steps stay as scripts know them.
    void spoken_inTheLanguageThatIsAskedFor()
    {
        const Answer answer
            = runDyncal({"selftest", "--calibrations", "0"}, {"DYNCAL_LANGUAGE=sv"});
        QVERIFY2(answer.exitCode == 0, answer.out + answer.err);
        QVERIFY(answer.out.contains("\nexpected_shock "));
        QVERIFY(answer.out.contains("den infallande stötvågens densitetskvot"));
        QVERIFY(!answer.out.contains("density ratio") && !answer.out.contains("how far"));
        QVERIFY(answer.out.contains("\nAlla "));
    }

    /// Ctrl-C leaves neither files nor folder.
    void interrupted_leavesNothing()
    {
        QProcess process;
        process.start(qEnvironmentVariable("DYNCAL_BINARY"),
            {"selftest", "--calibrations", "10000", "-o", path("stopped")});
        QVERIFY(process.waitForStarted());
        QVERIFY(waitUntilAwaited(process, SIGINT));
        QTest::qWait(500);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(kLongest_ms));
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(process.readAllStandardError(), QByteArray("Stopped on request.\n"));
        QVERIFY(!QDir(path("stopped")).exists());
    }
};

DYNCAL_TEST(TestSelftestCommand)
#include "tst_selftest_command.moc"
