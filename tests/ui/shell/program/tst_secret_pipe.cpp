// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/program/program_call.h"
#include "ui/shell/program/secret_pipe.h"

#include <QLineEdit>
#include <QtTest>

#include <array>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

using namespace dyncal;

/// A secret on its way from a field to a program: read once, and nowhere else.
class TestSecretPipe : public QObject
{
    Q_OBJECT

private:
    static QByteArray contentOf(const SecretPipe &pipe)
    {
        std::array<char, 8192> bytes{};
        const ssize_t size = ::read(pipe.readEnd(), bytes.data(), bytes.size());
        return {bytes.data(), std::max<qsizetype>(size, 0)};
    }
    static QByteArray outOf(const QString &command, SecretPipe secret)
    {
        ProgramCall call("/bin/sh", nullptr);
        std::optional<ProgramAnswer> answer;
        connect(&call, &ProgramCall::ended, &call, [&](const ProgramAnswer &end) { answer = end; });
        call.start({"-c", command}, std::move(secret));
        if (!QTest::qWaitFor([&] { return answer.has_value(); }, 30'000))
            qFatal("no end");
        return answer->out;
    }
    static SecretPipe pipeOf(const QString &text)
    {
        QLineEdit field;
        field.setText(text);
        return SecretPipe::takenFrom(field);
    }

private slots:
    void typed_isALineInThePipe_andNoLongerInTheField()
    {
        QLineEdit field;
        field.setEchoMode(QLineEdit::Password);
        QTest::keyClicks(&field, "hemligt-ord");
        const SecretPipe pipe = SecretPipe::takenFrom(field);
        QVERIFY(pipe.isGiven());
        QCOMPARE(contentOf(pipe), QByteArray("hemligt-ord\n"));
        QVERIFY(field.text().isEmpty());
        QVERIFY(!field.isUndoAvailable());
        field.setEchoMode(QLineEdit::Normal);
        field.undo();
        QVERIFY(field.text().isEmpty());
    }

    void bytesOfTheField_areOverwritten()
    {
        QLineEdit field("hemligt-ord");
        const QString shared = field.text(); // the field's own bytes
        const SecretPipe pipe = SecretPipe::takenFrom(field);
        QCOMPARE(shared, QString(11, QChar(0)));
        QLineEdit other("annat");
        const QString before = other.text();
        wipe(other);
        QVERIFY(other.text().isEmpty());
        QCOMPARE(before, QString(5, QChar(0)));
    }

    void nothing_isNone()
    {
        QVERIFY(!pipeOf({}).isGiven());
        QVERIFY(!SecretPipe().isGiven());
    }

    void everyLetter_isUtf8()
    {
        for (const QString &text : {QStringLiteral("å ö \u20ac"), QStringLiteral(" blanks "),
                 QString::fromUcs4(U"\U0001F511"), QString(SecretPipe::kMostLetters, u'\u20ac')})
            QCOMPARE(contentOf(pipeOf(text)), text.toUtf8() + '\n');
    }

    void moved_isClosedOnce()
    {
        SecretPipe first = pipeOf("a");
        const int end = first.readEnd();
        SecretPipe second = std::move(first);
        QVERIFY(!first.isGiven() && second.readEnd() == end);
        second = pipeOf("b");
        QVERIFY(::fcntl(end, F_GETFD) == -1 || second.readEnd() == end);
        QCOMPARE(contentOf(second), QByteArray("b\n"));
        const int last = second.readEnd();
        second = SecretPipe();
        QCOMPARE(::fcntl(last, F_GETFD), -1);
    }

    void program_readsItFromItsInput_andHasItNowhereElse()
    {
        const QByteArray out
            = outOf("cat; tr '\\0' ' ' < /proc/$$/cmdline; tr '\\0' ' ' < /proc/$$/environ",
                pipeOf("ord-77"));
        QVERIFY(out.startsWith("ord-77\n"));
        QCOMPARE(out.count("ord-77"), 1);
    }

    void programWithoutOne_readsNothing()
    {
        QCOMPARE(outOf("cat; echo end", {}), QByteArray("end\n"));
    }

    void nextCall_doesNotGetItAgain()
    {
        ProgramCall call("/bin/sh", nullptr);
        QList<QByteArray> outs;
        connect(
            &call, &ProgramCall::ended, &call, [&](const ProgramAnswer &end) { outs << end.out; });
        call.start({"-c", "head -c 3"}, pipeOf("abcdef"));
        QTRY_COMPARE_WITH_TIMEOUT(outs.size(), 1, 30'000);
        call.start({"-c", "cat"});
        QTRY_COMPARE_WITH_TIMEOUT(outs.size(), 2, 30'000);
        QCOMPARE(outs, QList<QByteArray>({"abc", ""}));
    }
};

DYNCAL_TEST(TestSecretPipe)
#include "tst_secret_pipe.moc"
