// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/calendar_date.h"
#include "core/history/sensor_history.h"
#include "tests/core/history/made_history.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Change = std::function<void(EarlierJson &)>;

/// One calibration at the beginning of every year from 2020 on, each with its change.
SensorHistory historyOf(const std::vector<Change> &changes, const std::vector<double> &at_Hz = {})
{
    std::vector<EarlierCalibration> all;
    for (const Change &change : changes) {
        const std::string year = std::to_string(2020 + all.size());
        EarlierJson root = madeResults({.day = year + "-01-01"});
        if (change)
            change(root);
        all.push_back(earlierCalibration({year, root, {}, {}}).value());
    }
    return sensorHistory(calibrationsOfSensor(all, {}).value(), at_Hz);
}

/// Sensitivities, u as made: 5e-8, k = 2.
SensorHistory ofSensitivities(const std::vector<double> &values)
{
    std::vector<Change> changes;
    for (const double value : values)
        changes.push_back([value](EarlierJson &root) { root["sensitivity"]["value"] = value; });
    return historyOf(changes);
}

const HistorySeries &sensitivityOf(const SensorHistory &history)
{
    return history.series.at(2);
}

Change set(const char *section, const char *key, const EarlierJson &value)
{
    return [=](EarlierJson &root) { root[section][key] = value; };
}

bool contains(const std::string &text, const char *words)
{
    return text.find(words) != std::string::npos;
}

std::string statesOf(const HistorySeries &series)
{
    std::string text;
    for (const SeriesEntry &entry : series.entries)
        text += entry.state ? std::string(controlStateName(*entry.state)).substr(0, 1) : "-";
    return text;
}

} // namespace

/// The series of a sensor: what stands beside what, and what cannot.
class TestSensorHistory : public QObject
{
    Q_OBJECT

private slots:
    void series_areTheKeyResultsAndTheFrequencies();
    void error_isAgainstTheOneBefore();
    void valueWithoutU_isPassedOver();
    void notStated_isPassedOverWithItsReason();
    void blockedPoint_statesNothing();
    void otherUnit_takesNoPart();
    void limits_beginWithFiveCalibrations();
    void valueWithoutU_countsForTheLimits();
    void outlier_isConspicuous();
    void straightLine_isTheDriftPerYear();
    void drift_needsThreeWithU();
    void oneMoment_hasNoDrift();
    void phase_isCountedToTheNearestTurn();
    void rows_areComparedAtOneFrequencyOnly();
    void frequencyWithoutRow_isSaid();
    void methods_areNamedWhereTheyChange();
    void assumptions_sayWhatIsShared();
    void nothing_isNoFault();
};

void TestSensorHistory::series_areTheKeyResultsAndTheFrequencies()
{
    const SensorHistory history = historyOf({{}, {}}, {1e3, 1e5});
    std::string names;
    for (const HistorySeries &series : history.series) {
        names += std::string(series.quantity.name()) + ' ';
        QCOMPARE(series.entries.size(), std::size_t(2));
    }
    QCOMPARE(names,
        std::string("f0_hz damping_ratio sensitivity magnitude phase_rad magnitude phase_rad "));
    QCOMPARE(history.series[0].unit, std::string("Hz"));
    QCOMPARE(sensitivityOf(history).unit, std::string("V/Pa"));
    QCOMPARE(history.series[5].quantity.row_Hz, 1e5);
    QCOMPARE(history.series[5].entries[1].position, 5.5e-6);
    QVERIFY(!history.isConspicuous());
}

/// U = 1e-7 each: (5.1 - 5.0)/(0.1 sqrt(2)).
void TestSensorHistory::error_isAgainstTheOneBefore()
{
    const SensorHistory history = ofSensitivities({5.0e-6, 5.1e-6, 4.9e-6});
    const auto &entries = sensitivityOf(history).entries;
    QVERIFY(std::isnan(entries[0].En));
    QVERIFY(contains(entries[0].whyNoEn, "No calibration before"));
    QCOMPARE(entries[0].before, Index(-1));
    QVERIFY(isNear(entries[1].En, 1.0 / std::sqrt(2.0)));
    QVERIFY(isNear(entries[2].En, -std::sqrt(2.0)));
    QCOMPARE(entries[1].before, Index(0));
    QCOMPARE(entries[2].before, Index(1));
    QVERIFY(sensitivityOf(history).isConspicuous());
    QVERIFY(!history.series[0].isConspicuous());
    QVERIFY(history.isConspicuous());
}

void TestSensorHistory::valueWithoutU_isPassedOver()
{
    const SensorHistory history
        = historyOf({{}, set("sensitivity", "u", nullptr), set("sensitivity", "u", 0.0), {}});
    const auto &entries = sensitivityOf(history).entries;
    for (const std::size_t i : {1, 2}) {
        QVERIFY(std::isnan(entries[i].En));
        QVERIFY(contains(entries[i].whyNoEn, "does not state it with an uncertainty"));
        QCOMPARE(entries[i].position, 5e-6);
    }
    QCOMPARE(entries[3].En, 0.0);
    QCOMPARE(entries[3].before, Index(0));
}

void TestSensorHistory::notStated_isPassedOverWithItsReason()
{
    const SensorHistory history = historyOf({{}, set("sensitivity", "value", nullptr), {}});
    const auto &entries = sensitivityOf(history).entries;
    QVERIFY(std::isnan(entries[1].position));
    QVERIFY(contains(entries[1].whyNoEn, "Not stated"));
    QVERIFY(contains(entries[1].stated.missing, "Not determined"));
    QCOMPARE(entries[2].before, Index(0));
    QVERIFY(!entries[1].state);
}

void TestSensorHistory::blockedPoint_statesNothing()
{
    const auto block = [](EarlierJson &root) {
        root["findings"] = {{{"id", "SHK-001"}, {"severity", "block"}, {"message", "No step."}}};
        root["response"]["frequency_hz"] = {1e3, 1.01e4, 1e5};
    };
    const SensorHistory history = historyOf({{}, block}, {1.01e4});
    for (const HistorySeries &series : history.series) {
        QVERIFY(std::isnan(series.entries[1].stated.value));
        QCOMPARE(series.entries[1].stated.missing, std::string("Blocked: SHK-001: No step."));
    }
    QCOMPARE(history.series[3].quantity.row_Hz, 1e4); // nor does it choose a row
}

void TestSensorHistory::otherUnit_takesNoPart()
{
    const SensorHistory history
        = historyOf({set("sensitivity", "unit", "pC/Pa"), {}, {}, {}, {}, {}});
    const HistorySeries &series = sensitivityOf(history);
    QCOMPARE(series.unit, std::string("V/Pa"));
    QVERIFY(std::isnan(series.entries[0].position));
    QVERIFY(contains(series.entries[0].whyNoEn, "stated in pC/Pa and the newest in V/Pa"));
    QCOMPARE(series.entries[0].stated.value, 5e-6); // it is shown
    QCOMPARE(series.entries[1].before, Index(-1));
    QCOMPARE(statesOf(series), std::string("-iiiii"));
    QCOMPARE(series.drift->count, Index(5));
}

void TestSensorHistory::limits_beginWithFiveCalibrations()
{
    const SensorHistory four = ofSensitivities({5e-6, 6e-6, 5e-6, 6e-6});
    QVERIFY(!sensitivityOf(four).limits);
    QVERIFY(contains(
        sensitivityOf(four).whyNoLimits, "Limits need at least 5 calibrations; 4 state it."));
    QCOMPARE(statesOf(sensitivityOf(four)), std::string("----"));
    const SensorHistory five = ofSensitivities({5e-6, 6e-6, 5e-6, 6e-6, 5e-6});
    QCOMPARE(sensitivityOf(five).whyNoLimits, std::string());
    QVERIFY(isNear(sensitivityOf(five).limits->mean, 5.4e-6));
    QVERIFY(isNear(sensitivityOf(five).limits->sigma, 1e-6 * std::sqrt(std::acos(-1.0)) / 2.0));
    QCOMPARE(statesOf(sensitivityOf(five)), std::string("iiiii"));
}

void TestSensorHistory::valueWithoutU_countsForTheLimits()
{
    const SensorHistory history = historyOf({{}, set("sensitivity", "u", nullptr), {}, {}, {}});
    QVERIFY(sensitivityOf(history).limits.has_value());
    QCOMPARE(sensitivityOf(history).drift->count, Index(4));
}

void TestSensorHistory::outlier_isConspicuous()
{
    const SensorHistory history
        = ofSensitivities({5.0e-6, 5.01e-6, 4.99e-6, 5.0e-6, 5.01e-6, 5.1e-6});
    QCOMPARE(statesOf(sensitivityOf(history)), std::string("iiiiia"));
    QVERIFY(std::abs(sensitivityOf(history).entries[5].En) < 1.0);
    QVERIFY(history.isConspicuous());
}

void TestSensorHistory::straightLine_isTheDriftPerYear()
{
    std::vector<Change> changes;
    for (const char *day : {"2020-01-01", "2021-06-30", "2022-01-01", "2024-02-29"}) {
        const double year = *daysSince1970(day) / kDaysOfYear;
        changes.push_back([day, year](EarlierJson &root) {
            root["recipe"]["certificate"]["fields"]["date_performed"] = day;
            root["sensitivity"]["value"] = 5e-6 + 2e-8 * (year - 50.0);
        });
    }
    const SensorHistory history = historyOf(changes);
    const YearlyDrift drift = sensitivityOf(history).drift.value();
    QVERIFY(isNear(drift.perYear, 2e-8, 1e-8));
    QVERIFY(drift.birge < 1e-6);
    QCOMPARE(drift.k, 2.0);
    QCOMPARE(drift.count, Index(4));
    QCOMPARE(sensitivityOf(history).whyNoDrift, std::string());
    QVERIFY(std::abs(history.series[0].drift->perYear) < 1e-6); // f0 stayed
}

void TestSensorHistory::drift_needsThreeWithU()
{
    const SensorHistory history = historyOf({{}, {}, set("sensitivity", "u", nullptr)});
    QVERIFY(!sensitivityOf(history).drift);
    QVERIFY(contains(sensitivityOf(history).whyNoDrift, "at least 3 calibrations; 2 state it."));
    QVERIFY(history.series[0].drift.has_value());
    const SensorHistory alone = historyOf({{}});
    QVERIFY(contains(sensitivityOf(alone).whyNoDrift, "; 1 states it."));
}

void TestSensorHistory::oneMoment_hasNoDrift()
{
    int recording = 0;
    const auto sameDay = [&recording](EarlierJson &root) {
        root["recipe"]["certificate"]["fields"]["date_performed"] = "2020-01-01";
        root["inputs"][0]["sha256"] = std::to_string(recording++);
    };
    const SensorHistory history = historyOf({sameDay, sameDay, sameDay});
    QCOMPARE(sensitivityOf(history).whyNoDrift, std::string("All calibrations are of one moment."));
}

void TestSensorHistory::phase_isCountedToTheNearestTurn()
{
    const auto phase = [](double value) {
        return [value](EarlierJson &root) { root["response"]["phase_rad"][2] = value; };
    };
    const SensorHistory history
        = historyOf({phase(-3.1), phase(3.15), phase(-3.14), phase(3.1), phase(3.14)}, {1e5});
    const HistorySeries &series = history.series[4];
    const double turn = 2.0 * std::acos(-1.0);
    QVERIFY(isNear(series.entries[1].position, 3.15 - turn));
    QVERIFY(isNear(series.entries[3].position, 3.1 - turn));
    QVERIFY(isNear(series.entries[1].En, (3.15 - turn + 3.1) / (0.04 * std::sqrt(2.0)), 1e-9));
    QVERIFY(series.limits->sigma < 0.1);
    QCOMPARE(series.entries[1].stated.value, 3.15); // as stated
}

void TestSensorHistory::rows_areComparedAtOneFrequencyOnly()
{
    const auto moved = [](EarlierJson &root) {
        root["response"]["frequency_hz"] = {1e3, 1.002e4, 1e5};
    };
    const SensorHistory history = historyOf({{}, moved, {}}, {9.9e3});
    const HistorySeries &magnitude = history.series[3];
    QCOMPARE(magnitude.quantity.row_Hz, 1e4);
    QVERIFY(std::isnan(magnitude.entries[1].stated.value));
    QVERIFY(contains(magnitude.entries[1].stated.missing, "no row at 10 kHz"));
    QCOMPARE(magnitude.entries[2].before, Index(0));
}

void TestSensorHistory::frequencyWithoutRow_isSaid()
{
    const SensorHistory history = historyOf({{}, {}}, {5e6});
    QVERIFY(std::isnan(history.series[3].quantity.row_Hz));
    for (const SeriesEntry &entry : history.series[3].entries)
        QVERIFY(contains(entry.stated.missing, "within 3 % of 5 MHz"));
}

void TestSensorHistory::methods_areNamedWhereTheyChange()
{
    const auto methods = [](const EarlierJson &versions) {
        return [versions](EarlierJson &root) { root["software"]["method"] = versions; };
    };
    const SensorHistory history = historyOf({methods({{"shock", 1}, {"model", 2}}),
        methods({{"shock", 1}, {"model", 2}}), methods({{"shock", 6}, {"model", 2}, {"checks", 4}}),
        methods(nullptr), methods(nullptr)});
    QCOMPARE(history.methodChanges[0], std::string());
    QCOMPARE(history.methodChanges[1], std::string());
    QCOMPARE(history.methodChanges[2], std::string("checks 4 (new), shock 1 -> 6"));
    QCOMPARE(history.methodChanges[3], std::string("versions recorded in one of both only"));
    QCOMPARE(history.methodChanges[4], std::string());
}

void TestSensorHistory::assumptions_sayWhatIsShared()
{
    std::string all;
    for (const std::string &sentence : historyAssumptions())
        all += sentence;
    QVERIFY(contains(all, "the same tube, references and method"));
    QVERIFY(contains(all, "smaller than it would be for independent results"));
    QVERIFY(contains(all, "no tolerance"));
}

void TestSensorHistory::nothing_isNoFault()
{
    const SensorHistory history = sensorHistory({.serial = "17"}, {1e3});
    QCOMPARE(history.series.size(), std::size_t(5));
    QVERIFY(history.series[0].entries.empty());
    QVERIFY(!history.isConspicuous());
}

DYNCAL_TEST(TestSensorHistory)
#include "tst_sensor_history.moc"
