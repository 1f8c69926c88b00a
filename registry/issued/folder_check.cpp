// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/folder_check.h"

#include "core/base/content_hash.h"
#include "core/base/writing/written_list.h"
#include "registry/issued/archive_check.h"
#include "registry/issued/bound_files.h"
#include "registry/store/trail_table.h"
#include "registry/trail/audit_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace dyncal {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Difference = std::optional<Message>;

/// The folder as it lies on the disk.
struct Contents
{
    std::map<std::string, std::string> files; ///< bytes by name
    IssuedManifest manifest;

    const std::string &bytes(const char *name) const { return files.at(name); }
};

Result<Contents> readFolder(const std::string &folder)
{
    Contents contents;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = fs::relative(entry->path(), folder, error).generic_string();
        if (entry->is_directory(error) && !entry->is_symlink(error))
            continue;
        std::ifstream in(entry->path(), std::ios::binary);
        contents.files[name] = std::string(std::istreambuf_iterator<char>(in), {});
    }
    const auto manifest = contents.files.contains(kManifest)
        ? parseManifest(contents.bytes(kManifest))
        : std::nullopt;
    if (error || !manifest)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 cannot be read as an issued certificate: its manifest.json is missing or changed; take an unchanged copy of the folder."),
                {folder}});
    contents.manifest = *manifest;
    return contents;
}

Message isMissing(const std::string &name)
{
    return {DYNCAL_TEXT("core", "%1 is missing."), {name}};
}

Message isChanged(const std::string &name)
{
    return {DYNCAL_TEXT("core", "%1 is not the file that was issued (another SHA-256)."), {name}};
}

std::vector<std::string> neededNames()
{
    return {kFrozenProject, "recipe.json", "results.json", kIssuedPdf, kAuditFile};
}

Difference checkMissing(const Contents &contents)
{
    std::vector<std::string> names = neededNames();
    for (const auto &[name, hash] : contents.manifest.files)
        names.push_back(name);
    names.emplace_back(kWrittenList);
    for (const std::string &name : names)
        if (!contents.files.contains(name))
            return isMissing(name);
    return {};
}

/// The list that the writer of the folder left: it says the same as the manifest.
std::string writtenListOf(const Contents &contents)
{
    WrittenList list;
    for (const auto &[name, hash] : contents.manifest.files)
        list.push_back({name, "issue", hash});
    list.push_back({kManifest, "issue", sha256Hex(std::string_view(contents.bytes(kManifest)))});
    return writtenListText(list);
}

Difference checkHashes(const Contents &contents)
{
    for (const auto &[name, bytes] : contents.files) {
        if (name == kManifest)
            continue;
        const auto stated = contents.manifest.files.find(name);
        if (name == kWrittenList) {
            if (bytes != writtenListOf(contents))
                return isChanged(name);
        } else if (stated == contents.manifest.files.end()) {
            return Message{DYNCAL_TEXT("core",
                               "%1 does not belong to the certificate: the manifest lacks it."),
                {name}};
        } else if (sha256Hex(std::string_view(bytes)) != stated->second) {
            return isChanged(name);
        }
    }
    return {};
}

Difference checkTrail(const Contents &contents, FolderCheck &check)
{
    const auto lines = parseAudit(contents.bytes(kAuditFile));
    if (!lines)
        return lines.error().message;
    check.entries = std::ssize(*lines);
    if (const std::optional<Index> broken = firstBrokenLine(*lines))
        return Message{DYNCAL_TEXT("core", "The chain of audit.jsonl is broken at line %1."),
            {std::to_string(*broken)}};
    if (lines->empty() || lines->back().sha256 != contents.manifest.head)
        return Message{DYNCAL_TEXT("core",
                           "audit.jsonl does not end with the entry that the certificate names."),
            {}};
    return {};
}

Message doesNotFit(const char *one, const char *other, const char *what)
{
    return {DYNCAL_TEXT("core", "%1 and %2 do not say the same of %3."), {one, other, what}};
}

/// Names and hashes of recordings, in their order.
using Recordings = std::vector<std::pair<std::string, std::string>>;

Recordings recordingsOf(const Json &list, const char *name)
{
    Recordings recordings;
    for (const Json &one : list)
        recordings.emplace_back(
            fs::path(one.at(name).get<std::string>()).filename().string(), one.at("sha256"));
    return recordings;
}

/// What the documents of a certificate have in common.
struct Documents
{
    Json recipe, recipeOfProject, recipeOfResults;
    Recordings ofProject, ofResults;
    std::string number, utc;
};

Difference compareDocuments(const Documents &documents, const IssuedManifest &manifest)
{
    if (documents.recipeOfResults != documents.recipe)
        return doesNotFit("results.json", "recipe.json", "the recipe");
    if (documents.recipeOfProject != documents.recipe)
        return doesNotFit(kFrozenProject, "recipe.json", "the recipe");
    if (documents.ofResults != documents.ofProject)
        return doesNotFit(kFrozenProject, "results.json", "the recordings");
    if (documents.utc != manifest.utc)
        return doesNotFit("results.json", kManifest, "the time");
    if (documents.number != std::to_string(manifest.number))
        return doesNotFit("recipe.json", kManifest, "the number");
    return {};
}

Difference checkDocuments(const Contents &contents)
{
    const char *name = kFrozenProject;
    Documents documents;
    try {
        const Json project = Json::parse(contents.bytes(name));
        documents.recipeOfProject = project.at("recipe");
        documents.ofProject = recordingsOf(project.at("captures"), "path");
        name = "recipe.json";
        documents.recipe = Json::parse(contents.bytes(name));
        documents.number = documents.recipe.at("certificate").at("fields").at("certificate_number");
        name = "results.json";
        const Json results = Json::parse(contents.bytes(name));
        documents.recipeOfResults = results.at("recipe");
        documents.ofResults = recordingsOf(results.at("inputs"), "file");
        documents.utc = results.at("created_utc");
    } catch (const Json::exception &) {
        return Message{DYNCAL_TEXT("core", "%1 does not hold what belongs into it."), {name}};
    }
    return compareDocuments(documents, contents.manifest);
}

/// Value of a mark in the PDF's metadata (xmpOf, core/pdf); empty without it.
std::string markIn(const std::string &pdf, const std::string &name)
{
    const std::string open = "<dyncal:" + name + ">", close = "</dyncal:" + name + ">";
    const std::size_t begin = pdf.find(open);
    const std::size_t end = begin == pdf.npos ? begin : pdf.find(close, begin);
    return end == pdf.npos ? std::string()
                           : pdf.substr(begin + open.size(), end - begin - open.size());
}

Difference checkPdf(const Contents &contents)
{
    const std::string &pdf = contents.bytes(kIssuedPdf);
    const IssuedManifest &manifest = contents.manifest;
    if (markIn(pdf, "number") != std::to_string(manifest.number))
        return doesNotFit(kIssuedPdf, kManifest, "the number");
    if (markIn(pdf, "head") != manifest.head)
        return doesNotFit(kIssuedPdf, kAuditFile, "the audit trail");
    if (markIn(pdf, "results") != manifest.files.at("results.json"))
        return doesNotFit(kIssuedPdf, "results.json", "the results");
    // Certificates of earlier versions do not state it.
    if (const std::string bound = markIn(pdf, "files");
        !bound.empty() && bound != boundFilesHash(manifest.files))
        return doesNotFit(kIssuedPdf, kManifest, "the files");
    return checkPdfArchive(pdf, contents.files);
}

Difference checkItself(const Contents &contents, FolderCheck &check)
{
    if (Difference difference = checkMissing(contents)) {
        check.isMissing = true;
        return difference;
    }
    if (Difference difference = checkHashes(contents))
        return difference;
    if (Difference difference = checkTrail(contents, check))
        return difference;
    if (Difference difference = checkDocuments(contents))
        return difference;
    return checkPdf(contents);
}

Difference checkRecord(const Contents &contents, const CertificateRecord &record)
{
    if (record.state == CertificateState::Reserved || record.state == CertificateState::Void)
        return Message{
            DYNCAL_TEXT("core", "By the registry certificate %1 was not issued: the number is %2."),
            {std::to_string(record.number), certificateStateName(record.state)}};
    std::map<std::string, std::string> files = contents.manifest.files;
    files[kManifest] = sha256Hex(std::string_view(contents.bytes(kManifest)));
    for (const auto &[name, hash] : files)
        if (const auto stated = record.files.find(name);
            stated == record.files.end() || stated->second != hash)
            return isChanged(name);
    if (files.size() != record.files.size() || record.head != contents.manifest.head
        || record.amends != contents.manifest.amends)
        return doesNotFit(kManifest, "the registry", "the certificate");
    return {};
}

Result<Difference> checkAgainstTrail(const Contents &contents, CertificateRegister &registry)
{
    const auto lines = parseAudit(contents.bytes(kAuditFile));
    const auto entries
        = entriesBetween(registry.database(), lines->front().sequence, lines->back().sequence);
    if (!entries)
        return tl::unexpected<Error>(entries.error());
    if (auditText(*entries, certificateObject(contents.manifest.number))
        != contents.bytes(kAuditFile))
        return Difference(doesNotFit(kAuditFile, "the registry", "the audit trail"));
    return Difference();
}

Result<Difference> checkAgainst(
    CertificateRegister &registry, const Contents &contents, FolderCheck &check)
{
    const Result<CertificateRecord> record = registry.find(contents.manifest.number);
    if (!record && record.error().kind == ErrorKind::Usage)
        return Difference(record.error().message);
    if (!record)
        return tl::unexpected<Error>(record.error());
    check.state = record->state;
    check.remarks = remarksOn(*record);
    if (Difference difference = checkRecord(contents, *record))
        return difference;
    return checkAgainstTrail(contents, registry);
}

} // namespace

std::vector<Message> remarksOn(const CertificateRecord &record)
{
    if (record.state == CertificateState::Withdrawn)
        return {{DYNCAL_TEXT("core", "Certificate %1 is withdrawn: %2"),
            {std::to_string(record.number), record.reason}}};
    if (record.state == CertificateState::Replaced)
        return {{DYNCAL_TEXT("core", "Certificate %1 is replaced by %2."),
            {std::to_string(record.number), std::to_string(record.replacedBy)}}};
    return {};
}

Result<FolderCheck> checkIssuedFolder(const std::string &folder, CertificateRegister *registry)
{
    const Result<Contents> contents = readFolder(folder);
    if (!contents)
        return tl::unexpected<Error>(contents.error());
    FolderCheck check;
    check.number = contents->manifest.number;
    check.head = contents->manifest.head;
    check.firstDifference = checkItself(*contents, check);
    if (check.firstDifference)
        return check;
    if (!registry) {
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "No registry was given: the folder agrees with itself, and whether it is what was issued is not known."),
                {}});
        return check;
    }
    const Result<Difference> difference = checkAgainst(*registry, *contents, check);
    if (!difference)
        return tl::unexpected<Error>(difference.error());
    check.firstDifference = *difference;
    return check;
}

Result<std::optional<CertificateRecord>> certificateWithFile(
    CertificateRegister &registry, const std::string &sha256)
{
    const auto records = registry.all();
    if (!records)
        return tl::unexpected<Error>(records.error());
    for (const CertificateRecord &record : *records)
        for (const auto &[name, hash] : record.files)
            if (hash == sha256)
                return std::optional(record);
    return std::optional<CertificateRecord>();
}

} // namespace dyncal
