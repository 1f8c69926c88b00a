// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/issued_files.h"

#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "core/reference/reference_source.h"
#include "registry/trail/audit_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace dyncal {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char *kSchema = "dyncal-manifest/1";
constexpr std::array<const char *, 8> kNames{"project.dyncal", "recipe.json", "results.json",
    "certificate.pdf", "dcc.xml", kHistoryFile, kAuditFile, kManifest};

IssuedManifest manifestOf(const ReservedNumber &reserved)
{
    const CertificateRecord &record = reserved.record;
    return {record.number, record.amends, record.jobSha256, record.reservedUtc, record.head, {}};
}

/// Fails where the folder holds another certificate, perhaps of another registry.
Result<void> checkPlace(const std::string &folder, const IssuedManifest &own)
{
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(folder, unknown)))
        return {};
    const auto there = readManifest(folder);
    if (there && there->number == own.number && there->jobSha256 == own.jobSha256
        && there->utc == own.utc)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 is there already and does not belong to this certificate; give another folder (-o), or move that one. The number %2 stays reserved."),
            {folder, std::to_string(own.number)}});
}

FolderRequest requestOf(const std::string &folder, const std::vector<std::string> &recordings,
    const std::function<Result<void>()> &mayCommit)
{
    std::vector<std::string> names{"sources/"};
    names.insert(names.end(), kNames.begin(), kNames.end());
    return {folder, "issue", isIssuedName, std::move(names), recordings, {}, {}, mayCommit};
}

} // namespace

std::optional<IssuedManifest> readManifest(const std::string &folder)
{
    std::ifstream in(fs::path(folder) / kManifest, std::ios::binary);
    return parseManifest({std::istreambuf_iterator<char>(in), {}});
}

std::map<std::string, std::string> hashesOf(const std::map<std::string, std::string> &files)
{
    std::map<std::string, std::string> hashes;
    for (const auto &[name, bytes] : files)
        hashes[name] = sha256Hex(std::string_view(bytes));
    return hashes;
}

std::string manifestText(const IssuedManifest &manifest)
{
    return jsonText(Json{{"schema", kSchema}, {"number", manifest.number},
        {"amends", manifest.amends}, {"job_sha256", manifest.jobSha256}, {"utc", manifest.utc},
        {"head", manifest.head}, {"files", manifest.files}});
}

std::optional<IssuedManifest> parseManifest(const std::string &text)
{
    try {
        const Json json = Json::parse(text);
        IssuedManifest manifest;
        manifest.number = json.at("number").get<Index>();
        manifest.amends = json.at("amends").get<Index>();
        manifest.jobSha256 = json.at("job_sha256").get<std::string>();
        manifest.utc = json.at("utc").get<std::string>();
        manifest.head = json.at("head").get<std::string>();
        manifest.files = json.at("files").get<std::map<std::string, std::string>>();
        return manifestText(manifest) == text ? std::optional(manifest) : std::nullopt;
    } catch (const Json::exception &) {
        return std::nullopt;
    }
}

bool isIssuedName(const std::string &name)
{
    return std::ranges::find(kNames, name) != kNames.end() || isKeptSourceName(name);
}

std::string issuedFolder(const std::string &folder, Index number)
{
    return (fs::path(folder) / std::to_string(number)).string();
}

Result<std::map<std::string, std::string>> writeIssuedFolder(const std::string &folder,
    const ReservedNumber &reserved, const std::map<std::string, std::string> &files,
    const std::vector<std::string> &recordings, const std::function<Result<void>()> &mayCommit,
    const JobControl &control)
{
    const std::string place = issuedFolder(folder, reserved.record.number);
    IssuedManifest manifest = manifestOf(reserved);
    if (const Result<void> isFree = checkPlace(place, manifest); !isFree)
        return tl::unexpected<Error>(isFree.error());
    std::map<std::string, std::string> all = files;
    all[kAuditFile] = auditText(reserved.trail, certificateObject(reserved.record.number));
    manifest.files = hashesOf(all);
    all[kManifest] = manifestText(manifest);
    Result<FolderWrite> write = FolderWrite::begin(requestOf(place, recordings, mayCommit));
    if (!write)
        return tl::unexpected<Error>(write.error());
    std::vector<FolderFile> list;
    list.reserve(all.size());
    for (const auto &[name, bytes] : all)
        list.push_back({name, bytes});
    if (const Result<void> done = write->commit(list, control); !done)
        return tl::unexpected<Error>(done.error());
    std::map<std::string, std::string> hashes = manifest.files;
    hashes[kManifest] = sha256Hex(std::string_view(all[kManifest]));
    return hashes;
}

} // namespace dyncal
