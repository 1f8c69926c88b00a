// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room that know libxml2.

#include "core/signing/openssl_handles.h"
#include "core/signing/xml_document.h"

namespace dyncal::xml {

/// The signature of a document.
struct FoundXmlSignature
{
    bool isNone = false; ///< no trace of any
    xmlNode *element = nullptr; ///< only with certificates
    std::vector<openssl::Certificate> certificates
        = {}; ///< the signer's first; empty: not accepted
};

/// Looks for the signature and holds it against the one form that signedXml() writes, node by node:
/// what is not in that form never reaches xmlsec.
FoundXmlSignature signatureIn(xmlDoc *document);

} // namespace dyncal::xml
