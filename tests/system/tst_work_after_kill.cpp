// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/window_process.h"
#include "tests/system/written_project.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace {

constexpr const char *kCustomer = "field_customer"; ///< on the certificate page
constexpr const char *kOffer = "text recoverySentence";

} // namespace

/// The program is killed in the middle of work; the next start gives the work back.
class TestWorkAfterKill : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString home() const { return path("home"); }
    QDir kept() const { return QDir(home() + "/data/dyncal/dyncal/recovery"); }
    QStringList keptFiles() const { return kept().entryList({"*.dyncal"}, QDir::Files); }

    /// Types a customer and kills the program once that is kept.
    void editAndKill(const QString &file, const QString &customer)
    {
        WindowProcess window(home(), {file});
        QVERIFY2(window.waitFor("title", QFileInfo(file).baseName()), window.last());
        edit(window, customer);
        QVERIFY2(window.waitFor("text autoSaveStatus", "Auto-saved"), window.last());
        window.stop(SIGKILL);
    }

    static void edit(WindowProcess &window, const QString &customer)
    {
        QCOMPARE(window.ask("key Alt+0"), QString("done"));
        QCOMPARE(window.ask(QString("type %1 %2").arg(kCustomer, customer)), QString("done"));
        QVERIFY2(window.waitFor("title", "modified"), window.last());
    }

    /// The tour of the pages: in the short form ended when its window was shown.
    void tour() const
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_DATA_HOME", home() + "/data");
        process.setProcessEnvironment(environment);
        process.start(qEnvironmentVariable("DYNCAL_BINARY"), {"--screenshot-tour", path("tour")});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("tour/00-start.png")), 60000);
        if (dyncal::trials::count(1, 2) == 1)
            process.terminate();
        QVERIFY(process.waitForFinished(240000));
    }

    QString customerIn(const QString &project) const
    {
        const QJsonValue recipe = fileJson(project)["recipe"];
        return recipe["certificate"]["fields"]["customer"].toString();
    }

private slots:
    void initTestCase()
    {
        QCOMPARE(runDyncal({"simulate", "-o", path("simulated.h5"), "--sample-rate-hz", "2e7",
                               "--duration-s", "0.005", "--shots", "low"})
                     .exitCode,
            0);
    }

    /// A recording, a project of it and a user who never ran the program.
    void init()
    {
        QDir here(m_folder.path());
        for (const char *name : {"home", "work"})
            QVERIFY(QDir(path(name)).removeRecursively() && here.mkpath(name));
        QVERIFY(QFile::copy(path("simulated.h5"), path("work/a.h5")));
        const QJsonObject recipe{{"uncertainty", QJsonObject{{"monte_carlo_trials", 100}}},
            {"certificate", QJsonObject{{"fields", QJsonObject{{"customer", "First"}}}}}};
        QVERIFY(writeProject(path("work/job.dyncal"), {path("work/a.h5")}, recipe));
    }

    void killed_whileEdited_offersTheWorkAndSavesItToItsProject()
    {
        const QString project = path("work/job.dyncal");
        editAndKill(project, "Second");
        QCOMPARE(customerIn(project), QString("First"));

        WindowProcess window(home(), {});
        QVERIFY2(window.waitFor(kOffer, "Recovered work on job from "), window.last());
        const QRegularExpression times("from \\d\\d:\\d\\d:\\d\\d \\(\\d+ s before stop\\)");
        QVERIFY2(times.match(window.ask(kOffer)).hasMatch(), window.last());
        QCOMPARE(window.ask("key Alt+R"), QString("done"));
        QVERIFY2(window.waitFor("title", "job[*] – Dyncal modified"), window.last());
        QCOMPARE(window.ask(kOffer), QString("-"));
        QCOMPARE(window.ask("key Alt+0"), QString("done"));
        QCOMPARE(window.ask(QString("text %1").arg(kCustomer)), QString("Second"));
        QCOMPARE(customerIn(project), QString("First")); // nothing is saved unasked

        // Once the recordings are sealed and computed from.
        QVERIFY2(window.waitFor("list findingsPanel", "note"), window.last());
        QCOMPARE(window.ask("key Ctrl+S"), QString("done"));
        QVERIFY(!window.ask("title").contains("modified"));
        QCOMPARE(customerIn(project), QString("Second"));
        QTRY_VERIFY(keptFiles().isEmpty());
        QCOMPARE(window.ask("trigger quitAction"), QString("done"));
        QVERIFY(window.hasEndedWell());
        QVERIFY2(kept().isEmpty(), qPrintable(kept().entryList().join(' ')));
    }

    void killedAgain_whileRestored_isOfferedAgain()
    {
        editAndKill(path("work/job.dyncal"), "Second");
        {
            WindowProcess window(home(), {});
            QVERIFY2(window.waitFor(kOffer, "Recovered"), window.last());
            QCOMPARE(window.ask("click restoreWork"), QString("done"));
            QVERIFY2(window.waitFor("title", "modified"), window.last());
            window.stop(SIGKILL);
        }
        WindowProcess window(home(), {});
        QVERIFY2(window.waitFor(kOffer, "Recovered work on job"), window.last());
    }

    /// TERM and HUP keep what was typed a moment before, without waiting for the next auto-save.
    void askedToEnd_whileEdited_keepsTheLastChange()
    {
        for (const int signal : {SIGTERM, SIGHUP}) {
            QVERIFY(QDir(home()).removeRecursively());
            {
                WindowProcess window(home(), {path("work/job.dyncal")});
                QVERIFY2(window.waitFor("title", "job"), window.last());
                edit(window, "Second");
                window.stop(signal);
                QCOMPARE(window.exitCode(), 128 + signal);
            }
            WindowProcess window(home(), {});
            QVERIFY2(window.waitFor(kOffer, "Recovered work on job"), window.last());
            window.stop(SIGKILL);
        }
    }

    void terminated_unanswered_isOfferedAgain()
    {
        editAndKill(path("work/job.dyncal"), "Second");
        {
            WindowProcess window(home(), {});
            QVERIFY2(window.waitFor(kOffer, "Recovered"), window.last());
            window.stop(SIGTERM);
        }
        WindowProcess window(home(), {});
        QVERIFY2(window.waitFor(kOffer, "Recovered work on job"), window.last());
    }

    void secondWindow_whileTheFirstWorks_isOfferedNothing()
    {
        WindowProcess first(home(), {path("work/job.dyncal")});
        QVERIFY2(first.waitFor("title", "job"), first.last());
        edit(first, "Second");
        QVERIFY2(first.waitFor("text autoSaveStatus", "Auto-saved"), first.last());
        WindowProcess second(home(), {path("work/a.h5")});
        QVERIFY2(second.waitFor("title", "Untitled"), second.last());
        QCOMPARE(second.ask(kOffer), QString("-"));
        edit(second, "Third");
        QVERIFY2(second.waitFor("text autoSaveStatus", "Auto-saved"), second.last());
        QCOMPARE(keptFiles().size(), 2);
    }

    void changedRecording_ofRecoveredWork_isFound()
    {
        editAndKill(path("work/job.dyncal"), "Second");
        QCOMPARE(runDyncal({"simulate", "-o", path("work/other.h5"), "--sample-rate-hz", "2e7",
                               "--duration-s", "0.005", "--shots", "low", "--seed", "2"})
                     .exitCode,
            0);
        QVERIFY(QFile::remove(path("work/a.h5")));
        QVERIFY(QFile::rename(path("work/other.h5"), path("work/a.h5")));
        WindowProcess window(home(), {});
        QVERIFY2(window.waitFor(kOffer, "Recovered"), window.last());
        QCOMPARE(window.ask("click restoreWork"), QString("done"));
        QVERIFY2(window.waitFor("title", "modified"), window.last());
        QVERIFY2(window.waitFor("list findingsPanel", "changed since"), window.last());
    }

    void missingRecording_isNamedAndTheWorkStays()
    {
        editAndKill(path("work/job.dyncal"), "Second");
        QVERIFY(QFile::rename(path("work/a.h5"), path("work/b.h5")));
        WindowProcess window(home(), {});
        QVERIFY2(window.waitFor(kOffer, "Recovered"), window.last());
        QCOMPARE(window.ask("click restoreWork"), QString("done"));
        QVERIFY2(window.waitFor(kOffer, path("work/a.h5")), window.last());
        QVERIFY(QFile::rename(path("work/b.h5"), path("work/a.h5")));
        QCOMPARE(window.ask("click restoreWork"), QString("done"));
        QVERIFY2(window.waitFor("title", "job[*] – Dyncal modified"), window.last());
    }

    /// Scenario S28: one recording is moved, a byte of another one changed, while the program lies
    /// dead in the middle of an edit.
    void s28_movedAndChangedRecordings_areNamedAndNothingLeaves()
    {
        const QString project = path("work/job.dyncal");
        QVERIFY(QFile::copy(path("simulated.h5"), path("work/shot_low.h5")));
        QCOMPARE(runDyncal({"simulate", "-o", path("work/shot_high.h5"), "--sample-rate-hz", "2e7",
                               "--duration-s", "0.005", "--shots", "high", "--seed", "3"})
                     .exitCode,
            0);
        const QJsonObject recipe{{"uncertainty", QJsonObject{{"monte_carlo_trials", 100}}}};
        QVERIFY(writeProject(
            project, QStringList{path("work/shot_low.h5"), path("work/shot_high.h5")}, recipe));
        editAndKill(project, "Second");
        QVERIFY(QDir(m_folder.path()).mkpath("work/elsewhere"));
        QVERIFY(QFile::rename(path("work/shot_high.h5"), path("work/elsewhere/shot_high.h5")));
        QByteArray bytes = bytesOf(path("work/shot_low.h5"));
        const auto middle = bytes.size() / 2; // among the samples
        bytes[middle] = static_cast<char>(bytes[middle] ^ 1);
        QVERIFY(writeBytes(path("work/shot_low.h5"), bytes));

        WindowProcess window(home(), {});
        QVERIFY2(window.waitFor(kOffer, "Recovered work on job from "), window.last());
        const QRegularExpression times("from \\d\\d:\\d\\d:\\d\\d \\(\\d+ s before stop\\)");
        QVERIFY2(times.match(window.ask(kOffer)).hasMatch(), window.last());
        QCOMPARE(window.ask("click restoreWork"), QString("done"));
        QVERIFY2(window.waitFor(kOffer, "shot_high.h5"), window.last());
        QCOMPARE(window.ask("start locateRecordings"), QString("done"));
        QVERIFY2(window.waitFor("text fileNameEdit", ""), window.last());
        QCOMPARE(window.ask("type fileNameEdit " + path("work/elsewhere")), QString("done"));
        // The recording's own hash finds the byte, before that of the project (CAP-015) is asked.
        QVERIFY2(window.waitFor("list findingsPanel", "CAP-018"), window.last());
        QVERIFY2(window.last().contains("shot_low.h5"), window.last());
        QCOMPARE(window.ask("trigger stageAction12"), QString("done")); // a dialog had the keys
        QCOMPARE(window.ask(QString("text %1").arg(kCustomer)), QString("Second"));
        QCOMPARE(window.ask("trigger issueAction"), QString("done"));
        QVERIFY2(window.waitFor("list issueObstacles", "CAP-018"), window.last());
    }

    void commandLine_leavesTheWorkAlone()
    {
        editAndKill(path("work/job.dyncal"), "Second");
        const QStringList before = kept().entryList(QDir::Files);
        QCOMPARE(
            runDyncal({"info", path("work/a.h5")}, {"XDG_DATA_HOME=" + home() + "/data"}).exitCode,
            0);
        tour();
        QCOMPARE(kept().entryList(QDir::Files), before);
    }
};

DYNCAL_TEST(TestWorkAfterKill)
#include "tst_work_after_kill.moc"
