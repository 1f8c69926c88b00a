// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room only: who is fit to sign, and what is too weak to be believed.

#include "core/base/result.h"
#include "core/signing/openssl_handles.h"

#include <optional>

namespace dyncal {

/// Whether signatures of documents may rest on this key: RSA of 2048 bits or more, or the curves
/// P-256, P-384 and P-521, which other programs verify too.
bool isStrongKey(const EVP_PKEY *key);

/// "RSA, 1024 bits", "secp256k1", "ED25519", "RSA-PSS": what a key is.
std::string kindOfKey(const EVP_PKEY *key);

/// What is too weak in a chain, the signer's certificate first: its key (isStrongKey), a key above
/// it with less than 112 bits of security, or a hash with less under any certificate but the last,
/// which is trusted by itself (as level 2 of X509_VERIFY_PARAM_set_auth_level(3) has it).
std::optional<Message> weaknessOf(const std::vector<openssl::Certificate> &chain);

/// Fails (Usage) where the certificate's key is not strong, or its usage or its extended usage is
/// not for signatures of documents; `source`: where the key is.
Result<void> checkFitToSign(X509 *certificate, const std::string &source);

/// Fails (Usage) where the certificate is not valid at this moment (ISO 8601, UTC).
Result<void> checkSignerValidAt(const X509 *certificate, const std::string &utc);

} // namespace dyncal
