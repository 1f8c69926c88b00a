// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/sensor_calibrations.h"
#include "core/history/sensor_history.h"
#include "tests/core/recheck/earlier_results.h"

#include <string>
#include <vector>

/// Calibrations of a sensor as the tests of core/history need them: written down, not computed.
namespace dyncal::testing {

/// What differs from one made calibration to the next.
struct MadeCalibration
{
    std::string day; ///< of the calibration; empty: not stated
    double sensitivity = 5e-6;
    double u = 5e-8; ///< of the sensitivity
    std::string serial = "17";
    std::string recording = {}; ///< empty: one of its own, by the day
    std::string createdUtc = "2026-06-01T00:00:00Z";
};

inline EarlierJson madeResults(const MadeCalibration &made)
{
    EarlierJson root = earlierResults();
    root["created_utc"] = made.createdUtc;
    root["sensitivity"]["value"] = made.sensitivity;
    root["sensitivity"]["u"] = made.u;
    EarlierJson &fields = root["recipe"]["certificate"]["fields"];
    fields = {{"sensor_serial", made.serial}};
    if (!made.day.empty())
        fields["date_performed"] = made.day;
    const std::string recording = made.recording.empty() ? made.day : made.recording;
    return withInputs(root, {{"shot.h5", recording}});
}

inline EarlierResults madeRead(
    const MadeCalibration &made, const std::string &file = "results.json")
{
    return {file, madeResults(made), sha256Hex(std::string_view(file)), {}};
}

inline EarlierCalibration madeCalibration(
    const MadeCalibration &made, const std::string &file = "results.json", Index number = 0)
{
    return earlierCalibration(madeRead(made, file), number).value();
}

/// One for every made one, its file named by its place: "0", "1", ...
inline std::vector<EarlierCalibration> madeCalibrations(const std::vector<MadeCalibration> &made)
{
    std::vector<EarlierCalibration> all;
    for (const MadeCalibration &one : made)
        all.push_back(madeCalibration(one, std::to_string(all.size())));
    return all;
}

/// The history of one calibration a year from 2020 on, certificate 11, 12, ...
inline SensorHistory madeHistory(const std::vector<double> &sensitivities, double u = 5e-8)
{
    std::vector<EarlierCalibration> all;
    for (const double value : sensitivities) {
        const auto number = static_cast<Index>(11 + all.size());
        const std::string year = std::to_string(2020 + all.size());
        all.push_back(
            madeCalibration({.day = year + "-01-01", .sensitivity = value, .u = u}, year, number));
    }
    return sensorHistory(calibrationsOfSensor(all, {}).value(), {});
}

/// "0 2 1": the files in their order.
template <typename Entries>
std::string filesOf(const Entries &entries)
{
    std::string text;
    for (const auto &one : entries)
        text += (text.empty() ? "" : " ") + one.file;
    return text;
}

} // namespace dyncal::testing
