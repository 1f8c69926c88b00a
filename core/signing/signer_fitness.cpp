// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signer_fitness.h"

#include "core/signing/certificate_facts.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr int kLeastRsaBits = 2048;
constexpr int kLeastSecurityBits = 112;
constexpr std::array<std::string_view, 3> kCurves{"prime256v1", "secp384r1", "secp521r1"};

/// As OpenSSL calls it; empty where it is none that has a name.
std::string curveOf(const EVP_PKEY *key)
{
    std::array<char, 80> name{};
    std::size_t size = 0;
    const bool isNamed = EVP_PKEY_get_group_name(key, name.data(), name.size(), &size) == 1;
    ERR_clear_error();
    return isNamed ? std::string(name.data(), size) : std::string();
}

/// Words for the hash under a certificate; empty where it is strong enough.
std::string weakHashOf(X509 *certificate)
{
    int hash = NID_undef, bits = 0;
    const bool isKnown = X509_get_signature_info(certificate, &hash, nullptr, &bits, nullptr) == 1;
    if (isKnown && bits >= kLeastSecurityBits)
        return {};
    const char *name = hash == NID_undef ? nullptr : OBJ_nid2ln(hash);
    return name != nullptr ? name : "-";
}

Message weak(const X509 *certificate, const std::string &what)
{
    return {DYNCAL_TEXT("core",
                "The certificate of “%1” rests on %2, which is too weak to show who signed."),
        {subjectName(certificate), what}};
}

} // namespace

bool isStrongKey(const EVP_PKEY *key)
{
    const int kind = EVP_PKEY_get_base_id(key);
    if (kind == EVP_PKEY_RSA)
        return EVP_PKEY_get_bits(key) >= kLeastRsaBits;
    return kind == EVP_PKEY_EC && std::ranges::find(kCurves, curveOf(key)) != kCurves.end();
}

std::string kindOfKey(const EVP_PKEY *key)
{
    const int kind = EVP_PKEY_get_base_id(key);
    if (kind == EVP_PKEY_RSA)
        return "RSA, " + std::to_string(EVP_PKEY_get_bits(key)) + " bits";
    const std::string curve = kind == EVP_PKEY_EC ? curveOf(key) : std::string();
    const char *name = EVP_PKEY_get0_type_name(key);
    return !curve.empty() ? curve : name != nullptr ? name : "-";
}

std::optional<Message> weaknessOf(const std::vector<openssl::Certificate> &chain)
{
    for (std::size_t i = 0; i < chain.size(); ++i) {
        X509 *certificate = chain[i].get();
        const EVP_PKEY *key = X509_get0_pubkey(certificate);
        const bool isStrong = key != nullptr
            && (i == 0 ? isStrongKey(key) : EVP_PKEY_get_security_bits(key) >= kLeastSecurityBits);
        if (!isStrong)
            return weak(certificate, key != nullptr ? kindOfKey(key) : "-");
        const std::string hash = i + 1 < chain.size() ? weakHashOf(certificate) : std::string();
        if (!hash.empty())
            return weak(certificate, hash);
    }
    ERR_clear_error();
    return std::nullopt;
}

Result<void> checkFitToSign(X509 *certificate, const std::string &source)
{
    const EVP_PKEY *key = X509_get0_pubkey(certificate);
    if (key == nullptr || !isStrongKey(key))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The key in %1 (%3) is none to sign certificates with; take an RSA key of %2 bits or more (not RSA-PSS), or one of the curves P-256, P-384 and P-521."),
                {source, std::to_string(kLeastRsaBits),
                    key != nullptr ? kindOfKey(key) : std::string("-")}});
    if (!maySign(certificate))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The certificate of %1 is not for signatures: its key usage has neither digitalSignature nor nonRepudiation; take one that has."),
                {subjectName(certificate)}});
    if (isForOtherUse(certificate))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The certificate of %1 is one of a server or of a time-stamping authority (extended key usage), and not for signatures of documents; take one that is."),
                {subjectName(certificate)}});
    return {};
}

Result<void> checkSignerValidAt(const X509 *certificate, const std::string &utc)
{
    if (isValidAt(certificate, utc))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The certificate of %1 is valid from %2 to %3 and not at %4, when it would sign; take one that is valid."),
            {subjectName(certificate), validFrom(certificate), validUntil(certificate), utc}});
}

} // namespace dyncal
