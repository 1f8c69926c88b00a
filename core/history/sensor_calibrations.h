// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/earlier_calibration.h"

#include <string>
#include <vector>

namespace dyncal {

enum class LeftOutFor { NoSerial, SameRecordings, NotInForce, NotUnderstood };

const char *leftOutName(LeftOutFor why); ///< "no_serial", "same_recordings", "not_in_force"

/// A calibration that takes no part in the history, or (NotUnderstood) a part of a certificate that
/// does.
struct LeftOutCalibration
{
    std::string file;
    Index number = 0; ///< of its certificate; 0: none
    LeftOutFor why = LeftOutFor::NoSerial;
    std::string reason;
};

/// How many calibrations there are of a sensor.
struct CalibrationCount
{
    std::string serial;
    Index calibrations = 0;
};

/// Of every serial number that the results state, in their order; those without one are not
/// counted.
std::vector<CalibrationCount> sensorsOf(const std::vector<EarlierCalibration> &all);

struct SensorCalibrations
{
    std::string serial;
    std::vector<EarlierCalibration> points = {}; ///< in the order of their days
    std::vector<LeftOutCalibration> leftOut = {};
};

/// The calibrations of one sensor: those with the serial number `serial`, or, where it is empty,
/// the only one there is. What states none is left out, and what is not in force. Of several
/// results from the same recordings (all hashes the same) one counts: one that could be issued
/// before one that was blocked, then the newest (`created_utc`); the others are left out, each with
/// the one that stands for it. Results of one day are in the order in which they were made. Fails
/// (Usage) where the serial numbers are several, none, or not the one asked for, naming them.
Result<SensorCalibrations> calibrationsOfSensor(
    std::vector<EarlierCalibration> all, const std::string &serial);

/// "certificate 17 (issued/17/results.json)", or the file alone.
std::string calibrationName(Index number, const std::string &file);

} // namespace dyncal
