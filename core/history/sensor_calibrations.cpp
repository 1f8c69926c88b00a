// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/sensor_calibrations.h"

#include "core/base/ascii_text.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace dyncal {
namespace {

constexpr std::size_t kMostSerialsNamed = 12;

std::vector<std::string> serialsOf(const std::vector<EarlierCalibration> &all)
{
    std::vector<std::string> serials;
    for (const CalibrationCount &one : sensorsOf(all))
        serials.push_back(one.serial);
    return serials;
}

Result<std::string> chosenSerial(const std::vector<std::string> &there, const std::string &asked)
{
    if (there.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "None of the results states the serial number of its sensor, so they are nobody's history; fill it in on the certificate and repeat the runs."),
                {}});
    if (asked.empty() && there.size() > 1)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The results are of %1 sensors, and a history is of one; choose it by its serial number: %2."),
                {std::to_string(there.size()), commaList(there, kMostSerialsNamed)}});
    if (!asked.empty() && std::ranges::find(there, asked) == there.end())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "None of the results is of a sensor with the serial number %1; there are results of %2."),
                {asked, commaList(there, kMostSerialsNamed)}});
    return asked.empty() ? there.front() : asked;
}

/// What counts more comes last.
auto standing(const EarlierCalibration &one)
{
    return std::tuple(one.blocked.empty(), std::string_view(one.createdUtc), one.number);
}

bool isFromSameRecordings(const EarlierCalibration &a, const EarlierCalibration &b)
{
    return !a.recordings.empty() && a.recordings == b.recordings;
}

/// The one that stands for all results from the same recordings: of those equal in all that counts
/// the first.
const EarlierCalibration &standingFor(
    const EarlierCalibration &one, const std::vector<EarlierCalibration> &all)
{
    const EarlierCalibration *best = nullptr;
    for (const EarlierCalibration &other : all) {
        const bool competes = &other == &one || isFromSameRecordings(one, other);
        if (competes && (!best || standing(*best) < standing(other)))
            best = &other;
    }
    return *best;
}

std::string ofSameRecordings(const EarlierCalibration &counts)
{
    return "The same recordings are in " + calibrationName(counts.number, counts.file)
        + ", which is newer or not blocked and counts.";
}

/// Names of those that stand for others, before anything is moved.
std::vector<std::string> reasonsToLeaveOut(const std::vector<EarlierCalibration> &all)
{
    std::vector<std::string> reasons;
    for (const EarlierCalibration &one : all) {
        const EarlierCalibration &counts = standingFor(one, all);
        reasons.push_back(&counts == &one ? std::string() : ofSameRecordings(counts));
    }
    return reasons;
}

bool isEarlier(const EarlierCalibration &a, const EarlierCalibration &b)
{
    return std::tie(a.day, a.createdUtc, a.number) < std::tie(b.day, b.createdUtc, b.number);
}

/// Those of one sensor that count; what states no serial number and what is not in force is left
/// out.
std::vector<EarlierCalibration> ofSensor(
    std::vector<EarlierCalibration> all, SensorCalibrations &sensor)
{
    std::vector<EarlierCalibration> own;
    for (EarlierCalibration &one : all) {
        if (one.serial.empty())
            sensor.leftOut.push_back({one.file, one.number, LeftOutFor::NoSerial,
                one.whyNoSerial.empty() ? "It states no serial number of its sensor."
                                        : one.whyNoSerial});
        else if (one.serial == sensor.serial && !one.notInForce.empty())
            sensor.leftOut.push_back(
                {one.file, one.number, LeftOutFor::NotInForce, one.notInForce});
        else if (one.serial == sensor.serial)
            own.push_back(std::move(one));
    }
    return own;
}

} // namespace

const char *leftOutName(LeftOutFor why)
{
    switch (why) {
    case LeftOutFor::SameRecordings:
        return "same_recordings";
    case LeftOutFor::NotInForce:
        return "not_in_force";
    case LeftOutFor::NotUnderstood:
        return "not_understood";
    case LeftOutFor::NoSerial:
        break;
    }
    return "no_serial";
}

std::vector<CalibrationCount> sensorsOf(const std::vector<EarlierCalibration> &all)
{
    std::map<std::string, Index> counts;
    for (const EarlierCalibration &one : all)
        if (!one.serial.empty())
            ++counts[one.serial];
    std::vector<CalibrationCount> sensors;
    for (const auto &[serial, calibrations] : counts)
        sensors.push_back({serial, calibrations});
    return sensors;
}

std::string calibrationName(Index number, const std::string &file)
{
    return number > 0 ? "certificate " + std::to_string(number) + " (" + file + ')' : file;
}

Result<SensorCalibrations> calibrationsOfSensor(
    std::vector<EarlierCalibration> all, const std::string &serial)
{
    const Result<std::string> chosen = chosenSerial(serialsOf(all), std::string(trimmed(serial)));
    if (!chosen)
        return tl::unexpected<Error>(chosen.error());
    SensorCalibrations sensor{.serial = *chosen};
    std::vector<EarlierCalibration> own = ofSensor(std::move(all), sensor);
    const std::vector<std::string> reasons = reasonsToLeaveOut(own);
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (reasons[i].empty())
            sensor.points.push_back(std::move(own[i]));
        else
            sensor.leftOut.push_back(
                {own[i].file, own[i].number, LeftOutFor::SameRecordings, reasons[i]});
    }
    std::ranges::stable_sort(sensor.points, isEarlier);
    for (const EarlierCalibration &point : sensor.points)
        for (const Message &one : point.notAssigned)
            sensor.leftOut.push_back(
                {point.file, point.number, LeftOutFor::NotUnderstood, english(one)});
    return sensor;
}

} // namespace dyncal
