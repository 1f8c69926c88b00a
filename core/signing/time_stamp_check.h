// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room only.

#include "core/signing/cms_opened.h"
#include "core/signing/signature_check.h"

namespace dyncal {

/// Looks at the time stamp of a signature that is right (RFC 3161, attribute
/// id-aa-timeStampToken): it must be over this signature, signed by its authority, which one of the
/// trusted certificates stands behind, and whose certificate was valid then. Puts the moment, or
/// the remark why it does not count, into the check; without a time stamp nothing.
void judgeStamp(
    const openssl::OpenedCms &opened, const TrustSettings &trust, SignatureCheck &check);

/// Moment of a token (DER) that is over `signature` and whose own signature is right, whoever made
/// it; empty otherwise.
std::string momentOfToken(std::string_view token, std::string_view signature);

} // namespace dyncal
