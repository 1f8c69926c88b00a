// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/history_files.h"

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/results/csv_table.h"
#include "core/results/json_record.h"

#include <cmath>

namespace dyncal {
namespace {

using Record = JsonRecord;

constexpr const char *kNotOverFrequency = "It is of no frequency.";
constexpr const char *kNothingChanged = "As at the calibration before, or there is none before.";

std::string orElse(const std::string &reason, const char *otherwise)
{
    return reason.empty() ? otherwise : reason;
}

Record::Json textsOf(const std::vector<Message> &messages)
{
    Record::Json list = Record::Json::array();
    for (const Message &one : messages)
        list.push_back(english(one));
    return list;
}

void setCertificate(Record &record, Index number)
{
    if (number > 0)
        record.set("certificate", number);
    else
        record.missing("certificate", "No manifest of a certificate lies beside these results.");
}

Record::Json pointJson(const EarlierCalibration &point, const std::string &methodChanges)
{
    Record record;
    record.set("file", point.file);
    setCertificate(record, point.number);
    record.set("time", point.time);
    record.set("time_of", point.isDayOfCalibration ? "calibration" : "results");
    record.text("created_utc", point.createdUtc, "The results state none.");
    if (point.dcc.version.empty())
        record.missing("dcc", "It is read from a results.json.");
    else
        record.set("dcc",
            Record::Json{{"number", point.dcc.number}, {"laboratory", point.dcc.laboratory},
                {"version", point.dcc.version}});
    record.text("methods_changed", methodChanges, kNothingChanged);
    record.text("blocked", point.blocked, "Nothing blocks.");
    record.set("remarks", textsOf(point.remarks));
    return record.take();
}

Record::Json entryJson(const SeriesEntry &entry)
{
    const FollowedValue &stated = entry.stated;
    const std::string whyNoU = orElse(stated.missing, "Not stated.");
    Record record;
    record.number("value", stated.value, whyNoU);
    record.number("u", stated.u, whyNoU);
    record.number("k", stated.k, whyNoU);
    record.number("u_expanded", stated.U(), whyNoU);
    record.text("unit", stated.unit, orElse(stated.missing, "The results state no unit."));
    record.number("e_n", entry.En, entry.whyNoEn);
    if (entry.before >= 0)
        record.set("e_n_against", entry.before);
    else
        record.missing("e_n_against", entry.whyNoEn);
    record.text("control_state", entry.state ? controlStateName(*entry.state) : "",
        "There are no limits, or the value takes no part.");
    return record.take();
}

Record::Json limitsJson(const ControlLimits &limits)
{
    return {{"mean", limits.mean}, {"sigma", limits.sigma}, {"warning_low", limits.warningLow()},
        {"warning_high", limits.warningHigh()}, {"action_low", limits.actionLow()},
        {"action_high", limits.actionHigh()}};
}

Record::Json driftJson(const YearlyDrift &drift)
{
    return {{"per_year", drift.perYear}, {"u", drift.u}, {"k", drift.k}, {"u_expanded", drift.U()},
        {"birge_ratio", drift.birge}, {"calibrations", drift.count}};
}

Record::Json seriesJson(const HistorySeries &series)
{
    const FollowedQuantity &quantity = series.quantity;
    const std::string whyNoRow = quantity.isOverFrequency()
        ? "No results have a row within 3 % of it."
        : kNotOverFrequency;
    Record record;
    record.set("quantity", quantity.name());
    record.number("asked_hz", quantity.asked_Hz, kNotOverFrequency);
    record.number("frequency_hz", quantity.row_Hz, whyNoRow);
    record.text("unit", series.unit, "No calibration states it.");
    Record::Json values = Record::Json::array();
    for (const SeriesEntry &entry : series.entries)
        values.push_back(entryJson(entry));
    record.set("values", std::move(values));
    if (series.limits)
        record.set("limits", limitsJson(*series.limits));
    else
        record.missing("limits", series.whyNoLimits);
    if (series.drift)
        record.set("drift", driftJson(*series.drift));
    else
        record.missing("drift", series.whyNoDrift);
    return record.take();
}

Record::Json leftOutJson(const LeftOutCalibration &one)
{
    Record record;
    record.set("file", one.file);
    setCertificate(record, one.number);
    record.set("why", leftOutName(one.why));
    record.set("reason", one.reason);
    return record.take();
}

Record::Json unreadJson(const std::vector<UnreadResults> &unread)
{
    Record::Json list = Record::Json::array();
    for (const UnreadResults &one : unread)
        list.push_back({{"file", one.file}, {"reason", one.reason}});
    return list;
}

/// A row of a table, cell by cell.
class CsvRow
{
public:
    void add(const std::string &text)
    {
        m_text += (m_isEmpty ? "" : ",") + csvCell(text);
        m_isEmpty = false;
    }
    void add(double value) { add(std::isfinite(value) ? numberText(value) : std::string()); }
    std::string text() const { return m_text + '\n'; }

private:
    std::string m_text;
    bool m_isEmpty = true;
};

std::string csvHead()
{
    CsvRow row;
    for (const char *name : {"quantity", "frequency_hz", "unit", "time", "certificate", "value",
             "u", "k", "u_expanded", "e_n", "control_state", "mean", "warning_low", "warning_high",
             "action_low", "action_high", "drift_per_year", "u_drift_per_year", "methods_changed",
             "reason", "file"})
        row.add(std::string(name));
    return row.text();
}

void addStated(CsvRow &row, const EarlierCalibration &point, const SeriesEntry &entry)
{
    const FollowedValue &stated = entry.stated;
    row.add(stated.unit);
    row.add(point.time);
    row.add(point.number > 0 ? std::to_string(point.number) : std::string());
    for (const double value : {stated.value, stated.u, stated.k, stated.U(), entry.En})
        row.add(value);
    row.add(std::string(entry.state ? controlStateName(*entry.state) : ""));
}

void addOfSeries(CsvRow &row, const HistorySeries &series)
{
    const ControlLimits limits = series.limits.value_or(ControlLimits());
    const YearlyDrift drift = series.drift.value_or(YearlyDrift());
    for (const double value : {limits.mean, limits.warningLow(), limits.warningHigh(),
             limits.actionLow(), limits.actionHigh(), drift.perYear, drift.u})
        row.add(value);
}

std::string csvRow(const SensorHistory &history, const HistorySeries &series, std::size_t i)
{
    const EarlierCalibration &point = history.sensor.points[i];
    const SeriesEntry &entry = series.entries[i];
    CsvRow row;
    row.add(std::string(series.quantity.name()));
    row.add(series.quantity.row_Hz);
    addStated(row, point, entry);
    addOfSeries(row, series);
    row.add(history.methodChanges[i]);
    row.add(entry.stated.missing);
    row.add(point.file);
    return row.text();
}

} // namespace

std::string historyJson(const SensorHistory &history, const std::vector<UnreadResults> &unread)
{
    Record record;
    record.set("schema", "dyncal-history/1");
    record.set("sensor", history.sensor.serial);
    record.set("assumptions", historyAssumptions());
    Record::Json points = Record::Json::array(), series = points, leftOut = points;
    for (std::size_t i = 0; i < history.sensor.points.size(); ++i)
        points.push_back(pointJson(history.sensor.points[i], history.methodChanges[i]));
    for (const HistorySeries &one : history.series)
        series.push_back(seriesJson(one));
    for (const LeftOutCalibration &one : history.sensor.leftOut)
        leftOut.push_back(leftOutJson(one));
    record.set("points", std::move(points));
    record.set("series", std::move(series));
    record.set("left_out", std::move(leftOut));
    record.set("unread", unreadJson(unread));
    return jsonText(record.take());
}

std::string sensorsJson(
    const std::vector<CalibrationCount> &sensors, const std::vector<UnreadResults> &unread)
{
    Record::Json list = Record::Json::array();
    for (const CalibrationCount &one : sensors)
        list.push_back({{"serial", one.serial}, {"calibrations", one.calibrations}});
    return jsonText({{"schema", "dyncal-history-sensors/1"}, {"sensors", std::move(list)},
        {"unread", unreadJson(unread)}});
}

std::string historyCsv(const SensorHistory &history)
{
    std::string text = csvHead();
    for (const HistorySeries &series : history.series)
        for (std::size_t i = 0; i < series.entries.size(); ++i)
            text += csvRow(history, series, i);
    return text;
}

} // namespace dyncal
