// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/earlier_calibration.h"

#include "core/base/ascii_text.h"
#include "core/base/calendar_date.h"
#include "core/recheck/finding_changes.h"
#include "core/recheck/method_changes.h"
#include "core/results/results_reading.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace dyncal {
namespace {

std::string fieldOfCertificate(const nlohmann::json &results, const char *name)
{
    const nlohmann::json &certificate = valueAt(valueAt(results, "recipe"), "certificate");
    return std::string(trimmed(textAt(valueAt(certificate, "fields"), name)));
}

/// All of them or none: a calibration of which a recording is unknown is none that is known again.
std::vector<std::string> hashesOf(const nlohmann::json &inputs)
{
    std::vector<std::string> hashes;
    for (const nlohmann::json &one : inputs) {
        hashes.push_back(textAt(one, "sha256"));
        if (hashes.back().empty())
            return {};
    }
    std::ranges::sort(hashes);
    return hashes;
}

/// False where nothing says when it was.
bool setTime(EarlierCalibration &calibration)
{
    const std::string day = fieldOfCertificate(calibration.results, "date_performed");
    calibration.isDayOfCalibration = isCalendarDate(day);
    calibration.time = calibration.isDayOfCalibration ? day : calibration.createdUtc;
    const auto days = daysSince1970(calibration.time);
    calibration.day = days.value_or(0.0);
    return days.has_value();
}

} // namespace

Result<EarlierCalibration> earlierCalibration(EarlierResults read, Index number)
{
    EarlierCalibration calibration{.file = std::move(read.file),
        .number = number,
        .serial = fieldOfCertificate(read.results, "sensor_serial"),
        .createdUtc = textAt(read.results, "created_utc"),
        .methods = statedMethods(read.results),
        .blocked = blockOf(read.results),
        .recordings = hashesOf(valueAt(read.results, "inputs")),
        .results = std::move(read.results),
        .remarks = std::move(read.remarks)};
    if (setTime(calibration))
        return calibration;
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 does not say when the calibration was: no day of calibration is stated, and the results were made at \"%2\", which is no moment such as 2026-01-31T09:00:00Z; repeat the run."),
            {calibration.file, calibration.createdUtc}});
}

Result<std::vector<std::string>> resultsFilesOf(const std::vector<std::string> &paths)
{
    namespace fs = std::filesystem;
    std::vector<std::string> files;
    std::set<fs::path> known;
    std::error_code unknown;
    const auto add = [&](const std::string &file) {
        if (known.insert(fs::weakly_canonical(file, unknown)).second)
            files.push_back(file);
    };
    for (const std::string &path : paths) {
        if (!fs::is_directory(path, unknown)) {
            add(path); // whatever it is, reading says it
            continue;
        }
        const auto folders = runFoldersBelow(path);
        if (!folders)
            return tl::unexpected<Error>(folders.error());
        for (const std::string &folder : *folders)
            add((fs::path(folder) / kResultsFile).string());
    }
    return files;
}

} // namespace dyncal
