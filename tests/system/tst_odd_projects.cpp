// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Projects that were written by hand or by other versions: opened as they say, or refused.

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/short_capture.h"

#include <QTemporaryDir>
#include <QTest>

class TestOddProjects : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    Answer exported(QByteArray project) const
    {
        project.replace('\'', '"');
        if (!writeBytes(path("job.dyncal"), project))
            return {};
        return runDyncal({"export", path("job.dyncal"), "-o", path("out")});
    }

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(path("capture.h5"), 1)); }

    /// A project says null where it knows no hash; one that was taken out is no way past CAP-015.
    void recordingWhoseHashWasTakenOut_isNotCertified()
    {
        const Answer answer = exported("{'format': 'dyncal-project', 'version': 1, 'recipe': {}, "
                                       "'captures': [{'path': 'capture.h5'}]}");
        QVERIFY2(answer.err.contains("CAP-015"), answer.err);
        QCOMPARE(answer.exitCode, 2);
    }

    void oddContent_isRefused_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const char *name, const char *content, const char *sentence) {
            QTest::newRow(name) << QByteArray(content) << QByteArray(sentence);
        };
        row("recipe is a word", "'version': 1, 'recipe': 'x'", "holds no recipe");
        row("no recipe", "'version': 1", "holds no recipe");
        row("a key twice", "'version': 1, 'recipe': {}, 'recipe': {}",
            "holds the key \"recipe\" twice");
        row("a key twice in the recipe", "'version': 1, 'recipe': {'window': {}, 'window': {}}",
            "holds the key \"window\" twice");
        row("a minor version", "'version': 1.7, 'recipe': {}",
            "has version 1.7, which no program writes");
        row("a word for a version", "'version': '1', 'recipe': {}", "has version \"1\", which");
        row("no version", "'recipe': {}", "has version none, which");
    }
    void oddContent_isRefused()
    {
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, sentence);
        const Answer answer = exported("{'format': 'dyncal-project', " + content
            + ", 'captures': [{'path': 'capture.h5', 'sha256': null}]}");
        QCOMPARE(answer.exitCode, 3);
        QVERIFY2(answer.err.contains(sentence), answer.err);
        QCOMPARE(answer.complaints().size(), 1);
    }

    void nameThatIsNotUtf8_isSaid()
    {
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.start("/bin/bash",
            {"-c",
                "cp job.dyncal $'\\xff.dyncal'; \"$DYNCAL_BINARY\" export $'\\xff.dyncal' -o out; "
                "code=$?; rm $'\\xff.dyncal'; exit $code"});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.exitCode(), 3);
        const QByteArray said = shell.readAllStandardError();
        QVERIFY2(said.contains("not valid UTF-8; rename"), said);
    }
};

DYNCAL_TEST(TestOddProjects)
#include "tst_odd_projects.moc"
