// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/issued_history.h"

#include "app/cli/history_reading.h"

#include "core/base/content_hash.h"
#include "core/recheck/earlier_run.h"
#include "core/results/results_reading.h"
#include "registry/issued/issued_files.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

Result<EarlierCalibration> presentCalibration(
    const std::string &results, const CertificateRecord &record)
{
    Result<nlohmann::json> parsed = parseResults(results, kResultsFile);
    if (!parsed)
        return tl::unexpected<Error>(parsed.error());
    return earlierCalibration({std::to_string(record.number) + '/' + kResultsFile,
                                  std::move(*parsed), sha256Hex(std::string_view(results)), {}},
        record.number);
}

/// Of every folder NUMBER that was issued; none where the first certificate is still to come.
Result<std::vector<std::string>> issuedResults(const std::string &folder)
{
    std::vector<std::string> files;
    std::error_code problem;
    for (fs::directory_iterator one(folder, problem), end; !problem && one != end;
         one.increment(problem))
        if (readManifest(one->path().string()))
            files.push_back((one->path() / kResultsFile).string());
    if (problem && problem != std::errc::no_such_file_or_directory)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The folder %1 cannot be read (%2), and the certificate is to state the sensor's history from it; give the rights to read it, or choose a template without the section 'history'."),
                {folder, problem.message()}});
    std::ranges::sort(files);
    return files;
}

Result<ReadCalibrations> wholeBelow(const std::string &folder)
{
    const Result<std::vector<std::string>> files = issuedResults(folder);
    if (!files)
        return tl::unexpected<Error>(files.error());
    Result<ReadCalibrations> read = readCalibrations(*files);
    if (!read || read->unread.empty())
        return read;
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The certificate is to state the sensor's history, and %1 cannot be read, so that the history might lack a certificate; mend or move that file, or choose a template without the section 'history'."),
            {read->unread.front().file}});
}

} // namespace

Result<SensorHistory> issuedHistory(const std::string &folder, const std::string &registry,
    const CertificateRecord &record, const std::string &results)
{
    Result<EarlierCalibration> present = presentCalibration(results, record);
    Result<ReadCalibrations> read = wholeBelow(folder);
    if (!present || !read)
        return tl::unexpected<Error>(present ? read.error() : present.error());
    if (const Result<void> asked = lookUpStates(registry, read->all); !asked)
        return tl::unexpected<Error>(asked.error());
    const std::string serial = present->serial;
    std::erase_if(read->all, [&](const EarlierCalibration &one) {
        return one.number <= 0 || one.number == record.number || one.number == record.amends
            || !one.notInForce.empty() || one.serial != serial;
    });
    for (EarlierCalibration &one : read->all)
        one.file = fs::path(one.file).lexically_relative(folder).generic_string();
    read->all.push_back(std::move(*present));
    return calibrationsOfSensor(std::move(read->all), serial).map([](SensorCalibrations sensor) {
        return sensorHistory(std::move(sensor), {});
    });
}

} // namespace dyncal
