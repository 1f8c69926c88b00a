// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/history_reading.h"

#include "app/base/interrupt.h"
#include "app/cli/console.h"
#include "app/cli/spoken.h"

#include "core/history/dcc_calibration.h"
#include "registry/certificates/certificate_register.h"
#include "registry/issued/issued_files.h"
#include "registry/store/registry_address.h"

#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// What the manifest beside it says of these results.
Result<EarlierCalibration> readCalibration(const std::string &file)
{
    if (isXmlFile(file))
        return readEarlierDcc(file);
    Result<EarlierResults> read = readEarlierResults(file);
    if (!read)
        return tl::unexpected<Error>(read.error());
    const auto manifest = readManifest(fs::path(read->file).parent_path().string());
    const std::string name = fs::path(read->file).filename().string();
    if (!manifest || !manifest->files.contains(name))
        return earlierCalibration(std::move(*read));
    if (manifest->files.at(name) != read->sha256)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "%1 is not the file that was issued (the manifest of certificate %2 has another hash), so it is nobody's history; look with dyncal verify what was changed."),
                {read->file, std::to_string(manifest->number)}});
    Result<EarlierCalibration> issued = earlierCalibration(std::move(*read), manifest->number);
    if (issued)
        issued->jobSha256 = manifest->jobSha256;
    return issued;
}

std::string whyNotInForce(const CertificateRecord &record)
{
    const std::string number = std::to_string(record.number);
    if (record.state == CertificateState::Replaced)
        return "Certificate " + number + " was replaced by certificate "
            + std::to_string(record.replacedBy) + '.';
    return record.state == CertificateState::Withdrawn
        ? "Certificate " + number + " was withdrawn: " + record.reason
        : std::string();
}

void lookUpState(const std::vector<CertificateRecord> &records, EarlierCalibration &calibration)
{
    for (const CertificateRecord &record : records)
        if (record.number == calibration.number && record.jobSha256 == calibration.jobSha256)
            calibration.notInForce = whyNotInForce(record);
}

/// Of this user, who has not issued anything yet.
bool isNotThereYet(const std::string &registry)
{
    const Result<RegistryAddress> own = registryAddress(registry);
    std::error_code unknown;
    return registry.empty() && own && !own->isServer() && !fs::exists(own->file, unknown);
}

} // namespace

Result<ReadCalibrations> readCalibrations(const std::vector<std::string> &files)
{
    ReadCalibrations read;
    for (const std::string &file : files) {
        if (interruptToken().stop_requested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
        Result<EarlierCalibration> one = readCalibration(file);
        if (one)
            read.all.push_back(std::move(*one));
        else
            read.unread.push_back({file, spoken(one.error().message)});
        if (!one)
            report(one.error());
    }
    return read;
}

Result<void> lookUpStates(const std::string &registry, std::vector<EarlierCalibration> &all)
{
    if (isNotThereYet(registry))
        return {};
    Result<CertificateRegister> opened = CertificateRegister::openToRead(registry);
    const auto records = opened ? opened->all() : tl::unexpected<Error>(std::move(opened.error()));
    if (!records)
        return tl::unexpected<Error>(records.error());
    for (EarlierCalibration &one : all)
        if (one.number > 0)
            lookUpState(*records, one);
    return {};
}

} // namespace dyncal
