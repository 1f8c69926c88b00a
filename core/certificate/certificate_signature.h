// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/project/certificate_template.h"

#include <string>

namespace dyncal {

/// Who signs a certificate's file, and when: known before its pages are drawn.
struct CertificateSigner
{
    std::string name = {}; ///< in the signer's certificate; empty: a service that says it later
    std::string utc = {}; ///< ISO 8601 with Z
};

/// The section kSignatureSection of a draft: says when it is filled.
CertificateSection signatureToCome();

/// That of a certificate that is issued without a signature.
CertificateSection withoutSignature();

/// That of a signed certificate: name, moment and number.
CertificateSection signatureSection(const CertificateSigner &signer, const std::string &number);

} // namespace dyncal
