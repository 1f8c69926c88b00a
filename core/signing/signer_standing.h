// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/openssl_handles.h"
#include "core/signing/signature_check.h"

namespace dyncal {

/// The certificates of a PEM text, in its order; empty where there are none.
std::vector<openssl::Certificate> certificatesIn(std::string_view pem);

/// The certificates from `leaf` up to one that is trusted, whatever their validity in time; empty
/// where none of the anchors stands behind it. `purpose`: X509_PURPOSE_ANY, or ..._TIMESTAMP_SIGN.
/// Nothing is fetched; whether a certificate was revoked is not looked up.
std::vector<openssl::Certificate> chainToAnchor(
    X509 *leaf, STACK_OF(X509) * others, const std::string &anchors, int purpose);

/// Puts what is known of the signer into the check of unchanged bytes: Valid, UnknownSigner or
/// Expired, with remarks. The certificates must be valid at the moment of the time stamp, if there
/// is one; else at the moment that the signature states and at that of looking. A signer whose
/// certificates are too weak (weaknessOf) is unknown: others may have forged them.
void judgeSigner(
    X509 *signer, STACK_OF(X509) * others, const TrustSettings &trust, SignatureCheck &check);

} // namespace dyncal
