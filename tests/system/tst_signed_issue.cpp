// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates signed as they are issued by the built program, and verified by it and by others.

#include "tests/support/answering_server.h"
#include "tests/support/made_stamps.h"
#include "tests/support/made_token.h"
#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"

#include <QRegularExpression>
#include <QtTest>

using namespace dyncal::testing;

class TestSignedIssue : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    MadeKeys m_keys;
    QString recording() const { return m_recordings.filePath("shot.h5"); }

    /// A job whose program reads this secret from file descriptor 3, as a shell gives it.
    Answer issueWith(
        const IssuedJob &job, const QStringList &signing, const QByteArray &secret) const
    {
        writeBytes(job.path("secret"), secret + '\n');
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("SOURCE_DATE_EPOCH", "1767225600");
        process.setProcessEnvironment(environment);
        process.start("sh",
            QStringList{"-c", "f=$1; shift; exec \"$DYNCAL_BINARY\" \"$@\" --pin-fd 3 3< \"$f\"",
                "sh", job.path("secret"), "issue", job.path("job.dyncal"), "-o", job.output(),
                "--registry", job.registry(), "--json"}
                + signing);
        Answer answer;
        if (process.waitForFinished(240000) && process.exitStatus() == QProcess::NormalExit)
            answer.exitCode = process.exitCode();
        answer.out = process.readAllStandardOutput();
        answer.err = process.readAllStandardError();
        QFile::remove(job.path("secret"));
        return answer;
    }
    static QJsonObject verified(
        const IssuedJob &job, const QStringList &more, int exitCode, const QString &file = "/1")
    {
        const Answer answer = runDyncal(
            QStringList{"verify", job.output() + file, "--registry", job.registry(), "--json"}
            + more);
        if (answer.exitCode != exitCode)
            qWarning("%d: %s", answer.exitCode, (answer.out + answer.err).constData());
        return answer.exitCode == exitCode
            ? QJsonDocument::fromJson(answer.out).array().first().toObject()
            : QJsonObject();
    }
    QStringList trust() const { return {"--trust", m_keys.path("root.pem")}; }
    QStringList byKey() const { return {"--key", m_keys.path("lab.all.pem")}; }
    static QByteArray pdfsig(const IssuedJob &job)
    {
        return answerOf("pdfsig", {job.output() + "/1/certificate.pdf"}).out;
    }

    /// Number of the page, from 1, on which these words stand.
    static QByteArray pageWith(const QString &pdf, const QByteArray &words)
    {
        const QByteArrayList pages = answerOf("pdftotext", {"-layout", pdf, "-"}).out.split('\f');
        for (qsizetype i = 0; i < pages.size(); ++i)
            if (pages[i].contains(words))
                return QByteArray::number(i + 1);
        return {};
    }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(recording(), 7));
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Example Laboratory"));
        QVERIFY(m_keys.make("stamps", "Stamps", "stamps"));
        QVERIFY(m_keys.make("past", "Past", "signer", {"-newkey", "rsa:2048"}, "20250101000000Z",
            "20250601000000Z"));
        QVERIFY(m_keys.makePkcs12("lab", "hemligt-ord-77"));
    }

    void keyOfAFile_signs()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const Answer issued = job.issue(byKey());
        QVERIFY2(issued.exitCode == 0, issued.err);
        QVERIFY(issued.json()["signed"].toBool());
        QCOMPARE(issued.json()["signer"].toString(), "Example Laboratory");
        QVERIFY(issued.json()["time_stamp_authority"].isNull());
        QVERIFY2(pdfsig(job).contains("Signature is Valid"), pdfsig(job));
        QVERIFY(pdfsig(job).contains("Total document signed"));
        const QJsonObject known = verified(job, trust(), 1); // recordings were not looked for
        QCOMPARE(known["status"].toString(), "valid");
        QCOMPARE(known["signer"].toString(), "Example Laboratory");
        QCOMPARE(known["signed_utc"].toString(), "2026-01-01T00:00:00Z");
        QVERIFY(known["stamped_utc"].isNull());
        QCOMPARE(verified(job, {}, 1)["status"].toString(), "unknown-signer");
        QCOMPARE(verified(job, trust() + QStringList{"--at", "2040-01-01"}, 1)["status"].toString(),
            "expired");
        const QJsonObject single = verified(job, trust(), 0, "/1/certificate.pdf");
        QCOMPARE(single["status"].toString(), "valid");
        QCOMPARE(single["number"].toInt(), 1);
        const Answer alone
            = runDyncal(QStringList{"verify", job.output() + "/1/certificate.pdf"} + trust());
        QVERIFY2(alone.exitCode == 0, alone.out);
        QVERIFY(alone.out.contains("signed by Example Laboratory at 2026-01-01T00:00:00Z"));
        const Answer again = job.issue(byKey());
        QCOMPARE(again.out, issued.out);
        const Answer unsignedAgain = job.issue();
        QVERIFY(unsignedAgain.json()["signed"].toBool());
    }

    /// By a template with the section: the field lies over its words, read by other programs.
    void signature_isSeenOverNameMomentAndNumber()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const QJsonArray sections{"administrative", "item", "key-results", "method", "conditions",
            "results", "frequency-response", "remarks", "statements", "signature"};
        QVERIFY(writeBytes(job.path("seen.json"),
            QJsonDocument(QJsonObject{{"schema", "dyncal-template/1"}, {"sections", sections},
                              {"figures", QJsonArray()}})
                .toJson()));
        const Answer issued = job.issue(byKey() + QStringList{"--template", job.path("seen.json")});
        QVERIFY2(issued.exitCode == 0, issued.err);
        QVERIFY2(pdfsig(job).contains("Signature is Valid"), pdfsig(job));
        QVERIFY(pdfsig(job).contains("Total document signed"));
        const QString pdf = job.output() + "/1/certificate.pdf";
        QCOMPARE(answerOf("qpdf", {"--check", pdf}).err, QByteArray());
        const QRegularExpressionMatch place
            = QRegularExpression("/Rect\\[([\\d.]+) ([\\d.]+) ([\\d.]+) ([\\d.]+)\\]/AP")
                  .match(QString::fromLatin1(bytesOf(pdf)));
        QVERIFY(place.hasMatch());
        const QStringList corner = place.capturedTexts();
        const QByteArray page = pageWith(pdf, "Electronic signature");
        QVERIFY(!page.isEmpty());
        const int bottom = 842 - qRound(corner[2].toDouble());
        const int top = 842 - qRound(corner[4].toDouble());
        const QByteArray seen = answerOf("pdftotext",
            {"-f", page, "-l", page, "-x", corner[1].section('.', 0, 0), "-y", QString::number(top),
                "-W", QString::number(qRound(corner[3].toDouble() - corner[1].toDouble())), "-H",
                QString::number(bottom - top), "-layout", pdf, "-"})
                                    .out.simplified();
        QCOMPARE(seen,
            QByteArray("Signed by Example Laboratory Signed at (UTC) 2026-01-01T00:00:00Z Number "
                       "of the certificate 1"));
        QCOMPARE(verified(job, trust(), 1)["status"].toString(), "valid");
    }

    void copies_makeTheSameBytes()
    {
        const IssuedJob one, other;
        QVERIFY(one.begin(recording()) && other.begin(recording()));
        QCOMPARE(one.issue(byKey()).exitCode, 0);
        QCOMPARE(other.issue(byKey()).exitCode, 0);
        QVERIFY(bytesBelow(one.output()) == bytesBelow(other.output()));
    }

    void changedPdf_isFound()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        QCOMPARE(job.issue(byKey()).exitCode, 0);
        const QString path = job.output() + "/1/certificate.pdf";
        QByteArray bytes = bytesOf(path);
        bytes[bytes.size() / 3] = static_cast<char>(bytes[bytes.size() / 3] ^ 1);
        QVERIFY(writeBytes(path, bytes));
        const Answer alone = runDyncal(QStringList{"verify", path, "--json"} + trust());
        QCOMPARE(alone.exitCode, 2);
        QVERIFY2(alone.out.contains("it was changed") && alone.out.contains("Signed are the bytes"),
            alone.out);
        QCOMPARE(verified(job, trust(), 2)["status"].toString(), "changed");
    }

    void secrets_leaveNoTrace()
    {
        const QByteArray secret = "hemligt-ord-77";
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const QStringList key{"--key", m_keys.path("lab.p12")};
        const Answer wrong = issueWith(job, key, "annat-ord-88");
        QCOMPARE(wrong.exitCode, 4);
        QCOMPARE(wrong.complaints().size(), 1);
        QVERIFY(!wrong.err.contains("annat-ord-88"));
        QVERIFY(!QFile::exists(job.registry())); // no number is taken
        const Answer issued = issueWith(job, key, secret);
        QVERIFY2(issued.exitCode == 0, issued.err);
        QVERIFY(!issued.out.contains(secret) && !issued.err.contains(secret));
        const auto files = bytesBelow(job.folder.path());
        for (auto file = files.begin(); file != files.end(); ++file)
            QVERIFY2(!file->contains(secret), qPrintable(file.key()));
        QCOMPARE(verified(job, trust(), 1)["status"].toString(), "valid");
    }

    void token_signs()
    {
        const MadeToken token(m_keys);
        QVERIFY(token.isMade);
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const Answer wrong = issueWith(job, {"--key", MadeToken::kUri}, "99999999");
        QCOMPARE(wrong.exitCode, 4);
        QVERIFY2(wrong.complaints().size() == 1, wrong.err);
        const Answer issued = issueWith(job, {"--key", MadeToken::kUri}, MadeToken::kPin);
        QVERIFY2(issued.exitCode == 0, issued.err);
        QVERIFY(pdfsig(job).contains("Signature is Valid"));
        QCOMPARE(verified(job, trust(), 1)["status"].toString(), "valid");
        const auto files = bytesBelow(job.folder.path());
        for (auto file = files.begin(); file != files.end(); ++file)
            QVERIFY2(!file->contains(MadeToken::kPin), qPrintable(file.key()));
    }

    void authority_stampsIt()
    {
        const MadeStamps stamps(m_keys);
        const AnsweringServer server([&](const std::string &, const std::string &body) {
            return httpAnswer(stamps.reply(body));
        });
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const Answer silent = job.issue(byKey() + QStringList{"--tsa", "http://127.0.0.1:1/"});
        QCOMPARE(silent.exitCode, 3);
        QVERIFY(!QFile::exists(job.output() + "/1"));
        const Answer issued
            = job.issue(byKey() + QStringList{"--tsa", QString::fromStdString(server.url())});
        QVERIFY2(issued.exitCode == 0, issued.err);
        QCOMPARE(issued.json()["number"].toInt(), 1); // the reserved one
        QCOMPARE(
            issued.json()["time_stamp_authority"].toString(), QString::fromStdString(server.url()));
        const QJsonObject found = verified(job, trust() + QStringList{"--at", "2040-01-01"}, 1);
        QCOMPARE(found["status"].toString(), "valid"); // the time stamp shows that it was
        QVERIFY(found["stamped_utc"].toString().endsWith('Z'));
    }

    void service_seals()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const QString service
            = qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/support/seal_service.py";
        QCOMPARE(job.issue({"--seal-command", "false"}).exitCode, 3);
        const Answer issued = job.issue({"--seal-command",
            "python3 '" + service + "' '" + m_keys.path("lab.key") + "' '" + m_keys.path("lab.pem")
                + "'"});
        QVERIFY2(issued.exitCode == 0, issued.err);
        QVERIFY(pdfsig(job).contains("Signature is Valid"));
        QCOMPARE(verified(job, trust(), 1)["signer"].toString(), "Example Laboratory");
    }

    void serviceOfAnExpiredCertificate_issuesNothing()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const auto sealedBy = [&](const QString &name) {
            return job.issue({"--seal-command",
                "python3 '" + qEnvironmentVariable("DYNCAL_SOURCE_DIR")
                    + "/tests/support/seal_service.py' '" + m_keys.path(name + ".key") + "' '"
                    + m_keys.path(name + ".pem") + "'"});
        };
        const Answer refused = sealedBy("past");
        QCOMPARE(refused.exitCode, 4);
        QVERIFY2(refused.err.contains("is valid from 2025-01-01"), refused.err);
        QVERIFY(!QFile::exists(job.output() + "/1"));
        QCOMPARE(sealedBy("lab").json()["number"].toInt(), 1); // the reserved one
    }

    void issuedWithoutASignature_staysSo()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const auto saysSo = [](const Answer &answer) {
            return answer.err.contains("was issued before, without a signature");
        };
        QVERIFY(!saysSo(job.issue()));
        const Answer again = job.issue(byKey());
        QCOMPARE(again.exitCode, 0);
        QVERIFY(!again.json()["signed"].toBool());
        QVERIFY2(saysSo(again), again.err);
        QVERIFY(again.out.contains("CER-011"));
        QVERIFY(!saysSo(job.issue()));
        // The single files say that nobody signed them, also without a registry.
        QVERIFY(QFile::copy(job.output() + "/1/certificate.pdf", job.path("copy")));
        for (const QString &file : {job.output() + "/1/dcc.xml", job.path("copy")}) {
            const Answer alone = runDyncal({"verify", file, "--json"});
            QCOMPARE(alone.exitCode, 1);
            QCOMPARE(
                QJsonDocument::fromJson(alone.out).array().first().toObject()["status"].toString(),
                "unsigned");
        }
    }

    void wrongUsage_isSaid_data()
    {
        QTest::addColumn<QStringList>("signing");
        const QString key = m_keys.path("lab.all.pem");
        QTest::newRow("nobody") << QStringList{};
        QTest::newRow("both") << QStringList{"--key", key, "--unsigned"};
        QTest::newRow("two") << QStringList{"--key", key, "--seal-command", "true"};
        QTest::newRow("stamp alone") << QStringList{"--unsigned", "--tsa", "http://a/"};
        QTest::newRow("pin alone") << QStringList{"--unsigned", "--pin-fd", "0"};
        QTest::newRow("https") << QStringList{"--key", key, "--tsa", "https://a/"};
        QTest::newRow("open quote") << QStringList{"--seal-command", "'a"};
        QTest::newRow("expired") << QStringList{"--key", m_keys.path("past.all.pem")};
        QTest::newRow("closed") << QStringList{"--key", key, "--pin-fd", "77"};
        for (const char *number : {"pin", "1024", "99999999999", "-1", "3.5"})
            QTest::newRow(QByteArray("descriptor ") + number)
                << QStringList{"--key", key, QString("--pin-fd=") + number};
        QTest::newRow("pin in uri") << QStringList{"--key", "pkcs11:token=a?pin-value=1"};
    }
    void wrongUsage_isSaid()
    {
        QFETCH(QStringList, signing);
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        const Answer answer = runDyncal(QStringList{"issue", job.path("job.dyncal"), "-o",
                                            job.output(), "--registry", job.registry()}
                + signing,
            {"SOURCE_DATE_EPOCH=1767225600"});
        QCOMPARE(answer.exitCode, 4);
        QCOMPARE(answer.complaints().size(), 1);
        QVERIFY2(!signing.join(' ').contains("--pin-fd=")
                || answer.err.contains("number of an open file descriptor, 0 to 1023"),
            answer.err);
        QVERIFY(!QFile::exists(job.registry()) && !QFile::exists(job.output()));
    }

    void verify_wrongUsageIsSaid()
    {
        const IssuedJob job;
        for (const QStringList &bad : {QStringList{"--at", "yesterday"}, {"--at", "2026-01-31T"}})
            QCOMPARE(runDyncal(QStringList{"verify", recording()} + bad).exitCode, 4);
        QCOMPARE(runDyncal({"verify", recording(), "--trust", recording()}).exitCode, 3);
    }
};

DYNCAL_TEST(TestSignedIssue)
#include "tst_signed_issue.moc"
