// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_issue.h"

#include "core/certificate/certificate_words.h"

#include <algorithm>

namespace dyncal {
namespace {

CertificateField replacedField(const CertificateIssue &issue)
{
    return {"amends", {DYNCAL_TEXT("core", "Replaces"), {}},
        {DYNCAL_TEXT("core", "certificate %V1, which is no longer valid; what changed: %V2"),
            {issue.amends, issue.reason}}};
}

Message stateOf(const CertificateIssue &issue)
{
    if (issue.signer && issue.amends.empty())
        return {DYNCAL_TEXT("core", "issued, with an electronic signature in this file"), {}};
    if (issue.signer)
        return {DYNCAL_TEXT(
                    "core", "issued as an amendment, with an electronic signature in this file"),
            {}};
    if (issue.amends.empty())
        return {DYNCAL_TEXT("core", "issued, not signed"), {}};
    return {DYNCAL_TEXT("core", "issued as an amendment, not signed"), {}};
}

CertificateSection issueSection(const CertificateIssue &issue)
{
    CertificateSection section;
    section.id = "issue";
    section.title = {DYNCAL_TEXT("core", "Issue"), {}};
    section.fields = {
        {"state", {DYNCAL_TEXT("core", "State"), {}}, stateOf(issue)},
        {"trail_head", {DYNCAL_TEXT("core", "Audit trail before issuing (SHA-256)"), {}},
            verbatim(issue.head)},
        {"results_sha256", {DYNCAL_TEXT("core", "SHA-256 of results.json"), {}},
            verbatim(issue.resultsSha256)},
    };
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "dyncal verify holds this page, the files beside it and the laboratory's registry against each other."),
            {}});
    return section;
}

/// A draft knows nothing of traceability; an issued one is refused without it.
void stateTraceability(CertificateData &data)
{
    const auto statements = std::ranges::find(data.sections, "statements", &CertificateSection::id);
    if (statements != data.sections.end() && !statements->paragraphs.empty())
        statements->paragraphs.back() = {
            DYNCAL_TEXT("core",
                "The results are traceable to the International System of Units (SI) through the reference standards that are listed with their certificates in the section \"Method\"."),
            {}};
}

/// What the draft had to leave open; nothing where the template does not have it.
void replaceSection(const CertificateSection &known, CertificateData &data)
{
    const auto open = std::ranges::find(data.sections, known.id, &CertificateSection::id);
    if (open != data.sections.end())
        *open = known;
}

} // namespace

void markIssued(const CertificateIssue &issue, CertificateData &data)
{
    data.draft = false;
    data.number = issue.number;
    data.marks = {{"number", issue.number}, {"amends", issue.amends}, {"head", issue.head},
        {"results", issue.resultsSha256}, {"files", issue.filesSha256}};
    data.attachments = issue.attachments;
    if (issue.signer)
        data.marks.emplace_back(kSignedMark, "true");
    if (!issue.amends.empty() && !data.sections.empty())
        data.sections.front().fields.push_back(replacedField(issue));
    stateTraceability(data);
    if (issue.history)
        replaceSection(*issue.history, data);
    replaceSection(
        issue.signer ? signatureSection(*issue.signer, issue.number) : withoutSignature(), data);
    const auto records = std::ranges::find(data.sections, "records", &CertificateSection::id);
    data.sections.insert(records, issueSection(issue));
}

CertificateData certificateOf(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen,
    const std::optional<CertificateIssue> &issue)
{
    CertificateData data = makeCertificate(results, recipe, createdUtc, chosen);
    if (issue)
        markIssued(*issue, data);
    return data;
}

} // namespace dyncal
