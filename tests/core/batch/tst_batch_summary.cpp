// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_summary.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QtTest>

using namespace dyncal;

namespace {

SensorStanding standing(const std::string &id, SensorState state)
{
    SensorStanding made{id, {}};
    made.record.state = state;
    return made;
}

SensorStanding calibrated(const std::string &id)
{
    SensorStanding made = standing(id, SensorState::Cautions);
    made.record.results = {{"f0_hz", 318001.9171702389, "Hz", 19.25, 2.0},
        {"q", 25.0, "", std::nullopt, std::nullopt},
        {"sensitivity", 5.021200744931696e-06, "V/Pa", 1.25e-7, 2.25}};
    made.record.findings = {{"CAP-017", Severity::Info, 0}, {"WIN-001", Severity::Caution, 2},
        {"SHK-005", Severity::Info, 1}, {"WIN-001", Severity::Caution, 3}};
    return made;
}

std::vector<std::vector<std::string>> cellsOf(const std::string &csv)
{
    std::vector<std::vector<std::string>> rows{{""}};
    bool isQuoted = false;
    for (const char c : csv) {
        if (c == '"')
            isQuoted = !isQuoted;
        else if (c == ',' && !isQuoted)
            rows.back().emplace_back();
        else if (c == '\n' && !isQuoted)
            rows.push_back({""});
        else
            rows.back().back() += c;
    }
    rows.pop_back();
    return rows;
}

} // namespace

/// The summary of a batch, and its counts.
class TestBatchSummary : public QObject
{
    Q_OBJECT

private slots:
    void csv_ofNothing_isItsHead();
    void csv_statesValueUAndK();
    void csv_hasEveryQuantityThatAnySensorHas();
    void csv_everyRowHasAsManyCells();
    void csv_keepsTheOrderGiven();
    void csv_namesFindingsByGravity();
    void csv_foreignTextIsOneCell();
    void csv_numbersReadBackTheSame();
    void tally_countsAndSays();
    void status_listsWhatIsNotDone();
};

void TestBatchSummary::csv_ofNothing_isItsHead()
{
    QCOMPARE(batchSummaryCsv({}),
        std::string("sensor,state,sensitivity,u_expanded_sensitivity,k_sensitivity,f0_hz,"
                    "u_expanded_f0_hz,k_f0_hz,damping_ratio,u_expanded_damping_ratio,"
                    "k_damping_ratio,sensitivity_unit,blocking,cautions,notes,reason\n"));
}

void TestBatchSummary::csv_statesValueUAndK()
{
    const auto rows = cellsOf(batchSummaryCsv({calibrated("a")}));
    QCOMPARE(rows.size(), std::size_t(2));
    const std::vector<std::string> expected{"a", "cautions", "5.021200744931696e-06", "1.25e-07",
        "2.25", "318001.9171702389", "19.25", "2", "", "", "", "25", "", "", "V/Pa", "",
        "WIN-001@2 WIN-001@3", "CAP-017 SHK-005@1", ""};
    QCOMPARE(rows[1], expected);
}

void TestBatchSummary::csv_hasEveryQuantityThatAnySensorHas()
{
    SensorStanding other = standing("b", SensorState::Done);
    other.record.results = {{"within_5_percent_hz", 7e4, "Hz"}, {"minus_3_db_hz", 123456.5, "Hz"}};
    const auto rows = cellsOf(batchSummaryCsv({calibrated("a"), other}));
    const auto column
        = [&](const char *name) { return std::ranges::find(rows[0], name) - rows[0].begin(); };
    QVERIFY(column("minus_3_db_hz") < column("q"));
    QVERIFY(column("q") < column("within_5_percent_hz"));
    QCOMPARE(rows[1][static_cast<std::size_t>(column("minus_3_db_hz"))], std::string());
    QCOMPARE(rows[2][static_cast<std::size_t>(column("minus_3_db_hz"))], std::string("123456.5"));
}

void TestBatchSummary::csv_everyRowHasAsManyCells()
{
    const auto rows = cellsOf(batchSummaryCsv({calibrated("a"), standing("b", SensorState::Failed),
        standing("c", SensorState::Missing), standing("d", SensorState::Blocked)}));
    QCOMPARE(rows.size(), std::size_t(5));
    for (const auto &row : rows)
        QCOMPARE(row.size(), rows[0].size());
}

void TestBatchSummary::csv_keepsTheOrderGiven()
{
    const auto rows = cellsOf(
        batchSummaryCsv({standing("b", SensorState::Done), standing("a", SensorState::Missing)}));
    QCOMPARE(rows[1][0], std::string("b"));
    QCOMPARE(rows[2][0], std::string("a"));
    QCOMPARE(rows[2][1], std::string("missing"));
}

void TestBatchSummary::csv_namesFindingsByGravity()
{
    SensorStanding one = standing("a", SensorState::Blocked);
    one.record.findings = {{"CAP-002", Severity::Block, 1}, {"CAP-003", Severity::Block, 0},
        {"WIN-001", Severity::Caution, 0}};
    const auto rows = cellsOf(batchSummaryCsv({one}));
    const std::size_t count = rows[1].size();
    QCOMPARE(rows[1][count - 4], std::string("CAP-002@1 CAP-003"));
    QCOMPARE(rows[1][count - 3], std::string("WIN-001"));
    QCOMPARE(rows[1][count - 2], std::string());
}

void TestBatchSummary::csv_foreignTextIsOneCell()
{
    SensorStanding one = standing("=1+2,\"x\"", SensorState::Failed);
    one.record.reason = "Line 1;\nline 2, \x1b[31m";
    const std::string csv = batchSummaryCsv({one});
    QVERIFY(csv.find('\x1b') == std::string::npos);
    QCOMPARE(std::ranges::count(csv, '\n'), std::ptrdiff_t(2));
    const auto rows = cellsOf(csv);
    QCOMPARE(rows[1].size(), rows[0].size());
    QVERIFY(rows[1][0].starts_with("'=1+2")); // no spreadsheet takes it for a formula
}

void TestBatchSummary::csv_numbersReadBackTheSame()
{
    SensorStanding one = standing("a", SensorState::Done);
    const double values[] = {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -2.5};
    for (const double value : values)
        one.record.results.push_back(
            {"x" + std::to_string(one.record.results.size()), value, "", value, 2.0});
    const auto rows = cellsOf(batchSummaryCsv({one}));
    for (std::size_t i = 0; i < std::size(values); ++i)
        QCOMPARE(std::strtod(rows[1][11 + 3 * i].c_str(), nullptr), values[i]);
}

void TestBatchSummary::tally_countsAndSays()
{
    BatchTally tally;
    QCOMPARE(tallyText(tally),
        std::string("0 sensors: 0 done, 0 with cautions, 0 blocked, 0 failed, 0 missing"));
    tally.add(SensorState::Done);
    QVERIFY(tallyText(tally).starts_with("1 sensor: 1 done"));
    for (int i = 0; i < kSensorStates; ++i)
        for (int n = 0; n <= i; ++n)
            tally.add(static_cast<SensorState>(i));
    QCOMPARE(tally.total(), std::size_t(16));
    QCOMPARE(tallyText(tally),
        std::string("16 sensors: 2 done, 2 with cautions, 3 blocked, 4 failed, 5 missing"));
}

void TestBatchSummary::status_listsWhatIsNotDone()
{
    SensorStanding failed = standing("f", SensorState::Failed);
    failed.record.reason = "No file.";
    const auto json = nlohmann::json::parse(statusJson(
        {standing("d", SensorState::Done), failed, standing("m", SensorState::Missing)}));
    QCOMPARE(json.at("schema").get<std::string>(), std::string("dyncal-batch-status/1"));
    QCOMPARE(json.at("sensors").get<int>(), 3);
    QCOMPARE(json.at("done").get<int>(), 1);
    QCOMPARE(json.at("cautions").get<int>(), 0);
    QCOMPARE(json.at("failed").get<int>(), 1);
    QCOMPARE(json.at("missing").get<int>(), 1);
    QCOMPARE(json.at("not_done").size(), std::size_t(2));
    QCOMPARE(json.at("not_done")[0].at("sensor").get<std::string>(), std::string("f"));
    QCOMPARE(json.at("not_done")[0].at("reason").get<std::string>(), std::string("No file."));
    QVERIFY(!json.at("not_done")[1].contains("reason"));
}

DYNCAL_TEST(TestBatchSummary)
#include "tst_batch_summary.moc"
