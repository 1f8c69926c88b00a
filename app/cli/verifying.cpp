// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/verifying.h"

#include "app/base/interrupt.h"
#include "app/cli/project_job.h"

#include "core/base/ascii_text.h"
#include "core/base/content_hash.h"
#include "core/capture/capture_seal.h"
#include "core/capture/opening/capture_open.h"
#include "core/recheck/recording_search.h"
#include "registry/certificates/registry_check.h"
#include "registry/issued/file_signatures.h"
#include "registry/issued/folder_check.h"
#include "ui/session/project_checksum.h"
#include "ui/session/project_file.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace dyncal {
namespace {

namespace fs = std::filesystem;
using Status = Verified::Status;

bool isAddress(const std::string &text)
{
    return text.starts_with("postgresql://") || text.starts_with("postgres://");
}

bool isDatabaseFile(const std::string &path)
{
    constexpr std::string_view kBegin = "SQLite format 3";
    std::ifstream in(path, std::ios::binary);
    std::string begin(kBegin.size(), '\0');
    return in.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kBegin;
}

Verified unreadable(Verified one, const Error &error)
{
    one.status = Status::Unreadable;
    one.firstDifference = error.message;
    return one;
}

Verified verifyRegistry(const std::string &address)
{
    Verified one{.file = address, .kind = "registry"};
    if (const auto parsed = registryAddress(address))
        one.file = parsed->shown();
    Result<CertificateRegister> registry = CertificateRegister::openToRead(address);
    if (!registry)
        return unreadable(one, registry.error());
    const Result<RegistryCheck> check = checkRegistry(*registry);
    if (!check)
        return unreadable(one, check.error());
    one.status = check->firstDifference ? Status::Changed : Status::Valid;
    one.firstDifference = check->firstDifference;
    one.entries = check->entries;
    one.anchored = check->anchored;
    one.head = check->head;
    return one;
}

/// The recordings of an issued folder, by their content.
std::optional<Message> recordingDifference(
    const std::string &folder, const std::vector<std::string> &places)
{
    if (places.empty())
        return {};
    Result<RecordingSearch> search = RecordingSearch::in(places);
    const Result<EarlierRun> run = readEarlierRun(folder);
    if (!search || !run)
        return search ? run.error().message : search.error().message;
    const auto found = search->find(*run, {interruptToken(), {}});
    return found ? std::optional<Message>() : std::optional(found.error().message);
}

/// What is known of a signature, of a file that has no other difference.
void takeSignature(const SignatureCheck &check, Verified &one)
{
    constexpr std::array kStatuses{Status::Valid, Status::Unsigned, Status::Changed,
        Status::UnknownSigner, Status::Expired}; // as in SignatureCheck
    one.status = kStatuses[static_cast<std::size_t>(check.status)];
    one.firstDifference = check.difference;
    one.remarks.insert(one.remarks.begin(), check.remarks.begin(), check.remarks.end());
    one.signer = check.signer;
    one.signedUtc = check.signedUtc;
    one.stampedUtc = check.stampedUtc;
}

Verified verifyFolder(
    const std::string &folder, CertificateRegister *registry, const VerifyOptions &options)
{
    Verified one{.file = folder, .kind = "certificate"};
    Result<FolderCheck> check = checkIssuedFolder(folder, registry);
    if (!check)
        return unreadable(one, check.error());
    if (!check->firstDifference)
        check->firstDifference = recordingDifference(folder, options.recordings);
    if (options.recordings.empty())
        check->remarks.push_back(
            {DYNCAL_TEXT("core", "The recordings were not looked for (--recordings DIR)."), {}});
    one.status = check->isMissing ? Status::Missing : Status::Changed;
    one.firstDifference = check->firstDifference;
    one.remarks = check->remarks;
    if (!check->firstDifference)
        takeSignature(checkFolderSignatures(folder, options.trust), one);
    one.number = check->number;
    one.state = check->state ? certificateStateName(*check->state) : "";
    one.entries = one.anchored = check->entries;
    one.head = check->head;
    return one;
}

/// A project: its checksums, and its recordings where they are.
Verified verifyProject(const std::string &path)
{
    Verified one{.file = path, .kind = "project"};
    const Result<ProjectFile> file = readProjectFile(QString::fromStdString(path));
    if (!file)
        return unreadable(one, file.error());
    if (const std::optional<Finding> older = olderVersion(*file))
        one.remarks.push_back(older->message);
    Findings findings = checkProject(file->content, QFileInfo(file->path).fileName());
    if (worstSeverity(findings) == Severity::Info) {
        const Result<ProjectState> job = readProjectJob(*file);
        if (!job && job.error().findingId == kMissingRecordings)
            one.remarks.push_back(job.error().message);
        else if (!job)
            return unreadable(one, job.error());
        else
            findings = job->captures->findings;
    }
    for (const Finding &finding : findings) {
        if (finding.id == "PRJ-002")
            one.remarks.push_back(finding.message);
        else if (!one.firstDifference && (finding.id == "PRJ-001" || finding.id == "CAP-015"))
            one.firstDifference = finding.message;
    }
    if (one.firstDifference)
        one.status = Status::Changed;
    return one;
}

/// A recording: samples against the hashes that it states.
Verified verifyRecording(const std::string &path)
{
    Verified one{.file = path, .kind = "recording"};
    const JobControl control{interruptToken(), {}};
    const Result<CaptureSet> set = readCaptures({path}, {}, control);
    if (!set)
        return unreadable(one, set.error());
    const Result<CaptureSet> sealed = sealCaptures(*set, control);
    if (sealed)
        return one;
    one.status = Status::Changed;
    one.firstDifference = sealed.error().message;
    return one;
}

/// A single file of a certificate: its own signature, and the registry knows its hash.
Verified verifySingle(
    const std::string &path, CertificateRegister *registry, const TrustSettings &trust)
{
    Verified one{.file = path, .kind = "file"};
    const Result<SignatureCheck> signature = checkFileSignature(path, trust);
    if (!signature)
        return unreadable(one, signature.error());
    takeSignature(*signature, one);
    const bool isSound = one.status != Status::Changed && one.status != Status::Unsigned;
    if (one.status == Status::Changed || (isSound && !registry))
        return one;
    const auto record
        = registry ? certificateWithFile(*registry, sha256OfFile(path)) : std::nullopt;
    if (!registry && signedKindOf(path) != SignedKind::None) {
        one.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "It has no signature, and without the registry (--registry) or the folder of its certificate nothing else shows whether it is as it was issued."),
                {}});
        return one;
    }
    if (!registry || !record) {
        if (registry)
            return unreadable(one, record.error());
        one.status = Status::Unreadable;
        one.firstDifference = Message{
            DYNCAL_TEXT("core",
                "A single file that is not signed can be verified with the registry only; name it (--registry), or the folder of the certificate."),
            {}};
        return one;
    }
    if (!*record) {
        one.status = Status::Changed;
        one.firstDifference
            = Message{DYNCAL_TEXT("core", "The registry knows no certificate with this file."), {}};
        return one;
    }
    one.number = (*record)->number;
    one.state = certificateStateName((*record)->state);
    const std::vector<Message> remarks = remarksOn(**record);
    one.remarks.insert(one.remarks.end(), remarks.begin(), remarks.end());
    return one;
}

/// Issued folders in or below a folder, in order of their names.
std::vector<std::string> foldersBelow(const std::string &folder)
{
    std::vector<std::string> found;
    std::error_code ignored;
    if (fs::exists(fs::path(folder) / kManifest, ignored))
        return {folder};
    for (fs::recursive_directory_iterator entry(folder, ignored), end; entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) // what is just being written
            entry.disable_recursion_pending();
        else if (name == kManifest)
            found.push_back(entry->path().parent_path().string());
    }
    std::ranges::sort(found);
    return found;
}

std::vector<Verified> verifyOne(
    const std::string &file, CertificateRegister *registry, const VerifyOptions &options)
{
    std::error_code ignored;
    if (isAddress(file) || isDatabaseFile(file))
        return {verifyRegistry(file)};
    if (fs::is_directory(file, ignored)) {
        std::vector<Verified> all;
        for (const std::string &folder : foldersBelow(file))
            all.push_back(verifyFolder(folder, registry, options));
        if (all.empty()) // says so
            all.push_back(verifyFolder(file, registry, options));
        return all;
    }
    if (!fs::exists(file, ignored))
        return {unreadable({.file = file, .kind = "file"},
            {ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core", "The file %1 does not exist."), {file}}, {}, 0})};
    const std::string extension = lowerCase(fs::path(file).extension().string());
    if (extension == ".dyncal")
        return {verifyProject(file)};
    if (extension == ".json" || extension == ".jsonl" || signedKindOf(file) != SignedKind::None)
        return {verifySingle(file, registry, options.trust)};
    return {verifyRecording(file)};
}

} // namespace

Result<std::vector<Verified>> verifyAll(const VerifyOptions &options)
{
    std::optional<CertificateRegister> registry;
    if (!options.registry.empty()) {
        Result<CertificateRegister> opened = CertificateRegister::openToRead(options.registry);
        if (!opened)
            return tl::unexpected<Error>(opened.error());
        registry.emplace(std::move(*opened));
    }
    std::vector<Verified> all;
    for (const std::string &file : options.files) {
        const auto found = verifyOne(file, registry ? &*registry : nullptr, options);
        all.insert(all.end(), found.begin(), found.end());
        if (interruptToken().stop_requested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
    }
    return all;
}

} // namespace dyncal
