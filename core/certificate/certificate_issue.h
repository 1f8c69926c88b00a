// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate.h"
#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_signature.h"

#include <optional>
#include <string>

namespace dyncal {

/// What makes a certificate of a draft: stands on its pages and in the file's metadata.
struct CertificateIssue
{
    std::string number;
    std::string amends = {}; ///< number of the certificate that it replaces; empty: none
    std::string reason = {}; ///< of the amendment: what changed
    std::string head = {}; ///< SHA-256 of the last entry of the audit trail before issuing
    std::string resultsSha256 = {}; ///< of results.json beside it
    std::string filesSha256 = {}; ///< of all files beside it (boundFilesHash); only in the metadata
    std::vector<CertificateAttachment> attachments = {}; ///< inside its PDF
    /// For that of the template (certificate_history.h), where it has one.
    std::optional<CertificateSection> history = {};
    std::optional<CertificateSigner> signer = {}; ///< of the file when it is whole; empty: unsigned
};

/// Mark of a certificate whose file is signed when it is whole.
inline constexpr const char *kSignedMark = "signed";

/// Makes the certificate an issued one: number, state, what it replaces, and what it is bound to.
void markIssued(const CertificateIssue &issue, CertificateData &data);

/// makeCertificate(), marked where it is issued.
CertificateData certificateOf(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen,
    const std::optional<CertificateIssue> &issue);

} // namespace dyncal
