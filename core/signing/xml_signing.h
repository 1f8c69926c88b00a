// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/signing_key.h"
#include "core/xml/xml_limits.h"

#include <string>

namespace dyncal {

/// Signs an XML document as a whole by an enveloped XML signature (XML-DSig), put before the end
/// tag of its root without any other change: exclusive canonicalisation without comments, SHA-256,
/// RSA PKCS#1 v1.5 or ECDSA, the signer's certificate and those above it as X509Data. With RSA the
/// same document and key give the same bytes. Comments are not signed (XML-DSig, 4.4.3.3). Fails
/// (FileUnreadable) for what is no XML within the limits (no document type, no entities,
/// kMostXmlBytes) or has a signature already, and (Internal) where the key refuses to sign.
Result<std::string> signedXml(const std::string &xml, const SigningKey &key);

/// The document without the signature that signedXml() put in: what it got, byte for byte.
std::string withoutXmlSignature(const std::string &xml);

} // namespace dyncal
