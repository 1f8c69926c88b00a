// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the fields of the correction window say, as values: no window is needed.

#include "tests/support/made_results.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/recording_files.h"
#include "tests/ui/support/sample_results.h"
#include "ui/shell/correction/correction_task.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

CorrectionChoice wholeChoice()
{
    CorrectionChoice choice;
    choice.isOfProject = false;
    choice.results = "/data/results.json";
    choice.recordings = QStringList{"/data/blast.csv"};
    return choice;
}

std::string whyNot(const CorrectionChoice &choice)
{
    const auto task = taskOf(choice, {});
    return task ? std::string() : english(task.error().message);
}

} // namespace

class TestCorrectionTask : public QObject
{
    Q_OBJECT

private slots:
    void choice_becomesATask()
    {
        CorrectionChoice choice = wholeChoice();
        choice.filter.band_Hz = 1e5;
        choice.window = {-1e-3, 2e-3};
        choice.beyond_Pa = 70.0;
        const auto task = taskOf(choice, {});
        QVERIFY(task.has_value());
        QCOMPARE(task->results, std::string("/data/results.json"));
        QCOMPARE(task->recordings, std::vector<std::string>{"/data/blast.csv"});
        QCOMPARE(*task->filter.band_Hz, 1e5);
        QVERIFY(task->record.window_s == (Interval{-1e-3, 2e-3}));
        QVERIFY(!task->record.quiet_s);
        QCOMPARE(*task->record.beyond_Pa, 70.0);
        QVERIFY(!task->run);
        choice.isOfProject = true; // the file does not count then
        QVERIFY(taskOf(choice, {})->results.empty());
    }

    void whatIsMissing_isSaid()
    {
        CorrectionChoice choice = wholeChoice();
        choice.results.clear();
        QVERIFY(whyNot(choice).starts_with("No calibration is chosen"));
        choice = wholeChoice();
        choice.recordings.clear();
        QVERIFY(whyNot(choice).starts_with("No recording is chosen"));
        for (const TypedStretch &stretch : {TypedStretch{1.0, std::nullopt},
                 TypedStretch{std::nullopt, 1.0}, TypedStretch{2.0, 1.0}, TypedStretch{1.0, 1.0}}) {
            choice = wholeChoice();
            choice.window = stretch;
            QVERIFY(whyNot(choice).starts_with("A stretch of the recording needs"));
            choice = wholeChoice();
            choice.quiet = stretch;
            QVERIFY(whyNot(choice).starts_with("A stretch of the recording needs"));
        }
    }

    /// Those of the project only where that was asked for; of them import and checks alone.
    void recordings_areReadAsChosen()
    {
        Recipe project;
        project.import.scale = 3.0;
        project.checks.rateMismatch_percent = 7.0;
        project.window.end_s = 1.0;
        CorrectionChoice choice = wholeChoice();
        QVERIFY(readingRecipe(choice, project) == Recipe());
        choice.channel = "CH2";
        QCOMPARE(readingRecipe(choice, project).import.channels.at("CH2"), std::string("dut"));
        choice.isReadAsProject = true;
        const Recipe read = readingRecipe(choice, project);
        QCOMPARE(read.import.scale, 3.0);
        QCOMPARE(read.checks.rateMismatch_percent, 7.0);
        QCOMPARE(read.import.channels.size(), std::size_t(1));
        QVERIFY(!(read.window == project.window));
    }

    void channels_areThoseOfAllRecordings()
    {
        const ScratchFolder scratch;
        const auto put = [&](const char *name, const char *header) {
            test::TableText table;
            table.header = header;
            const QByteArray text = test::tableText(table);
            return scratch.write(name, text.constData(), static_cast<std::size_t>(text.size()));
        };
        const std::string one = put("one.csv", "time [s],A [V],B [V]\n");
        const std::string other = put("other.csv", "time [s],B [V],C [V]\n");
        const auto names = channelsOf({one, other}, {}, {});
        QVERIFY(names.has_value());
        QCOMPARE(*names, (QStringList{"A", "B", "C"}));
        QVERIFY(!channelsOf({scratch.file("none.csv")}, {}, {}));
    }

    /// A run that may not be published corrects nothing.
    void blockedRun_saysWhatBlocks()
    {
        CorrectionTask task;
        task.recordings = {"/nowhere/none.csv"};
        task.run = ProjectRun{};
        task.run->outcome.error = fail(ErrorKind::DataBlocked, {"No step.", {}}, "WIN-002").value();
        const auto report = correctionReport(task, {});
        QVERIFY(!report);
        QVERIFY(english(report.error().message).find("No step.") != std::string::npos);
    }
};

DYNCAL_TEST(TestCorrectionTask)
#include "tst_correction_task.moc"
