// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room only.

#include "core/base/result.h"
#include "core/signing/openssl_handles.h"

#include <optional>

namespace dyncal::openssl {

struct FreedStack
{
    void operator()(STACK_OF(X509) * stack) const { sk_X509_pop_free(stack, &X509_free); }
};

/// A CMS with its one signer.
struct OpenedCms
{
    Cms cms;
    std::unique_ptr<STACK_OF(X509), FreedStack> others; ///< all certificates in it
    CMS_SignerInfo *signer = nullptr; ///< of `cms`
    X509 *certificate = nullptr; ///< the signer's, of `cms`
};

/// Opens a detached CMS (DER, nothing behind it) with one signer, whose certificate is in it. Fails
/// (DataBlocked) for anything else, with what is wrong.
Result<OpenedCms> openCms(std::string_view der);

/// Bytes of hexadecimal digits; of a wrong one and all behind it none.
Bytes bytesOfHex(std::string_view digits);

/// SHA-256, SHA-384 and SHA-512, by their numbers in OpenSSL.
bool isAcceptedHash(int hash);

/// Hash with which its signer works: SHA-256 where it is none that is accepted (faultOf() says so).
const EVP_MD *digestAlgorithm(const OpenedCms &opened);

/// What is wrong with the signature over content with this hash; empty: nothing.
std::optional<Message> faultOf(const OpenedCms &opened, const Bytes &digest);

/// Attribute of that name; empty where there is none.
std::string signingTime(const OpenedCms &opened);

} // namespace dyncal::openssl
