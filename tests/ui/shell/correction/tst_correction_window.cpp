// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// File > Correct a recording, as an operator uses it: the command line's bytes, every refusal as a
// sentence, stopped work, both languages.

#include "tests/support/made_results.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "tests/ui/support/layout_faults.h"
#include "tests/ui/support/quick_pipeline.h"
#include "tests/ui/support/recording_files.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/shell/correction/correction_form.h"
#include "ui/shell/correction/correction_window.h"
#include "ui/shell/preferences/theme_style.h"
#include "ui/stages/frame/value_table.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr int kPatience_ms = 120'000;
constexpr double kRate_Hz = 5e6;
constexpr double kPeak_Pa = 1e5;

/// A pulse as the sensor of MadeResults records it, with the noise of a converter, perhaps beside
/// another channel that recorded half of it.
QByteArray pulseTable(Index count = 6000, bool isBeside = false)
{
    const Eigen::VectorXd record
        = TrueSensor().recordOf(kPeak_Pa * burst(count, kRate_Hz, 700e-6, 20e-6, 0.0), kRate_Hz);
    QByteArray text(isBeside ? "time (s),blast (V),side (V)\n" : "time (s),blast (V)\n");
    for (Index n = 0; n < count; ++n) {
        const double volt = record[n] + 1e-7 * (double((n * 7919) % 13) - 6.0);
        text += QByteArray::number(double(n) / kRate_Hz, 'g', 12) + ','
            + QByteArray::number(volt, 'g', 12)
            + (isBeside ? ',' + QByteArray::number(0.5 * volt, 'g', 12) : QByteArray()) + '\n';
    }
    return text;
}

struct CorrectionBench : test::WindowBench
{
    CorrectionWindow *dialog = nullptr;

    explicit CorrectionBench(
        Session::Pipeline pipeline = [](auto &&...) { return PipelineOutcome(); })
        : WindowBench(std::move(pipeline))
    {
        window->show();
        test::writeFile(path("pulse.csv"), pulseTable());
        test::writeFile(path("results.json"), QByteArray::fromStdString(MadeResults().text()));
    }

    /// What cannot be read once the layout is done, which takes its time on a loaded machine.
    QStringList settledFaults() const
    {
        QStringList faults;
        QElapsedTimer waited;
        waited.start();
        do {
            QTest::qWait(200);
            faults = test::LayoutFaults(*dialog).found();
        } while (!faults.isEmpty() && waited.elapsed() < 5000);
        return faults;
    }

    void open()
    {
        find<QAction>("correctAction")->trigger();
        dialog = find<CorrectionWindow>("correctionWindow");
    }
    QString path(const QString &name) const { return folder.filePath(name); }
    QPushButton *button(const char *name) const { return find<QPushButton>(name); }
    QString verdict() const { return find<QLabel>("correctionVerdict")->text(); }
    const PlotContent &pressure() const
    {
        return find<PlotWidget>("correctionPressurePlot")->content();
    }

    void choose(const char *box, int row) const
    {
        auto *choice = find<QComboBox>(box);
        choice->setCurrentIndex(row);
        emit choice->activated(row);
    }
    void takeResults(const QString &file)
    {
        choose("correctionFrom", 1);
        prompts.setNextFile(file);
        button("correctionChooseResults")->click();
    }
    void takeRecording(const QString &file)
    {
        prompts.setNextFile(file);
        button("correctionChooseRecordings")->click();
        waitDone();
    }
    void type(const QString &name, const QString &text) const
    {
        auto *edit = find<QLineEdit>(name + "Value");
        edit->setFocus();
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Tab);
    }
    void waitDone() const { QTRY_VERIFY_WITH_TIMEOUT(!dialog->isRunning(), kPatience_ms); }
    void correct() const
    {
        button("correctionStart")->click();
        waitDone();
    }
    void save(const QString &target)
    {
        prompts.setNextFile(path(target));
        button("correctionSave")->click();
        waitDone();
    }
    /// With the files of the bench and a band of 150 kHz.
    void correctPulse()
    {
        open();
        takeResults(path("results.json"));
        takeRecording(path("pulse.csv"));
        type("correctionBand", "150");
        correct();
    }
};

int commandLine(const QStringList &arguments)
{
    QProcess process;
    process.start(qEnvironmentVariable("DYNCAL_BINARY"), arguments);
    return process.waitForFinished(kPatience_ms) ? process.exitCode() : -1;
}

void compareFolders(const QString &one, const QString &other)
{
    const QStringList files = QDir(one).entryList(QDir::Files | QDir::Hidden);
    QVERIFY(files.size() >= 9);
    QCOMPARE(QDir(other).entryList(QDir::Files | QDir::Hidden), files);
    for (const QString &file : files)
        QVERIFY2(bytesOf(one + '/' + file) == bytesOf(other + '/' + file), qPrintable(file));
}

} // namespace

class TestCorrectionWindow : public QObject
{
    Q_OBJECT

private slots:
    void opened_saysWhatToDo_andIsNotModal();
    void pulse_isShownWithItsBand();
    void savedFiles_areThoseOfTheCommandLine();
    void options_areThoseOfTheCommandLine();
    void runOfTheProject_savesTheFilesOfTheCommandLine();
    void refusals_areSentencesInTheWindow_data();
    void refusals_areSentencesInTheWindow();
    void withoutAProject_itSaysWhy();
    void saturatedRecording_isRefusedWithItsFinding();
    void cautionsOfTheCalibration_areShown();
    void otherChannel_canBeChosen();
    void changedField_makesTheResultOld();
    void foreignFile_isNotReplaced();
    void stopped_keepsNothing();
    void closedWhileItRuns_endsSoon();
    void work_doesNotHoldTheWindow();
    void secondCall_bringsTheSameWindow();
    void language_changesEverything();
    void everyLook_canBeRead();
};

void TestCorrectionWindow::opened_saysWhatToDo_andIsNotModal()
{
    CorrectionBench bench;
    bench.open();
    QVERIFY(bench.dialog->isVisible() && !bench.dialog->isModal());
    QVERIFY(bench.verdict().startsWith("Choose the calibration"));
    QVERIFY(!bench.button("correctionSave")->isEnabled());
    QVERIFY(!bench.find<QProgressBar>("correctionProgress")->isVisible());
    bench.button("correctionClose")->click();
    QVERIFY(!bench.dialog->isVisible());
}

void TestCorrectionWindow::pulse_isShownWithItsBand()
{
    CorrectionBench bench;
    bench.correctPulse();
    QVERIFY2(bench.verdict().startsWith("Corrected"), qPrintable(bench.verdict()));
    QCOMPARE(bench.pressure().curves.size(), std::size_t(3));
    const std::vector<double> &p = bench.pressure().curves[2].y;
    QVERIFY(std::abs(*std::ranges::max_element(p) / kPeak_Pa - 1.0) < 1e-2);
    QCOMPARE(bench.find<PlotWidget>("correctionRecordedPlot")->content().yAxis.unit, QString("V"));
    const auto *table = bench.find<ValueTable>("correctionShots");
    QCOMPARE(table->rowCount(), 1);
    QVERIFY2(table->item(0, 2)->text().endsWith("kPa"), qPrintable(table->item(0, 2)->text()));
    const QString filter = bench.find<QLabel>("correctionFilter")->text();
    for (const char *words : {"150 kHz", "225 kHz", "delay", "Pa/V", "amplified up to 1 times"})
        QVERIFY2(filter.contains(words), qPrintable(filter));
    QVERIFY(bench.button("correctionSave")->isEnabled());
}

void TestCorrectionWindow::savedFiles_areThoseOfTheCommandLine()
{
    CorrectionBench bench;
    bench.correctPulse();
    bench.save("window");
    QVERIFY2(bench.verdict().startsWith("Written: "), qPrintable(bench.verdict()));
    QCOMPARE(commandLine({"correct", bench.path("pulse.csv"), "--with", bench.path("results.json"),
                 "--band", "150000", "-o", bench.path("cli")}),
        0);
    compareFolders(bench.path("cli"), bench.path("window"));
}

/// Every field once.
void TestCorrectionWindow::options_areThoseOfTheCommandLine()
{
    CorrectionBench bench;
    bench.open();
    bench.takeResults(bench.path("results.json"));
    bench.takeRecording(bench.path("pulse.csv"));
    for (const auto &[field, text] :
        {std::pair("correctionBand", "120"), std::pair("correctionEdge", "200"),
            std::pair("correctionDelay", "60"), std::pair("correctionWindowBegin", "0.5"),
            std::pair("correctionWindowEnd", "0.9"), std::pair("correctionQuietBegin", "0"),
            std::pair("correctionQuietEnd", "0.4"), std::pair("correctionBeyond", "0.07")})
        bench.type(field, text);
    bench.correct();
    QVERIFY2(bench.verdict().startsWith("Corrected"), qPrintable(bench.verdict()));
    bench.save("window");
    QCOMPARE(
        commandLine({"correct", bench.path("pulse.csv"), "--with", bench.path("results.json"),
            "--band", "120e3", "--edge", "200e3", "--delay", "60e-6", "--window", "0.5e-3,0.9e-3",
            "--quiet", "0,0.4e-3", "--beyond", "70", "-o", bench.path("cli")}),
        0);
    compareFolders(bench.path("cli"), bench.path("window"));
    bench.type("correctionEdge", "");
    bench.type("correctionDelay", "");
    bench.choose("correctionLowPass", 1);
    bench.correct();
    QVERIFY2(bench.verdict().startsWith("Corrected"), qPrintable(bench.verdict()));
    bench.save("window");
    QCOMPARE(commandLine({"correct", bench.path("pulse.csv"), "--with", bench.path("results.json"),
                 "--band", "120e3", "--low-pass", "two-pole", "--window", "0.5e-3,0.9e-3",
                 "--quiet", "0,0.4e-3", "--beyond", "70", "-o", bench.path("cli")}),
        0);
    compareFolders(bench.path("cli"), bench.path("window"));
}

/// Its results as they would be exported are the calibration.
void TestCorrectionWindow::runOfTheProject_savesTheFilesOfTheCommandLine()
{
    CorrectionBench bench(test::quickPipeline());
    const QString calibration = bench.path("calibration.h5");
    QCOMPARE(commandLine({"simulate", "-o", calibration, "--duration-s", "0.004"}), 0);
    bench.window->files().openPaths({calibration});
    Session &session = bench.window->session();
    QTRY_VERIFY_WITH_TIMEOUT(session.state().hasShots(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!session.isComputing(), kPatience_ms);
    QVERIFY(session.isUpToDate());
    bench.open();
    bench.takeRecording(calibration); // its own shots: the step is what was computed
    bench.type("correctionBand", "1000");
    bench.correct();
    QVERIFY2(bench.verdict().startsWith("Corrected"), qPrintable(bench.verdict()));
    bench.save("window");
    bench.prompts.setNextFile(bench.path("run"));
    bench.window->files().exportResults();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window->files().isBusy(), kPatience_ms);
    const int code = commandLine({"correct", calibration, "--with", bench.path("run"), "--band",
        "1e6", "-o", bench.path("cli")});
    QVERIFY(code == 0 || code == 1);
    compareFolders(bench.path("cli"), bench.path("window"));
    Recipe recipe = session.recipe();
    recipe.window.end_s = 1e-3;
    session.apply(recipe, "window"); // now it is of an earlier run
    QVERIFY(!bench.button("correctionSave")->isEnabled());
    QVERIFY(bench.verdict().contains("earlier settings"));
}

void TestCorrectionWindow::refusals_areSentencesInTheWindow_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("band") << "correctionBand"
                          << "9000"
                          << "\"Band up to\"";
    QTest::newRow("edge") << "correctionEdge"
                          << "1"
                          << "\"Nothing beyond\"";
    QTest::newRow("delay") << "correctionDelay"
                           << "0.001"
                           << "\"Delay\"";
    QTest::newRow("one end") << "correctionWindowBegin"
                             << "0.1"
                             << "both or neither";
    QTest::newRow("one end of quiet") << "correctionQuietEnd"
                                      << "0.1"
                                      << "both or neither";
    QTest::newRow("no results") << "results"
                                << "none.json"
                                << "cannot be read";
    QTest::newRow("odd results") << "results"
                                 << "pulse.csv"
                                 << "is not valid JSON";
    QTest::newRow("no recording") << "recording"
                                  << "none.csv"
                                  << "none.csv";
    QTest::newRow("odd recording") << "recording"
                                   << "results.json"
                                   << "results.json";
}

void TestCorrectionWindow::refusals_areSentencesInTheWindow()
{
    QFETCH(QString, field);
    QFETCH(QString, text);
    QFETCH(QString, says);
    CorrectionBench bench;
    bench.correctPulse();
    if (field == "results")
        bench.takeResults(bench.path(text));
    else if (field == "recording")
        bench.takeRecording(bench.path(text));
    else
        bench.type(field, text);
    bench.correct();
    QVERIFY2(bench.verdict().contains(says), qPrintable(bench.verdict()));
    QVERIFY(!bench.verdict().contains("--"));
    QVERIFY(!bench.button("correctionSave")->isEnabled());
    QVERIFY(bench.find<PlotWidget>("correctionPressurePlot")->isDimmed()); // what was, pale
    QVERIFY(bench.prompts.shownProblems().isEmpty());
}

void TestCorrectionWindow::withoutAProject_itSaysWhy()
{
    CorrectionBench bench;
    bench.open();
    bench.correct();
    QVERIFY2(bench.verdict().startsWith("No recording is chosen"), qPrintable(bench.verdict()));
    bench.takeRecording(bench.path("pulse.csv"));
    bench.correct();
    QVERIFY2(bench.verdict().contains("There is no model yet")
            || bench.verdict().contains("out of date"),
        qPrintable(bench.verdict()));
    bench.choose("correctionFrom", 1);
    bench.correct();
    QVERIFY(bench.verdict().startsWith("No calibration is chosen"));
}

void TestCorrectionWindow::saturatedRecording_isRefusedWithItsFinding()
{
    CorrectionBench bench;
    const QString clipped = bench.path("clipped.h5");
    QCOMPARE(commandLine({"simulate", "-o", clipped, "--preset", "piezo", "--duration-s", "0.003",
                 "--sample-rate-hz", "5e6", "--shots", "low", "--defect", "clip"}),
        0);
    bench.open();
    bench.takeResults(bench.path("results.json"));
    bench.takeRecording(clipped);
    bench.correct();
    QVERIFY2(bench.verdict().startsWith("Nothing was corrected"), qPrintable(bench.verdict()));
    const auto *findings = bench.find<QListWidget>("correctionFindings");
    QVERIFY(findings->isVisible());
    bool isNamed = false;
    for (int i = 0; i < findings->count(); ++i)
        isNamed = isNamed || findings->item(i)->text().contains("CAP-007");
    QVERIFY(isNamed);
    QVERIFY(!bench.button("correctionSave")->isEnabled());
}

void TestCorrectionWindow::cautionsOfTheCalibration_areShown()
{
    CorrectionBench bench;
    MadeJson root = MadeResults().json();
    root["findings"].push_back({{"id", "UNC-001"}, {"severity", "caution"}});
    test::writeFile(bench.path("results.json"), QByteArray::fromStdString(jsonText(root)));
    bench.correctPulse();
    const auto *findings = bench.find<QListWidget>("correctionFindings");
    QVERIFY(findings->isVisible());
    QVERIFY(findings->item(0)->text().contains("UNC-001"));
}

void TestCorrectionWindow::otherChannel_canBeChosen()
{
    CorrectionBench bench;
    test::writeFile(bench.path("pulse.csv"), pulseTable(6000, true));
    bench.correctPulse();
    const auto *box = bench.find<QComboBox>("correctionChannel");
    QCOMPARE(box->count(), 3);
    QCOMPARE(box->itemText(2), QString("side"));
    QVERIFY(bench.verdict().startsWith("Nothing was corrected")); // which of them is the sensor?
    bench.choose("correctionChannel", 2);
    QVERIFY(!bench.button("correctionSave")->isEnabled());
    bench.correct();
    const std::vector<double> &p = bench.pressure().curves[2].y;
    QVERIFY(std::abs(*std::ranges::max_element(p) / kPeak_Pa - 0.5) < 1e-2);
    bench.save("window");
    test::writeFile(bench.path("recipe.json"), R"({"import": {"channels": {"side": "dut"}}})");
    QCOMPARE(
        commandLine({"correct", bench.path("pulse.csv"), "--with", bench.path("results.json"),
            "--recipe", bench.path("recipe.json"), "--band", "150000", "-o", bench.path("cli")}),
        0);
    compareFolders(bench.path("cli"), bench.path("window"));
}

void TestCorrectionWindow::changedField_makesTheResultOld()
{
    CorrectionBench bench;
    bench.correctPulse();
    const auto *plot = bench.find<PlotWidget>("correctionPressurePlot");
    QVERIFY(!plot->isDimmed());
    bench.type("correctionBand", "100");
    QVERIFY(plot->isDimmed());
    QVERIFY(bench.verdict().contains("earlier settings"));
    QVERIFY(!bench.button("correctionSave")->isEnabled());
    bench.correct();
    QVERIFY(!plot->isDimmed() && bench.button("correctionSave")->isEnabled());
}

void TestCorrectionWindow::foreignFile_isNotReplaced()
{
    CorrectionBench bench;
    bench.correctPulse();
    QVERIFY(QDir().mkpath(bench.path("taken")));
    test::writeFile(bench.path("taken/filter.json"), "somebody's");
    bench.save("taken");
    QVERIFY2(bench.verdict().contains("filter.json"), qPrintable(bench.verdict()));
    QCOMPARE(bytesOf(bench.path("taken/filter.json")), QByteArray("somebody's"));
    bench.button("correctionSave")->click(); // and no folder chosen
    QVERIFY(bench.button("correctionSave")->isEnabled());
    bench.save("free");
    QVERIFY(bench.verdict().startsWith("Written: "));
    test::writeFile(bench.path("pulse.csv"), "time (s),blast (V)\n0,1\n");
    bench.save("later"); // the recording is no longer what was corrected
    QVERIFY2(!bench.verdict().startsWith("Written"), qPrintable(bench.verdict()));
    QVERIFY(!QFile::exists(bench.path("later/filter.json")));
}

/// The first press stops, the second closes.
void TestCorrectionWindow::stopped_keepsNothing()
{
    CorrectionBench bench;
    bench.open();
    bench.takeResults(bench.path("results.json"));
    bench.takeRecording(bench.path("pulse.csv"));
    bench.button("correctionStart")->click();
    QVERIFY(bench.dialog->isRunning());
    QVERIFY(bench.find<QProgressBar>("correctionProgress")->isVisible());
    QCOMPARE(bench.button("correctionClose")->text(), QString("&Cancel"));
    QVERIFY(!bench.find<CorrectionForm>("correctionForm")->isEnabled());
    bench.button("correctionClose")->click();
    QVERIFY(!bench.dialog->isRunning() && bench.dialog->isVisible());
    QVERIFY(bench.verdict().startsWith("Stopped"));
    QTest::qWait(200); // nothing arrives afterwards
    QVERIFY(bench.pressure().curves.empty());
    QVERIFY(!bench.button("correctionSave")->isEnabled());
    bench.correct();
    QVERIFY(bench.verdict().startsWith("Corrected"));
    bench.button("correctionClose")->click();
    QVERIFY(!bench.dialog->isVisible());
}

void TestCorrectionWindow::closedWhileItRuns_endsSoon()
{
    QElapsedTimer taken;
    {
        CorrectionBench bench;
        bench.open();
        bench.takeResults(bench.path("results.json"));
        bench.takeRecording(bench.path("pulse.csv"));
        bench.button("correctionStart")->click();
        taken.start();
    }
    QVERIFY(taken.elapsed() < 20'000);
}

void TestCorrectionWindow::work_doesNotHoldTheWindow()
{
    CorrectionBench bench;
    test::writeFile(bench.path("pulse.csv"), pulseTable(100'000));
    bench.open();
    bench.takeResults(bench.path("results.json"));
    test::EventLoopWatchdog watchdog;
    bench.takeRecording(bench.path("pulse.csv"));
    bench.correct();
    QVERIFY(bench.verdict().startsWith("Corrected"));
    qInfo("longest time without an answer: %lld ms", watchdog.longestGap_ms());
}

void TestCorrectionWindow::secondCall_bringsTheSameWindow()
{
    CorrectionBench bench;
    bench.correctPulse();
    bench.dialog->close();
    bench.find<QAction>("correctAction")->trigger();
    QCOMPARE(bench.window->findChildren<CorrectionWindow *>().size(), 1);
    QVERIFY(bench.dialog->isVisible());
    QCOMPARE(bench.pressure().curves.size(), std::size_t(3)); // what was there still is
}

void TestCorrectionWindow::language_changesEverything()
{
    CorrectionBench bench;
    bench.correctPulse();
    QStringList english;
    const auto words = [&] {
        QStringList all{bench.dialog->windowTitle(), bench.pressure().title};
        for (const QLabel *label : bench.dialog->findChildren<QLabel *>())
            all << label->text();
        for (const QAbstractButton *button : bench.dialog->findChildren<QAbstractButton *>())
            all << button->text();
        for (const QLineEdit *edit : bench.dialog->findChildren<QLineEdit *>())
            all << edit->placeholderText();
        for (const QComboBox *box : bench.dialog->findChildren<QComboBox *>())
            for (int i = 0; i < box->count(); ++i)
                all << box->itemText(i);
        const auto *table = bench.find<ValueTable>("correctionShots");
        for (int i = 0; i < table->columnCount(); ++i)
            all << table->horizontalHeaderItem(i)->text();
        return all;
    };
    english = words();
    // A button has the keyboard while all is built anew.
    bench.dialog->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(bench.dialog));
    bench.button("correctionClose")->setFocus();
    QVERIFY(bench.button("correctionClose")->hasFocus());
    bench.language.install("sv");
    QTRY_VERIFY(bench.dialog->windowTitle() != "Correct a recording");
    const QStringList swedish = words();
    QCOMPARE(swedish.size(), english.size());
    const QRegularExpression letters("[a-z]{4,}");
    for (qsizetype i = 0; i < english.size(); ++i)
        if (english[i].contains(letters) && !english[i].endsWith(".csv")
            && !english[i].endsWith(".json") && english[i] != "blast" && english[i] != "side")
            QVERIFY2(swedish[i] != english[i], qPrintable(english[i]));
    QCOMPARE(bench.find<QLineEdit>("correctionBandValue")->text(), QString("150"));
    QVERIFY(bench.button("correctionSave")->isEnabled());
    bench.save("swedish");
    bench.language.install("en");
    QTRY_COMPARE(bench.dialog->windowTitle(), QString("Correct a recording"));
    bench.save("english");
    compareFolders(bench.path("swedish"), bench.path("english"));
}

/// Both languages, light and dark, small and large; the pictures go where $DYNCAL_SHOTS says.
void TestCorrectionWindow::everyLook_canBeRead()
{
    CorrectionBench bench;
    MadeJson root = MadeResults().json();
    root["findings"].push_back({{"id", "UNC-001"}, {"severity", "caution"}});
    test::writeFile(bench.path("results.json"), QByteArray::fromStdString(jsonText(root)));
    bench.correctPulse();
    const QString shots = qEnvironmentVariable("DYNCAL_SHOTS");
    QStringList faults;
    for (const QString &language : {QString("sv"), QString("en")}) {
        bench.language.install(language);
        for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark}) {
            useTheme(theme);
            for (const QSize &size : {QSize(1000, 640), QSize(1200, 800)}) {
                bench.dialog->resize(size);
                const QString look
                    = QString("%1-%2-%3").arg(language, themeName(theme)).arg(size.width());
                for (const QString &fault : bench.settledFaults())
                    faults << look + ": " + fault;
                if (!shots.isEmpty())
                    QVERIFY(bench.dialog->grab().save(QDir(shots).filePath(look + ".png")));
            }
        }
    }
    useTheme(ThemeKind::Light);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
}

DYNCAL_TEST(TestCorrectionWindow)
#include "tst_correction_window.moc"
