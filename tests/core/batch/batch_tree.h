// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/content_hash.h"
#include "core/batch/sensor_place.h"
#include "core/results/run_files.h"
#include "tests/support/scratch_folder.h"

#include <filesystem>
#include <string>
#include <string_view>

/// Folders of recordings and results for the tests of a batch.
namespace dyncal::testing {

inline void writeText(const std::filesystem::path &path, std::string_view text)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

/// A text table, which the readers recognise; another content for every `seed`.
inline std::string recordingText(int seed)
{
    std::string text = "time,dut\n";
    for (int i = 0; i < 40; ++i)
        text += std::to_string(i) + "e-6," + std::to_string(i < 20 ? 0 : seed + i % 3) + '\n';
    return text;
}

inline void writeRecording(const std::filesystem::path &path, int seed)
{
    writeText(path, recordingText(seed));
}

/// A sensor as a plan has it, with files of these contents in `source`.
inline PlannedSensor plannedSensor(const std::string &id, std::vector<std::string> contents = {"a"})
{
    PlannedSensor sensor;
    sensor.id = id;
    sensor.source = "in/" + id;
    for (const std::string &content : contents)
        sensor.inputs.push_back({"shot_" + std::to_string(sensor.inputs.size() + 1) + ".csv",
            sha256Hex(content), content.size()});
    sensor.recipeSha256 = sha256Hex(std::string_view("recipe"));
    sensor.methods = {{"model", 6}, {"window", 4}};
    sensor.output = "plan.out/" + id;
    return sensor;
}

/// Writes results of the sensor as a run of a batch does: as one transaction, with the list.
inline bool writeResults(const std::filesystem::path &planFolder, const PlannedSensor &sensor,
    const SensorOutcome &record, const std::string &results = "{}")
{
    const std::string folder = (planFolder / sensor.output / kCalibrationFolder).string();
    Result<FolderWrite> write = FolderWrite::begin(runFolder(folder, CaptureSet()));
    const std::string text = recordText(record);
    return write
        && write->commit(
                    {{"csv/poles.csv", "1,2"}, {kBatchRecord, text}, {"results.json", results}})
               .has_value();
}

/// The record of a sensor that is done.
inline SensorOutcome doneRecord(const PlannedSensor &sensor)
{
    SensorOutcome record;
    record.key = sensorKey(sensor);
    record.state = SensorState::Done;
    record.results = {{"sensitivity", 5e-6, "V/Pa", 1e-7, 2.0}, {"f0_hz", 318e3, "Hz", 20.0, 2.0}};
    record.findings = {{"CAP-017", Severity::Info, 0}};
    return record;
}

} // namespace dyncal::testing
