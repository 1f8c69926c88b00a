// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/sensor_place.h"

#include "core/base/file_descriptor.h"
#include "core/base/writing/atomic_file.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/temporary_name.h"
#include "core/base/writing/write_claim.h"
#include "core/base/writing/write_problem.h"
#include "core/base/writing/written_list.h"
#include "core/results/run_files.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include <fcntl.h>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestRecord = std::size_t(1) << 20U;
constexpr std::size_t kLongestWrittenList = std::size_t(16) << 20U;
constexpr int kMostSetAside = 10000;

FileDescriptor openedFolder(const std::string &folder)
{
    return FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

std::string recordOfResults()
{
    return std::string(kCalibrationFolder) + '/' + kBatchRecord;
}

std::optional<SensorOutcome> recordIn(const FileDescriptor &folder, const std::string &name)
{
    const auto text = folder.valid() ? textAt(folder.get(), name, kLongestRecord) : std::nullopt;
    return text ? parseRecord(*text) : std::nullopt;
}

/// The list, if it names what a batch needs.
std::optional<WrittenList> listIn(const FileDescriptor &folder)
{
    const auto text
        = folder.valid() ? textAt(folder.get(), kWrittenList, kLongestWrittenList) : std::nullopt;
    const auto list = text ? parseWrittenList(*text) : std::nullopt;
    const bool isOfBatch = list && listed(*list, kBatchRecord) && listed(*list, "results.json");
    return isOfBatch ? list : std::nullopt;
}

bool isAsListed(int folder, const WrittenFile &file)
{
    return sha256At(folder, file.file) == file.sha256;
}

bool hasTemporaries(int folder)
{
    const std::vector<std::string> names = namesIn(folder);
    return std::ranges::any_of(
        names, [](const std::string &name) { return name.starts_with(".dyncal-"); });
}

/// A killed write is completed or undone first: half of it is no damage.
Result<void> completeWrites(const std::string &outputFolder, int folder)
{
    if (!hasTemporaries(folder))
        return {};
    const std::string shown = (fs::path(outputFolder) / kCalibrationFolder).string();
    return clearClaims(
        outputFolder, kCalibrationFolder, shown, runFolder(shown, CaptureSet()).mayComplete);
}

Result<std::string> renamedAside(const std::string &outputFolder, int folder)
{
    for (int number = 1; number <= kMostSetAside; ++number) {
        const std::string name
            = std::string(kCalibrationFolder) + ".damaged-" + std::to_string(number);
        if (renameToFree(folder, kCalibrationFolder, folder, name))
            return (fs::path(outputFolder) / name).string();
        if (errno != EEXIST)
            break;
    }
    return cannotWrite((fs::path(outputFolder) / kCalibrationFolder).string());
}

} // namespace

std::string pathOfPlan(const std::string &planFolder, const std::string &path)
{
    return planFolder == "." ? path : (fs::path(planFolder) / path).string();
}

SensorOutcome recordOnDisk(const std::string &planFolder, const PlannedSensor &sensor)
{
    if (!sensor.obstacle.empty())
        return {{}, SensorState::Failed, sensor.obstacle, {}, {}, {}, sensor.said};
    const std::string key = sensorKey(sensor);
    const FileDescriptor output = openedFolder(pathOfPlan(planFolder, sensor.output));
    for (const std::string &name : {std::string(kFailureRecord), recordOfResults()})
        if (auto record = recordIn(output, name); record && record->key == key)
            return *record;
    return {key, SensorState::Missing, {}, {}, {}, {}};
}

std::optional<SensorOutcome> plannedResults(
    const std::string &planFolder, const PlannedSensor &sensor)
{
    auto record = recordIn(openedFolder(pathOfPlan(planFolder, sensor.output)), recordOfResults());
    return record && record->key == sensorKey(sensor) ? record : std::nullopt;
}

bool looksWhole(const std::string &planFolder, const PlannedSensor &sensor)
{
    const FileDescriptor folder
        = openedFolder(pathOfPlan(planFolder, sensor.output) + '/' + kCalibrationFolder);
    const auto list = listIn(folder);
    return list && isAsListed(folder.get(), *listed(*list, kBatchRecord))
        && std::ranges::all_of(*list, [&](const WrittenFile &file) {
               return identityOf(folder.get(), file.file).has_value();
           });
}

bool isBeingComputed(const std::string &outputFolder)
{
    const FolderLock lock(outputFolder);
    return lock.valid() ? hasLiveClaims(lock.folder(), {}) : errno == EWOULDBLOCK;
}

Result<void> keepFailure(
    const std::string &planFolder, const PlannedSensor &sensor, const KeptMessage &reason)
{
    const std::string folder = pathOfPlan(planFolder, sensor.output);
    std::error_code ignored; // the write says what is wrong
    fs::create_directories(folder, ignored);
    const SensorOutcome record{
        sensorKey(sensor), SensorState::Failed, english(reason.message()), {}, {}, {}, reason};
    return writeFileAtomically((fs::path(folder) / kFailureRecord).string(), recordText(record));
}

void forgetFailure(const std::string &planFolder, const PlannedSensor &sensor)
{
    const FileDescriptor output = openedFolder(pathOfPlan(planFolder, sensor.output));
    if (recordIn(output, kFailureRecord))
        ::unlinkat(output.get(), kFailureRecord, 0);
}

bool isWhole(const std::string &calibrationFolder)
{
    const FileDescriptor folder = openedFolder(calibrationFolder);
    const auto list = listIn(folder);
    return list && recordIn(folder, kBatchRecord)
        && std::ranges::all_of(
            *list, [&](const WrittenFile &file) { return isAsListed(folder.get(), file); });
}

Result<std::string> setDamagedAside(const std::string &outputFolder)
{
    const FileDescriptor folder = openedFolder(outputFolder);
    if (!folder.valid())
        return std::string();
    if (const Result<void> completed = completeWrites(outputFolder, folder.get()); !completed)
        return tl::unexpected<Error>(completed.error());
    const bool isThere = identityOf(folder.get(), kCalibrationFolder).has_value();
    if (!isThere || isWhole((fs::path(outputFolder) / kCalibrationFolder).string()))
        return std::string();
    return renamedAside(outputFolder, folder.get());
}

} // namespace dyncal
