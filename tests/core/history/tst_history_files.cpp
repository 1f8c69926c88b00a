// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/history_files.h"
#include "tests/core/history/made_history.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <set>
#include <sstream>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Six years; the second is without U of the sensitivity, the third is a certificate.
SensorHistory sixYears()
{
    std::vector<EarlierCalibration> all;
    for (int year = 2020; year < 2026; ++year) {
        EarlierJson root = madeResults(
            {.day = std::to_string(year) + "-05-01", .sensitivity = 5e-6 + 1e-8 * (year % 2)});
        if (year == 2021)
            root["sensitivity"]["u"] = nullptr;
        all.push_back(
            earlierCalibration({std::to_string(year), root, {}, {}}, year == 2022 ? 31 : 0)
                .value());
    }
    all.push_back(madeCalibration({.day = "2025-05-01"}, "again"));
    return sensorHistory(calibrationsOfSensor(all, {}).value(), {1e4});
}

EarlierJson jsonOf(const SensorHistory &history, const std::vector<UnreadResults> &unread = {})
{
    return EarlierJson::parse(historyJson(history, unread));
}

/// Lines of cells; none of the made texts holds a comma.
std::vector<std::vector<std::string>> cellsOf(const std::string &csv)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        rows.emplace_back();
        line += ',';
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            rows.back().push_back(cell);
    }
    return rows;
}

/// No null without its reason, at any depth.
bool areNullsExplained(const EarlierJson &json)
{
    for (const auto &[key, value] : json.items()) {
        if (value.is_structured() ? !areNullsExplained(value)
                                  : value.is_null() && !json.contains(key + "_reason"))
            return false;
    }
    return true;
}

} // namespace

/// The history as JSON and as a table.
class TestHistoryFiles : public QObject
{
    Q_OBJECT

private slots:
    void json_holdsPointsAndSeries();
    void json_hasTheNumbersOfTheHistory();
    void everyNull_hasItsReason();
    void leftOutAndUnread_areNamed();
    void csv_hasALineForEveryValue();
    void csv_hasTheNumbersOfTheHistory();
    void missingValue_isAnEmptyCellWithItsReason();
    void hostileTexts_stayCells();
};

void TestHistoryFiles::json_holdsPointsAndSeries()
{
    const EarlierJson root = jsonOf(sixYears());
    QCOMPARE(root["schema"].get<std::string>(), std::string("dyncal-history/1"));
    QCOMPARE(root["sensor"].get<std::string>(), std::string("17"));
    QCOMPARE(root["points"].size(), std::size_t(6));
    QCOMPARE(root["points"][0]["time"].get<std::string>(), std::string("2020-05-01"));
    QCOMPARE(root["points"][0]["time_of"].get<std::string>(), std::string("calibration"));
    QVERIFY(root["points"][0]["certificate"].is_null());
    QCOMPARE(root["points"][2]["certificate"].get<int>(), 31);
    QCOMPARE(root["points"][2]["file"].get<std::string>(), std::string("2022"));
    QCOMPARE(root["series"].size(), std::size_t(5));
    for (const EarlierJson &series : root["series"])
        QCOMPARE(series["values"].size(), std::size_t(6));
    QVERIFY(!root["assumptions"].empty());
}

void TestHistoryFiles::json_hasTheNumbersOfTheHistory()
{
    const SensorHistory history = sixYears();
    const HistorySeries &series = history.series[2];
    const EarlierJson json = jsonOf(history)["series"][2];
    QCOMPARE(json["quantity"].get<std::string>(), std::string("sensitivity"));
    QCOMPARE(json["unit"].get<std::string>(), std::string("V/Pa"));
    const EarlierJson &last = json["values"][5];
    QCOMPARE(last["value"].get<double>(), 5.01e-6);
    QCOMPARE(last["u"].get<double>(), 5e-8);
    QCOMPARE(last["k"].get<double>(), 2.0);
    QCOMPARE(last["u_expanded"].get<double>(), 1e-7);
    QCOMPARE(last["e_n"].get<double>(), series.entries[5].En);
    QCOMPARE(last["e_n_against"].get<int>(), 4);
    QCOMPARE(last["control_state"].get<std::string>(), std::string("inside"));
    QCOMPARE(json["limits"]["sigma"].get<double>(), series.limits->sigma);
    QCOMPARE(json["limits"]["action_high"].get<double>(), series.limits->actionHigh());
    QCOMPARE(json["drift"]["per_year"].get<double>(), series.drift->perYear);
    QCOMPARE(json["drift"]["u"].get<double>(), series.drift->u);
    QCOMPARE(json["drift"]["u_expanded"].get<double>(), series.drift->U());
    QCOMPARE(json["drift"]["calibrations"].get<int>(), 5);
    QCOMPARE(jsonOf(history)["series"][3]["frequency_hz"].get<double>(), 1e4);
}

void TestHistoryFiles::everyNull_hasItsReason()
{
    QVERIFY(areNullsExplained(jsonOf(sixYears())));
    QVERIFY(areNullsExplained(jsonOf(sensorHistory(
        calibrationsOfSensor({madeCalibration({.day = "2025-01-01"})}, {}).value(), {7e6}))));
    QVERIFY(areNullsExplained(jsonOf(sensorHistory({.serial = "17"}, {}))));
}

void TestHistoryFiles::leftOutAndUnread_areNamed()
{
    const EarlierJson root = jsonOf(sixYears(), {{"damaged.json", "It is damaged."}});
    QCOMPARE(root["left_out"].size(), std::size_t(1));
    QCOMPARE(root["left_out"][0]["file"].get<std::string>(), std::string("again"));
    QVERIFY(root["left_out"][0]["reason"].get<std::string>().find("2025") != std::string::npos);
    QCOMPARE(root["unread"][0]["file"].get<std::string>(), std::string("damaged.json"));
    QCOMPARE(root["unread"][0]["reason"].get<std::string>(), std::string("It is damaged."));
}

void TestHistoryFiles::csv_hasALineForEveryValue()
{
    const auto rows = cellsOf(historyCsv(sixYears()));
    QCOMPARE(rows.size(), std::size_t(1 + 5 * 6));
    for (const auto &row : rows)
        QCOMPARE(row.size(), rows[0].size());
    QCOMPARE(rows[0][0], std::string("quantity"));
    QCOMPARE(rows[1][0], std::string("f0_hz"));
    QCOMPARE(rows[30][0], std::string("phase_rad"));
    QCOMPARE(rows[30][1], std::string("10000"));
    QCOMPARE(std::set(rows[0].begin(), rows[0].end()).size(), rows[0].size());
}

void TestHistoryFiles::csv_hasTheNumbersOfTheHistory()
{
    const SensorHistory history = sixYears();
    const auto rows = cellsOf(historyCsv(history));
    const auto cell = [&](std::size_t row, const char *name) {
        const auto at = std::ranges::find(rows[0], name) - rows[0].begin();
        return rows[row][static_cast<std::size_t>(at)];
    };
    for (std::size_t i = 0; i < 6; ++i) {
        const HistorySeries &series = history.series[2];
        const std::size_t row = 13 + i;
        QCOMPARE(std::stod(cell(row, "value")), series.entries[i].stated.value);
        QCOMPARE(std::stod(cell(row, "mean")), series.limits->mean);
        QCOMPARE(std::stod(cell(row, "warning_low")), series.limits->warningLow());
        QCOMPARE(std::stod(cell(row, "drift_per_year")), series.drift->perYear);
        QCOMPARE(cell(row, "time"), history.sensor.points[i].time);
        QCOMPARE(cell(row, "file"), history.sensor.points[i].file);
    }
    QCOMPARE(cell(15, "certificate"), std::string("31"));
    QCOMPARE(std::stod(cell(18, "e_n")), history.series[2].entries[5].En);
    QCOMPARE(std::stod(cell(18, "u_expanded")), 1e-7);
}

void TestHistoryFiles::missingValue_isAnEmptyCellWithItsReason()
{
    const auto rows = cellsOf(historyCsv(sixYears()));
    const std::vector<std::string> &second = rows[14]; // sensitivity of 2021
    QCOMPARE(second[5], std::string("5.01e-06"));
    for (const std::size_t i : {6, 7, 8, 9})
        QCOMPARE(second[i], std::string());
    QCOMPARE(second[18], std::string()); // methods as before
    QCOMPARE(second[19], std::string("These results state no uncertainty of it."));
}

/// No formula, no second line, no second cell.
void TestHistoryFiles::hostileTexts_stayCells()
{
    const auto one
        = madeCalibration({.day = "2025-01-01", .serial = "=1+1"}, "=cmd|' /C calc'!A0\n");
    const SensorHistory history = sensorHistory(calibrationsOfSensor({one}, {}).value(), {});
    const std::string csv = historyCsv(history);
    QCOMPARE(std::ranges::count(csv, '\n'), 4);
    QVERIFY(csv.find(",=cmd") == std::string::npos);
    QVERIFY(csv.find("'=cmd") != std::string::npos);
    QCOMPARE(jsonOf(history)["sensor"].get<std::string>(), std::string("=1+1"));
}

DYNCAL_TEST(TestHistoryFiles)
#include "tst_history_files.moc"
