// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/measured_data.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/import/import_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "ui/shell/import/import_channel_table.h"
#include "ui/text/level_text.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QtTest>

using namespace dyncal;
using namespace dyncal::test;

namespace {

/// Steps of 3, 1 and 2 (inverted) without any computation.
PipelineOutcome fixedSteps(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId until, const JobControl &control)
{
    PipelineOutcome outcome = noComputation(captures, recipe, cache, until, control);
    auto prepared = std::make_shared<PreparedCaptures>();
    if (const auto applied = applyImportSettings(*captures, recipe.import))
        prepared->set = *applied;
    outcome.results.captures = prepared;
    auto window = std::make_shared<WindowResult>();
    for (const double step : {3.0, 1.0, -2.0}) {
        WindowedResponse response;
        response.shot = std::ssize(window->responses) + 1;
        response.step = step;
        window->responses.push_back(response);
    }
    outcome.results.window = window;
    return outcome;
}

} // namespace

/// Recordings as operators have them: several at once, some of them bad, some with open questions.
class TestCaptureImport : public QObject
{
    Q_OBJECT

private slots:
    void drop_threeGoodFiles_opensThemWithoutAQuestion();
    void drop_goodAndBadFiles_listsTheBadInOnePanel();
    void drop_onlyBadFiles_leavesTheJobAlone();
    void panel_retry_readsWhatWasRepaired();
    void panel_copy_givesIdPathAndSentence();
    void panel_dismissed_goesAway();
    void panel_languageSwitched_keepsItsFiles();
    void add_toAJob_keepsItsShotsAndLevels();
    void noDut_asksAndTakesTheAnswerForAllFiles();
    void noDut_askedInVain_takesTheFilesAsTheyAre();
    void noDut_answeredForOneFile_asksForTheNext();
    void oneFilePerChannel_isAskedForAsOneRecording();
    void tagByStepHeight_writesLevelsThatCanBeChanged();
    void dialog_fromTheCapturesPage_changesTheJobAsOneStep();
    void sampleRate_changedOnThePage_isHeldAgainstTheFile();
    void manyFiles_neverHoldTheWindow();
};

void TestCaptureImport::drop_threeGoodFiles_opensThemWithoutAQuestion()
{
    const ImportBench bench;
    QStringList paths;
    for (const char *name : {"low.csv", "medium.csv", "high.csv"})
        paths << bench.write(name, oneChannel());
    bench.drop(paths);
    QTRY_COMPARE(bench.shots(), std::size_t(3));
    QVERIFY(!bench.dialog());
    QVERIFY(!bench.panelShown());
    QCOMPARE(bench.window->session().state().captures->inputs[1].file, std::string("medium.csv"));
}

void TestCaptureImport::drop_goodAndBadFiles_listsTheBadInOnePanel()
{
    const ImportBench bench;
    const QStringList paths{bench.write("letter.h5", "%PDF-1.7 not a capture"),
        bench.write("good.csv", oneChannel()),
        bench.write("report.csv", QByteArray("PK\3\4\24\0\6\0", 8) + QByteArray(200, '\1')),
        bench.folder.filePath("gone.csv"), bench.write("also_good.csv", oneChannel())};
    bench.drop(paths);
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    QTRY_VERIFY(bench.panelShown());
    QCOMPARE(bench.prompts.shownProblems(), QStringList()); // no box beside the panel
    QVERIFY(!bench.dialog());
    const auto &problems = bench.panel()->problems();
    QCOMPARE(problems.size(), std::size_t(3));
    QCOMPARE(problems[0].error.findingId, std::string("CAP-001"));
    auto *table = bench.find<QTableWidget>("problemTable");
    QCOMPARE(table->rowCount(), 3);
    QCOMPARE(table->item(0, 0)->text(), QString("letter.h5"));
    QVERIFY2(table->item(0, 1)->text().contains("PDF"), qPrintable(table->item(0, 1)->text()));
    QVERIFY(table->item(1, 1)->text().contains("report.csv"));
    QVERIFY(!table->item(1, 1)->text().contains(bench.folder.path())); // the name is enough
    QVERIFY(table->item(2, 1)->text().contains("does not exist"));
    QVERIFY(table->cellWidget(0, 2)); // import settings
    QVERIFY(!table->cellWidget(2, 2)); // there is no file
    QVERIFY(bench.find<QLabel>("problemSummary")->text().startsWith("3 files"));
}

void TestCaptureImport::drop_onlyBadFiles_leavesTheJobAlone()
{
    const ImportBench bench;
    bench.drop({bench.write("good.csv", oneChannel())});
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    bench.settle(); // sealing replaces the captures
    const ProjectState before = bench.window->session().state();
    bench.drop({bench.write("letter.h5", "%PDF-1.7"), bench.write("empty.csv", "")});
    QTRY_VERIFY(bench.panelShown());
    bench.settle();
    QCOMPARE(bench.panel()->problems().size(), std::size_t(2));
    QVERIFY(bench.window->session().state() == before);
    QCOMPARE(bench.window->session().undoStack().count(), 0);
}

void TestCaptureImport::panel_retry_readsWhatWasRepaired()
{
    const ImportBench bench;
    const QString first = bench.write("a.csv", "%PDF-1.7");
    const QString second = bench.write("b.csv", "%PDF-1.7");
    bench.drop({first, second});
    QTRY_COMPARE(bench.panel()->problems().size(), std::size_t(2));
    bench.write("a.csv", oneChannel());
    bench.find<QPushButton>("retryProblems")->click();
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    QTRY_COMPARE(bench.panel()->problems().size(), std::size_t(1));
    QCOMPARE(bench.panel()->problems()[0].path, second.toStdString());
    bench.write("b.csv", oneChannel());
    bench.find<QPushButton>("retryProblems")->click();
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    QTRY_VERIFY(!bench.panelShown());
}

void TestCaptureImport::panel_copy_givesIdPathAndSentence()
{
    const ImportBench bench;
    const QString path = bench.write("letter.h5", "%PDF-1.7");
    bench.drop({path});
    QTRY_VERIFY(bench.panelShown());
    bench.find<QPushButton>("copyProblems")->click();
    const QStringList cells = QGuiApplication::clipboard()->text().split('\t');
    QCOMPARE(cells.size(), 3);
    QCOMPARE(cells[0], QString("CAP-001"));
    QCOMPARE(cells[1], path);
    QVERIFY(cells[2].contains("PDF"));
}

void TestCaptureImport::panel_dismissed_goesAway()
{
    const ImportBench bench;
    bench.drop({bench.write("letter.h5", "%PDF-1.7")});
    QTRY_VERIFY(bench.panelShown());
    bench.find<QPushButton>("dismissProblems")->click();
    QVERIFY(!bench.panelShown());
    QVERIFY(bench.panel()->problems().empty());
}

void TestCaptureImport::panel_languageSwitched_keepsItsFiles()
{
    ImportBench bench;
    bench.drop({bench.write("letter.h5", "%PDF-1.7")});
    QTRY_VERIFY(bench.panelShown());
    bench.language.install("sv");
    QTRY_VERIFY(bench.find<QDockWidget>("problemsDock")->windowTitle()
        != QString("Files that could not be read"));
    QVERIFY(bench.panelShown());
    QCOMPARE(bench.panel()->problems().size(), std::size_t(1));
    bench.language.install("en");
    QCoreApplication::processEvents();
}

void TestCaptureImport::add_toAJob_keepsItsShotsAndLevels()
{
    ImportBench bench;
    bench.drop({bench.write("low.csv", oneChannel())});
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    Recipe recipe = bench.window->session().recipe();
    recipe.import.levels = {"low"};
    recipe.import.unit = "bar";
    bench.window->session().apply(recipe, "levels");
    bench.prompts.setNextFiles({bench.write("a.csv", oneChannel()), bench.write("b.csv", "")});
    bench.window->files().addCaptures();
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    QCOMPARE(bench.import().levels, (std::vector<std::string>{"low", ""})); // one for each shot
    QCOMPARE(bench.import().unit, std::optional<std::string>("bar"));
    QTRY_COMPARE(bench.panel()->problems().size(), std::size_t(1));
    bench.window->session().undoStack().undo();
    QCOMPARE(bench.shots(), std::size_t(1));
    QCOMPARE(bench.import().levels, (std::vector<std::string>{"low"}));
}

void TestCaptureImport::noDut_asksAndTakesTheAnswerForAllFiles()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", tableText({})), bench.write("b.csv", tableText({}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QCOMPARE(bench.shots(), std::size_t(0));
    QVERIFY(!importButton(dialog)->isEnabled());
    QVERIFY2(verdict(dialog).contains("DUT"), qPrintable(verdict(dialog)));
    QVERIFY(importButton(dialog)->text().contains("2 files"));
    auto *channels = dialog->findChild<ImportChannelTable *>("importChannels");
    QCOMPARE(channels->rowCount(), 2); // without the times
    QCOMPARE(channels->item(1, 0)->text(), QString("side"));
    choose(dialog, "importRole1", kDutRole);
    choose(dialog, "importRole2", kDutRole + 1);
    QVERIFY(importButton(dialog)->isEnabled());
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    QCOMPARE(bench.import().channels.at("p"), std::string("dut"));
    QCOMPARE(bench.import().channels.at("side"), std::string("driven_side"));
    QTRY_VERIFY(!bench.dialog());
    QVERIFY(!bench.panelShown());
}

void TestCaptureImport::noDut_askedInVain_takesTheFilesAsTheyAre()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", tableText({})), bench.write("bad.csv", "")});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    dialog->reject();
    QTRY_COMPARE(bench.shots(), std::size_t(1)); // CAP-002 says the rest
    QCOMPARE(bench.panel()->problems().size(), std::size_t(1));
    QVERIFY(bench.import() == ImportSettings{});
}

void TestCaptureImport::noDut_answeredForOneFile_asksForTheNext()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", tableText({})), bench.write("b.csv", tableText({}))});
    for (const int dut : {1, 2}) { // the channels of the two files are the other way round
        const QString title = dut == 1 ? "Import a.csv" : "Import b.csv";
        QTRY_VERIFY(bench.dialog() && bench.dialog()->windowTitle() == title);
        ImportDialog *dialog = bench.waitDialog();
        choose(dialog, QString("importRole%1").arg(dut), kDutRole);
        dialog->findChild<QRadioButton *>("importForFile")->click();
        importButton(dialog)->click();
    }
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    QVERIFY(bench.import().channels.empty());
    QCOMPARE(bench.import().files.at("a.csv").channels.at("p"), std::string("dut"));
    QCOMPARE(bench.import().files.at("b.csv").channels.at("side"), std::string("dut"));
    const auto applied
        = applyImportSettings(*bench.window->session().state().captures, bench.import());
    QVERIFY(applied);
    QCOMPARE(applied->shots[0].channelWithRole(ChannelRole::Dut)->name, std::string("p"));
    QCOMPARE(applied->shots[1].channelWithRole(ChannelRole::Dut)->name, std::string("side"));
}

/// What the dialog looks at is the recording, not the one file that it was opened for.
void TestCaptureImport::oneFilePerChannel_isAskedForAsOneRecording()
{
    QFile file(QString::fromStdString(
        (dyncal::testing::dataFolder() / "rigolwfm/files/trc/lecroy_2.trc").string()));
    if (!file.open(QIODevice::ReadOnly))
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no lecroy_2.trc: 0 files covered");
    const QByteArray first = file.readAll();
    QByteArray second = first;
    const qsizetype source = first.indexOf("WAVEDESC") + 344; // little-endian, channel from 0
    second[source] = static_cast<char>(first[source] + 1);
    const ImportBench bench;
    bench.drop({bench.write("C1shot.trc", first), bench.write("C2shot.trc", second)});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog); // two channels: which is the DUT?
    QCOMPARE(dialog->findChild<ImportChannelTable *>("importChannels")->rowCount(), 2);
    choose(dialog, "importRole2", kDutRole);
    QVERIFY2(importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    QCOMPARE(bench.import().channels.size(), std::size_t(1));
    QCOMPARE(bench.window->session().state().captures->inputs.size(), std::size_t(2));
    ImportSettings apart = bench.import();
    apart.channelFiles = "apart";
    bench.window->files().captures().change(apart, "apart");
    QTRY_COMPARE(bench.shots(), std::size_t(2));
}

/// Scenario S03.
void TestCaptureImport::tagByStepHeight_writesLevelsThatCanBeChanged()
{
    const ImportBench bench(fixedSteps);
    bench.drop({bench.write("a.csv", oneChannel()), bench.write("b.csv", oneChannel()),
        bench.write("c.csv", oneChannel())});
    QTRY_COMPARE(bench.shots(), std::size_t(3));
    bench.settle();
    bench.window->showPage(0);
    auto *tag = bench.find<QPushButton>("tagByStepHeight");
    QTRY_VERIFY(tag->isEnabled());
    tag->click();
    QCOMPARE(bench.import().levels, (std::vector<std::string>{"high", "low", "medium"}));
    bench.settle();
    auto *level = bench.find<QComboBox>("levelOfShot2");
    QCOMPARE(level->currentText(), levelText(ShotLevel::Low));
    level->setCurrentIndex(level->findText(levelText(ShotLevel::Medium)));
    emit level->activated(level->currentIndex());
    QCOMPARE(bench.import().levels, (std::vector<std::string>{"high", "medium", "medium"}));
}

void TestCaptureImport::dialog_fromTheCapturesPage_changesTheJobAsOneStep()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", oneChannel()), bench.write("b.csv", oneChannel())});
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    bench.window->showPage(0);
    bench.find<QPushButton>("importSettings")->click();
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QVERIFY2(verdict(dialog).startsWith("●"), qPrintable(verdict(dialog)));
    choose(dialog, "importPressure1", 1);
    choose(dialog, "importSeparator", kComma);
    QTRY_VERIFY2(
        !dialog->isLooking() && importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    importButton(dialog)->click();
    QTRY_COMPARE(bench.import().channelDetails.size(), std::size_t(1));
    QCOMPARE(bench.import().channelDetails.at("p").reference, std::string("gauge"));
    QCOMPARE(bench.import().separator, std::string(","));
    QCOMPARE(bench.shots(), std::size_t(2));
    QCOMPARE(bench.window->session().undoStack().count(), 1);
    bench.window->session().undoStack().undo();
    QCOMPARE(bench.import().separator, std::string("auto"));
    QVERIFY(bench.import().channelDetails.empty());
}

void TestCaptureImport::sampleRate_changedOnThePage_isHeldAgainstTheFile()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", oneChannel())});
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    ImportSettings next = bench.import();
    next.sampleRate_Hz = 3e6; // the times say 1 MHz
    bench.window->files().captures().change(next, "rate");
    QTRY_VERIFY(bench.panelShown());
    QCOMPARE(bench.panel()->problems()[0].error.findingId, std::string("CAP-003"));
    QVERIFY(!bench.import().sampleRate_Hz); // the job stays as it was
    QCOMPARE(bench.window->session().undoStack().count(), 0);
}

void TestCaptureImport::manyFiles_neverHoldTheWindow()
{
    constexpr qint64 kLongestGap_ms = 300; // aim 100 ms; machines that test do other work as well
    const ImportBench bench;
    QStringList paths;
    for (int i = 0; i < 6; ++i)
        paths << bench.write(QString("shot%1.csv").arg(i),
            tableText({.header = "time [s],p [V]\n", .columns = 1, .rows = 100000}));
    QTest::qWait(200);
    EventLoopWatchdog watchdog;
    bench.drop(paths);
    QTRY_COMPARE_WITH_TIMEOUT(bench.shots(), std::size_t(6), 60000);
    qInfo("longest time without an answer: %lld ms (aim 100 ms)", watchdog.longestGap_ms());
    QVERIFY(watchdog.longestGap_ms() < kLongestGap_ms);
}

DYNCAL_TEST(TestCaptureImport)
#include "tst_capture_import.moc"
