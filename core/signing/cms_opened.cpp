// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/cms_opened.h"

#include "core/signing/certificate_facts.h"

#include <openssl/ess.h>

#include <algorithm>
#include <array>

namespace dyncal::openssl {
namespace {

constexpr std::array kAcceptedHashes{NID_sha256, NID_sha384, NID_sha512};

tl::unexpected<Error> unreadable()
{
    ERR_clear_error();
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "The signature is no detached CMS with one signer and the certificate of that signer: it was changed, or is of a kind that is not read here."),
            {}});
}

int hashOf(const OpenedCms &opened)
{
    X509_ALGOR *algorithm = nullptr;
    CMS_SignerInfo_get0_algs(opened.signer, nullptr, nullptr, &algorithm, nullptr);
    const ASN1_OBJECT *object = nullptr;
    X509_ALGOR_get0(&object, nullptr, nullptr, algorithm);
    return OBJ_obj2nid(object);
}

/// The one value of a signed attribute; null where it is not there once, with one value.
const ASN1_TYPE *valueOf(const OpenedCms &opened, int nid)
{
    const int place = CMS_signed_get_attr_by_NID(opened.signer, nid, -1);
    if (place < 0 || CMS_signed_get_attr_by_NID(opened.signer, nid, place) >= 0)
        return nullptr;
    X509_ATTRIBUTE *attribute = CMS_signed_get_attr(opened.signer, place);
    return X509_ATTRIBUTE_count(attribute) == 1 ? X509_ATTRIBUTE_get0_type(attribute, 0) : nullptr;
}

bool hasDigest(const OpenedCms &opened, const Bytes &digest)
{
    const ASN1_TYPE *value = valueOf(opened, NID_pkcs9_messageDigest);
    if (value == nullptr || value->type != V_ASN1_OCTET_STRING)
        return false;
    const ASN1_OCTET_STRING *stated = value->value.octet_string;
    return std::ranges::equal(digest,
        std::span(
            ASN1_STRING_get0_data(stated), static_cast<std::size_t>(ASN1_STRING_length(stated))));
}

bool isOfData(const OpenedCms &opened)
{
    const ASN1_TYPE *value = valueOf(opened, NID_pkcs9_contentType);
    return value != nullptr && value->type == V_ASN1_OBJECT
        && OBJ_obj2nid(value->value.object) == NID_pkcs7_data;
}

/// Whether the certificate is the one that was signed along (signing-certificate-v2), where the
/// signature says so.
bool isCertificateMeant(const OpenedCms &opened)
{
    if (CMS_signed_get_attr_by_NID(opened.signer, NID_id_smime_aa_signingCertificateV2, -1) < 0)
        return true;
    const ASN1_TYPE *value = valueOf(opened, NID_id_smime_aa_signingCertificateV2);
    if (value == nullptr || value->type != V_ASN1_SEQUENCE)
        return false;
    const unsigned char *der = ASN1_STRING_get0_data(value->value.sequence);
    const std::unique_ptr<ESS_SIGNING_CERT_V2, Freed<&ESS_SIGNING_CERT_V2_free>> meant(
        d2i_ESS_SIGNING_CERT_V2(nullptr, &der, ASN1_STRING_length(value->value.sequence)));
    const Borrowed chain(sk_X509_new_null());
    sk_X509_push(chain.get(), opened.certificate);
    for (int i = 0; i < sk_X509_num(opened.others.get()); ++i)
        sk_X509_push(chain.get(), sk_X509_value(opened.others.get(), i));
    return meant && OSSL_ESS_check_signing_certs(nullptr, meant.get(), chain.get(), 1) == 1;
}

/// Whether the signed attributes are DER (RFC 5652, 5.3). The library verifies them as it would
/// write them, and would not see a bit that only changes how they stand there.
bool hasAttributesAsWritten(const CMS_SignerInfo *signer, std::string_view der)
{
    std::string all;
    for (int i = 0; i < CMS_signed_get_attr_count(signer); ++i) {
        unsigned char *written = nullptr;
        const int size = i2d_X509_ATTRIBUTE(CMS_signed_get_attr(signer, i), &written);
        const std::unique_ptr<unsigned char, void (*)(unsigned char *)> kept(
            written, [](unsigned char *bytes) { OPENSSL_free(bytes); });
        if (size <= 0)
            return false;
        all.append(reinterpret_cast<const char *>(written), static_cast<std::size_t>(size));
    }
    const int size = ASN1_object_size(1, static_cast<int>(all.size()), 0);
    std::string field(static_cast<std::size_t>(size) - all.size(), '\0');
    auto *head = reinterpret_cast<unsigned char *>(field.data());
    ASN1_put_object(&head, 1, static_cast<int>(all.size()), 0, V_ASN1_CONTEXT_SPECIFIC);
    return all.empty() || der.find(field + all) != der.npos;
}

} // namespace

Result<OpenedCms> openCms(std::string_view der)
{
    const unsigned char *place = bytesOf(der);
    OpenedCms opened{Cms(d2i_CMS_ContentInfo(nullptr, &place, static_cast<long>(der.size()))), {}};
    if (!opened.cms || place != bytesOf(der) + der.size()
        || OBJ_obj2nid(CMS_get0_type(opened.cms.get())) != NID_pkcs7_signed
        || CMS_is_detached(opened.cms.get()) != 1)
        return unreadable();
    const STACK_OF(CMS_SignerInfo) *signers = CMS_get0_SignerInfos(opened.cms.get());
    opened.others.reset(CMS_get1_certs(opened.cms.get()));
    if (sk_CMS_SignerInfo_num(signers) != 1 || !opened.others)
        return unreadable();
    opened.signer = sk_CMS_SignerInfo_value(signers, 0);
    if (!hasAttributesAsWritten(opened.signer, der))
        return unreadable();
    CMS_set1_signers_certs(opened.cms.get(), nullptr, 0);
    CMS_SignerInfo_get0_algs(opened.signer, nullptr, &opened.certificate, nullptr, nullptr);
    if (opened.certificate == nullptr)
        return unreadable();
    return opened;
}

Bytes bytesOfHex(std::string_view digits)
{
    constexpr std::string_view kDigits = "0123456789abcdef", kCapitals = "0123456789ABCDEF";
    const auto valueOfDigit = [&](char c) { return std::min(kDigits.find(c), kCapitals.find(c)); };
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        const std::size_t high = valueOfDigit(digits[i]), low = valueOfDigit(digits[i + 1]);
        if (high == kDigits.npos || low == kDigits.npos)
            break;
        bytes.push_back(static_cast<unsigned char>(high * kDigits.size() + low));
    }
    return bytes;
}

bool isAcceptedHash(int hash)
{
    return std::ranges::find(kAcceptedHashes, hash) != kAcceptedHashes.end();
}

const EVP_MD *digestAlgorithm(const OpenedCms &opened)
{
    const int hash = hashOf(opened);
    return isAcceptedHash(hash) ? EVP_get_digestbynid(hash) : EVP_sha256();
}

std::optional<Message> faultOf(const OpenedCms &opened, const Bytes &digest)
{
    std::optional<Message> fault;
    if (!isAcceptedHash(hashOf(opened)))
        fault = Message{
            DYNCAL_TEXT("core",
                "The signature rests on a hash that is not accepted: SHA-256, SHA-384 and SHA-512 are."),
            {}};
    else if (!isOfData(opened) || !hasDigest(opened, digest))
        fault = Message{
            DYNCAL_TEXT("core", "What was signed is not what stands there now: it was changed."),
            {}};
    else if (CMS_SignerInfo_verify(opened.signer) != 1 || !isCertificateMeant(opened))
        fault = Message{
            DYNCAL_TEXT("core",
                "The signature was not made by the key of the certificate beside it: one of both was changed."),
            {}};
    ERR_clear_error();
    return fault;
}

std::string signingTime(const OpenedCms &opened)
{
    const ASN1_TYPE *value = valueOf(opened, NID_pkcs9_signingTime);
    const bool isTime = value != nullptr
        && (value->type == V_ASN1_UTCTIME || value->type == V_ASN1_GENERALIZEDTIME);
    return isTime ? utcText(value->value.asn1_string) : std::string();
}

} // namespace dyncal::openssl
