// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates of a whole batch, from one registry: what is not ready stays a draft with its
// reason.

#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"

#include <QtTest>

class TestIssuePlan : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }
    Answer plan() const
    {
        return runDyncal({"batch", "plan", path("in"), "--recipe", path("complete.json"), "-o",
            path("stock.jsonl")});
    }
    Answer issue(const QStringList &more = {}) const
    {
        return runDyncal(
            QStringList{"issue", path("stock.jsonl"), "-o", path("certificates"), "--registry",
                path("registry.sqlite"), "--by", "A. Berg", "--unsigned", "--json"}
                + more,
            {"SOURCE_DATE_EPOCH=1767225600"});
    }
    /// A recipe of the sensor's own beside its recording.
    void writeRecipe(const QString &id, const QJsonObject &recipe) const
    {
        writeBytes(path("in/" + id + "/recipe.json"), QJsonDocument(recipe).toJson());
    }
    static QJsonObject of(const Answer &answer, const QString &id)
    {
        for (const QJsonValue &one : answer.json()["sensors"].toArray())
            if (one.toObject()["id"] == id)
                return one.toObject();
        return {};
    }

private slots:
    void initTestCase()
    {
        for (int i = 1; i <= 4; ++i) {
            const QString id = QString("in/SN-%1").arg(i);
            QVERIFY(QDir(m_folder.path()).mkpath(id));
            if (i < 4)
                QVERIFY(simulateShortCapture(path(id + "/shot.h5"), 20 + i));
        }
        writeBytes(path("in/SN-4/shot.h5"), "no recording");
        writeBytes(path("complete.json"), QJsonDocument(completeRecipe()).toJson());
        QJsonObject lacking = completeRecipe();
        QJsonObject fields = completeFields();
        fields.remove("customer");
        lacking["certificate"] = QJsonObject{{"fields", fields}};
        writeRecipe("SN-2", lacking);
        const Answer planned = plan();
        QVERIFY2(QFile::exists(path("stock.jsonl")), planned.err);
    }

    void whatIsReady_isIssued_theOthersStayDrafts()
    {
        const Answer answer = issue();
        QVERIFY2(answer.exitCode == 2, answer.err);
        QCOMPARE(answer.json()["sensors"].toArray().size(), 4);
        QCOMPARE(of(answer, "SN-1")["number"].toInt(), 1);
        QCOMPARE(of(answer, "SN-3")["number"].toInt(), 2);
        for (int number = 1; number <= 2; ++number)
            QVERIFY(QFile::exists(path(QString("certificates/%1/certificate.pdf").arg(number))));
        const QJsonObject lacking = of(answer, "SN-2");
        QVERIFY(lacking["number"].isNull());
        QVERIFY2(lacking["reason"].toString().startsWith("CER-001"),
            qPrintable(lacking["reason"].toString()));
        QVERIFY(of(answer, "SN-4")["number"].isNull());
        QVERIFY(!of(answer, "SN-4")["reason"].toString().isEmpty());
        QVERIFY(answer.err.contains("SN-2 stays a draft"));
        const Answer verified = runDyncal({"verify", path("certificates"), path("registry.sqlite"),
            "--registry", path("registry.sqlite")});
        QVERIFY2(verified.exitCode == 1, verified.out + verified.err); // unsigned
    }

    /// A second run goes on where the first ended: no number twice, no file touched.
    void again_onlyWhatWasMissing_isNew()
    {
        const auto before = bytesBelow(path("certificates"));
        QCOMPARE(of(issue(), "SN-3")["number"].toInt(), 2);
        QCOMPARE(bytesBelow(path("certificates")), before);
        writeRecipe("SN-2", completeRecipe());
        const Answer changed = issue(); // the plan is of the recipe before
        QVERIFY(of(changed, "SN-2")["number"].isNull());
        QVERIFY(plan().err.contains("SN-4"));
        const QJsonObject now = of(issue(), "SN-2");
        QVERIFY2(now["number"].toInt() == 3, qPrintable(now["reason"].toString()));
        QVERIFY(QFile::exists(path("certificates/3/certificate.pdf")));
    }

    /// Nothing says on which folder it was made.
    void plansFolder_isNotInTheFiles()
    {
        for (const QByteArray &bytes : bytesBelow(path("certificates")))
            QVERIFY(!bytes.contains(m_folder.path().toUtf8()));
    }

    void amendmentsAndNumbers_areOfOneJob()
    {
        for (const QStringList &more : {QStringList{"--number", "7"},
                 QStringList{"--amends", "1", "--reason", "another customer"}}) {
            const Answer answer = issue(more);
            QCOMPARE(answer.exitCode, 4);
            QVERIFY2(answer.err.contains("plan"), answer.err);
        }
    }

    void brokenPlan_isRefused()
    {
        writeBytes(path("broken.jsonl"), "{}\n");
        const Answer answer = runDyncal({"issue", path("broken.jsonl"), "-o", path("elsewhere"),
            "--registry", path("registry.sqlite"), "--unsigned"});
        QCOMPARE(answer.exitCode, 4);
        QVERIFY(!QFile::exists(path("elsewhere")));
    }
};

DYNCAL_TEST(TestIssuePlan)
#include "tst_issue_plan.moc"
