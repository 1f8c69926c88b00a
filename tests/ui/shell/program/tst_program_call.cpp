// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/program/program_call.h"
#include "ui/text/number_locale.h"

#include <QtTest>

#include <optional>

using namespace dyncal;

/// A command as a process: what it printed, how it ended, and that nothing outlives its owner.
class TestProgramCall : public QObject
{
    Q_OBJECT

private:
    static constexpr int kPatience_ms = 30'000;

    /// Of a command of the shell.
    static ProgramAnswer answerTo(const QString &command)
    {
        ProgramCall call("/bin/sh", nullptr);
        std::optional<ProgramAnswer> answer;
        connect(&call, &ProgramCall::ended, &call, [&](const ProgramAnswer &end) { answer = end; });
        call.start({"-c", command});
        if (!QTest::qWaitFor([&] { return answer.has_value(); }, kPatience_ms))
            qFatal("no end");
        return *answer;
    }

private slots:
    void end_isToldWithWhatWasPrinted()
    {
        const ProgramAnswer answer = answerTo("echo out; echo first >&2; echo last. >&2; exit 2");
        QCOMPARE(answer.out, QByteArray("out\n"));
        QCOMPARE(answer.exitCode, 2);
        QCOMPARE(answer.complaint, QString("last."));
        QCOMPARE(problemOf(answer), QString()); // it came to its end
    }

    void failure_isItsLastSentence()
    {
        const ProgramAnswer answer = answerTo("echo other >&2; echo The file is none. >&2; exit 3");
        QCOMPARE(problemOf(answer), QString("The file is none."));
    }

    void sentences_comeInTheLanguageOfTheWindow()
    {
        const QLocale before;
        const auto restore = qScopeGuard([&] { QLocale::setDefault(before); });
        for (const char *code : {"sv", "de", "en"}) {
            QLocale::setDefault(numberLocale(code));
            QCOMPARE(answerTo("printf %s \"$DYNCAL_LANGUAGE\"").out, QByteArray(code));
        }
    }

    void crash_isSaid()
    {
        const ProgramAnswer answer = answerTo("kill -SEGV $$");
        QVERIFY(answer.isCrash && !answer.isStopped);
        QVERIFY(problemOf(answer).contains("crashed"));
    }

    void longOutput_comesWhole() { QCOMPARE(answerTo("seq 1 200000").out.count('\n'), 200000); }

    void missingProgram_isSaid()
    {
        ProgramCall call("/no/such/program", nullptr);
        QString problem;
        connect(&call, &ProgramCall::ended, &call,
            [&](const ProgramAnswer &end) { problem = problemOf(end); });
        call.start({});
        QTRY_VERIFY(problem.contains("could not be started"));
        QVERIFY(!call.isRunning());
    }

    void stopped_isNoProblem()
    {
        ProgramCall call("/bin/sh", nullptr);
        std::optional<ProgramAnswer> answer;
        connect(&call, &ProgramCall::ended, &call, [&](const ProgramAnswer &end) { answer = end; });
        call.start({"-c", "exec sleep 60"});
        QTRY_VERIFY(call.isRunning());
        call.stop();
        QVERIFY(call.isStopping());
        QTRY_VERIFY_WITH_TIMEOUT(answer.has_value(), kPatience_ms);
        QVERIFY(answer->isStopped);
        QCOMPARE(problemOf(*answer), QString());
    }

    void nothing_outlivesItsOwner()
    {
        QTemporaryDir folder;
        const QString mark = folder.filePath("ended");
        {
            ProgramCall call("/bin/sh", nullptr);
            call.start({"-c",
                "trap 'touch " + mark + "; exit 0' TERM; touch " + mark
                    + ".begun; while :; do sleep 0.05; done"});
            QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(mark + ".begun"), kPatience_ms);
        }
        QVERIFY(QFile::exists(mark)); // asked to end in good order, and awaited
    }

    void words_areNoCommand()
    {
        ProgramCall call("/bin/echo", nullptr);
        QByteArray out;
        connect(
            &call, &ProgramCall::ended, &call, [&](const ProgramAnswer &end) { out = end.out; });
        call.start({"a b", "$(touch x)", "; rm", "--reason=\"q\""});
        QTRY_COMPARE(out, QByteArray("a b $(touch x) ; rm --reason=\"q\"\n"));
    }
};

DYNCAL_TEST(TestProgramCall)
#include "tst_program_call.moc"
