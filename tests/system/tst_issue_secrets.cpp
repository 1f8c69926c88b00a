// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// While a certificate is signed, nobody on the machine sees the PIN: in no argument and no
// environment of the program and of what it starts, and in no file of output, registry and
// temporary folder.

#include "tests/support/made_token.h"
#include "tests/support/test_program.h"
#include "tests/system/secret_look.h"
#include "tests/system/signed_job.h"

#include <QtTest>

using namespace dyncal::testing;

namespace {

constexpr int kFewLooks = 20; ///< while one certificate is issued: some hundred on an idle machine

} // namespace

class TestIssueSecrets : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    QTemporaryDir m_secrets; ///< where a secret may be
    MadeKeys m_keys;
    QString secretFile() const { return m_secrets.filePath("secret"); }

    /// Issues with a secret in file descriptor 3 while `look` watches; everything temporary goes
    /// to the job's folder.
    Answer issue(const IssuedJob &job, const QStringList &signing, SecretLook &look) const
    {
        QDir(job.folder.path()).mkpath("tmp");
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("SOURCE_DATE_EPOCH", "1767225600");
        environment.insert("TMPDIR", job.path("tmp"));
        process.setProcessEnvironment(environment);
        process.start("sh",
            QStringList{"-c", "exec 3< \"$1\"; shift; exec \"$DYNCAL_BINARY\" \"$@\"", "sh",
                secretFile(), "issue", job.path("job.dyncal"), "-o", job.output(), "--registry",
                job.registry(), "--json"}
                + signing);
        Answer answer;
        if (process.waitForStarted() && look.follow(process))
            answer.exitCode = process.exitCode();
        answer.out = process.readAllStandardOutput();
        answer.err = process.readAllStandardError();
        return answer;
    }
    void checkNoTrace(const IssuedJob &job, const Answer &answer, const SecretLook &look) const
    {
        QVERIFY2(answer.exitCode == 0, answer.err);
        QVERIFY2(look.traces().isEmpty(), qPrintable(look.traces().join(", ")));
        QVERIFY2(look.looks() > kFewLooks, QByteArray::number(look.looks()));
        QVERIFY(look.saw(" issue "));
        const QJsonArray rows = verifyRows({job.output() + "/1"}, m_keys.path("root.pem"));
        QCOMPARE(rows[0].toObject()["status"].toString(), QString("valid"));
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(m_recordings.filePath("shot.h5"), 7));
        QVERIFY(m_keys.make("lab", "Example Laboratory"));
        QVERIFY(m_keys.makePkcs12("lab", "hemligt-ord-77"));
    }

    /// What is shown of a program that is less careful is seen.
    void look_seesASecret()
    {
        const QTemporaryDir folder;
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("PIN", "hemligt-ord-77");
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(folder.path());
        // A subshell with its own argument, behind one that has none.
        process.start(
            "sh", {"-c", "printf %s \"$PIN\" > .kept; sh -c 'sleep 0.3; true' \"$PIN\"; rm .kept"});
        QVERIFY(process.waitForStarted());
        SecretLook look("hemligt-ord-77", {folder.path()});
        QVERIFY(look.follow(process));
        const QString traces = look.traces().join('\n');
        QVERIFY2(traces.contains("arguments of") && traces.contains("environment of")
                && traces.contains(".kept"),
            qPrintable(traces));
    }

    void passphrase_isNeverSeen()
    {
        const IssuedJob job;
        QVERIFY(job.begin(m_recordings.filePath("shot.h5")));
        QVERIFY(writeBytes(secretFile(), "hemligt-ord-77\n"));
        SecretLook look("hemligt-ord-77", {job.folder.path()});
        const Answer answer = issue(job, {"--key", m_keys.path("lab.p12"), "--pin-fd", "3"}, look);
        checkNoTrace(job, answer, look);
        QVERIFY(!(answer.out + answer.err).contains("hemligt-ord-77"));
    }

    void pinOfAToken_isNeverSeen()
    {
        const MadeToken token(m_keys);
        QVERIFY(token.isMade);
        const IssuedJob job;
        QVERIFY(job.begin(m_recordings.filePath("shot.h5")));
        QVERIFY(writeBytes(secretFile(), QByteArray(MadeToken::kPin) + '\n'));
        SecretLook look(MadeToken::kPin, {job.folder.path()});
        const Answer answer = issue(job, {"--key", MadeToken::kUri, "--pin-fd", "3"}, look);
        checkNoTrace(job, answer, look);
        QVERIFY(!(answer.out + answer.err).contains(MadeToken::kPin));
    }

    /// A service that has a PIN of its own, and tells the terminal of it.
    void secretOfASealService_isKeptNowhere()
    {
        const IssuedJob job;
        QVERIFY(job.begin(m_recordings.filePath("shot.h5")));
        const QString service = m_secrets.filePath("service.sh");
        QVERIFY(writeBytes(service,
            "pin=hemligt-ord-77\nread hash\nsleep 0.3\necho \"opened with $pin\" >&2\n"
            "echo \"$hash\" | python3 \"$DYNCAL_SOURCE_DIR/tests/support/seal_service.py\" "
            "\"$1\" \"$2\"\n"));
        SecretLook look("hemligt-ord-77", {job.folder.path()});
        const QString command = QString("sh '%1' '%2' '%3'")
                                    .arg(service, m_keys.path("lab.key"), m_keys.path("lab.pem"));
        const Answer answer = issue(job, {"--seal-command", command}, look);
        checkNoTrace(job, answer, look);
        QVERIFY(look.saw("sh " + service.toUtf8()) && look.saw("seal_service.py"));
        QVERIFY(answer.err.contains("opened with hemligt-ord-77")); // so it was said
    }
};

DYNCAL_TEST(TestIssueSecrets)
#include "tst_issue_secrets.moc"
