// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/issuing.h"

#include "app/base/interrupt.h"
#include "app/cli/drawing_process.h"
#include "app/cli/issued_history.h"

#include "core/base/content_hash.h"
#include "core/capture/capture_seal.h"
#include "core/certificate/certificate_attachments.h"
#include "core/certificate/certificate_issue.h"
#include "core/dcc/dcc_document.h"
#include "core/history/history_files.h"
#include "core/history/history_section.h"
#include "core/reference/reference_source.h"
#include "core/results/results_json.h"
#include "registry/issued/bound_files.h"
#include "registry/issued/file_signatures.h"
#include "registry/issued/folder_check.h"
#include "registry/issued/issued_files.h"
#include "ui/report/certificate_dcc.h"
#include "ui/report/history_figures.h"
#include "ui/session/project_file.h"

namespace dyncal {
namespace {

using Files = std::map<std::string, std::string>;

std::string certificateNumber(Index number)
{
    return number > 0 ? std::to_string(number) : std::string();
}

NumberRequest requestOf(
    const ProjectState &job, const PipelineOutcome &outcome, const IssueOrder &order)
{
    const auto customer = job.recipe.certificate.fields.find("customer");
    NumberRequest request;
    request.job = jobOf(*job.captures);
    request.jobSha256 = jobSha256(
        *job.captures, job.recipe, order.names, certificateNumber(order.amends), order.reason);
    request.utc = order.names.utc;
    request.by = issuerOf(job.recipe, order.names);
    request.reviewedBy = order.names.reviewedBy;
    request.sensor = sensorName(outcome.results, job.recipe);
    if (customer != job.recipe.certificate.fields.end())
        request.customer = customer->second;
    request.number = order.number;
    request.amends = order.amends;
    request.reason = order.reason;
    for (const auto &[action, reason] : decisionsOf(*job.captures, job.recipe))
        request.decisions.push_back({action, reason});
    return request;
}

Result<ReservedNumber> reserveNumber(const std::string &registry, const NumberRequest &request)
{
    // The connection ends with this, so that no application object is there when the PDF is drawn.
    Result<CertificateRegister> opened = CertificateRegister::open(registry);
    if (!opened)
        return tl::unexpected<Error>(opened.error());
    return opened->reserve(request);
}

template <typename Settings>
void keepSource(const Settings &settings, Files &files)
{
    if (settings.loaded)
        files[keptSourceName(settings.source, settings.loaded->sha256)] = settings.loaded->content;
}

/// What a template that asks for it gets of the sensor's earlier certificates.
struct StatedHistory
{
    std::optional<CertificateSection> section = {};
    std::vector<FigureMaker> figures = {};
};

Result<StatedHistory> historyFor(const ChosenTemplate &chosen, const IssueOrder &order,
    const CertificateRecord &record, Files &files)
{
    if (std::ranges::find(chosen.layout.sections, kHistorySection) == chosen.layout.sections.end())
        return StatedHistory{};
    const Result<SensorHistory> history
        = issuedHistory(order.output, order.registry, record, files["results.json"]);
    if (!history)
        return tl::unexpected<Error>(history.error());
    files[kHistoryFile] = historyCsv(*history);
    return StatedHistory{historySection(*history), historyFigureMakers(*history)};
}

/// Signed before it is embedded.
Result<void> signDcc(const IssueOrder &order, Files &files)
{
    const auto dcc = files.find(kDccFile);
    if (dcc == files.end())
        return {};
    Result<std::string> made = signedDcc(dcc->second, order.signing);
    if (!made)
        return tl::unexpected<Error>(made.error());
    dcc->second = std::move(*made);
    return {};
}

/// Last of all: the signature is of the whole file.
Result<Files> withSignedPdf(Files files, const IssueOrder &order)
{
    Result<std::string> made
        = signedCertificate(files[kIssuedPdf], order.signing, order.names.utc, interruptToken());
    if (!made)
        return tl::unexpected<Error>(made.error());
    files[kIssuedPdf] = std::move(*made);
    return files;
}

CertificateIssue issueOf(
    const IssueOrder &order, const CertificateRecord &record, const std::string &results)
{
    CertificateIssue issue{std::to_string(record.number), certificateNumber(record.amends),
        record.reason, record.head, sha256Hex(std::string_view(results))};
    if (order.signing.isSigned())
        issue.signer = CertificateSigner{signerOf(order.signing), order.names.utc};
    return issue;
}

Result<Files> filesOf(const ProjectState &job, const PipelineOutcome &outcome,
    const ChosenTemplate &chosen, const IssueOrder &order, const CertificateRecord &record)
{
    // The names that were given when the number was reserved, and its time: a restart later makes
    // the same files.
    const std::string number = std::to_string(record.number);
    const Recipe recipe
        = issuedRecipe(job.recipe, number, {record.by, record.reviewedBy, record.reservedUtc});
    Files files{{"recipe.json", recipeJson(recipe)},
        {"results.json", resultsJson(outcome, recipe, record.reservedUtc)},
        {kFrozenProject, frozenProjectBytes({job.captures, recipe}).toStdString()}};
    keepSource(recipe.chain, files);
    if (recipe.comparison.enabled)
        keepSource(recipe.comparison, files);
    files.merge(keptTemplateFiles(chosen));
    Result<StatedHistory> history = historyFor(chosen, order, record, files);
    if (!history)
        return tl::unexpected<Error>(history.error());
    CertificateIssue issue = issueOf(order, record, files["results.json"]);
    issue.history = std::move(history->section);
    if (outcome.results.response)
        files[kDccFile] = certificateDcc(
            certificateOf(outcome.results, recipe, record.reservedUtc, chosen, issue),
            outcome.results, recipe, issue);
    if (const Result<void> dcc = signDcc(order, files); !dcc)
        return tl::unexpected<Error>(dcc.error());
    issue.filesSha256 = boundFilesHash(hashesOf(files));
    issue.attachments = certificateAttachments(files);
    Result<std::vector<DrawnFile>> drawn = drawWithoutWindow(
        outcome.results, recipe, record.reservedUtc, chosen, issue, history->figures);
    if (!drawn)
        return tl::unexpected<Error>(drawn.error());
    for (DrawnFile &file : *drawn)
        files[file.name] = std::move(file.bytes);
    return withSignedPdf(std::move(files), order);
}

std::vector<std::string> recordingsOf(const CaptureSet &captures)
{
    std::vector<std::string> paths;
    for (const InputFile &input : captures.inputs)
        paths.push_back(input.path);
    return paths;
}

Result<CertificateRecord> registerIssued(const std::string &registry, Index number,
    const std::map<std::string, std::string> &hashes, const std::string &utc)
{
    // The one that has the number; one that is missing by now is never made anew.
    Result<CertificateRegister> opened = CertificateRegister::openToChange(registry);
    if (!opened)
        return tl::unexpected<Error>(opened.error());
    return opened->markIssued(number, hashes, utc);
}

/// Of a job that is issued already: its folder must be where it is asked for.
Result<IssuedCertificate> issuedBefore(const IssueOrder &order, const CertificateRecord &record)
{
    const std::string folder = issuedFolder(order.output, record.number);
    const Result<FolderCheck> check = checkIssuedFolder(folder, nullptr);
    if (check && !check->firstDifference)
        return IssuedCertificate{record, folder,
            checkFolderSignatures(folder, {}).status != SignatureCheck::Status::Unsigned};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "This job was issued as certificate %1, and %2 does not hold it; name the folder that does (-o), or issue an amendment by --amends %1 --reason TEXT."),
            {std::to_string(record.number), folder}},
        "CER-006");
}

} // namespace

Result<IssuedCertificate> issueCertificate(const ProjectState &job, const PipelineOutcome &outcome,
    const ChosenTemplate &chosen, const IssueOrder &order)
{
    const Result<ReservedNumber> reserved
        = reserveNumber(order.registry, requestOf(job, outcome, order));
    if (!reserved)
        return tl::unexpected<Error>(reserved.error());
    const CertificateRecord &record = reserved->record;
    if (record.state != CertificateState::Reserved)
        return issuedBefore(order, record);
    const Result<Files> files = filesOf(job, outcome, chosen, order, record);
    if (!files)
        return tl::unexpected<Error>(files.error());
    const auto hashes
        = writeIssuedFolder(order.output, *reserved, *files, recordingsOf(*job.captures),
            [&] { return checkStillWhole(*job.captures); }, {interruptToken(), {}});
    if (!hashes)
        return tl::unexpected<Error>(hashes.error());
    const Result<CertificateRecord> issued
        = registerIssued(order.registry, record.number, *hashes, order.names.utc);
    if (!issued)
        return tl::unexpected<Error>(issued.error());
    return IssuedCertificate{*issued, issuedFolder(order.output, record.number),
        order.signing.isSigned(), order.signing.authority};
}

} // namespace dyncal
