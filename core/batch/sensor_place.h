// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/batch/batch_plan.h"
#include "core/batch/sensor_outcome.h"

#include <optional>
#include <string>

namespace dyncal {

/// The folder of a sensor's results below the output folder of its own, as `dyncal run` leaves it
/// and with kBatchRecord; and beside it why there are none.
inline constexpr const char *kCalibrationFolder = "calibration";
inline constexpr const char *kFailureRecord = "failed.json";

/// Path of a file or folder of a plan, as `planFolder` is given.
std::string pathOfPlan(const std::string &planFolder, const std::string &path);

/// Where a sensor of the plan in `planFolder` stands, from the files that say so: quick, so results
/// are not hashed (isWhole() does). A failure is told before earlier results. Never fails: what
/// cannot be read is Missing.
SensorOutcome recordOnDisk(const std::string &planFolder, const PlannedSensor &sensor);

/// The record beside the sensor's results if they are of what is planned, whatever failed since.
std::optional<SensorOutcome> plannedResults(
    const std::string &planFolder, const PlannedSensor &sensor);

/// Keeps that the sensor failed; what there is of earlier results stays. Fails as
/// writeFileAtomically.
Result<void> keepFailure(
    const std::string &planFolder, const PlannedSensor &sensor, const KeptMessage &reason);

/// Removes what keepFailure() left, if it did.
void forgetFailure(const std::string &planFolder, const PlannedSensor &sensor);

/// A quick look at the sensor's results: the record is as listed, and all listed files are there.
bool looksWhole(const std::string &planFolder, const PlannedSensor &sensor);

/// Whether another program writes into the sensor's folder now.
bool isBeingComputed(const std::string &outputFolder);

/// Whether the folder of results is there and exactly as it was written: every file of its list has
/// the hash that the list states, and record and results are among them.
bool isWhole(const std::string &calibrationFolder);

/// Completes what a killed program left of a write into the sensor's folder, and gives the folder
/// another name ("calibration.damaged-1") if it is not whole; nothing in it is changed. Returns the
/// new name, empty if nothing was set aside. Fails (Usage) if another program writes there now or
/// the folder cannot be renamed.
Result<std::string> setDamagedAside(const std::string &outputFolder);

} // namespace dyncal
