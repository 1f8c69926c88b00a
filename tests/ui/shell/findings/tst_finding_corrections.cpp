// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/import_rules.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/sample_results.h"
#include "ui/session/file_import.h"
#include "ui/shell/findings/finding_corrections.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/shell/main_window.h"

#include <QClipboard>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

namespace {

Finding finding(const char *id, Index shot, const char *channel = "Sensor")
{
    return {.id = id,
        .severity = Severity::Caution,
        .shot = shot,
        .channel = channel,
        .message = {"%1 %2 %3 %4", {"a", "b", "c", "psi"}}};
}

/// Three shots in three files.
CaptureSet threeFiles()
{
    CaptureSet set = test::sampleCaptures();
    set.inputs = {{"/data/low.h5", "low.h5", "a", "test"}, {"/data/mid.h5", "mid.h5", "b", "test"},
        {"/data/high.h5", "high.h5", "c", "test"}};
    for (std::size_t i = 0; i < set.shots.size(); ++i)
        set.shots[i].input = static_cast<Index>(i);
    return set;
}

QStringList labels(const std::vector<OfferedCorrection> &corrections)
{
    QStringList texts;
    for (const OfferedCorrection &correction : corrections)
        texts << correction.label;
    return texts;
}

ImportSettings corrected(const OfferedCorrection &correction, ImportSettings settings = {})
{
    correction.apply(settings, "reason");
    return settings;
}

ChannelRole roleIn(const CaptureSet &set, std::size_t shot, const char *channel)
{
    const auto &channels = set.shots[shot].channels;
    return std::ranges::find(channels, channel, &Channel::name)->role;
}

} // namespace

class TestFindingCorrections : public QObject
{
    Q_OBJECT

private slots:
    void others_haveNone();
    void ownCorrection_ofAFinding_isOffered();
    void noDut_offersEveryChannel();
    void swapped_oneFile_swapsThatShotOnly();
    void swapped_all_swapsEveryShot();
    void swapped_oneInput_swapsThatShotOnly();
    void inverted_flipsWhatIsInForce();
    void unit_takesTheOneThatFits();
    void gaps_areInterpolatedOrTheShotExcluded();
    void lastShot_cannotBeExcluded();
    void rate_showsTheImportSettings();
    void panel_buttons_editTheRecipeAsOneStep();
    void panel_excludeAskedInVain_changesNothing();
    void panel_copy_leavesButtonsOut();
    void panel_sameFindings_keepRowsAndSelection();
    void ownSettings_readBackAsWanted();
    void settingsForAll_keepWhatIsOfShotsAndOtherFiles();
};

void TestFindingCorrections::others_haveNone()
{
    for (const char *id : {"CAP-004", "CAP-005", "WIN-001", "SHK-001", ""})
        QVERIFY2(correctionsOf(finding(id, 1), threeFiles()).empty(), id);
    for (const char *id : {"CAP-002", "CAP-007", "CAP-010"}) // there is no such shot
        for (const Index shot : {0, 4, -1})
            QVERIFY2(correctionsOf(finding(id, shot), threeFiles()).empty(), id);
}

void TestFindingCorrections::noDut_offersEveryChannel()
{
    const std::vector<OfferedCorrection> corrections
        = correctionsOf(finding("CAP-002", 1), threeFiles());
    QCOMPARE(labels(corrections), QStringList({"\"Sensor\" is the DUT", "\"Side\" is the DUT"}));
    QCOMPARE(
        corrected(corrections[1]).channels, (std::map<std::string, std::string>{{"Side", "dut"}}));
}

void TestFindingCorrections::swapped_oneFile_swapsThatShotOnly()
{
    const CaptureSet set = threeFiles();
    const std::vector<OfferedCorrection> corrections
        = correctionsOf(finding("CAP-010", 2), set, {finding("CAP-010", 2)});
    // The other shots are right: nobody is offered to make them wrong.
    QCOMPARE(labels(corrections), QStringList({"Swap in mid.h5", "Exclude shot 2..."}));
    const Result<CaptureSet> applied = applyImportSettings(set, corrected(corrections[0]));
    QVERIFY(applied);
    QCOMPARE(roleIn(*applied, 0, "Sensor"), ChannelRole::Dut);
    QCOMPARE(roleIn(*applied, 1, "Sensor"), ChannelRole::DrivenSide);
    QCOMPARE(roleIn(*applied, 1, "Side"), ChannelRole::Dut);
    QCOMPARE(roleIn(*applied, 2, "Sensor"), ChannelRole::Dut);
}

void TestFindingCorrections::swapped_all_swapsEveryShot()
{
    const CaptureSet set = threeFiles();
    const Findings all{finding("CAP-010", 1), finding("CAP-010", 2), finding("CAP-010", 3)};
    const std::vector<OfferedCorrection> corrections = correctionsOf(all[1], set, all);
    QCOMPARE(labels(corrections),
        QStringList({"Swap in mid.h5", "Swap in all shots", "Exclude shot 2..."}));
    // Also where one file had been swapped before.
    const Result<CaptureSet> applied
        = applyImportSettings(set, corrected(corrections[1], corrected(corrections[0])));
    QVERIFY(applied);
    for (std::size_t shot = 0; shot < 3; ++shot) {
        QCOMPARE(roleIn(*applied, shot, "Sensor"), ChannelRole::DrivenSide);
        QCOMPARE(roleIn(*applied, shot, "Side"), ChannelRole::Dut);
    }
}

/// Three shots in one file: the shot that is swapped is swapped back alone.
void TestFindingCorrections::swapped_oneInput_swapsThatShotOnly()
{
    const CaptureSet set = test::sampleCaptures();
    const std::string first = set.shots[0].channelWithRole(ChannelRole::Dut)->name;
    Findings all{finding("CAP-010", 2)};
    std::vector<OfferedCorrection> corrections = correctionsOf(all[0], set, all);
    QCOMPARE(labels(corrections), QStringList({"Swap in shot 2", "Exclude shot 2..."}));
    const Result<CaptureSet> applied = applyImportSettings(set, corrected(corrections[0]));
    QVERIFY(applied);
    QCOMPARE(roleIn(*applied, 0, first.c_str()), ChannelRole::Dut);
    QCOMPARE(roleIn(*applied, 1, first.c_str()), ChannelRole::DrivenSide);
    QCOMPARE(roleIn(*applied, 2, first.c_str()), ChannelRole::Dut);

    all = {finding("CAP-010", 1), finding("CAP-010", 2), finding("CAP-010", 3)};
    const ImportSettings one = corrected(corrections[0]);
    corrections = correctionsOf(all[1], set, all);
    QCOMPARE(labels(corrections),
        QStringList({"Swap in shot 2", "Swap in all shots", "Exclude shot 2..."}));
    const Result<CaptureSet> every
        = applyImportSettings(set, corrected(corrections[1], one)); // also where one was before
    QVERIFY(every);
    for (std::size_t shot = 0; shot < 3; ++shot)
        QCOMPARE(roleIn(*every, shot, first.c_str()), ChannelRole::DrivenSide);
}

void TestFindingCorrections::inverted_flipsWhatIsInForce()
{
    const std::vector<OfferedCorrection> corrections
        = correctionsOf(finding("CAP-012", 2), threeFiles());
    QCOMPARE(corrections.size(), std::size_t(1));
    QCOMPARE(corrected(corrections[0]).polarity, -1);
    QCOMPARE(corrected(corrections[0], corrected(corrections[0])).polarity, 1);
    ImportSettings channel;
    channel.channelDetails["Sensor"].polarity = -1; // wins over that of the DUT
    QCOMPARE(corrected(corrections[0], channel).channelDetails["Sensor"].polarity,
        std::optional<int>(1));
    QCOMPARE(corrected(corrections[0], channel).polarity, 1);
    ImportSettings file = channel;
    file.files["mid.h5"].channelDetails["Sensor"].polarity = 1; // wins over both
    const ImportSettings next = corrected(corrections[0], file);
    QCOMPARE(next.files.at("mid.h5").channelDetails.at("Sensor").polarity, std::optional<int>(-1));
    QCOMPARE(next.channelDetails.at("Sensor").polarity, std::optional<int>(-1)); // of the others
}

void TestFindingCorrections::unit_takesTheOneThatFits()
{
    const std::vector<OfferedCorrection> corrections
        = correctionsOf(finding("CAP-013", 1), threeFiles());
    QCOMPARE(labels(corrections), QStringList("The unit is psi"));
    QCOMPARE(corrected(corrections[0]).unit, std::optional<std::string>("psi"));
    ImportSettings channel;
    channel.channelDetails["Sensor"].unit = "bar";
    QCOMPARE(corrected(corrections[0], channel).channelDetails["Sensor"].unit,
        std::optional<std::string>("psi"));
    Finding none = finding("CAP-013", 1);
    none.message.arguments[3].clear(); // no unit fits
    QVERIFY(correctionsOf(none, threeFiles()).empty());
}

void TestFindingCorrections::gaps_areInterpolatedOrTheShotExcluded()
{
    const std::vector<OfferedCorrection> corrections
        = correctionsOf(finding("CAP-006", 3), threeFiles());
    QCOMPARE(corrections.size(), std::size_t(2));
    QVERIFY(corrections[0].question.isEmpty());
    QCOMPARE(corrected(corrections[0]).interpolateInvalid, Index(5));
    QVERIFY(!corrections[1].question.isEmpty());
    const ImportSettings excluded = corrected(corrections[1]);
    QCOMPARE(excluded.exclude.size(), std::size_t(1));
    QCOMPARE(excluded.exclude[0].shot, Index(3));
    QCOMPARE(excluded.exclude[0].reason, std::string("reason"));
}

void TestFindingCorrections::lastShot_cannotBeExcluded()
{
    CaptureSet set = threeFiles();
    QCOMPARE(correctionsOf(finding("CAP-007", 1), set).size(), std::size_t(1));
    QVERIFY(correctionsOf(finding("CAP-007", 0), set).empty()); // of no shot in particular
    set.shots[1].included = set.shots[2].included = false;
    QVERIFY(correctionsOf(finding("CAP-007", 1), set).empty());
    QVERIFY(correctionsOf(finding("CAP-007", 2), set).empty()); // is out already
}

void TestFindingCorrections::rate_showsTheImportSettings()
{
    QCOMPARE(
        correctionsOf(finding("CAP-003", 2), threeFiles())[0].importPath, QString("/data/mid.h5"));
    Finding named = finding("CAP-019", 0);
    named.message.arguments = {"/data/high.h5"};
    QCOMPARE(correctionsOf(named, threeFiles())[0].importPath, QString("/data/high.h5"));
    named.message.arguments = {"/data/other.h5"};
    QVERIFY(correctionsOf(named, threeFiles()).empty());
}

namespace {

/// Raises one finding as long as nothing was corrected.
PipelineOutcome oneFinding(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId last, const JobControl &control)
{
    PipelineOutcome outcome = test::samplePipeline(captures, recipe, cache, last, control);
    auto prepared = std::make_shared<PreparedCaptures>(*outcome.results.captures);
    prepared->findings.clear();
    if (recipe.import.polarity > 0)
        prepared->findings.push_back(finding("CAP-012", 1));
    if (recipe.import.exclude.empty())
        prepared->findings.push_back(finding("CAP-007", 2));
    outcome.results.captures = prepared;
    return outcome;
}

struct Bench : test::WindowBench
{
    Bench()
        : WindowBench(oneFinding)
    {
        window->show();
        window->session().reset({std::make_shared<const CaptureSet>(threeFiles()), {}});
    }
    QPushButton *button(const QString &id) const
    {
        return window->findChild<QPushButton *>("correction_" + id + "_1");
    }
};

} // namespace

void TestFindingCorrections::panel_buttons_editTheRecipeAsOneStep()
{
    Bench bench;
    QTRY_VERIFY(bench.button("CAP-012"));
    QVERIFY(bench.button("CAP-012")->accessibleDescription().contains("CAP-012"));
    bench.button("CAP-012")->click();
    QTRY_COMPARE(bench.window->session().recipe().import.polarity, -1);
    QTRY_VERIFY(!bench.button("CAP-012")); // what is corrected is gone
    QCOMPARE(bench.window->session().undoStack().count(), 1);
    bench.prompts.setNextSentence("burst too late");
    bench.button("CAP-007")->click();
    QTRY_COMPARE(bench.window->session().recipe().import.exclude.size(), std::size_t(1));
    QCOMPARE(
        bench.window->session().recipe().import.exclude[0].reason, std::string("burst too late"));
    bench.window->session().undoStack().undo();
    bench.window->session().undoStack().undo();
    QCOMPARE(bench.window->session().recipe().import, ImportSettings{});
    QTRY_VERIFY(bench.button("CAP-012"));
}

void TestFindingCorrections::panel_excludeAskedInVain_changesNothing()
{
    Bench bench;
    QTRY_VERIFY(bench.button("CAP-007"));
    bench.button("CAP-007")->click(); // no reason is given
    QTest::qWait(50);
    QCOMPARE(bench.window->session().undoStack().count(), 0);
}

void TestFindingCorrections::panel_copy_leavesButtonsOut()
{
    Bench bench;
    QTRY_VERIFY(bench.button("CAP-007"));
    auto *panel = bench.window->findChild<FindingsPanel *>("findingsPanel");
    panel->clearSelection();
    QTest::keySequence(panel, QKeySequence::Copy);
    const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
    for (const QString &line : lines)
        QVERIFY2(!line.trimmed().isEmpty(), qPrintable(lines.join('|')));
    QVERIFY(lines.size() >= 2);
}

void TestFindingCorrections::panel_sameFindings_keepRowsAndSelection()
{
    FindingsPanel panel;
    const CaptureSet captures;
    const auto finding = [](Severity severity, const char *sentence) {
        return Finding{.id = "ORD-009", .severity = severity, .message = {sentence, {}}};
    };
    Findings findings{finding(Severity::Info, "First."), finding(Severity::Caution, "Second.")};
    panel.setFindings(findings, {}, captures);
    QCOMPARE(panel.count(), 3); // the caution, its buttons, the note folded
    QListWidgetItem *top = panel.item(0); // the caution comes first
    QVERIFY(top->text().contains("Second."));
    top->setSelected(true);
    panel.setFindings(findings, {}, captures);
    QCOMPARE(panel.item(0), top);
    QVERIFY(top->isSelected());

    findings[1].message.text = "Third.";
    panel.setFindings(findings, {}, captures);
    QVERIFY(panel.item(0)->text().contains("Third."));
    panel.setFindings(findings, {{"ORD-009", 0, "known"}}, captures);
    QVERIFY(panel.item(0)->text().contains("known"));
    panel.setFindings({}, {}, captures);
    QCOMPARE(panel.count(), 1);
    QVERIFY(!(panel.item(0)->flags() & Qt::ItemIsSelectable));
    panel.setFindings({}, {}, captures);
    QCOMPARE(panel.count(), 1);
    panel.setFindings(findings, {}, captures);
    QCOMPARE(panel.count(), 3);
}

void TestFindingCorrections::ownSettings_readBackAsWanted()
{
    ImportSettings all;
    all.decimal = ",";
    all.channels["a"] = "dut";
    all.files["other.csv"].separator = ";";
    ImportSettings wanted = all;
    wanted.files.clear();
    wanted.decimal = ".";
    wanted.format = "text";
    wanted.columns = {{"time", 2}};
    wanted.channels["b"] = "driver";
    wanted.channelDetails["a"].sensitivity = 1.25e-5;
    wanted.sampleRate_Hz = 2e6;
    wanted.sampleRateReason = "crystal";
    wanted.skipRows = 4;
    wanted.polarity = -1;
    wanted.interpolateInvalid = 3;
    const ImportSettings next = withOwnSettings(all, "/data/x.csv", wanted);
    ImportSettings effective = settingsOfFile(next, "/elsewhere/x.csv");
    effective.files.clear();
    QVERIFY(effective == wanted);
    QVERIFY(settingsOfFile(next, "other.csv").separator == ";"); // as before
    ImportSettings third = settingsOfFile(next, "third.csv");
    QVERIFY(third.decimal == "," && !third.sampleRate_Hz);
    // Nothing of its own: no entry, and an earlier one goes.
    ImportSettings same = all;
    QVERIFY(withOwnSettings(next, "x.csv", same).files.size() == 1);
}

void TestFindingCorrections::settingsForAll_keepWhatIsOfShotsAndOtherFiles()
{
    ImportSettings job;
    job.levels = {"low"};
    job.exclude = {{1, "burst"}};
    job.files["x.csv"].decimal = ",";
    job.files["y.csv"].decimal = ",";
    ImportSettings wanted;
    wanted.decimal = ".";
    const ImportSettings next = withSettingsForAll(job, "/data/x.csv", wanted);
    QCOMPARE(next.decimal, std::string("."));
    QCOMPARE(next.levels, job.levels);
    QCOMPARE(next.exclude.size(), std::size_t(1));
    QVERIFY(!next.files.contains("x.csv") && next.files.contains("y.csv"));
}

void TestFindingCorrections::ownCorrection_ofAFinding_isOffered()
{
    Finding celsius = finding("SHK-004", 1);
    celsius.correction
        = Correction{.label = {"Use %1 K", {"294.15"}}, .key = "shock.t1_k", .value = "294.15"};
    const std::vector<OfferedCorrection> corrections = correctionsOf(celsius, threeFiles());
    QCOMPARE(labels(corrections), QStringList("Use 294.15 K"));
    QVERIFY(corrections.front().ofFinding == celsius.correction);
}

DYNCAL_TEST(TestFindingCorrections)
#include "tst_finding_corrections.moc"
