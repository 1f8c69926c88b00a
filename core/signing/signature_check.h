// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Against what a signature is held.
struct TrustSettings
{
    std::string anchors; ///< certificates that are trusted, PEM; empty: none
    std::string utc; ///< the moment of looking, ISO 8601, UTC
};

/// What is known of the signature of a document. Only Valid says that the bytes are the signer's
/// and the signer is known by certificates that are strong enough; UnknownSigner and Expired say
/// that the bytes are as they were signed.
struct SignatureCheck
{
    enum class Status { Valid, Unsigned, Changed, UnknownSigner, Expired };

    Status status = Status::Unsigned;
    std::string signer = {}; ///< name in its certificate; known only for bytes that are unchanged
    std::string certificate = {}; ///< SHA-256 of that certificate, 64 hexadecimal digits
    std::string signedUtc = {}; ///< as the signature states it; empty: not stated
    std::string stampedUtc = {}; ///< by a time stamp that is right; empty: none
    std::optional<Message> difference = {}; ///< of Changed
    std::vector<Message> remarks = {};

    bool operator==(const SignatureCheck &) const = default;
};

/// Reads certificates (PEM) to trust. Fails (FileUnreadable) where there is none.
Result<std::string> readAnchors(const std::string &path);

/// "valid", "unsigned", "changed", "unknown-signer", "expired".
const char *signatureStatusName(SignatureCheck::Status status);

} // namespace dyncal
