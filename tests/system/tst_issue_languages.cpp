// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates issued in each language, by the built program.

#include "tests/support/test_program.h"
#include "tests/system/issued_job.h"

#include <QProcess>
#include <QtTest>

class TestIssueLanguages : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    QString recording() const { return m_recordings.filePath("shot.h5"); }

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(recording(), 7)); }

    /// Read by a script of its own: labels by the translation, numbers as the language writes them.
    void everyLanguage_printsTheNumbersOfItsResults()
    {
        for (const char *language : {"en", "sv", "de"}) {
            const IssuedJob job;
            QVERIFY(job.begin(recording()));
            const Answer issued = job.issue({"--languages", language});
            QVERIFY2(issued.exitCode == 0, issued.err);
            QProcess script;
            script.setProcessChannelMode(QProcess::MergedChannels);
            script.start("python3",
                {qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/audit/printed_numbers.py",
                    job.output() + "/1", language});
            QVERIFY(script.waitForFinished(60000));
            const QByteArray said = script.readAll();
            QVERIFY2(
                script.exitCode() == 0 && said.contains("compared with results.json, 0 differ"),
                said);
        }
    }

    void unknownOrThree_takeNoNumber()
    {
        const IssuedJob job;
        QVERIFY(job.begin(recording()));
        for (const char *languages : {"fr", "en,sv,de"}) {
            const Answer refused = job.issue({"--languages", languages});
            QVERIFY2(refused.exitCode == 4, refused.err);
            QVERIFY2(refused.err.contains("certificate.languages"), refused.err);
        }
        QVERIFY(!QDir(job.output() + "/1").exists());
    }
};

DYNCAL_TEST(TestIssueLanguages)
#include "tst_issue_languages.moc"
