// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of a batch from values: rows, words, order, filter, changes in place.

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/shell/batch/batch_table.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

using namespace dyncal;

namespace {

SensorNow sensorNow(const std::string &id, SensorState state)
{
    SensorNow sensor;
    sensor.standing.id = id;
    sensor.standing.record.state = state;
    return sensor;
}

/// One sensor of each state, in an order that is not that of the table.
BatchMoment allStates()
{
    BatchMoment moment{std::make_shared<const BatchPlan>(6), {}, {}};
    moment.sensors = {sensorNow("a/done", SensorState::Done), sensorNow("b", SensorState::Missing),
        sensorNow("c", SensorState::Cautions), sensorNow("d", SensorState::Blocked),
        sensorNow("e", SensorState::Failed), sensorNow("f", SensorState::Missing)};
    moment.sensors[5].isRunning = true;
    moment.sensors[0].standing.record.results = {{"f0_hz", 318123.4, "Hz", 20.0, 2.0},
        {"damping_ratio", 0.0123456, "", 0.0012, 2.1}, {"sensitivity", 5e-6, "V/Pa"}};
    moment.sensors[2].standing.record.findings = {{"CAP-017", Severity::Info, 0},
        {"WIN-001", Severity::Caution, 2}, {"MOD-001", Severity::Caution, 0}};
    moment.sensors[3].standing.record.findings = {{"SIG-003", Severity::Block, 1}};
    moment.sensors[4].standing.record.reason = "The file is damaged.";
    return moment;
}

struct Bench
{
    Language language;
    BatchTable table{nullptr};
    QTableView *view = table.findChild<QTableView *>("batchTable");

    explicit Bench(const BatchMoment &moment, const char *code = "en")
    {
        language.install(code);
        table.showWords();
        table.setMoment(moment);
    }
    QString cell(int row, int column) const
    {
        return view->model()->index(row, column).data().toString();
    }
    QStringList column(int column) const
    {
        QStringList cells;
        for (int row = 0; row < view->model()->rowCount(); ++row)
            cells << cell(row, column);
        return cells;
    }
    QString tally() const { return table.findChild<QLabel *>("batchTally")->text(); }
    void type(const QString &text) { table.findChild<QLineEdit *>("batchText")->setText(text); }
    void choose(int state) { table.findChild<QComboBox *>("batchState")->setCurrentIndex(state); }
};

} // namespace

class TestBatchTable : public QObject
{
    Q_OBJECT

private slots:
    /// Also those that another language's program has written down.
    void reason_isInTheLanguageOfTheWindow()
    {
        BatchMoment moment = allStates();
        SensorOutcome &record = moment.sensors[4].standing.record;
        record.said = {"%1: %M1", {"CAP-018"},
            {{"%1 does not exist; check the name and the folder.", {"a.h5"}}}};
        record.reason = english(record.said.message());
        QCOMPARE(record.reason,
            std::string("CAP-018: a.h5 does not exist; check the name and the folder."));
        const QString swedish("CAP-018: a.h5 finns inte; kontrollera namnet och mappen.");
        Bench bench(moment, "sv");
        QCOMPARE(bench.column(BatchModel::Reason).first(), swedish);
        QVERIFY(
            bench.view->model()->index(0, 0).data(Qt::ToolTipRole).toString().contains(swedish));
        bench.type("finns inte");
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList{"e"});
    }

    void worst_standsFirst()
    {
        const Bench bench(allStates());
        QCOMPARE(
            bench.column(BatchModel::Sensor), QStringList({"e", "d", "c", "f", "b", "a/done"}));
        QCOMPARE(bench.column(BatchModel::State),
            QStringList(
                {"■ failed", "■ blocked", "▲ cautions", "⟳ running", "□ missing", "● done"}));
        QCOMPARE(bench.tally(),
            QString("6 sensors: 1 failed, 1 blocked, 1 cautions, 1 running, 1 missing, 1 done"));
    }

    /// Values to the digits of their U; without U three digits; nothing where there is no result.
    void results_areShownWithU()
    {
        const Bench bench(allStates());
        QCOMPARE(bench.cell(5, BatchModel::Frequency), QString("318.123 kHz ± 0.020 kHz"));
        QCOMPARE(bench.cell(5, BatchModel::Damping), QString("0.0123 ± 0.0012"));
        QCOMPARE(bench.cell(5, BatchModel::Sensitivity), QString("5.00 µV/Pa"));
        QCOMPARE(bench.cell(0, BatchModel::Frequency), QString());
        QVERIFY(bench.view->model()
                    ->index(5, 0)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains("damping_ratio = 0.0123 ± 0.0012 (k = 2.1)"));
    }

    void worstFinding_andReason()
    {
        const Bench bench(allStates());
        QCOMPARE(bench.cell(1, BatchModel::Worst), QString("■ SIG-003, shot 1"));
        QCOMPARE(bench.cell(2, BatchModel::Worst), QString("▲ WIN-001, shot 2 (and 1 more)"));
        QCOMPARE(bench.cell(5, BatchModel::Worst), QString());
        QCOMPARE(bench.cell(0, BatchModel::Reason), QString("The file is damaged."));
        QVERIFY(bench.view->model()
                    ->index(2, 0)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains("WIN-001, shot 2; MOD-001"));
    }

    void text_filtersNameFindingAndReason()
    {
        Bench bench(allStates());
        bench.type("DONE");
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList("a/done"));
        bench.type("mod-00");
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList("c"));
        bench.type("damaged");
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList("e"));
        bench.type(" ");
        QCOMPARE(bench.view->model()->rowCount(), 6);
    }

    /// Every state of the list shows its one sensor, and what is running is not shown as missing.
    void state_filters()
    {
        Bench bench(allStates());
        const QStringList one{"e", "d", "c", "f", "b", "a/done"};
        for (int state = 0; state < one.size(); ++state) {
            bench.choose(state + 1);
            QCOMPARE(bench.column(BatchModel::Sensor), QStringList(one[state]));
        }
        bench.choose(0);
        QCOMPARE(bench.view->model()->rowCount(), 6);
    }

    void columns_sortByValue()
    {
        BatchMoment moment{std::make_shared<const BatchPlan>(3), {}, {}};
        moment.sensors = {sensorNow("SN-2", SensorState::Done),
            sensorNow("SN-10", SensorState::Done), sensorNow("SN-11", SensorState::Failed)};
        moment.sensors[0].standing.record.results = {{"f0_hz", 900e3, "Hz"}};
        moment.sensors[1].standing.record.results = {{"f0_hz", 1.1e6, "Hz"}};
        const Bench bench(moment);
        bench.view->sortByColumn(BatchModel::Frequency, Qt::AscendingOrder);
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList({"SN-2", "SN-10", "SN-11"}));
        bench.view->sortByColumn(BatchModel::Sensor, Qt::DescendingOrder);
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList({"SN-11", "SN-10", "SN-2"}));
    }

    /// A sensor that gets another state moves to its place; what was selected stays selected.
    void change_keepsTheSelection()
    {
        BatchMoment moment = allStates();
        Bench bench(moment);
        bench.view->selectRow(3); // f
        QCOMPARE(bench.table.selected(), std::optional<std::size_t>(5));
        moment.sensors[5] = sensorNow("f", SensorState::Failed);
        moment.sensors[4] = sensorNow("e", SensorState::Done);
        bench.table.setMoment(moment);
        QCOMPARE(
            bench.column(BatchModel::Sensor), QStringList({"f", "d", "c", "b", "a/done", "e"}));
        QCOMPARE(bench.table.selected(), std::optional<std::size_t>(5));
        bench.table.setMoment({std::make_shared<const BatchPlan>(1), {}, {moment.sensors[0]}});
        QCOMPARE(bench.column(BatchModel::Sensor), QStringList("a/done"));
        QVERIFY(!bench.table.selected());
    }

    void foreignNames_areMadePresentable()
    {
        BatchMoment moment{std::make_shared<const BatchPlan>(1), {}, {}};
        moment.sensors = {sensorNow("a\x1b[2Jb\n<b>c", SensorState::Failed)};
        moment.sensors[0].standing.record.reason = "x\x07y";
        const Bench bench(moment);
        for (const int column : {int(BatchModel::Sensor), int(BatchModel::Reason)})
            for (const QChar c : bench.cell(0, column))
                QVERIFY(c.unicode() >= 0x20);
    }

    /// The window must answer while a large batch changes.
    void tenThousand_changeQuickly()
    {
        constexpr std::size_t kSensors = 10'000;
        BatchMoment moment{std::make_shared<const BatchPlan>(kSensors), {}, {}};
        for (std::size_t i = 0; i < kSensors; ++i)
            moment.sensors.push_back(sensorNow("SN-" + std::to_string(i), SensorState::Missing));
        Bench bench(moment);
        bench.table.resize(1000, 600);
        bench.table.show();
        for (std::size_t i = 0; i < kSensors; i += 100)
            moment.sensors[i].standing.record = allStates().sensors[0].standing.record;
        QElapsedTimer taken;
        taken.start();
        bench.table.setMoment(moment);
        QCoreApplication::processEvents();
        qInfo("100 of 10 000 rows changed in %lld ms", taken.elapsed());
        QVERIFY(taken.elapsed() < 1000);
        QCOMPARE(bench.view->model()->rowCount(), int(kSensors));
    }

    void swedish_hasNoEnglishLeft()
    {
        const test::InSwedish swedish;
        const Bench bench(allStates(), "sv");
        for (const QString &state : bench.column(BatchModel::State))
            for (const char *english :
                {"failed", "blocked", "cautions", "running", "missing", "done"})
                QVERIFY2(!state.contains(english), qPrintable(state));
        QCOMPARE(bench.cell(5, BatchModel::Frequency), QString("318,123 kHz ± 0,020 kHz"));
        QVERIFY(bench.tally().startsWith("6 givare: "));
        QCOMPARE(bench.view->model()->headerData(0, Qt::Horizontal).toString(), QString("Givare"));
    }
};

DYNCAL_TEST(TestBatchTable)
#include "tst_batch_table.moc"
