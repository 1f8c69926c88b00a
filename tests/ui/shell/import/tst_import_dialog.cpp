// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/import/import_bench.h"
#include "ui/session/import_profiles.h"
#include "ui/shell/import/import_channel_table.h"
#include "ui/shell/import/import_preview_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

using namespace dyncal;
using namespace dyncal::test;

/// What the import dialog asks, and what it makes of the answers.
class TestImportDialog : public QObject
{
    Q_OBJECT

private slots:
    void channelDetails_typed_areInTheSettings();
    void hdf5_datasets_arePickedFromTheTree();
    void rateAgainstTheFile_needsAReason();
    void noRate_asks();
    void germanTable_readsWithoutAQuestion();
    void ambiguousDecimal_asksAndShowsTheEffect();
    void headerAgainstTimes_offersBoth_data();
    void headerAgainstTimes_offersBoth();
    void unreadableCells_areMarkedAndBlock();
    void timeColumn_chosen_isInTheSettings();
    void eachColumnAShot_importsOneShotPerColumn();
    void eachColumnAShot_headerAgainstTimes_leavesTheTimesOut();
    void profile_kept_isOfferedForTheNextFile();
    void profile_badName_isRefused();
    void dialog_ofTheExample_listsItsChannels();
};

void TestImportDialog::channelDetails_typed_areInTheSettings()
{
    const ImportBench bench;
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
void TestImportDialog::hdf5_datasets_arePickedFromTheTree()
{
    const ImportBench bench;
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

void TestImportDialog::rateAgainstTheFile_needsAReason()
{
    const ImportBench bench;
    // A file that states its rate without a column of times: header only.
    const QString csv = bench.write("a.csv",
        tableText({.header = "Sample rate: 1 MHz\np [V]\n", .times = false, .columns = 1}));
    ImportDialog dialog(csv, {}, 1, bench.preferences.profileFolder(), nullptr);
    QTRY_VERIFY(!dialog.isLooking());
    QVERIFY2(importButton(&dialog)->isEnabled(), qPrintable(verdict(&dialog)));
    auto *rate = dialog.findChild<QLineEdit *>("importRateValue");
    rate->selectAll();
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

void TestImportDialog::noRate_asks()
{
    const ImportBench bench;
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

void TestImportDialog::germanTable_readsWithoutAQuestion()
{
    const ImportBench bench;
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

void TestImportDialog::ambiguousDecimal_asksAndShowsTheEffect()
{
    const ImportBench bench;
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

void TestImportDialog::headerAgainstTimes_offersBoth_data()
{
    QTest::addColumn<QString>("button");
    QTest::addColumn<double>("rate_Hz");
    QTest::newRow("times") << "useTimes" << 1e6;
    QTest::newRow("header") << "useHeader" << 10e6;
}

void TestImportDialog::headerAgainstTimes_offersBoth()
{
    QFETCH(QString, button);
    QFETCH(double, rate_Hz);
    const ImportBench bench;
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

void TestImportDialog::unreadableCells_areMarkedAndBlock()
{
    const ImportBench bench;
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

void TestImportDialog::timeColumn_chosen_isInTheSettings()
{
    const ImportBench bench;
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

void TestImportDialog::eachColumnAShot_importsOneShotPerColumn()
{
    const ImportBench bench;
    bench.drop({bench.write(
        "series.csv", tableText({.header = "time [s],a [V],b [V],c [V]\n", .columns = 3}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QVERIFY2(verdict(dialog).contains("each column is a shot"), qPrintable(verdict(dialog)));
    QVERIFY(!importButton(dialog)->isEnabled());
    auto *each = dialog->findChild<QCheckBox *>("importShotColumns");
    QVERIFY(each && each->isVisible() && !each->toolTip().isEmpty());
    QTest::mouseClick(each, Qt::LeftButton, {}, QPoint(8, each->height() / 2));
    QTRY_VERIFY(!dialog->isLooking());
    QVERIFY2(importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    auto *table = dialog->findChild<ImportChannelTable *>("importChannels");
    QCOMPARE(table->rowCount(), 3);
    QCOMPARE(table->item(0, 0)->text(), QString("a"));
    QCOMPARE(table->item(2, 1)->text(), QString("DUT, shot 3"));
    QVERIFY(table->cellWidget(2, 2)); // each has its trace
    auto *preview = dialog->findChild<ImportPreviewTable *>("importPreview");
    QCOMPARE(preview->horizontalHeaderItem(0)->text(), QString("time [s] (time)"));
    QCOMPARE(preview->horizontalHeaderItem(2)->text(), QString("b [V] (shot 2)"));

    auto *gain = dialog->findChild<QLineEdit *>("importGain2Value"); // said of one, meant for all
    gain->setFocus();
    QTest::keyClicks(gain, "10");
    QTest::keyClick(gain, Qt::Key_Tab);
    QCOMPARE(dialog->findChild<QLineEdit *>("importGain3Value")->text(), QString("10"));
    QTest::mouseClick(each, Qt::LeftButton, {}, QPoint(8, each->height() / 2)); // and back
    QTRY_VERIFY(!dialog->isLooking());
    QVERIFY(dialog->findChild<QComboBox *>("importRole1"));
    QVERIFY(!importButton(dialog)->isEnabled());
    QVERIFY(dialog->settings().channelDetails.empty());
    QTest::mouseClick(each, Qt::LeftButton, {}, QPoint(8, each->height() / 2));
    QTRY_VERIFY(!dialog->isLooking() && importButton(dialog)->isEnabled());
    QTest::mouseClick(importButton(dialog), Qt::LeftButton);
    QTRY_COMPARE(bench.shots(), std::size_t(3));
    QCOMPARE(bench.import().columnsAre, std::string("shots"));
    const CaptureSet &set = *bench.window->session().state().captures;
    for (const Shot &shot : set.shots) {
        QCOMPARE(shot.channels.size(), std::size_t(1));
        QCOMPARE(shot.channels[0].role, ChannelRole::Dut);
    }
    // The same recipe reads the same in the command line's way.
    const auto again = readCaptures({set.inputs[0].path}, bench.import());
    QVERIFY(again.has_value());
    QCOMPARE(again->shots.size(), std::size_t(3));
}

void TestImportDialog::eachColumnAShot_headerAgainstTimes_leavesTheTimesOut()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv",
        tableText({.header = "Sample rate: 10 MHz\ntime [s],p [V],q [V]\n", .columns = 2}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    dialog->findChild<QCheckBox *>("importShotColumns")->click();
    QTRY_VERIFY(!dialog->isLooking());
    dialog->findChild<QPushButton *>("useHeader")->click();
    QTRY_VERIFY2(
        !dialog->isLooking() && importButton(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    importButton(dialog)->click();
    QTRY_COMPARE(bench.shots(), std::size_t(2));
    QCOMPARE(bench.import().sampleRate_Hz, std::optional<double>(10e6));
}

void TestImportDialog::profile_kept_isOfferedForTheNextFile()
{
    const ImportBench bench;
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

    const ImportBench next;
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

void TestImportDialog::profile_badName_isRefused()
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

void TestImportDialog::dialog_ofTheExample_listsItsChannels()
{
    const ImportBench bench;
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
    // What must be answered is in view: the roles, and the step in volts, not in counts.
    for (int row = 1; row <= 2; ++row) {
        const auto *role = dialog->findChild<QComboBox *>(QString("importRole%1").arg(row));
        QVERIFY(role && role->visibleRegion().boundingRect().width() == role->width());
        QVERIFY(role->width() >= role->sizeHint().width());
    }
    const auto *channels = dialog->findChild<ImportChannelTable *>("importChannels");
    QStringList looks;
    for (int row = 0; row < channels->rowCount(); ++row)
        for (int column = 0; column < channels->columnCount(); ++column)
            if (const auto *item = channels->item(row, column);
                item && item->text().contains("times the noise"))
                looks << item->text();
    QVERIFY2(looks.join('|').contains(" mV") || looks.join('|').contains(" V"),
        qPrintable(looks.join('|')));
    QVERIFY2(!looks.join('|').contains("kV"), qPrintable(looks.join('|')));
}

DYNCAL_TEST(TestImportDialog)
#include "tst_import_dialog.moc"
