// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_signature.h"

#include "core/certificate/certificate_words.h"

namespace dyncal {
namespace {

CertificateSection emptySection()
{
    CertificateSection section;
    section.id = kSignatureSection;
    section.title = {DYNCAL_TEXT("core", "Electronic signature"), {}};
    return section;
}

CertificateSection saying(Message sentence)
{
    CertificateSection section = emptySection();
    section.paragraphs.push_back(std::move(sentence));
    return section;
}

} // namespace

CertificateSection signatureToCome()
{
    return saying(
        {DYNCAL_TEXT("core",
             "When the certificate is issued, who signs it, when, and its number are stated here."),
            {}});
}

CertificateSection withoutSignature()
{
    return saying(
        {DYNCAL_TEXT("core", "This certificate was issued without an electronic signature."), {}});
}

CertificateSection signatureSection(const CertificateSigner &signer, const std::string &number)
{
    CertificateSection section = emptySection();
    const Message service{
        DYNCAL_TEXT(
            "core", "a service that signs for the laboratory; its name is in the signature"),
        {}};
    section.fields = {
        {"signed_by", {DYNCAL_TEXT("core", "Signed by"), {}},
            signer.name.empty() ? service : verbatim(signer.name)},
        {"signed_at", {DYNCAL_TEXT("core", "Signed at (UTC)"), {}}, verbatim(signer.utc)},
        {"signed_number", {DYNCAL_TEXT("core", "Number of the certificate"), {}}, verbatim(number)},
    };
    return section;
}

} // namespace dyncal
