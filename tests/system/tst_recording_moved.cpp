// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <map>

/// Recordings that somebody moves, removes or writes to while the program works on them.
class TestRecordingMoved : public QObject
{
    Q_OBJECT

private:
    static constexpr int kLongest_ms = 60000;
    static constexpr int kMany = 12; ///< moments of the change, over the time of the work
    static constexpr int kFew = 3; ///< of the same work with another change, in the suite

    QTemporaryDir m_folder;
    std::map<QStringList, std::pair<int, qint64>> m_undisturbed; ///< exit code and ms by verb
    QString path(const QString &name) const { return m_folder.filePath(name); }

    Answer answerWithChange(const QStringList &verb, const QString &change, qint64 after_ms) const
    {
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start(qEnvironmentVariable("DYNCAL_BINARY"), verb);
        QThread::msleep(static_cast<unsigned long>(after_ms));
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.start("sh", {"-c", change});
        Answer answer;
        if (shell.waitForFinished(kLongest_ms) && process.waitForFinished(kLongest_ms))
            answer.exitCode = process.exitCode();
        answer.out = process.readAllStandardOutput();
        answer.err = process.readAllStandardError();
        return answer;
    }

    /// Every file below, with its bytes.
    QMap<QString, QByteArray> kept(const QString &name) const
    {
        QMap<QString, QByteArray> files;
        QDirIterator entries(path(name), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (entries.hasNext()) {
            const QString file = entries.next();
            files[file] = bytesOf(file);
        }
        return files;
    }

private slots:
    void initTestCase()
    {
        // One shot: what is done with a recording is done three times with three.
        const Answer made = runDyncal({"simulate", "-o", path("kept.h5"), "--duration-s", "0.01",
            "--shots", "low", "--seed", "3"});
        QCOMPARE(made.exitCode, 0);
        // The Monte Carlo takes longer than all else and reads no recording.
        QVERIFY(writeBytes(path("quick.json"), kQuickRecipe));
    }

    void init()
    {
        QVERIFY(QDir(path("out")).removeRecursively());
        for (const char *name : {"used.h5", "moved.h5", "new.h5"})
            QFile::remove(path(name));
        QVERIFY(QFile::copy(path("kept.h5"), path("used.h5")));
    }

    void changedMeanwhile_isSaidOnceAndNothingIsWritten_data()
    {
        QTest::addColumn<QStringList>("verb");
        QTest::addColumn<QString>("change");
        QTest::addColumn<int>("moments");
        const int few = dyncal::trials::count(kFew, kMany);
        const QString move = "mv used.h5 moved.h5";
        const QStringList run{"run", "used.h5", "--recipe", "quick.json", "-o", "out"};
        QTest::newRow("run, moved") << run << move << dyncal::trials::count(6, kMany);
        QTest::newRow("run, removed") << run << "rm used.h5" << few;
        QTest::newRow("run, permissions") << run << "chmod o-r used.h5" << few;
        QTest::newRow("run, appended") << run << "printf x >> used.h5" << few;
        QTest::newRow("check, moved") << QStringList{"check", "used.h5"} << move << few;
        QTest::newRow("compare, moved")
            << QStringList{"compare", "used.h5", "--recipe", "quick.json"} << move << few;
        QTest::newRow("export, moved") << QStringList{"export", "used.h5", "--recipe", "quick.json",
            "-o", "out"} << move << few;
        QTest::newRow("import, moved")
            << QStringList{"import", "used.h5", "-o", "new.h5"} << move << few;
    }

    /// Whenever it happens: either what the undisturbed recording gives, or exit code 3.
    void changedMeanwhile_isSaidOnceAndNothingIsWritten()
    {
        QFETCH(QStringList, verb);
        QFETCH(QString, change);
        QFETCH(int, moments);
        QElapsedTimer timer;
        timer.start();
        if (!m_undisturbed.contains(verb)) {
            const int exitCode = answerWithChange(verb, "true", 0).exitCode;
            m_undisturbed[verb] = {exitCode, timer.elapsed()};
            QVERIFY(!verb.contains("new.h5") || QFile::remove(path("new.h5")));
        }
        const auto [sound, whole_ms] = m_undisturbed[verb];
        QVERIFY(sound == 0 || sound == 1);
        const auto before = kept("out");
        int caught = 0;
        for (int step = 0; step < moments; ++step) {
            QFile::remove(path("used.h5"));
            QVERIFY(QFile::copy(path("kept.h5"), path("used.h5")));
            const Answer answer = answerWithChange(verb, change, step * whole_ms / moments);
            if (answer.exitCode == sound) {
                QFile::remove(path("new.h5"));
                continue;
            }
            QVERIFY2(answer.exitCode == 3, answer.err);
            QVERIFY2(answer.complaints().size() == 1 && answer.err.contains("used.h5"), answer.err);
            QVERIFY2(answer.out.isEmpty(), answer.out);
            QVERIFY(!QFile::exists(path("new.h5")));
            if (caught++ == 0)
                qInfo("%s", answer.err.constData());
        }
        QVERIFY(caught > 0);
        if (!before.isEmpty())
            QCOMPARE(kept("out").keys(), before.keys());
        const QJsonObject results = fileJson(path("out/results.json"));
        if (!before.isEmpty() && verb.front() == "run")
            QVERIFY(results.contains("findings"));
    }
};

DYNCAL_TEST(TestRecordingMoved)
#include "tst_recording_moved.moc"
