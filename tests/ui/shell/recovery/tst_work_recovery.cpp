// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/recording_files.h"
#include "tests/ui/support/sample_results.h"
#include "ui/session/capture_reading.h"
#include "ui/session/project_file.h"
#include "ui/session/recovery_store.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QPalette>
#include <QPushButton>
#include <QtTest>

using namespace dyncal;
using namespace std::chrono_literals;

namespace {

constexpr AutoSaveDelays kQuick{20ms, 200ms, 1h};

/// The clock of the window bench stands at noon.
QDateTime at(const char *time)
{
    return QDateTime::fromString(QStringLiteral("2026-01-31T%1Z").arg(time), Qt::ISODate);
}

QString shown(const QDateTime &utc)
{
    return utc.toLocalTime().toString("HH:mm:ss");
}

/// A window, a recording, a project of it, and what a stopped program left of that.
struct Bench : test::WindowBench
{
    QString place = folder.filePath("recovery");
    QString recording = folder.filePath("low.csv");
    QString project = folder.filePath("job.dyncal");

    Bench()
        : WindowBench(test::samplePipeline)
    {
        QDir().mkpath(place);
        test::writeFile(recording, test::tableText({}));
        const auto read = readEach({recording.toStdString()}, {}, {});
        state.captures = std::make_shared<const CaptureSet>(read->set);
        if (!saveProject(project, state, projectFileHash(project)))
            qFatal("no project");
        QFile file(project);
        if (!file.open(QIODevice::ReadWrite)
            || !file.setFileTime(at("11:00:00"), QFileDevice::FileModificationTime))
            qFatal("no time");
        window->resize(1400, 900);
        window->show();
    }

    QString leave(const char *customer, const char *saved, const char *stopped,
        const QString &ofProject, int number = 1)
    {
        ProjectState edited = state;
        edited.recipe.certificate.fields["customer"] = customer;
        const QString file = place + QString("/work-%1.dyncal").arg(number);
        if (!writeRecoveryFile(file, edited, ofProject, at(saved), projectFileHash(ofProject)))
            qFatal("nothing left");
        markAlive(file, at(stopped));
        return file;
    }
    QString leave() { return leave("Second", "11:58:31", "11:58:43", project); }

    void start() { window->keepWork(place, kQuick); }
    QString sentence() const { return find<QLabel>("recoverySentence")->text(); }
    bool isOffered() const { return find<QWidget>("recoveryBanner")->isVisible(); }
    void click(const char *button)
    {
        QVERIFY(find<QPushButton>(button)->isVisible());
        QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton);
    }
    std::string customer() const
    {
        const auto &fields = window->session().recipe().certificate.fields;
        const auto found = fields.find("customer");
        return found == fields.end() ? std::string() : found->second;
    }
    void setCustomer(const char *name)
    {
        Recipe next = window->session().recipe();
        next.certificate.fields["customer"] = name;
        window->session().apply(next, "Customer");
    }
    QStringList kept() const { return QDir(place).entryList({"*.dyncal"}, QDir::Files); }

    ProjectState state;
};

} // namespace

class TestWorkRecovery : public QObject
{
    Q_OBJECT

private slots:
    void notAsked_nothingIsKeptOrOffered();
    void nothingLeft_showsNoBanner();
    void left_isOfferedByNameAndTimes();
    void left_daysAgo_hasTheDate();
    void left_ofAnUnsavedProject_isNamedByItsRecording();
    void left_projectSavedLater_isSaid();
    void restored_isUnsavedWorkOfItsProject();
    void restored_undoWorksAsUsual();
    void restored_overUnsavedChanges_asksFirst();
    void discarded_canBeTakenBackUntilClosed();
    void discarded_andQuit_isGone();
    void notNow_staysForTheNextStart();
    void several_areOfferedOneAfterTheOther();
    void missingRecording_isNamedAndCanBeLocated();
    void unreadable_isNamedAndCanBeClosed();
    void edited_statusSaysSinceWhen();
    void unwritable_isSaidInTheStatusLineOnly();
    void closed_discardedChangesLeaveNothing();
    void buttons_areReachedByKeyboard();
    void language_switched_isFollowed();
};

void TestWorkRecovery::notAsked_nothingIsKeptOrOffered()
{
    Bench bench;
    bench.leave();
    QVERIFY(!bench.isOffered());
    bench.window->session().reset(bench.state);
    bench.setCustomer("A");
    QTest::qWait(100);
    QCOMPARE(bench.kept(), QStringList{"work-1.dyncal"});
}

void TestWorkRecovery::nothingLeft_showsNoBanner()
{
    Bench bench;
    bench.start();
    QVERIFY(!bench.isOffered());
}

void TestWorkRecovery::left_isOfferedByNameAndTimes()
{
    Bench bench;
    bench.leave();
    bench.start();
    QVERIFY(bench.isOffered());
    QCOMPARE(bench.sentence(),
        QString("Recovered work on job from %1 (12 s before stop).").arg(shown(at("11:58:31"))));
    // Work goes on below it.
    QVERIFY(bench.find<QWidget>("startOpenCaptures")->isVisible());
    bench.window->session().reset(bench.state);
    QTRY_VERIFY(bench.find<QWidget>("capturesPage")->isVisible());
    QVERIFY(bench.isOffered());
    QVERIFY(bench.prompts.shownProblems().isEmpty());
}

void TestWorkRecovery::left_daysAgo_hasTheDate()
{
    Bench bench;
    const QString file = bench.leave();
    const QDateTime saved = at("11:58:31").addDays(-3);
    QVERIFY(writeRecoveryFile(file, bench.state, bench.project, saved));
    markAlive(file, saved.addSecs(7 * 60));
    bench.start();
    QVERIFY2(bench.sentence().contains(
                 "from " + saved.toLocalTime().toString("yyyy-MM-dd HH:mm:ss") + " (7 min before"),
        qPrintable(bench.sentence()));
}

void TestWorkRecovery::left_ofAnUnsavedProject_isNamedByItsRecording()
{
    Bench bench;
    bench.leave("Second", "11:00:00", "10:59:59", {}); // a clock that was set back
    bench.start();
    QVERIFY2(bench.sentence().startsWith("Recovered work on low.csv from ")
            && bench.sentence().contains("(0 s before stop)"),
        qPrintable(bench.sentence()));
    bench.click("restoreWork");
    QTRY_COMPARE(bench.customer(), std::string("Second"));
    QCOMPARE(bench.window->files().projectPath(), QString());
    QVERIFY(bench.window->isWindowModified());
}

void TestWorkRecovery::left_projectSavedLater_isSaid()
{
    Bench bench;
    bench.leave("Second", "10:00:00", "10:00:12", bench.project);
    bench.start();
    QVERIFY2(bench.sentence().endsWith(
                 "The project was saved after that, at " + shown(at("11:00:00")) + "."),
        qPrintable(bench.sentence()));
}

void TestWorkRecovery::restored_isUnsavedWorkOfItsProject()
{
    Bench bench;
    const QString file = bench.leave();
    bench.start();
    bench.click("restoreWork");
    QTRY_COMPARE(bench.customer(), std::string("Second"));
    QVERIFY(!bench.isOffered());
    QVERIFY(bench.window->isWindowModified());
    QCOMPARE(bench.window->files().projectPath(), bench.project);
    QVERIFY(QFile::exists(file)); // kept until it is saved
    QTRY_VERIFY(!bench.window->session().isComputing());
    QVERIFY(bench.window->files().save());
    QVERIFY(!bench.window->isWindowModified());
    QTRY_VERIFY(bench.kept().isEmpty());
    QCOMPARE(openProject(bench.project)->recipe.certificate.fields.at("customer"),
        std::string("Second"));
}

void TestWorkRecovery::restored_undoWorksAsUsual()
{
    Bench bench;
    bench.leave();
    bench.start();
    bench.click("restoreWork");
    QTRY_COMPARE(bench.customer(), std::string("Second"));
    bench.setCustomer("Third");
    bench.find<QAction>("undoAction")->trigger();
    QCOMPARE(bench.customer(), std::string("Second"));
    QVERIFY(!bench.find<QAction>("undoAction")->isEnabled());
    QVERIFY(bench.window->isWindowModified()); // still not what the project holds
    bench.find<QAction>("redoAction")->trigger();
    QCOMPARE(bench.customer(), std::string("Third"));
}

void TestWorkRecovery::restored_overUnsavedChanges_asksFirst()
{
    Bench bench;
    bench.leave();
    bench.start();
    bench.window->session().reset(bench.state);
    bench.setCustomer("Mine");
    bench.prompts.setNextAnswer(dyncal::Answer::Cancel);
    bench.click("restoreWork");
    QTest::qWait(50);
    QCOMPARE(bench.customer(), std::string("Mine"));
    QVERIFY(bench.isOffered());
    bench.prompts.setNextAnswer(dyncal::Answer::Discard);
    bench.click("restoreWork");
    QTRY_COMPARE(bench.customer(), std::string("Second"));
    QTRY_COMPARE(bench.kept(), QStringList{"work-1.dyncal"});
}

void TestWorkRecovery::discarded_canBeTakenBackUntilClosed()
{
    Bench bench;
    const QString file = bench.leave();
    bench.start();
    bench.click("discardWork");
    QCOMPARE(bench.sentence(), QString("The recovered work on job is discarded."));
    QVERIFY(!bench.find<QWidget>("restoreWork")->isVisible());
    bench.click("undoDiscard");
    QVERIFY(bench.sentence().startsWith("Recovered work on job"));
    bench.click("discardWork");
    bench.click("closeBanner");
    QVERIFY(!bench.isOffered());
    QVERIFY(!QFile::exists(file));
}

void TestWorkRecovery::discarded_andQuit_isGone()
{
    Bench bench;
    const QString file = bench.leave();
    bench.start();
    bench.click("discardWork");
    QVERIFY(bench.window->close());
    QVERIFY(!QFile::exists(file));
}

void TestWorkRecovery::notNow_staysForTheNextStart()
{
    Bench bench;
    const QString file = bench.leave();
    bench.start();
    bench.click("postponeWork");
    QVERIFY(!bench.isOffered());
    QVERIFY(bench.window->close());
    bench.window.reset();
    QVERIFY(QFile::exists(file));
    QCOMPARE(RecoveryStore(bench.place).leftBehind().size(), std::size_t(1));
}

void TestWorkRecovery::several_areOfferedOneAfterTheOther()
{
    Bench bench;
    bench.leave("Old", "10:00:00", "10:00:00", {}, 1);
    bench.leave("New", "11:30:00", "11:30:00", bench.project, 2);
    bench.start();
    QVERIFY2(
        bench.sentence().startsWith("Recovered work on job") && bench.sentence().contains("1 more"),
        qPrintable(bench.sentence()));
    bench.click("restoreWork");
    QTRY_COMPARE(bench.customer(), std::string("New"));
    QVERIFY(bench.sentence().startsWith("Recovered work on low.csv"));
    QVERIFY(!bench.sentence().contains("more"));
    bench.click("postponeWork");
    QVERIFY(!bench.isOffered());
    QCOMPARE(bench.kept().size(), 2);
}

void TestWorkRecovery::missingRecording_isNamedAndCanBeLocated()
{
    Bench bench;
    const QString file = bench.leave();
    QVERIFY(QDir(bench.folder.path()).mkpath("moved"));
    QVERIFY(QFile::rename(bench.recording, bench.folder.filePath("moved/low.csv")));
    bench.start();
    QVERIFY(!bench.find<QWidget>("locateRecordings")->isVisible());
    bench.click("restoreWork");
    QTRY_VERIFY(bench.sentence().contains(bench.recording));
    QVERIFY(bench.prompts.shownProblems().isEmpty()); // no dialog
    QVERIFY(QFile::exists(file));
    bench.prompts.setNextFile({}); // the folder dialog is cancelled
    bench.click("locateRecordings");
    QVERIFY(bench.isOffered());
    bench.prompts.setNextFile(bench.folder.filePath("moved"));
    bench.click("locateRecordings");
    QTRY_COMPARE(bench.customer(), std::string("Second"));
    QVERIFY(!bench.isOffered());
}

void TestWorkRecovery::unreadable_isNamedAndCanBeClosed()
{
    Bench bench;
    test::writeFile(bench.place + "/work-1.dyncal", "\x01\x02 nothing");
    bench.start();
    QVERIFY(bench.isOffered());
    QVERIFY2(bench.sentence().contains(bench.place + "/work-1.dyncal.unreadable-1"),
        qPrintable(bench.sentence()));
    QVERIFY(!bench.find<QWidget>("restoreWork")->isVisible());
    bench.click("closeBanner");
    QVERIFY(!bench.isOffered());
}

void TestWorkRecovery::edited_statusSaysSinceWhen()
{
    Bench bench;
    bench.start();
    bench.window->session().reset(bench.state);
    auto *status = bench.find<QLabel>("autoSaveStatus");
    QCOMPARE(status->text(), QString());
    bench.setCustomer("A");
    QTRY_COMPARE(status->text(), "Auto-saved " + shown(at("12:00:00")));
    QCOMPARE(bench.kept(), QStringList{"work-1.dyncal"});
    bench.window->session().undoStack().undo();
    QCOMPARE(status->text(), QString());
    QTRY_VERIFY(bench.kept().isEmpty());
}

void TestWorkRecovery::unwritable_isSaidInTheStatusLineOnly()
{
    Bench bench;
    bench.place = bench.recording + "/recovery"; // beneath a file
    bench.start();
    bench.window->session().reset(bench.state);
    bench.setCustomer("A");
    auto *status = bench.find<QLabel>("autoSaveStatus");
    QTRY_VERIFY(status->text().startsWith("Not auto-saved: "));
    QVERIFY(status->text().contains(bench.place));
    QCOMPARE(status->toolTip(), status->text());
    bench.setCustomer("B");
    QTest::qWait(100);
    QVERIFY(bench.prompts.shownProblems().isEmpty());
}

void TestWorkRecovery::closed_discardedChangesLeaveNothing()
{
    Bench bench;
    bench.start();
    bench.window->session().reset(bench.state);
    bench.setCustomer("A");
    QTRY_VERIFY(!bench.kept().isEmpty());
    bench.prompts.setNextAnswer(dyncal::Answer::Cancel);
    QVERIFY(!bench.window->close());
    QVERIFY(!bench.kept().isEmpty());
    bench.prompts.setNextAnswer(dyncal::Answer::Discard);
    QVERIFY(bench.window->close());
    bench.window.reset();
    QVERIFY(QDir(bench.place).isEmpty());
}

void TestWorkRecovery::buttons_areReachedByKeyboard()
{
    Bench bench;
    bench.leave();
    bench.start();
    for (const char *name : {"restoreWork", "discardWork", "postponeWork"}) {
        auto *button = bench.find<QPushButton>(name);
        QVERIFY2(button->focusPolicy() & Qt::TabFocus, name);
        QVERIFY2(!button->shortcut().isEmpty(), name);
    }
    bench.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
    QTest::keySequence(bench.window.get(), QKeySequence("Alt+D"));
    QTRY_VERIFY(bench.sentence().contains("discarded")); // a button takes its time for show
    QTest::keySequence(bench.window.get(), QKeySequence("Alt+U"));
    QTRY_VERIFY(bench.find<QPushButton>("restoreWork")->isVisible());
    bench.find<QPushButton>("restoreWork")->setFocus();
    QTest::keyClick(bench.find<QPushButton>("restoreWork"), Qt::Key_Space);
    QTRY_COMPARE(bench.customer(), std::string("Second"));
}

void TestWorkRecovery::language_switched_isFollowed()
{
    Bench bench;
    bench.leave();
    bench.start();
    const QString english = bench.sentence();
    bench.find<QAction>("languageAction_sv")->trigger();
    QTRY_COMPARE(bench.language.code(), QString("sv"));
    QCoreApplication::processEvents();
    QVERIFY(bench.isOffered());
    bench.find<QAction>("languageAction_en")->trigger();
    QCoreApplication::processEvents();
    QTRY_COMPARE(bench.sentence(), english);
    if (const QString folder = qEnvironmentVariable("DYNCAL_SHOTS"); !folder.isEmpty())
        bench.window->grab().save(folder + "/recovery.png");
}

DYNCAL_TEST(TestWorkRecovery)
#include "tst_work_recovery.moc"
