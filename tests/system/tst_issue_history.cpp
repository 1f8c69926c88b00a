// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates that state the sensor's history, by the built program.

#include "tests/support/test_program.h"
#include "tests/system/dcc_judges.h"
#include "tests/system/issued_job.h"

#include <QProcess>
#include <QtTest>

namespace {

/// A laboratory's template: the short one with the section.
bool writeTemplate(const QString &path)
{
    const QJsonArray sections{"administrative", "item", "key-results", "method", "conditions",
        "results", "frequency-response", "history", "remarks", "records", "statements"};
    QFile file(path);
    return file.open(QIODevice::WriteOnly)
        && file.write(QJsonDocument(QJsonObject{{"schema", "dyncal-template/1"},
                                        {"sections", sections}, {"figures", QJsonArray()}})
                          .toJson())
        > 0;
}

QJsonObject recipeOf(const QString &day, const QString &serial = "17")
{
    QJsonObject recipe = completeRecipe();
    QJsonObject fields = completeFields();
    fields["date_performed"] = day;
    fields["sensor_serial"] = serial;
    recipe["certificate"] = QJsonObject{{"fields", fields}};
    return recipe;
}

QString textOf(const QString &pdf)
{
    QProcess reader;
    reader.start("pdftotext", {"-layout", pdf, "-"});
    return reader.waitForFinished(30000) ? QString::fromUtf8(reader.readAllStandardOutput())
                                         : QString();
}

QList<QByteArray> linesOf(const QString &csv, const QByteArray &quantity)
{
    QList<QByteArray> lines;
    for (const QByteArray &line : bytesOf(csv).split('\n'))
        if (line.startsWith(quantity + ','))
            lines << line;
    return lines;
}

} // namespace

class TestIssueHistory : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;

    QString recording(int seed) const { return m_recordings.filePath(QString::number(seed)); }
    /// The next calibration in the same laboratory: another recording, another day.
    Answer issueNext(const IssuedJob &job, int seed, const QJsonObject &recipe,
        const QStringList &more = {}) const
    {
        QFile::remove(job.path("shot.h5"));
        if (!QFile::copy(recording(seed), job.path("shot.h5")) || !job.writeProject(recipe))
            return {};
        return job.issue(QStringList{"--template", job.path("with-history.json")} + more);
    }

private slots:
    void initTestCase()
    {
        for (const int seed : {7, 8, 9})
            QVERIFY(simulateShortCapture(recording(seed), seed));
    }

    void second_statesTheFirst_inPdfAndTable()
    {
        const IssuedJob job;
        QVERIFY(writeTemplate(job.path("with-history.json")));
        const Answer first = issueNext(job, 7, recipeOf("2025-03-01"));
        QVERIFY2(first.exitCode == 0, first.err);
        const Answer second = issueNext(job, 8, recipeOf("2026-01-07"));
        QVERIFY2(second.exitCode == 0, second.err);
        QCOMPARE(linesOf(job.output() + "/1/history.csv", "f0_hz").size(), 1);
        const auto lines = linesOf(job.output() + "/2/history.csv", "f0_hz");
        QCOMPARE(lines.size(), 2);
        QVERIFY2(lines[0].contains("2025-03-01,1,"), lines[0]);
        QVERIFY2(lines[1].contains("2026-01-07,2,"), lines[1]);
        QVERIFY2(!bytesOf(job.output() + "/2/history.csv").contains(job.folder.path().toUtf8()),
            "a path leaks");
        const QString text = textOf(job.output() + "/2/certificate.pdf");
        QVERIFY2(text.contains("Earlier calibrations"), qPrintable(text));
        QVERIFY(text.contains(QRegularExpression("2025-03-01 +1 +\\d")));
        QVERIFY(text.contains(QRegularExpression("2026-01-07 +2 +\\d")));
        const QByteArray dcc = bytesOf(job.output() + "/2/dcc.xml");
        QVERIFY(dcc.contains("refType=\"dyncal_historyOf dyncal_sensitivity\""));
        QCOMPARE(missingNumbers(job.output() + "/2", "en"), QByteArray());
        const Answer rules = runDyncal({"dcc", "check", job.output() + "/2/dcc.xml", "--json"});
        for (const QJsonValue finding : QJsonDocument::fromJson(rules.out)["findings"].toArray())
            QCOMPARE(finding["rule"].toString(), QString("country"));
        QCOMPARE(job.verify({job.output()}).exitCode, 1); // only that it is not signed
    }

    void withdrawnReplacedAndOtherSensors_takeNoPart()
    {
        const IssuedJob job;
        QVERIFY(writeTemplate(job.path("with-history.json")));
        QVERIFY(issueNext(job, 7, recipeOf("2025-03-01")).exitCode == 0);
        QVERIFY(issueNext(job, 8, recipeOf("2025-06-01", "18")).exitCode == 0);
        const Answer amended = issueNext(
            job, 7, recipeOf("2025-03-02"), {"--amends", "1", "--reason", "the day was wrong"});
        QVERIFY2(amended.exitCode == 0, amended.err);
        QCOMPARE(
            linesOf(job.output() + "/3/history.csv", "f0_hz").size(), 1); // not the replaced one
        const Answer next = issueNext(job, 9, recipeOf("2026-01-07"));
        QVERIFY2(next.exitCode == 0, next.err);
        const auto lines = linesOf(job.output() + "/4/history.csv", "sensitivity");
        QCOMPARE(lines.size(), 2); // 3 and 4
        QVERIFY(lines[0].contains("2025-03-02,3,"));
        QVERIFY(
            runDyncal({"withdraw", "3", "--reason", "tube", "--registry", job.registry()}).exitCode
            == 0);
        QVERIFY(
            issueNext(job, 9, recipeOf("2026-01-08"), {"--amends", "4", "--reason", "day"}).exitCode
            == 0);
        QCOMPARE(linesOf(job.output() + "/5/history.csv", "sensitivity").size(), 1);
    }

    void damagedOne_isRefused_andTheNumberWaits()
    {
        const IssuedJob job;
        QVERIFY(writeTemplate(job.path("with-history.json")));
        QVERIFY(issueNext(job, 7, recipeOf("2025-03-01")).exitCode == 0);
        const QString results = job.output() + "/1/results.json";
        const QByteArray whole = bytesOf(results);
        QFile::remove(results);
        const Answer refused = issueNext(job, 8, recipeOf("2026-01-07"));
        QVERIFY2(refused.exitCode != 0, refused.out);
        QVERIFY2(refused.err.contains("history"), refused.err);
        QVERIFY(!QDir(job.output() + "/2").exists());
        QFile file(results);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(whole) == whole.size());
        file.close();
        const Answer again = issueNext(job, 8, recipeOf("2026-01-07"));
        QVERIFY2(again.exitCode == 0, again.err);
        QVERIFY(QDir(job.output() + "/2").exists()); // the same number
    }

    void templateWithout_hasNone()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording(7)));
        QVERIFY(job.issue().exitCode == 0);
        QVERIFY(!QFile::exists(job.output() + "/1/history.csv"));
        QVERIFY(!textOf(job.output() + "/1/certificate.pdf").contains("Earlier calibrations"));
    }
};

DYNCAL_TEST(TestIssueHistory)
#include "tst_issue_history.moc"
