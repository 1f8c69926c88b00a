// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/sensor_history.h"

#include "core/dcc_reading/d_si_unit.h"
#include "core/recheck/method_changes.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr const char *kNoValue = "Not stated in this calibration.";
constexpr const char *kNothingBefore
    = "No calibration before states it with its complete uncertainty.";
constexpr const char *kNoOwnU = "This calibration does not state it with an uncertainty above 0.";

std::string tooFew(const char *what, Index needed, std::size_t found)
{
    return std::string(what) + " at least " + std::to_string(needed) + " calibrations; "
        + std::to_string(found) + (found == 1 ? " states it." : " state it.");
}

std::vector<FollowedQuantity> followed(
    const std::vector<EarlierCalibration> &points, const std::vector<double> &at_Hz)
{
    std::vector<FollowedQuantity> all{{FollowedKind::NaturalFrequency},
        {FollowedKind::DampingRatio}, {FollowedKind::Sensitivity}};
    std::vector<const nlohmann::json *> results;
    for (const EarlierCalibration &point : points)
        if (point.blocked.empty())
            results.push_back(&point.results);
    for (const double f_Hz : at_Hz)
        for (const FollowedKind kind : {FollowedKind::Magnitude, FollowedKind::Phase})
            all.push_back({kind, f_Hz, servingRow_Hz(results, f_Hz)});
    return all;
}

FollowedValue statedBy(const EarlierCalibration &point, const FollowedQuantity &quantity)
{
    if (point.blocked.empty())
        return followedValue(point.results, quantity);
    FollowedValue none;
    none.missing = "Blocked: " + point.blocked;
    return none;
}

std::string newestUnit(const std::vector<SeriesEntry> &entries)
{
    std::string unit;
    for (const SeriesEntry &entry : entries)
        if (std::isfinite(entry.stated.value))
            unit = entry.stated.unit;
    return unit;
}

/// What differs in its prefix only comes in the unit of the newest: a certificate's units have
/// none.
void convertUnits(HistorySeries &series)
{
    for (SeriesEntry &entry : series.entries)
        if (const auto ratio = unitRatio(entry.stated.unit, series.unit); ratio && *ratio != 1.0) {
            entry.stated.value *= *ratio;
            entry.stated.u *= *ratio;
            entry.stated.unit = series.unit;
        }
}

/// A phase is known to a turn: it is counted to the one nearest to the value before.
void setPositions(HistorySeries &series)
{
    double last = kUnknown;
    for (SeriesEntry &entry : series.entries) {
        if (!std::isfinite(entry.stated.value) || entry.stated.unit != series.unit)
            continue;
        const bool isTurned = series.quantity.kind == FollowedKind::Phase && std::isfinite(last);
        entry.position = isTurned ? last + std::remainder(entry.stated.value - last, kTwoPi)
                                  : entry.stated.value;
        last = entry.position;
    }
}

bool hasU(const SeriesEntry &entry)
{
    return std::isfinite(entry.position) && entry.stated.u > 0.0;
}

std::string whyNotCompared(const SeriesEntry &entry, const std::string &unit)
{
    if (!std::isfinite(entry.stated.value))
        return kNoValue;
    if (!std::isfinite(entry.position))
        return "It is stated in " + entry.stated.unit + " and the newest in " + unit + '.';
    return hasU(entry) ? kNothingBefore : kNoOwnU;
}

void setErrors(HistorySeries &series)
{
    Index before = -1;
    for (std::size_t i = 0; i < series.entries.size(); ++i) {
        SeriesEntry &entry = series.entries[i];
        if (hasU(entry) && before >= 0) {
            const SeriesEntry &earlier = series.entries[static_cast<std::size_t>(before)];
            entry.before = before;
            entry.En = normalisedError(
                entry.position, entry.stated.U(), earlier.position, earlier.stated.U());
        } else {
            entry.whyNoEn = whyNotCompared(entry, series.unit);
        }
        before = hasU(entry) ? static_cast<Index>(i) : before;
    }
}

void setLimits(HistorySeries &series)
{
    std::vector<double> values;
    for (const SeriesEntry &entry : series.entries)
        if (std::isfinite(entry.position))
            values.push_back(entry.position);
    series.limits
        = controlLimits(Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values)));
    if (!series.limits) {
        series.whyNoLimits = tooFew("Limits need", kFewestForLimits, values.size());
        return;
    }
    for (SeriesEntry &entry : series.entries)
        if (std::isfinite(entry.position))
            entry.state = controlState(*series.limits, entry.position);
}

void setDrift(HistorySeries &series, const std::vector<EarlierCalibration> &points)
{
    std::vector<double> days, values, u;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!hasU(series.entries[i]))
            continue;
        days.push_back(points[i].day);
        values.push_back(series.entries[i].position);
        u.push_back(series.entries[i].stated.u);
    }
    const auto column = [](const std::vector<double> &list) {
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(list.data(), std::ssize(list)));
    };
    series.drift = yearlyDrift(column(days), column(values), column(u));
    if (!series.drift)
        series.whyNoDrift = std::ssize(values) < kFewestForDrift
            ? tooFew("A drift with its uncertainty needs", kFewestForDrift, values.size())
            : "All calibrations are of one moment.";
}

HistorySeries seriesOf(
    const std::vector<EarlierCalibration> &points, const FollowedQuantity &quantity)
{
    HistorySeries series;
    series.quantity = quantity;
    for (const EarlierCalibration &point : points) {
        series.entries.emplace_back();
        series.entries.back().stated = statedBy(point, quantity);
    }
    series.unit = newestUnit(series.entries);
    convertUnits(series);
    setPositions(series);
    setErrors(series);
    setLimits(series);
    setDrift(series, points);
    return series;
}

std::string changesBetween(const EarlierCalibration &before, const EarlierCalibration &point)
{
    if (!before.methods || !point.methods)
        return before.methods == point.methods ? "" : "versions recorded in one of both only";
    std::string text;
    for (const MethodChange &change : methodChanges(before.methods, *point.methods))
        text += (text.empty() ? "" : ", ") + change.text();
    return text;
}

std::vector<std::string> methodChangesOf(const std::vector<EarlierCalibration> &points)
{
    std::vector<std::string> texts(points.size());
    for (std::size_t i = 1; i < points.size(); ++i)
        texts[i] = changesBetween(points[i - 1], points[i]);
    return texts;
}

} // namespace

bool HistorySeries::isConspicuous() const
{
    return std::ranges::any_of(entries, [](const SeriesEntry &entry) {
        return std::abs(entry.En) > 1.0
            || entry.state.value_or(ControlState::Inside) != ControlState::Inside;
    });
}

bool SensorHistory::isConspicuous() const
{
    return std::ranges::any_of(series, [](const auto &one) { return one.isConspicuous(); });
}

const std::vector<std::string> &historyAssumptions()
{
    static const std::vector<std::string> sentences{
        "E_n is against the calibration before and supposes independent ones: what both share (the same tube, references and method) is in both U and cancels in the difference, so that E_n is smaller than it would be for independent results.",
        "The limits are the mean and 2 and 3 times the standard deviation that follows from the differences of successive values; they show whether the sensor and its calibrations stay alike, and are no tolerance.",
        "The drift is a straight line weighted with the standard uncertainties as if they were independent; nothing is extrapolated.",
        "Withdrawn and replaced certificates are not known here; a registry knows them."};
    return sentences;
}

SensorHistory sensorHistory(SensorCalibrations sensor, const std::vector<double> &at_Hz)
{
    SensorHistory history;
    history.methodChanges = methodChangesOf(sensor.points);
    for (const FollowedQuantity &quantity : followed(sensor.points, at_Hz))
        history.series.push_back(seriesOf(sensor.points, quantity));
    history.sensor = std::move(sensor);
    return history;
}

} // namespace dyncal
