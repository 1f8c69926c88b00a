// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The sentences of the built program in the language that is asked for; what it writes to files,
// and what scripts key on, is the same in all of them.

#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"

#include <QTest>

class TestSpokenLanguage : public QObject
{
    Q_OBJECT

private:
    static Answer in(const char *language, const QStringList &words)
    {
        return runDyncal(words, {QString("DYNCAL_LANGUAGE=") + language});
    }

private slots:
    void errors_comeInThatLanguage()
    {
        const QStringList words{"info", "/no/such/file.h5"};
        const Answer english = runDyncal(words);
        const Answer swedish = in("sv", words);
        QCOMPARE(swedish.exitCode, english.exitCode);
        QCOMPARE(english.err,
            "CAP-018: /no/such/file.h5 does not exist; check the name and the folder.\n");
        QCOMPARE(
            swedish.err, "CAP-018: /no/such/file.h5 finns inte; kontrollera namnet och mappen.\n");
    }

    void otherLanguages_areEnglish()
    {
        const QStringList words{"info", "/no/such/file.h5"};
        for (const char *language : {"", "en", "C", "fi", "sv_SE", "../sv"})
            QCOMPARE(in(language, words).err, runDyncal(words).err);
    }

    void remarksAndDifferences_areTranslated_wordsForScriptsAreNot()
    {
        const IssuedJob job;
        QVERIFY(simulateShortCapture(job.path("made.h5"), 7));
        QVERIFY(job.begin(job.path("made.h5")));
        const Answer issued = job.issue({}, {"SOURCE_DATE_EPOCH=1767225600", "DYNCAL_LANGUAGE=sv"});
        QCOMPARE(issued.exitCode, 0);
        QVERIFY2(
            issued.err.contains("CER-010") && !issued.err.contains("names no country"), issued.err);
        const QJsonObject caution = issued.json()["findings"].toArray()[0].toObject();
        QCOMPARE(caution["id"].toString(), QString("CER-010"));
        QCOMPARE(caution["severity"].toString(), QString("caution"));
        QVERIFY(!caution["message"].toString().contains("names no country"));

        // The same as without: what is written has one language.
        const IssuedJob other;
        QVERIFY(other.begin(job.path("made.h5")));
        QCOMPARE(other.issue().exitCode, 0);
        QCOMPARE(
            bytesOf(job.output() + "/1/results.json"), bytesOf(other.output() + "/1/results.json"));
        QCOMPARE(bytesOf(job.output() + "/1/dcc.xml"), bytesOf(other.output() + "/1/dcc.xml"));

        QFile results(job.output() + "/1/results.json");
        QVERIFY(results.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(results.open(QIODevice::Append) && results.write(" ") == 1);
        results.close();
        const QStringList words{
            "verify", job.output() + "/1", "--registry", job.registry(), "--json"};
        const auto first = [](const Answer &answer) {
            return QJsonDocument::fromJson(answer.out).array()[0].toObject();
        };
        const QJsonObject swedish = first(in("sv", words)), english = first(runDyncal(words));
        QCOMPARE(swedish["status"].toString(), QString("changed"));
        QCOMPARE(english["status"].toString(), QString("changed"));
        QVERIFY(!swedish["first_difference"].toString().isEmpty());
        QVERIFY(swedish["first_difference"].toString() != english["first_difference"].toString());
    }

    /// Reasons that the batch has written down come in the language of who looks at them.
    void reasonsOfABatch_areTranslated_whenTheyAreSaid()
    {
        const QTemporaryDir folder;
        const QString plan = folder.filePath("plan.jsonl"), root = folder.filePath("root");
        QVERIFY(QDir().mkpath(root + "/photos") && QDir().mkpath(root + "/torn"));
        QVERIFY(writeBytes(root + "/photos/readme", "no recording"));
        QVERIFY(simulateShortCapture(root + "/torn/a.h5", 3));
        QCOMPARE(runDyncal({"batch", "plan", root, "-o", plan}).exitCode, 2);
        QVERIFY(writeBytes(root + "/torn/a.h5", "torn"));
        QCOMPARE(runDyncal({"batch", "run", plan}).exitCode, 2);

        const QStringList words{"batch", "status", plan};
        const Answer english = runDyncal(words), swedish = in("sv", words);
        QVERIFY2(english.out.contains("holds files but no recording"), english.out + english.err);
        QVERIFY2(english.out.contains("torn: failed: "), english.out);
        QVERIFY2(swedish.out.contains("torn: failed: "), swedish.out);
        for (const char *said : {"no recording", "changed", "plan again", "make the plan"})
            QVERIFY2(!swedish.out.contains(said), swedish.out);
        const QJsonArray left
            = in("sv", {"batch", "status", plan, "--json"}).json()["not_done"].toArray();
        QCOMPARE(left.size(), qsizetype(2));
        for (const QJsonValue &one : left) {
            QCOMPARE(one["state"].toString(), QString("failed"));
            QVERIFY(swedish.out.contains(one["reason"].toString().first(40).toUtf8()));
        }
    }
};

DYNCAL_TEST(TestSpokenLanguage)
#include "tst_spoken_language.moc"
