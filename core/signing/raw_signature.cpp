// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/raw_signature.h"

#include <openssl/ec.h>

namespace dyncal::openssl {

std::string signatureBy(EVP_PKEY *key, std::string_view what)
{
    const std::unique_ptr<EVP_MD_CTX, Freed<&EVP_MD_CTX_free>> context(EVP_MD_CTX_new());
    std::size_t size = 0;
    if (EVP_DigestSignInit(context.get(), nullptr, EVP_sha256(), nullptr, key) != 1
        || EVP_DigestSign(context.get(), nullptr, &size, bytesOf(what), what.size()) != 1)
        return {};
    std::string signature(size, '\0');
    auto *place = reinterpret_cast<unsigned char *>(signature.data());
    if (EVP_DigestSign(context.get(), place, &size, bytesOf(what), what.size()) != 1)
        return {};
    signature.resize(size);
    return signature;
}

std::string rawCurveSignature(const std::string &der, const EVP_PKEY *key)
{
    const unsigned char *place = bytesOf(der);
    const std::unique_ptr<ECDSA_SIG, Freed<&ECDSA_SIG_free>> signature(
        d2i_ECDSA_SIG(nullptr, &place, static_cast<long>(der.size())));
    const int size = (EVP_PKEY_get_bits(key) + 7) / 8;
    Bytes raw(2 * static_cast<std::size_t>(size));
    if (!signature || BN_bn2binpad(ECDSA_SIG_get0_r(signature.get()), raw.data(), size) != size
        || BN_bn2binpad(ECDSA_SIG_get0_s(signature.get()), raw.data() + size, size) != size)
        return {};
    return {raw.begin(), raw.end()};
}

} // namespace dyncal::openssl
