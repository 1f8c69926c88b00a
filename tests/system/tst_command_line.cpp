// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

/// How the program behaves as a command, whatever the numbers: help, exit codes, one sentence each.
class TestCommandLine : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    /// A complaint is one sentence: it ends with a full stop, and nothing is on stdout.
    static void verifyRefusal(const Answer &answer, int exitCode, const QByteArray &holds)
    {
        QVERIFY2(
            answer.exitCode == exitCode, QByteArray::number(answer.exitCode) + ": " + answer.err);
        QCOMPARE(answer.out, QByteArray());
        QVERIFY2(answer.complaints().size() == 1, answer.err);
        QVERIFY2(answer.err.trimmed().endsWith('.'), answer.err);
        QVERIFY2(answer.err.contains(holds), answer.err);
    }

private slots:
    void version_namesProgramVersionAndBuild()
    {
        const Answer answer = runDyncal({"--version"});
        QCOMPARE(answer.exitCode, 0);
        QVERIFY2(answer.out.startsWith("dyncal 0."), answer.out);
        QVERIFY2(answer.out.contains("(build "), answer.out);
    }

    void help_ofEveryVerb_hasAnExample_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("program") << QStringList{"--help"};
        for (const char *verb : {"simulate", "info", "import", "check", "run"})
            QTest::newRow(verb) << QStringList{verb, "--help"};
    }

    void help_ofEveryVerb_hasAnExample()
    {
        QFETCH(QStringList, arguments);
        const Answer answer = runDyncal(arguments);
        QCOMPARE(answer.exitCode, 0);
        QVERIFY2(answer.out.contains("Example:\n  dyncal "), answer.out);
        QCOMPARE(answer.err, QByteArray());
    }

    void wrongUsage_isOneSentenceAndExit4_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("holds");
        const auto row = [](const char *name, const QStringList &arguments, const char *holds) {
            QTest::newRow(name) << arguments << QByteArray(holds);
        };
        row("unknown option", {"--nonsense"}, "--nonsense");
        row("unknown option of a verb", {"run", "--nonsense", "x", "-o", "y"}, "--nonsense");
        row("missing output", {"run", "x.h5"}, "--output");
        row("missing files", {"run", "-o", "y"}, "files");
        row("misspelt verb", {"simulat", "-o", "x"}, "simulate");
        row("no number", {"simulate", "-o", "x.h5", "--seed", "seven"}, "seven");
        row("negative seed", {"simulate", "-o", "x.h5", "--seed", "-4"}, "-4");
        row("seed too large", {"simulate", "-o", "x.h5", "--seed", "99999999999999999999"},
            "18446744073709551615");
        row("sensor beyond the sample rate", {"simulate", "-o", "x.h5", "--sample-rate-hz", "4e6"},
            "rings at 2.33 MHz");
        row("unknown level", {"simulate", "-o", "x.h5", "--shots", "low,hgh"}, "hgh");
        row("unknown preset", {"simulate", "-o", "x.h5", "--preset", "optic9"}, "optic9");
        row("unknown defect", {"simulate", "-o", "x.h5", "--defect", "melted"}, "melted");
        row("f0 alone", {"simulate", "-o", "x.h5", "--f0-hz", "1e6"}, "--zeta");
        row("bad order", {"run", "x.h5", "-o", "y", "--order", "many"}, "many");
        row("order zero", {"run", "x.h5", "-o", "y", "--order", "0"}, "--order");
        row("order above the largest", {"run", "x.h5", "-o", "y", "--order", "500"}, "500");
    }

    void wrongUsage_isOneSentenceAndExit4()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, holds);
        verifyRefusal(runDyncal(arguments), 4, holds);
    }

    void missingFile_isExit3_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString none = "/nonexistent/capture.h5";
        QTest::newRow("info") << QStringList{"info", none};
        QTest::newRow("run") << QStringList{"run", none, "-o", path("out")};
        QTest::newRow("workbench") << QStringList{none};
    }

    void missingFile_isExit3()
    {
        QFETCH(QStringList, arguments);
        verifyRefusal(runDyncal(arguments), 3, "/nonexistent/capture.h5");
    }

    void emptyName_isExit3AndSaysSo()
    {
        verifyRefusal(runDyncal({"info", ""}), 3, "An empty name was given");
        verifyRefusal(runDyncal({""}), 3, "An empty name was given");
    }

    void projectThatIsAPipe_isRefusedAtOnce()
    {
        QCOMPARE(::mkfifo(path("pipe.dyncal").toUtf8().constData(), 0600), 0);
        verifyRefusal(runDyncal({"export", path("pipe.dyncal"), "-o", path("out")}), 3,
            "pipe.dyncal is a folder or a device, not a file");
    }

    void noCapture_isExit3AndNamesTheFile()
    {
        QVERIFY(writeBytes(path("letter.pdf"), "%PDF-1.4\nDear customer,\n"));
        const Answer answer = runDyncal({"info", path("letter.pdf")});
        QCOMPARE(answer.exitCode, 3);
        QVERIFY2(answer.err.contains("letter.pdf"), answer.err);
        QCOMPARE(answer.out, QByteArray());
    }

    void unknownRecipeKey_isExit4AndNamesTheNearest()
    {
        QVERIFY(writeBytes(path("wrong.json"), "{\"window\": {\"end\": 0.001}}"));
        verifyRefusal(runDyncal({"run", "x.h5", "--recipe", path("wrong.json"), "-o", path("out")}),
            4, "Recipe key window.end is unknown; the nearest known key is window.end_s.");
    }

    void malformedRecipe_isExit4AndNamesThePlace()
    {
        QVERIFY(writeBytes(path("broken.json"), "{\n  \"window\": {,}\n}"));
        verifyRefusal(
            runDyncal({"run", "x.h5", "--recipe", path("broken.json"), "-o", path("out")}), 4,
            "line 2, column 14");
    }

    void missingRecipe_isExit3()
    {
        verifyRefusal(runDyncal({"run", "x.h5", "--recipe", path("none.json"), "-o", path("out")}),
            3, "none.json");
    }

    void refusedRun_leavesNothingBehind()
    {
        QVERIFY(writeBytes(path("bad.json"), "{\"x\": 1}"));
        runDyncal({"run", "x.h5", "--recipe", path("bad.json"), "-o", path("never")});
        QVERIFY(!QFile::exists(path("never")));
    }

    void badEpoch_isExit4()
    {
        verifyRefusal(runDyncal({"simulate", "-o", path("x.h5")}, {"SOURCE_DATE_EPOCH=yesterday"}),
            4, "SOURCE_DATE_EPOCH is \"yesterday\"");
        QVERIFY(!QFile::exists(path("x.h5")));
    }

    void workbenchWithoutDisplay_isExit4AndNamesTheHelp()
    {
        verifyRefusal(runDyncal({}), 4, "dyncal --help");
    }

    void outputThatIsAFile_isExit4()
    {
        QVERIFY(writeBytes(path("taken"), "x"));
        QVERIFY(runDyncal({"simulate", "-o", path("small.h5"), "--sample-rate-hz", "2e7",
                              "--duration-s", "0.005"})
                    .exitCode
            == 0);
        const Answer answer = runDyncal({"run", path("small.h5"), "-o", path("taken")});
        verifyRefusal(answer, 4, "taken");
        QCOMPARE(bytesOf(path("taken")), QByteArray("x"));
    }

    void fullStandardOutput_isNotTakenForSuccess()
    {
        if (!QFile::exists("/dev/full"))
            QSKIP("/dev/full is not there");
        QProcess process;
        process.setStandardOutputFile("/dev/full");
        process.start(qEnvironmentVariable("DYNCAL_BINARY"), {"--version"});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 5);
    }
};

DYNCAL_TEST(TestCommandLine)
#include "tst_command_line.moc"
