// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/format_registry.h"
#include "core/capture/import_rules.h"
#include "tests/core/capture/hdf5_test_file.h"
#include "tests/support/measured_data.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "tests/ui/support/recording_files.h"
#include "tests/ui/support/sample_results.h"
#include "ui/session/import_profiles.h"
#include "ui/shell/import_channel_table.h"
#include "ui/shell/import_dialog.h"
#include "ui/shell/import_preview_table.h"
#include "ui/shell/main_window.h"
#include "ui/shell/problem_panel.h"
#include "ui/text/level_text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

using namespace dyncal;
using namespace dyncal::test;

namespace {

/// Answers at once: what is tested is how recordings come in.
PipelineOutcome noComputation(const std::shared_ptr<const CaptureSet> &captures, const Recipe &,
    ResultCache &, StageId, const JobControl &)
{
    PipelineOutcome outcome;
    auto prepared = std::make_shared<PreparedCaptures>();
    prepared->set = *captures;
    outcome.results.captures = prepared;
    return outcome;
}

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

struct Bench : test::WindowBench
{
    explicit Bench(const Session::Pipeline &pipeline = noComputation)
        : WindowBench(pipeline)
    {
        window->show();
    }

    QString write(const QString &name, const QByteArray &bytes) const
    {
        writeFile(folder.filePath(name), bytes);
        return folder.filePath(name);
    }
    void drop(const QStringList &paths) const
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString &path : paths)
            urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &enter);
        QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &event);
    }
    ImportDialog *dialog() const { return window->findChild<ImportDialog *>("importDialog"); }
    /// Waits for the dialog to open and to have read the file.
    ImportDialog *waitDialog() const
    {
        for (int i = 0; i < 500 && (!dialog() || dialog()->isLooking()); ++i)
            QTest::qWait(10);
        return dialog();
    }
    void settle() const
    {
        for (int i = 0; i < 500; ++i) {
            QTest::qWait(10);
            if (!window->files().isBusy() && !window->session().isComputing())
                return;
        }
    }
    ProblemPanel *panel() const { return find<ProblemPanel>("problemPanel"); }
    bool panelShown() const { return find<QDockWidget>("problemsDock")->isVisible(); }
    std::size_t shots() const { return window->session().state().captures->shots.size(); }
    const ImportSettings &import() const { return window->session().recipe().import; }
};

/// Clicks a choice of a combo box as an operator does.
void choose(const QDialog *dialog, const QString &name, int choice)
{
    auto *box = dialog->findChild<QComboBox *>(name);
    QVERIFY(box);
    box->setCurrentIndex(choice);
    emit box->activated(choice);
}

QString verdict(const ImportDialog *dialog)
{
    return dialog->findChild<QLabel *>("importVerdict")->text();
}

QPushButton *importButton(const ImportDialog *dialog)
{
    return dialog->findChild<QPushButton *>("importButton");
}

QByteArray oneChannel()
{
    return tableText({.header = "time [s],p [V]\n", .columns = 1});
}

constexpr int kComma = 1;
constexpr int kSemicolon = 2;
constexpr int kCommaDecimal = 2;
constexpr int kDutRole = 0;
constexpr int kNotRead = 0;
constexpr int kReadAsDut = 1;
constexpr int kReadAsDrivenSide = 2;
constexpr int kReadAsOther = 5;

std::vector<double> ramp(int count)
{
    std::vector<double> values;
    for (int k = 0; k < count; ++k)
        values.push_back(0.5 * k);
    return values;
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
    void channelDetails_typed_areInTheSettings();
    void hdf5_datasets_arePickedFromTheTree();
    void oneFilePerChannel_isAskedForAsOneRecording();
    void tagByStepHeight_writesLevelsThatCanBeChanged();
    void rateAgainstTheFile_needsAReason();
    void noRate_asks();
    void germanTable_readsWithoutAQuestion();
    void ambiguousDecimal_asksAndShowsTheEffect();
    void headerAgainstTimes_offersBoth_data();
    void headerAgainstTimes_offersBoth();
    void unreadableCells_areMarkedAndBlock();
    void timeColumn_chosen_isInTheSettings();
    void profile_kept_isOfferedForTheNextFile();
    void profile_badName_isRefused();
    void dialog_fromTheCapturesPage_changesTheJobAsOneStep();
    void dialog_ofTheExample_listsItsChannels();
    void sampleRate_changedOnThePage_isHeldAgainstTheFile();
    void manyFiles_neverHoldTheWindow();
};

void TestCaptureImport::drop_threeGoodFiles_opensThemWithoutAQuestion()
{
    const Bench bench;
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
    const Bench bench;
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
    const Bench bench;
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
    const Bench bench;
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
    const Bench bench;
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
    const Bench bench;
    bench.drop({bench.write("letter.h5", "%PDF-1.7")});
    QTRY_VERIFY(bench.panelShown());
    bench.find<QPushButton>("dismissProblems")->click();
    QVERIFY(!bench.panelShown());
    QVERIFY(bench.panel()->problems().empty());
}

void TestCaptureImport::panel_languageSwitched_keepsItsFiles()
{
    Bench bench;
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
    Bench bench;
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
    const Bench bench;
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
    const Bench bench;
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
    const Bench bench;
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

void TestCaptureImport::channelDetails_typed_areInTheSettings()
{
    const Bench bench;
    const QString path = bench.write("a.csv", tableText({}));
    ImportDialog dialog(path, {}, 1, bench.preferences.profileFolder(), nullptr);
    QTRY_VERIFY(!dialog.isLooking());
    const auto type = [&](const char *name, const char *text) {
        auto *edit = dialog.findChild<QLineEdit *>(name);
        QVERIFY(edit);
        edit->selectAll();
        QTest::keyClicks(edit, text);
        emit edit->editingFinished();
    };
    type("importSensitivity1Value", "12,5");
    type("importGain1Value", "10");
    type("importFactor2Value", "0.5");
    type("importUnit2", "bar");
    choose(&dialog, "importPressure2", 2);
    dialog.findChild<QCheckBox *>("importInverted1")->click();
    const auto details = dialog.settings().channelDetails;
    QCOMPARE(details.size(), std::size_t(2));
    QVERIFY(std::abs(*details.at("p").sensitivity / 12.5e-6 - 1.0) < 1e-12); // V/Pa
    QCOMPARE(details.at("p").gain, std::optional<double>(10.0));
    QCOMPARE(details.at("p").polarity, std::optional<int>(-1));
    QCOMPARE(details.at("side").scale, std::optional<double>(0.5));
    QCOMPARE(details.at("side").unit, std::optional<std::string>("bar"));
    QCOMPARE(details.at("side").reference, std::string("absolute"));
    type("importGain1Value", "-3"); // no gain: the last good one stays
    QCOMPARE(dialog.settings().channelDetails.at("p").gain, std::optional<double>(10.0));
}

/// Scenario S05: two long datasets, one of three values, no rate.
void TestCaptureImport::hdf5_datasets_arePickedFromTheTree()
{
    const Bench bench;
    const QString path = bench.folder.filePath("foreign.h5");
    {
        const dyncal::testing::Hdf5TestFile file(path.toStdString());
        file.doubles("/a", ramp(1000));
        file.doubles("/b", ramp(1000));
        file.doubles("/c", ramp(3));
        file.group("/raw");
        file.doubles("/raw/short", ramp(500));
        file.text("/a", "units", "V");
    }
    bench.drop({path});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    auto *tree = dialog->findChild<QTreeWidget *>("importDatasets");
    QVERIFY(tree && tree->isVisible());
    const auto rowOf = [&](const char *name) {
        const auto found = tree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.size() == 1 ? found.front() : nullptr;
    };
    QVERIFY(rowOf("a") && rowOf("b") && rowOf("c") && rowOf("short"));
    QCOMPARE(rowOf("short")->parent(), rowOf("raw"));
    QCOMPARE(rowOf("a")->text(2), QString("1000"));
    QCOMPARE(rowOf("a")->text(3), QString("float64"));
    QCOMPARE(rowOf("a")->text(4), QString("units = V"));
    QCOMPARE(rowOf("c")->text(4), QString("Dataset /c has 3 values - not a waveform."));
    QVERIFY(!dialog->findChild<QComboBox *>("readAs:/c"));
    QCOMPARE(dialog->findChild<QComboBox *>("readAs:/a")->currentIndex(), kReadAsOther);
    QCOMPARE(dialog->findChild<QComboBox *>("readAs:/raw/short")->currentIndex(), kNotRead);

    const auto pick = [&](const char *dataset, int choice) {
        choose(dialog, QString("readAs:") + dataset, choice);
        QTRY_VERIFY(!dialog->isLooking());
    };
    pick("/a", kReadAsDut);
    pick("/b", kReadAsDrivenSide);
    auto *rate = dialog->findChild<QLineEdit *>("importRateValue");
    QTest::keyClicks(rate, "100");
    emit rate->editingFinished();
    QTRY_VERIFY2(
        !dialog->isLooking() && importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    const auto roles = dialog->settings().channels;
    QCOMPARE(roles, (std::map<std::string, std::string>{{"/a", "dut"}, {"/b", "driven_side"}}));

    pick("/b", kNotRead); // and something shorter in its place
    pick("/raw/short", kReadAsDrivenSide);
    QCOMPARE(dialog->findChild<QComboBox *>("readAs:/b")->currentIndex(), kNotRead);
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    const auto &channels = bench.window->session().state().captures->shots[0].channels;
    QCOMPARE(channels.size(), std::size_t(2));
    QCOMPARE(channels[0].name, std::string("/a"));
    QCOMPARE(channels[1].name, std::string("/raw/short"));
    QCOMPARE(channels[1].samples.size(), Index(500));
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
    const Bench bench;
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
    const Bench bench(fixedSteps);
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

void TestCaptureImport::rateAgainstTheFile_needsAReason()
{
    const Bench bench;
    // A file that states its rate without a column of times: header only.
    const QString csv = bench.write("a.csv",
        tableText({.header = "Sample rate: 1 MHz\np [V]\n", .times = false, .columns = 1}));
    ImportDialog dialog(csv, {}, 1, bench.preferences.profileFolder(), nullptr);
    QTRY_VERIFY(!dialog.isLooking());
    QVERIFY2(importButton(&dialog)->isEnabled(), qPrintable(verdict(&dialog)));
    auto *rate = dialog.findChild<QLineEdit *>("importRateValue");
    QTest::keyClicks(rate, "2");
    emit rate->editingFinished();
    QTRY_VERIFY(!dialog.isLooking());
    QVERIFY2(!importButton(&dialog)->isEnabled(), qPrintable(verdict(&dialog)));
    auto *reason = dialog.findChild<QLineEdit *>("importRateReason");
    QVERIFY(!reason->isHidden());
    QTest::keyClicks(reason, "clock doubled");
    QVERIFY2(importButton(&dialog)->isEnabled(), qPrintable(verdict(&dialog)));
    QCOMPARE(dialog.settings().sampleRate_Hz, std::optional<double>(2e6));
    QCOMPARE(dialog.settings().sampleRateReason, std::string("clock doubled"));
}

void TestCaptureImport::noRate_asks()
{
    const Bench bench;
    bench.drop(
        {bench.write("a.csv", tableText({.header = "p [V]\n", .times = false, .columns = 1}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QVERIFY2(verdict(dialog).contains("sample rate"), qPrintable(verdict(dialog)));
    QVERIFY(!importButton(dialog)->isEnabled());
    auto *rate = dialog->findChild<QLineEdit *>("importRateValue");
    QVERIFY(rate);
    rate->setFocus();
    rate->selectAll();
    QTest::keyClicks(rate, "12,5");
    QTest::keyClick(rate, Qt::Key_Tab);
    QTRY_VERIFY(importButton(dialog)->isEnabled());
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    QCOMPARE(bench.import().sampleRate_Hz, std::optional<double>(12.5e6));
}

void TestCaptureImport::germanTable_readsWithoutAQuestion()
{
    const Bench bench;
    bench.drop({bench.write("shot.csv",
        tableText({.header = "Zeit [s];Kanal 1 [V]\n",
            .separator = ";",
            .decimal = ',',
            .columns = 1}))});
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    QVERIFY(!bench.dialog());
    const Channel &channel = bench.window->session().state().captures->shots[0].channels[0];
    QVERIFY(std::abs(channel.sampleRate_Hz - 1e6) < 1e-3);
    QCOMPARE(QString::fromStdString(channel.name), QString("Kanal 1"));
}

void TestCaptureImport::ambiguousDecimal_asksAndShowsTheEffect()
{
    const Bench bench;
    // Two columns with decimal point or one with decimal comma: "1,234".
    QByteArray text("rate 1 MHz\n");
    for (int i = 0; i < 200; ++i)
        text += QByteArray::number(i < 60 ? 1 : 2) + ',' + QByteArray::number(100 + (37 * i) % 800)
            + '\n';
    const QString path = bench.write("a.csv", text);
    const Result<TextPreview> preview = previewText(path.toStdString(), {});
    QVERIFY(preview);
    QVERIFY(preview->decimalAmbiguous);
    bench.drop({path});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QVERIFY(!importButton(dialog)->isEnabled());
    choose(dialog, "importDecimal", kCommaDecimal);
    choose(dialog, "importSeparator", kSemicolon);
    QTRY_VERIFY(!dialog->isLooking());
    QCOMPARE(dialog->findChild<ImportPreviewTable *>("importPreview")->columnCount(), 1);
    QCOMPARE(dialog->settings().decimal, std::string(","));
}

void TestCaptureImport::headerAgainstTimes_offersBoth_data()
{
    QTest::addColumn<QString>("button");
    QTest::addColumn<double>("rate_Hz");
    QTest::newRow("times") << "useTimes" << 1e6;
    QTest::newRow("header") << "useHeader" << 10e6;
}

void TestCaptureImport::headerAgainstTimes_offersBoth()
{
    QFETCH(QString, button);
    QFETCH(double, rate_Hz);
    const Bench bench;
    bench.drop({bench.write(
        "a.csv", tableText({.header = "Sample rate: 10 MHz\ntime [s],p [V]\n", .columns = 1}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QVERIFY(!importButton(dialog)->isEnabled());
    QVERIFY2(verdict(dialog).contains("10 MHz") && verdict(dialog).contains("1 MHz"),
        qPrintable(verdict(dialog)));
    auto *use = dialog->findChild<QPushButton *>(button);
    QVERIFY(use->isVisible());
    use->click();
    QTRY_VERIFY(!dialog->isLooking());
    QVERIFY2(!dialog->view().problem, qPrintable(verdict(dialog)));
    if (!importButton(dialog)->isEnabled()) // two columns of samples: which is the DUT?
        choose(dialog, "importRole2", kDutRole);
    QTRY_VERIFY2(importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    QCOMPARE(bench.import().sampleRate_Hz, std::optional<double>(rate_Hz));
    const CaptureSet &set = *bench.window->session().state().captures;
    QCOMPARE(set.shots[0].channels.size(), std::size_t(1)); // the times are no channel
    QCOMPARE(set.shots[0].channels[0].name, std::string("p"));
    // The same recipe reads the same in the command line's way.
    const auto again = readCaptures({set.inputs[0].path}, bench.import());
    QVERIFY(again.has_value());
    QVERIFY(std::ranges::any_of(set.findings, // recorded that the two disagreed
        [](const Finding &finding) { return finding.id == "CAP-003"; }));
}

void TestCaptureImport::unreadableCells_areMarkedAndBlock()
{
    const Bench bench;
    QByteArray text = oneChannel();
    text.replace("0.000010000,", "0.000010000,x");
    const QString path = bench.write("a.csv", text);
    bench.drop({path});
    QTRY_VERIFY(bench.panelShown());
    auto *table = bench.find<QTableWidget>("problemTable");
    static_cast<QPushButton *>(table->cellWidget(0, 2))->click();
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    auto *preview = dialog->findChild<ImportPreviewTable *>("importPreview");
    QCOMPARE(preview->markedCells(), 1);
    QVERIFY(preview->item(10, 1)->text().startsWith("✗"));
    QVERIFY(!importButton(dialog)->isEnabled());
    QVERIFY(dialog->findChild<QLabel *>("importCounts")->text().contains("unreadable cells: 1"));
    // With the rows up to that one as header, the rest reads; the titles are lost with them.
    dialog->findChild<QSpinBox *>("importHeader")->setValue(12);
    QTRY_VERIFY(!dialog->isLooking());
    QCOMPARE(preview->markedCells(), 0);
    QCOMPARE(dialog->settings().skipRows, std::optional<Index>(12));
    dialog->reject();
    QVERIFY(bench.panelShown()); // nothing was read, so the file stays listed
}

void TestCaptureImport::timeColumn_chosen_isInTheSettings()
{
    const Bench bench;
    const QString path = bench.write("a.csv", tableText({}));
    ImportDialog dialog(path, {}, 1, bench.preferences.profileFolder(), nullptr);
    QTRY_VERIFY(!dialog.isLooking());
    auto *time = dialog.findChild<QComboBox *>("importTime");
    QCOMPARE(time->count(), 5); // automatic, none, three columns
    choose(&dialog, "importTime", 2);
    QTRY_VERIFY(!dialog.isLooking());
    QCOMPARE(dialog.settings().columns.at("time"), Index(0));
    QCOMPARE(time->currentIndex(), 2);
    choose(&dialog, "importTime", 0);
    QTRY_VERIFY(!dialog.isLooking());
    QVERIFY(dialog.settings().columns.empty());
}

void TestCaptureImport::profile_kept_isOfferedForTheNextFile()
{
    const Bench bench;
    bench.drop({bench.write("a.csv", tableText({}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    choose(dialog, "importRole1", kDutRole);
    dialog->findChild<QCheckBox *>("keepProfile")->click();
    QVERIFY(!importButton(dialog)->isEnabled()); // it has no name yet
    dialog->findChild<QLineEdit *>("profileName")->setText("NI 5122 CSV");
    QVERIFY(importButton(dialog)->isEnabled());
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    const ImportProfiles profiles(bench.preferences.profileFolder());
    QCOMPARE(profiles.names(), QStringList("NI 5122 CSV"));

    const Bench next;
    QVERIFY(QDir().mkpath(next.preferences.profileFolder()));
    QVERIFY(QFile::copy(bench.preferences.profileFolder() + "/NI 5122 CSV.json",
        next.preferences.profileFolder() + "/NI 5122 CSV.json"));
    next.drop({next.write("b.csv", tableText({}))});
    dialog = next.waitDialog();
    QVERIFY(dialog);
    QTRY_COMPARE(
        dialog->findChild<QComboBox *>("importProfile")->currentText(), QString("NI 5122 CSV"));
    QTRY_VERIFY(importButton(dialog)->isEnabled()); // shown; one click takes it
    importButton(dialog)->click();
    QTRY_COMPARE(next.shots(), std::size_t(1));
    QCOMPARE(next.import().channels.at("p"), std::string("dut"));
}

void TestCaptureImport::profile_badName_isRefused()
{
    const QTemporaryDir folder;
    const ImportProfiles profiles(folder.filePath("profiles"));
    for (const char *name : {"", " a", "../up", ".hidden", "a/b", "a\\b"})
        QVERIFY2(!profiles.save(name, {}), name);
    ImportSettings settings;
    settings.sampleRate_Hz = 1.25e7;
    settings.decimal = ",";
    settings.levels = {"low"};
    settings.exclude = {{1, "burst"}};
    settings.files["a.csv"].decimal = ".";
    QVERIFY(profiles.save("Ångström 2", settings));
    QCOMPARE(profiles.names(), QStringList("Ångström 2"));
    const Result<ImportSettings> loaded = profiles.load("Ångström 2");
    QVERIFY(loaded);
    settings.levels.clear(); // of the shots of one job
    settings.exclude.clear();
    settings.files.clear();
    QVERIFY(*loaded == settings);
    QVERIFY(!profiles.load("none"));
}

void TestCaptureImport::dialog_fromTheCapturesPage_changesTheJobAsOneStep()
{
    const Bench bench;
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

void TestCaptureImport::dialog_ofTheExample_listsItsChannels()
{
    const Bench bench;
    bench.window->files().setExampleDuration(0.006);
    bench.window->files().openExample();
    QTRY_COMPARE_WITH_TIMEOUT(bench.shots(), std::size_t(3), 60000);
    bench.window->showPage(0);
    bench.find<QPushButton>("importSettings")->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.dialog() && !bench.dialog()->isLooking(), 60000);
    const ImportDialog *dialog = bench.dialog();
    QVERIFY2(importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    QVERIFY(dialog->findChild<ImportChannelTable *>("importChannels")->rowCount() >= 2);
    QVERIFY(!dialog->findChild<QWidget *>("importPreview")->isVisible());
}

void TestCaptureImport::sampleRate_changedOnThePage_isHeldAgainstTheFile()
{
    const Bench bench;
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
    const Bench bench;
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
