// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/signature_check.h"
#include "core/signing/signing_key.h"

#include <string>
#include <string_view>

namespace dyncal {

/// A detached CMS (RFC 5652, DER) over content with this SHA-256 (64 hexadecimal digits), with the
/// signed attributes of PAdES (EN 319 142-1, 6.3): content type, message digest and
/// signing-certificate-v2, and none else: the time of signing stands in the PDF. RSA signs with
/// PKCS#1 v1.5, so that the same hash and key give the same bytes; an elliptic curve does not. Key
/// and certificates are the key's. Fails (Internal) where the key, as one of a token, refuses to
/// sign.
Result<std::string> cmsOfHash(const std::string &sha256, const SigningKey &key);

/// Holds a detached CMS against the content it is for: one signer, SHA-256, SHA-384 or SHA-512, the
/// signing-certificate attribute where there is one, the signature, its time stamp, the signer.
/// `content` are the pieces that together are signed. `statedUtc`: the moment of signing where the
/// CMS states none.
SignatureCheck checkCms(std::string_view der, const std::vector<std::string_view> &content,
    const std::string &statedUtc, const TrustSettings &trust);

/// The same of content of which only the SHA-256 is known, and whoever signed it: whether it is a
/// signature over it at all. A sentence says why not.
std::optional<Message> faultOfCms(std::string_view der, const std::string &sha256);

/// Whether the signer of a CMS is one that may sign certificates now, as of a key (SigningKey):
/// fails (DataBlocked) where it is none, (Usage) where its key is not strong, its certificate not
/// for signatures or not valid at `utc`. `source`: who gave it, for the sentence.
Result<void> checkSignerOfCms(
    std::string_view der, const std::string &source, const std::string &utc);

} // namespace dyncal
