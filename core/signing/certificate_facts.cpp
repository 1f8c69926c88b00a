// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/certificate_facts.h"

#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace dyncal {
namespace {

std::string entryOf(const X509_NAME *name, int nid)
{
    const int place = X509_NAME_get_index_by_NID(name, nid, -1);
    if (place < 0)
        return {};
    unsigned char *text = nullptr;
    const int size
        = ASN1_STRING_to_UTF8(&text, X509_NAME_ENTRY_get_data(X509_NAME_get_entry(name, place)));
    std::string entry(size > 0 ? reinterpret_cast<char *>(text) : "",
        size > 0 ? static_cast<std::size_t>(size) : 0);
    OPENSSL_free(text);
    return entry;
}

std::string wholeName(const X509_NAME *name)
{
    const openssl::Bio out(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(out.get(), name, 0, XN_FLAG_ONELINE & ~ASN1_STRFLGS_ESC_MSB);
    char *text = nullptr;
    const long size = BIO_get_mem_data(out.get(), &text);
    return size > 0 ? std::string(text, static_cast<std::size_t>(size)) : std::string();
}

} // namespace

std::string subjectName(const X509 *certificate)
{
    const X509_NAME *name = X509_get_subject_name(certificate);
    for (const int nid : {NID_commonName, NID_organizationName})
        if (std::string entry = entryOf(name, nid); !entry.empty())
            return entry;
    return wholeName(name);
}

std::string utcText(const ASN1_TIME *time)
{
    std::tm moment{};
    if (time == nullptr || ASN1_TIME_to_tm(time, &moment) != 1)
        return {};
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &moment)};
}

std::string validFrom(const X509 *certificate)
{
    return utcText(X509_get0_notBefore(certificate));
}

std::string validUntil(const X509 *certificate)
{
    return utcText(X509_get0_notAfter(certificate));
}

bool isValidAt(const X509 *certificate, const std::string &utc)
{
    const std::string from = validFrom(certificate), until = validUntil(certificate);
    return !from.empty() && from <= utc && utc <= until;
}

bool maySign(X509 *certificate)
{
    // All bits are set where the certificate states no usage.
    return (X509_get_key_usage(certificate) & (KU_DIGITAL_SIGNATURE | KU_NON_REPUDIATION)) != 0;
}

bool isForOtherUse(const X509 *certificate)
{
    constexpr std::array kOthers{NID_server_auth, NID_time_stamp, NID_OCSP_sign};
    const std::unique_ptr<EXTENDED_KEY_USAGE, openssl::Freed<&EXTENDED_KEY_USAGE_free>> uses(
        static_cast<EXTENDED_KEY_USAGE *>(
            X509_get_ext_d2i(certificate, NID_ext_key_usage, nullptr, nullptr)));
    int others = 0;
    for (int i = 0; uses && i < sk_ASN1_OBJECT_num(uses.get()); ++i)
        others += std::ranges::find(kOthers, OBJ_obj2nid(sk_ASN1_OBJECT_value(uses.get(), i)))
                != kOthers.end()
            ? 1
            : 0;
    return others > 0 && others == sk_ASN1_OBJECT_num(uses.get());
}

} // namespace dyncal
