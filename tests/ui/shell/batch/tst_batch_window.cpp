// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A batch through its window: planned, run by the program as it is built, stopped, followed,
// merged, and its sensors opened in the main window.

#include "core/pipeline/pipeline.h"
#include "tests/support/test_program.h"
#include "tests/system/short_capture.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/window_grounds.h"
#include "ui/shell/batch/batch_window.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QtTest>

using namespace dyncal;
using dyncal::test::EventLoopWatchdog;

namespace {

constexpr int kPatience_ms = 240'000;
constexpr qint64 kLongestWork_ms = 200; ///< of the window's thread between two beats
constexpr const char *kEpoch = "1769860800"; ///< the clock of WindowBench

/// The main window with the window of batches, and a folder of recordings.
struct Bench : test::WindowBench
{
    QString root; ///< where recordings, plan and results are
    BatchWindow *batch = nullptr;

    explicit Bench(const QString &place = {})
        : WindowBench(runPipeline)
        , root(place.isEmpty() ? folder.path() : place)
    {
        window->show();
        find<QAction>("batchAction")->trigger();
        batch = find<BatchWindow>("batchWindow");
        batch->setProgram(qEnvironmentVariable("DYNCAL_BINARY"));
        writeBytes(path("quick.json"), R"({"uncertainty": {"monte_carlo_trials": 100}})");
    }
    QString path(const QString &name) const { return QDir(root).filePath(name); }
    QTableView *table() const { return find<QTableView>("batchTable"); }
    QPushButton *button(const char *name) const { return find<QPushButton>(name); }
    QString outcome() const { return find<QLabel>("batchOutcome")->text(); }
    QString cell(int row, int column) const
    {
        return table()->model()->index(row, column).data().toString();
    }
    QStringList column(int column) const
    {
        QStringList cells;
        for (int row = 0; row < table()->model()->rowCount(); ++row)
            cells << cell(row, column);
        return cells;
    }
    int rowOf(const QString &sensor) const
    {
        return int(column(BatchModel::Sensor).indexOf(sensor));
    }
    qsizetype count(const char *state) const
    {
        return column(BatchModel::State).filter(state).size();
    }
    void doubleClick(int row) const
    {
        const QModelIndex index = table()->model()->index(row, 0);
        table()->scrollTo(index);
        const QPoint place = table()->visualRect(index).center();
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(table()->viewport(), Qt::LeftButton, {}, place);
    }
    /// Plans through the dialog and waits for the table.
    void plan() const
    {
        button("batchNewPlan")->click();
        auto *dialog = find<QDialog>("batchPlanDialog");
        QVERIFY(!button("batchMakePlan")->isEnabled());
        dialog->findChild<QLineEdit *>("batchRoot")->setText(path("in"));
        dialog->findChild<QLineEdit *>("batchRecipe")->setText(path("quick.json"));
        dialog->findChild<QLineEdit *>("batchPlanFile")->setText(path("night.jsonl"));
        button("batchMakePlan")->click();
        QTRY_VERIFY_WITH_TIMEOUT(table()->model()->rowCount() > 0, kPatience_ms);
    }
    void run(int jobs) const
    {
        find<QSpinBox>("batchJobs")->setValue(jobs);
        button("batchRun")->click();
        QVERIFY(batch->isBusy());
    }
    void waitForEnd() const { QTRY_VERIFY_WITH_TIMEOUT(!batch->isBusy(), kPatience_ms); }
    ::Answer commandLine(const QStringList &words) const
    {
        return runDyncal(QStringList("batch") + words, {QString("SOURCE_DATE_EPOCH=") + kEpoch});
    }
};

} // namespace

class TestBatchWindow : public QObject
{
    Q_OBJECT

private:
    static constexpr int kSensors = 5;
    static constexpr int kSeeds[kSensors]{
        1, 3, 4, 5, 6}; ///< without cautions, also with few trials
    QTemporaryDir m_simulated;

    void addSensors(const Bench &bench, int count) const
    {
        for (int i = 1; i <= count; ++i) {
            const QString id = QString("in/SN-%1").arg(i);
            QDir(bench.root).mkpath(id);
            QVERIFY(QFile::copy(
                m_simulated.filePath(QString("%1.h5").arg(i)), bench.path(id + "/shot.h5")));
        }
    }
    void addBadSensors(const Bench &bench) const
    {
        QDir(bench.root).mkpath("in/clipped");
        QDir(bench.root).mkpath("in/corrupt");
        QVERIFY(QFile::copy(m_simulated.filePath("clipped.h5"), bench.path("in/clipped/shot.h5")));
        QVERIFY(writeBytes(
            bench.path("in/corrupt/shot.h5"), bytesOf(m_simulated.filePath("1.h5")).left(50000)));
    }

private slots:
    void initTestCase()
    {
        qputenv("SOURCE_DATE_EPOCH", kEpoch); // for the program that the window starts
        for (int i = 1; i <= kSensors; ++i)
            QVERIFY(
                simulateShortCapture(m_simulated.filePath(QString("%1.h5").arg(i)), kSeeds[i - 1]));
        QCOMPARE(runDyncal({"simulate", "-o", m_simulated.filePath("clipped.h5"), "--preset",
                               "piezo", "--duration-s", "0.003", "--sample-rate-hz", "1e7",
                               "--shots", "low", "--defect", "clip"},
                     {"SOURCE_DATE_EPOCH=1700000000"})
                     .exitCode,
            0);
    }

    void withoutPlan_nothingCanBeRun();
    void night_goodClippedAndCorrupt_asTheCommandLineDoes();
    void sensor_isOpenedByDoubleClick();
    void sensorThatCannotBeRead_isSaid();
    void stopped_keepsWhatIsComplete();
    void closedWhileItRuns_stopsIt();
    void workOfOthers_isSeenLive();
    void plans_thatCannotBeUsed_areSaid();
    void planDialog_asksForPaths_data();
    void planDialog_asksForPaths();
    void missingProgram_isSaid();
    void language_changesInPlace();
};

void TestBatchWindow::withoutPlan_nothingCanBeRun()
{
    const Bench bench;
    QVERIFY(bench.batch->isVisible() && !bench.batch->isModal());
    for (const char *name : {"batchRun", "batchStop", "batchMerge", "batchOpenSensor"})
        QVERIFY2(!bench.button(name)->isEnabled(), name);
    QVERIFY(bench.button("batchOpenPlan")->isEnabled());
    QVERIFY(!bench.find<QProgressBar>("batchProgress")->isVisible());
    bench.find<QAction>("batchAction")->trigger(); // the same window once more
    QCOMPARE(bench.window->findChildren<BatchWindow *>().size(), 1);
}

/// Scenario S29, and the files of the command line byte for byte.
void TestBatchWindow::night_goodClippedAndCorrupt_asTheCommandLineDoes()
{
    Bench bench;
    addSensors(bench, kSensors);
    addBadSensors(bench);
    bench.plan();
    QCOMPARE(bench.count("missing"), 7);
    const QByteArray plan = bytesOf(bench.path("night.jsonl"));
    QCOMPARE(bench
                 .commandLine({"plan", bench.path("in"), "--recipe", bench.path("quick.json"), "-o",
                     bench.path("night.jsonl")})
                 .exitCode,
        0);
    QCOMPARE(bytesOf(bench.path("night.jsonl")), plan);

    {
        EventLoopWatchdog watchdog;
        bench.run(2);
        QVERIFY(bench.find<QProgressBar>("batchProgress")->isVisible());
        QVERIFY(bench.button("batchStop")->isEnabled() && !bench.button("batchRun")->isEnabled());
        bench.waitForEnd();
        QVERIFY2(watchdog.longestWork_ms() < kLongestWork_ms,
            qPrintable(QString::number(watchdog.longestWork_ms())));
    }
    QCOMPARE(bench.outcome(), QString("The run has ended."));
    QTRY_COMPARE(bench.count("done"), 5);
    QCOMPARE(bench.cell(0, BatchModel::Sensor), QString("corrupt"));
    QCOMPARE(bench.cell(0, BatchModel::State), QString("■ failed"));
    QVERIFY(!bench.cell(0, BatchModel::Reason).isEmpty());
    QCOMPARE(bench.cell(1, BatchModel::Sensor), QString("clipped"));
    QVERIFY(!bench.cell(1, BatchModel::Worst).isEmpty());
    QVERIFY(bench.cell(6, BatchModel::Frequency).contains("Hz ± "));
    QVERIFY(bench.cell(6, BatchModel::Damping).contains(" ± "));

    bench.prompts.setNextFile(bench.path("window.csv"));
    bench.button("batchMerge")->click();
    bench.waitForEnd();
    QVERIFY2(bench.outcome().startsWith("Written: "), qPrintable(bench.outcome()));
    QCOMPARE(bench.commandLine({"merge", bench.path("night.jsonl"), "-o", bench.path("line.csv")})
                 .exitCode,
        2);
    QVERIFY(bytesOf(bench.path("window.csv")).count('\n') == 8);
    QCOMPARE(bytesOf(bench.path("window.csv")), bytesOf(bench.path("line.csv")));
    for (const char *code : {"sv", "en"}) {
        bench.language.install(code);
        QCOMPARE(test::faultsOnEveryGround(*bench.batch, bench.language), QString());
    }
    // What the window computed is complete for the command line.
    QVERIFY(bench.commandLine({"run", bench.path("night.jsonl")}).out.endsWith("kept 6\n"));
}

/// The job that opens is the batch's: what the main window exports of it is what the batch wrote.
void TestBatchWindow::sensor_isOpenedByDoubleClick()
{
    Bench bench;
    addSensors(bench, 2);
    bench.plan();
    bench.run(2);
    bench.waitForEnd();
    QTRY_COMPARE(bench.count("done"), 2);
    bench.doubleClick(bench.rowOf("SN-2"));
    const Session &session = bench.window->session();
    QTRY_VERIFY_WITH_TIMEOUT(session.state().hasShots(), kPatience_ms);
    QCOMPARE(session.recipe().uncertainty.monteCarloTrials, Index(100));
    QCOMPARE(QString::fromStdString(session.state().captures->inputs.front().path),
        bench.path("in/SN-2/shot.h5"));
    QTRY_VERIFY_WITH_TIMEOUT(session.isUpToDate(), kPatience_ms);
    bench.prompts.setNextFile(bench.path("exported"));
    bench.window->files().exportResults();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window->files().isBusy(), kPatience_ms);
    QVERIFY(bench.prompts.shownProblems().isEmpty());
    for (const char *name : {"csv/poles.csv", "csv/frequency_response.csv"}) {
        const QByteArray exported = bytesOf(bench.path("exported/") + name);
        QVERIFY2(!exported.isEmpty(), name);
        QCOMPARE(bytesOf(bench.path("night.out/SN-2/calibration/") + name), exported);
    }
    QJsonObject ofBatch = fileJson(bench.path("night.out/SN-2/calibration/results.json"));
    QJsonObject ofWindow = fileJson(bench.path("exported/results.json"));
    for (const char *key : {"model", "response", "uncertainty", "findings", "recipe"})
        QVERIFY2(ofBatch[key] == ofWindow[key] && !ofBatch[key].isUndefined(), key);

    // Unsaved changes of the job that is open are asked for.
    Recipe recipe = session.recipe();
    recipe.realization.order = 4;
    bench.window->session().apply(recipe, "order");
    bench.prompts.setNextAnswer(dyncal::Answer::Cancel);
    bench.doubleClick(bench.rowOf("SN-1"));
    QTest::qWait(300);
    QVERIFY(session.state().captures->inputs.front().path.ends_with("SN-2/shot.h5"));
}

void TestBatchWindow::sensorThatCannotBeRead_isSaid()
{
    Bench bench;
    addSensors(bench, 1);
    addBadSensors(bench);
    QVERIFY(QDir(bench.root).mkpath("in/empty"));
    QVERIFY(writeBytes(bench.path("in/empty/notes.txt"), "nothing"));
    bench.plan();
    QCOMPARE(bench.cell(0, BatchModel::Sensor), QString("empty")); // not planned
    bench.doubleClick(0);
    QTRY_COMPARE(bench.prompts.shownProblems().size(), 1);
    QVERIFY(bench.prompts.shownProblems().last().contains("could not be planned"));
    bench.doubleClick(bench.rowOf("corrupt"));
    QTRY_VERIFY(bench.find<QDockWidget>("problemsDock")->isVisible());
    QVERIFY(!bench.window->session().state().hasShots());

    QVERIFY(
        writeBytes(bench.path("quick.json"), R"({"uncertainty": {"monte_carlo_trials": 200}})"));
    bench.doubleClick(bench.rowOf("SN-1"));
    QTRY_COMPARE(bench.prompts.shownProblems().size(), 2);
    QVERIFY(bench.prompts.shownProblems().last().contains("is not as it was"));
    QVERIFY(
        writeBytes(bench.path("quick.json"), R"({"uncertainty": {"monte_carlo_trials": 100}})"));

    // Another recording under the planned name opens, and the finding that it changed blocks.
    QVERIFY(QFile::remove(bench.path("in/SN-1/shot.h5")));
    QVERIFY(QFile::copy(m_simulated.filePath("2.h5"), bench.path("in/SN-1/shot.h5")));
    bench.doubleClick(bench.rowOf("SN-1"));
    QTRY_VERIFY(bench.window->session().state().hasShots());
    const auto isChanged = [](const Finding &finding) {
        return finding.id == "CAP-015" && finding.severity == Severity::Block;
    };
    QTRY_VERIFY_WITH_TIMEOUT(
        std::ranges::any_of(bench.window->session().findings(), isChanged), kPatience_ms);
}

void TestBatchWindow::stopped_keepsWhatIsComplete()
{
    Bench bench;
    addSensors(bench, kSensors);
    bench.plan();
    bench.run(1);
    QTRY_VERIFY_WITH_TIMEOUT(
        QFile::exists(bench.path("night.out/SN-1/calibration/batch.json")), kPatience_ms);
    bench.button("batchStop")->click();
    QVERIFY(!bench.button("batchStop")->isEnabled());
    bench.waitForEnd();
    QCOMPARE(bench.outcome(), QString("The run was stopped; what is complete is kept."));
    QTRY_VERIFY(bench.count("done") >= 1);
    QVERIFY(bench.count("missing") >= 1);
    QCOMPARE(bench.count("failed"), 0);
    const QDateTime before
        = QFileInfo(bench.path("night.out/SN-1/calibration/results.json")).lastModified();
    bench.prompts.setNextFile(bench.path("part.csv"));
    bench.button("batchMerge")->click();
    bench.waitForEnd();
    QVERIFY2(bench.outcome().contains("missing"), qPrintable(bench.outcome()));
    QVERIFY(!QFile::exists(bench.path("part.csv")));

    bench.run(2);
    bench.waitForEnd();
    QTRY_COMPARE(bench.count("done"), kSensors);
    QCOMPARE(
        QFileInfo(bench.path("night.out/SN-1/calibration/results.json")).lastModified(), before);
}

/// Nothing goes on behind a program that was quit.
void TestBatchWindow::closedWhileItRuns_stopsIt()
{
    const QTemporaryDir work;
    {
        const Bench bench(work.path());
        addSensors(bench, kSensors);
        bench.plan();
        bench.run(1);
        QTRY_VERIFY_WITH_TIMEOUT( // of the table, which looks every two seconds, it could be the
                                  // last
            QFile::exists(bench.path("night.out/SN-1/calibration/batch.json")), kPatience_ms);
        bench.batch->close(); // it goes on behind the closed window
        QVERIFY(bench.batch->isBusy());
    }
    const auto status = [&] {
        return runDyncal({"batch", "status", work.filePath("night.jsonl"), "--json"});
    };
    const ::Answer atEnd = status();
    QVERIFY(atEnd.json()["missing"].toInt() >= 1);
    QTest::qWait(1500);
    QCOMPARE(status().out, atEnd.out);
}

/// Another program computes; the window sees what it is at and what it has done.
void TestBatchWindow::workOfOthers_isSeenLive()
{
    constexpr int kFew = 3;
    Bench bench;
    addSensors(bench, kFew);
    QVERIFY(writeBytes( // each takes longer than the two seconds between two looks
        bench.path("quick.json"), R"({"uncertainty": {"monte_carlo_trials": 20000}})"));
    bench.plan();
    QProcess other;
    other.start(qEnvironmentVariable("DYNCAL_BINARY"),
        {"batch", "run", bench.path("night.jsonl"), "--jobs", "1"});
    bool wasRunning = false;
    bool wasBetween = false;
    QElapsedTimer waited;
    for (waited.start(); bench.count("done") < kFew && waited.elapsed() < kPatience_ms;) {
        QTest::qWait(50);
        wasRunning |= bench.count("running") == 1;
        wasBetween |= bench.count("done") > 0 && bench.count("done") < kFew;
        QVERIFY(!bench.batch->isBusy());
    }
    QTRY_COMPARE(other.state(), QProcess::NotRunning);
    QCOMPARE(bench.count("done"), kFew);
    QVERIFY(wasBetween);
    QVERIFY(wasRunning);
}

void TestBatchWindow::plans_thatCannotBeUsed_areSaid()
{
    Bench bench;
    addSensors(bench, 1);
    bench.prompts.setNextFile(bench.path("in/SN-1/shot.h5"));
    bench.button("batchOpenPlan")->click();
    QTRY_VERIFY2(bench.outcome().startsWith("Line 1"), qPrintable(bench.outcome()));
    QVERIFY(!bench.button("batchRun")->isEnabled());
    bench.batch->makePlan({bench.path("in").toStdString(), {}, {}, false,
        bench.path("in/night.jsonl").toStdString()});
    QTRY_VERIFY2(bench.outcome().contains("would lie below"), qPrintable(bench.outcome()));
    bench.plan();
    const QByteArray plan = bytesOf(bench.path("night.jsonl"));
    QVERIFY(writeBytes(
        bench.path("night.jsonl"), QByteArray(plan).replace("\"window\":", "\"window\":9")));
    bench.batch->openPlan(bench.path("night.jsonl"));
    QTRY_VERIFY(bench.button("batchRun")->isEnabled());
    bench.button("batchRun")->click();
    QVERIFY(!bench.batch->isBusy());
    QVERIFY2(
        bench.outcome().contains("other versions of the methods"), qPrintable(bench.outcome()));
}

void TestBatchWindow::planDialog_asksForPaths_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "en";
    QTest::newRow("Swedish") << "sv";
}

void TestBatchWindow::planDialog_asksForPaths()
{
    QFETCH(QString, language);
    Bench bench;
    bench.language.install(language);
    bench.button("batchNewPlan")->click();
    auto *dialog = bench.find<QDialog>("batchPlanDialog");
    for (const char *name : {"batchRoot", "batchRecipe", "batchProfile", "batchPlanFile"}) {
        const auto *edit = dialog->findChild<QLineEdit *>(name);
        bench.button(qPrintable(QString(name) + "Choose"))->click(); // left without an answer
        QCOMPARE(edit->text(), QString());
        const QString path = bench.path(QString(name) + ".jsonl");
        bench.prompts.setNextFile(path);
        bench.button(qPrintable(QString(name) + "Choose"))->click();
        QCOMPARE(edit->text(), path);
    }
    QVERIFY(bench.button("batchMakePlan")->isEnabled());
    QCOMPARE(test::faultsOnEveryGround(*dialog, bench.language), QString());
    dialog->reject();
    QTRY_VERIFY(!bench.window->findChild<QDialog *>("batchPlanDialog"));
    QVERIFY(!bench.batch->isBusy());
}

void TestBatchWindow::missingProgram_isSaid()
{
    Bench bench;
    addSensors(bench, 1);
    bench.plan();
    bench.batch->setProgram(bench.path("none"));
    bench.button("batchRun")->click();
    QTRY_VERIFY2(bench.outcome().contains("could not be started"), qPrintable(bench.outcome()));
    QVERIFY(!bench.batch->isBusy());
}

void TestBatchWindow::language_changesInPlace()
{
    Bench bench;
    addSensors(bench, 2);
    bench.plan();
    QCOMPARE(bench.button("batchRun")->text(), QString("&Run"));
    const test::InSwedish swedish;
    QTRY_VERIFY(bench.button("batchRun")->text() != "&Run");
    QVERIFY(!bench.batch->windowTitle().isEmpty());
    QCOMPARE(bench.count("missing"), 0);
    QCOMPARE(bench.table()->model()->rowCount(), 2);
}

DYNCAL_TEST(TestBatchWindow)
#include "tst_batch_window.moc"
