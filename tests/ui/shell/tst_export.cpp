// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/atomic_file.h"
#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "ui/shell/main_window.h"

#include <QDir>
#include <QDirIterator>
#include <QLabel>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;
using dyncal::test::EventLoopWatchdog;
using testing::writeBytes;

namespace {

constexpr int kPatience_ms = 120'000;
constexpr int kSettle_ms = 1000;
/// The aim is 100 ms; machines that test do other work as well.
constexpr qint64 kLongestGap_ms = 300;
constexpr const char *kCreated = "2026-01-31T12:00:00Z";
constexpr const char *kEpoch = "1769860800"; // the same moment

/// Exit code of a call of the built program, which writes the date of the test.
int commandLine(const QStringList &arguments)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("SOURCE_DATE_EPOCH", kEpoch);
    process.setProcessEnvironment(environment);
    process.start(qEnvironmentVariable("DYNCAL_BINARY"), arguments);
    return process.waitForFinished(kPatience_ms) ? process.exitCode() : -1;
}

QStringList filesBelow(const QString &folder)
{
    QStringList files;
    QDirIterator walk(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext())
        files << QDir(folder).relativeFilePath(walk.next());
    files.sort();
    return files;
}

} // namespace

/// Writing results from the window: the bytes of the command line, and a window that answers.
class TestExport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void results_exported_areThoseOfTheCommandLine();
    void results_exportedInASwedishWindow_areTheSameBytes();
    void results_exported_neverHoldTheWindow();
    void results_exportedAgain_replaceTheEarlierRun();
    void progress_isShownWhileWriting();
    void export_cancelledWhileDrawing_changesNothingOnDisk();
    void export_intoUnwritablePlace_saysSoOnce();
    void results_overFilesOfSomebodyElse_areNotExported();
    void certificate_exported_writesOneFile();
    void quit_whileWriting_isRefused();
    void edit_whileWriting_isNotInWhatIsWritten();
    void recordingMoved_isSaidAndNothingIsWritten(); // the last: nothing can be exported after it

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString makeFolder(const QString &name) const
    {
        QDir().mkpath(path(name));
        return path(name);
    }
    void startExport(const QString &folder)
    {
        m_prompts.setNextFile(folder);
        m_window->files().exportResults();
    }
    void waitIdle() { QTRY_VERIFY_WITH_TIMEOUT(!m_window->files().isBusy(), kPatience_ms); }
    void exportTo(const QString &folder)
    {
        startExport(folder);
        QVERIFY(m_window->files().isBusy());
        waitIdle();
    }
    void compareWithCommandLine(const QString &folder);
    QStringList newProblems() { return m_prompts.shownProblems().mid(m_problemsBefore); }

    QTemporaryDir m_folder;
    Preferences m_preferences{m_folder.filePath("settings.ini")};
    Prompts m_prompts;
    Language m_language;
    std::unique_ptr<MainWindow> m_window;
    qsizetype m_problemsBefore = 0;
};

void TestExport::initTestCase()
{
    if (!QFile::exists(qEnvironmentVariable("DYNCAL_BINARY")))
        QSKIP("the program is not built: there is no command line to compare with");
    QCOMPARE(commandLine({"simulate", "-o", path("example.h5"), "--preset", "optic3"}), 0);
    const int exitCode = commandLine({"run", path("example.h5"), "-o", path("cli")});
    QVERIFY(exitCode == 0 || exitCode == 1); // 1: with cautions
    m_language.install("en");
    m_prompts.setScripted();
    m_preferences.setLastFolder(m_folder.path());
    m_window = std::make_unique<MainWindow>(
        runPipeline, [] { return Result<std::string>(kCreated); }, m_preferences, m_prompts,
        m_language);
    m_window->show();
    m_window->files().openPaths({path("example.h5")});
    QTRY_VERIFY_WITH_TIMEOUT(m_window->session().state().hasShots(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->session().isComputing(), kPatience_ms);
    QVERIFY(m_window->session().results().response);
}

void TestExport::init()
{
    m_problemsBefore = m_prompts.shownProblems().size();
}

void TestExport::compareWithCommandLine(const QString &folder)
{
    const QStringList files = filesBelow(path("cli"));
    QVERIFY(files.size() > 40);
    QCOMPARE(filesBelow(folder), files);
    for (const QString &file : files)
        QVERIFY2(bytesOf(folder + '/' + file) == bytesOf(path("cli/" + file)), qPrintable(file));
}

void TestExport::results_exported_areThoseOfTheCommandLine()
{
    const QString folder = makeFolder("out");
    exportTo(folder);
    QCOMPARE(newProblems(), QStringList());
    compareWithCommandLine(folder);
    QCOMPARE(m_window->findChild<QLabel *>("statusMessage")->text(), "Written: " + folder);
}

void TestExport::results_exportedInASwedishWindow_areTheSameBytes()
{
    m_language.install("sv");
    QCoreApplication::processEvents();
    const QString folder = makeFolder("sv");
    exportTo(folder);
    m_language.install("en");
    QTest::qWait(kSettle_ms); // the pages are made anew, which the next test does not measure
    compareWithCommandLine(folder);
}

void TestExport::results_exported_neverHoldTheWindow()
{
    const QString folder = makeFolder("watched");
    EventLoopWatchdog watchdog;
    exportTo(folder);
    qInfo("longest time without an answer: %lld ms (aim 100 ms)", watchdog.longestGap_ms());
    QVERIFY(watchdog.longestGap_ms() < kLongestGap_ms);
}

void TestExport::results_exportedAgain_replaceTheEarlierRun()
{
    const QString folder = makeFolder("again");
    exportTo(folder);
    QVERIFY(writeBytes(folder + "/mine.txt", "mine"));
    exportTo(folder);
    QCOMPARE(newProblems(), QStringList());
    QCOMPARE(bytesOf(folder + "/mine.txt"), QByteArray("mine"));
    QVERIFY(QFile::remove(folder + "/mine.txt"));
    compareWithCommandLine(folder);
}

void TestExport::progress_isShownWhileWriting()
{
    auto *bar = m_window->findChild<QProgressBar *>("progressBar");
    auto *cancel = m_window->findChild<QPushButton *>("cancelButton");
    int last = 0;
    bool falls = false;
    const auto watch = connect(bar, &QProgressBar::valueChanged, this, [&](int value) {
        falls = falls || value < last;
        last = value;
    });
    startExport(makeFolder("progress"));
    QVERIFY(bar->isVisible());
    QVERIFY(cancel->isVisible());
    QCOMPARE(m_window->findChild<QLabel *>("statusMessage")->text(), QString("Writing progress"));
    waitIdle();
    disconnect(watch);
    QVERIFY(last > 50);
    QVERIFY(!falls);
    QVERIFY(!bar->isVisible());
}

void TestExport::export_cancelledWhileDrawing_changesNothingOnDisk()
{
    const QString folder = makeFolder("cancelled");
    QVERIFY(writeBytes(folder + "/notes.txt", "earlier"));
    auto *bar = m_window->findChild<QProgressBar *>("progressBar");
    startExport(folder);
    QTRY_VERIFY(bar->value() > 10);
    m_window->findChild<QPushButton *>("cancelButton")->click();
    QVERIFY(!m_window->files().isBusy());
    QVERIFY(!bar->isVisible());
    QTest::qWait(100);
    QCOMPARE(filesBelow(folder), QStringList("notes.txt"));
    QCOMPARE(bytesOf(folder + "/notes.txt"), QByteArray("earlier"));
    QCOMPARE(newProblems(), QStringList());
}

void TestExport::export_intoUnwritablePlace_saysSoOnce()
{
    QVERIFY(writeBytes(path("file"), "no folder"));
    startExport(path("file"));
    QVERIFY(!m_window->files().isBusy());
    QCOMPARE(newProblems().size(), 1);
    QVERIFY2(newProblems()[0].contains("file"), qPrintable(newProblems()[0]));
    QCOMPARE(bytesOf(path("file")), QByteArray("no folder"));
}

void TestExport::results_overFilesOfSomebodyElse_areNotExported()
{
    const QString folder = makeFolder("foreign");
    QVERIFY(writeBytes(folder + "/recipe.json", "mine"));
    startExport(folder);
    QVERIFY(!m_window->files().isBusy());
    QCOMPARE(newProblems().size(), 1);
    QVERIFY2(newProblems()[0].contains("recipe.json is in the way"), qPrintable(newProblems()[0]));
    QCOMPARE(filesBelow(folder), QStringList("recipe.json"));
    QCOMPARE(bytesOf(folder + "/recipe.json"), QByteArray("mine"));
}

void TestExport::certificate_exported_writesOneFile()
{
    const QString folder = makeFolder("certificate");
    m_prompts.setNextFile(folder + "/c1");
    EventLoopWatchdog watchdog;
    m_window->files().exportCertificate();
    waitIdle();
    qInfo("longest time without an answer: %lld ms (aim 100 ms)", watchdog.longestGap_ms());
    QVERIFY(watchdog.longestGap_ms() < kLongestGap_ms);
    QCOMPARE(newProblems(), QStringList());
    QCOMPARE(filesBelow(folder), QStringList("c1.pdf")); // nothing else, nothing half-made
    QVERIFY(bytesOf(folder + "/c1.pdf") == bytesOf(path("cli/certificate.pdf")));
}

void TestExport::quit_whileWriting_isRefused()
{
    startExport(makeFolder("quit"));
    QVERIFY(!m_window->close());
    QVERIFY(m_window->isVisible());
    QCOMPARE(newProblems().size(), 1);
    QVERIFY(newProblems()[0].contains("quit"));
    waitIdle();
    QVERIFY(QFile::exists(path("quit/results.json")));
}

void TestExport::edit_whileWriting_isNotInWhatIsWritten()
{
    const QString folder = makeFolder("edited");
    startExport(folder);
    Recipe next = m_window->session().recipe();
    next.realization.order = 5;
    m_window->session().apply(next, "order");
    waitIdle();
    compareWithCommandLine(folder);
    m_window->session().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->session().isComputing(), kPatience_ms);
}

void TestExport::recordingMoved_isSaidAndNothingIsWritten()
{
    const QString folder = makeFolder("gone");
    QVERIFY(QFile::rename(path("example.h5"), path("elsewhere.h5")));
    const QList<void (FileActions::*)()> exports{
        &FileActions::exportResults, &FileActions::exportModel, &FileActions::exportCertificate};
    for (qsizetype i = 0; i < exports.size(); ++i) {
        m_prompts.setNextFile(
            exports[i] == &FileActions::exportCertificate ? folder + "/c" : folder);
        (m_window->files().*exports[i])();
        waitIdle();
        QCOMPARE(newProblems().size(), i + 1);
        QVERIFY2(newProblems().last().contains("example.h5 is no longer where it was opened"),
            qPrintable(newProblems().last()));
        QCOMPARE(filesBelow(folder), QStringList());
    }
}

DYNCAL_TEST(TestExport)
#include "tst_export.moc"
