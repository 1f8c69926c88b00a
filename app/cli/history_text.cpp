// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/history_text.h"

#include "app/cli/columns_text.h"
#include "app/cli/spoken.h"

#include "core/base/calendar_date.h"
#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"

#include <cmath>

namespace dyncal {
namespace {

using Line = std::vector<std::string>;

constexpr const char *kNone = "-";
constexpr int kDigitsOfRatio = 3;
constexpr int kDigitsOfRow = 6;

/// The day alone where the moment is that of the results.
std::string dayOf(const EarlierCalibration &point)
{
    return dayOfMoment(point.time);
}

/// Its number: of the registry, or as a certificate that was read states it.
std::string certificateOf(const EarlierCalibration &point)
{
    if (point.number > 0)
        return std::to_string(point.number);
    return point.dcc.number.empty() ? kNone : presentableInBrief(point.dcc.number);
}

std::string pointsText(const SensorHistory &history)
{
    std::vector<Line> lines{{"", "day", "of", "certificate", "methods changed", "results"}};
    for (std::size_t i = 0; i < history.sensor.points.size(); ++i) {
        const EarlierCalibration &point = history.sensor.points[i];
        lines.push_back({std::to_string(i + 1), dayOf(point),
            point.isDayOfCalibration ? "calibration" : "results", certificateOf(point),
            history.methodChanges[i].empty() ? kNone : presentableInBrief(history.methodChanges[i]),
            presentableInBrief(point.file)});
    }
    return columnsText(lines);
}

std::string remarksText(const SensorHistory &history)
{
    std::string text;
    for (std::size_t i = 0; i < history.sensor.points.size(); ++i) {
        const EarlierCalibration &point = history.sensor.points[i];
        for (const Message &remark : point.remarks)
            text += std::to_string(i + 1) + ": " + presentable(spoken(remark)) + '\n';
    }
    for (const LeftOutCalibration &one : history.sensor.leftOut)
        text += "left out " + presentable(calibrationName(one.number, one.file)) + ": "
            + presentable(one.reason) + '\n';
    return text;
}

std::string titleOf(const HistorySeries &series)
{
    const FollowedQuantity &quantity = series.quantity;
    const std::string name = quantity.name();
    if (!quantity.isOverFrequency())
        return name;
    const double f_Hz = std::isfinite(quantity.row_Hz) ? quantity.row_Hz : quantity.asked_Hz;
    return name + " at " + numberWithUnit(f_Hz, "Hz", kDigitsOfRow);
}

std::string numberOrNone(double value, int digits)
{
    return std::isfinite(value) ? numberText(value, digits) : kNone;
}

/// For print, where a number has none.
std::string unitOf(const std::string &unit)
{
    return unit == "1" ? std::string() : presentableInBrief(unit);
}

Line cellsOf(const SeriesEntry &entry)
{
    const FollowedValue &stated = entry.stated;
    if (!std::isfinite(stated.value))
        return {kNone, kNone, kNone, kNone, kNone};
    const std::string unit = unitOf(stated.unit);
    return {roundedText(stated.value, stated.U(), unit),
        std::isfinite(stated.u) ? numberWithUnit(stated.U(), unit, 2) : kNone,
        numberOrNone(stated.k, kDigitsOfRatio), numberOrNone(entry.En, 2),
        entry.state ? controlStateName(*entry.state) : kNone};
}

Line lineOf(std::size_t i, const EarlierCalibration &point, const SeriesEntry &entry)
{
    Line line{std::to_string(i + 1), dayOf(point)};
    for (const std::string &cell : cellsOf(entry))
        line.push_back(cell);
    if (!entry.stated.missing.empty())
        line.push_back(presentableInBrief(entry.stated.missing));
    return line;
}

std::string limitsText(const HistorySeries &series)
{
    if (!series.limits)
        return "  limits: none. " + series.whyNoLimits + '\n';
    const ControlLimits &limits = *series.limits;
    const auto at
        = [&](double value) { return roundedText(value, limits.sigma, unitOf(series.unit)); };
    return "  limits: mean " + at(limits.mean) + ", warning " + at(limits.warningLow()) + " to "
        + at(limits.warningHigh()) + ", action " + at(limits.actionLow()) + " to "
        + at(limits.actionHigh()) + '\n';
}

std::string driftText(const HistorySeries &series)
{
    if (!series.drift)
        return "  drift: none. " + series.whyNoDrift + '\n';
    const YearlyDrift &drift = *series.drift;
    return "  drift in a year: " + roundedTextWithU(drift.perYear, drift.u, unitOf(series.unit))
        + ", k = " + numberText(drift.k, kDigitsOfRatio) + ", of " + std::to_string(drift.count)
        + " calibrations\n";
}

std::string seriesText(const SensorHistory &history, const HistorySeries &series)
{
    const FollowedQuantity &quantity = series.quantity;
    if (quantity.isOverFrequency() && !std::isfinite(quantity.row_Hz))
        return '\n' + titleOf(series) + "\n  No results have a row within 3 % of it.\n";
    std::vector<Line> lines{{"", "day", "value", "U", "k", "E_n", "chart"}};
    for (std::size_t i = 0; i < series.entries.size(); ++i)
        lines.push_back(lineOf(i, history.sensor.points[i], series.entries[i]));
    return '\n' + titleOf(series) + '\n' + columnsText(lines) + limitsText(series)
        + driftText(series);
}

} // namespace

std::string historyText(const SensorHistory &history)
{
    std::string text = "Sensor " + presentableInBrief(history.sensor.serial) + "\n\n"
        + pointsText(history) + remarksText(history);
    for (const HistorySeries &series : history.series)
        text += seriesText(history, series);
    text += '\n';
    for (const std::string &sentence : historyAssumptions())
        text += sentence + '\n';
    return text;
}

} // namespace dyncal
