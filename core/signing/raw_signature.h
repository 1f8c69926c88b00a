// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room only.

#include "core/signing/openssl_handles.h"

namespace dyncal::openssl {

/// Signature over the SHA-256 of `what`: RSA by PKCS#1 v1.5, an elliptic curve's as DER. Empty
/// where the key refuses.
std::string signatureBy(EVP_PKEY *key, std::string_view what);

/// An elliptic curve's signature as both numbers behind each other, as XML-DSig has it (RFC 6931,
/// 2.3.6). Empty where it is none.
std::string rawCurveSignature(const std::string &der, const EVP_PKEY *key);

} // namespace dyncal::openssl
