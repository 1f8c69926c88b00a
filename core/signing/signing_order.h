// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/signature_check.h"
#include "core/signing/signing_key.h"

#include <map>
#include <optional>
#include <stop_token>
#include <string>

namespace dyncal {

/// Who signs: a key, or a service that gets the hash only; or nobody.
struct SigningOrder
{
    std::optional<SigningKey> key = {};
    std::string sealCommand = {}; ///< instead of the key
    std::string authority
        = {}; ///< address of a time-stamping authority (RFC 3161); empty: no stamp

    bool isSigned() const { return key.has_value() || !sealCommand.empty(); }
};

/// Name in a PDF of whom a service signs for; that of the certificate stands in its CMS.
inline constexpr const char *kSealName = "Seal";

/// Name in the certificate of the order's key; empty without a key.
std::string signerOf(const SigningOrder &order);

/// The DCC with its XML signature. Without a key, as with a seal service, it stays as it is. Fails
/// as signedXml() does.
Result<std::string> signedDcc(const std::string &xml, const SigningOrder &order);

/// The PDF with everything embedded, signed: the last thing that is done to it. `utc` is the moment
/// of signing, ISO 8601, which the PDF states and at which the certificate must be valid. Fails as
/// signedPdf(), cmsOfHash(), sealedBy(), checkSignerOfCms() and withTimeStamp() do. Without an
/// order it stays as it is.
Result<std::string> signedCertificate(const std::string &pdf, const SigningOrder &order,
    const std::string &utc, const std::stop_token &stop);

} // namespace dyncal
