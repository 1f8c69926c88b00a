// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/time_stamp_check.h"

#include "core/signing/certificate_facts.h"
#include "core/signing/signer_fitness.h"
#include "core/signing/signer_standing.h"

#include <openssl/x509v3.h>

#include <algorithm>

namespace dyncal {
namespace {

using Info = std::unique_ptr<TS_TST_INFO, openssl::Freed<&TS_TST_INFO_free>>;

openssl::Pkcs7 openToken(std::string_view token)
{
    const unsigned char *place = openssl::bytesOf(token);
    return openssl::Pkcs7(d2i_PKCS7(nullptr, &place, static_cast<long>(token.size())));
}

bool isOver(TS_TST_INFO *info, std::string_view signature)
{
    TS_MSG_IMPRINT *imprint = TS_TST_INFO_get_msg_imprint(info);
    const ASN1_OBJECT *object = nullptr;
    X509_ALGOR_get0(&object, nullptr, nullptr, TS_MSG_IMPRINT_get_algo(imprint));
    const EVP_MD *algorithm = EVP_get_digestbyobj(object);
    if (algorithm == nullptr || EVP_MD_get_size(algorithm) < EVP_MD_get_size(EVP_sha256()))
        return false;
    openssl::Bytes digest(EVP_MAX_MD_SIZE);
    unsigned size = 0;
    EVP_Digest(signature.data(), signature.size(), digest.data(), &size, algorithm, nullptr);
    const ASN1_OCTET_STRING *stated = TS_MSG_IMPRINT_get_msg(imprint);
    return std::ranges::equal(std::span(digest.data(), size),
        std::span(
            ASN1_STRING_get0_data(stated), static_cast<std::size_t>(ASN1_STRING_length(stated))));
}

/// Whether its signers hashed with one of those that a certificate's signature may rest on.
bool isHashedWell(PKCS7 *token)
{
    const STACK_OF(PKCS7_SIGNER_INFO) *signers = PKCS7_get_signer_info(token);
    for (int i = 0; i < sk_PKCS7_SIGNER_INFO_num(signers); ++i) {
        const ASN1_OBJECT *hash = nullptr;
        X509_ALGOR_get0(
            &hash, nullptr, nullptr, sk_PKCS7_SIGNER_INFO_value(signers, i)->digest_alg);
        if (!openssl::isAcceptedHash(OBJ_obj2nid(hash)))
            return false;
    }
    return true;
}

/// Moment of a token over `signature`; empty where its signature is not right.
std::string momentOf(PKCS7 *token, std::string_view signature)
{
    if (token == nullptr || !PKCS7_type_is_signed(token) || !isHashedWell(token)
        || PKCS7_verify(token, nullptr, nullptr, nullptr, nullptr, PKCS7_NOVERIFY) != 1)
        return {};
    const Info info(PKCS7_to_TS_TST_INFO(token));
    return info && isOver(info.get(), signature) ? utcText(TS_TST_INFO_get_time(info.get()))
                                                 : std::string();
}

/// Why a token that is right does not count, where it does not: a trusted certificate must stand
/// behind the authority, all of them valid at that moment and strong.
std::optional<Message> faultOfAuthority(
    PKCS7 *token, const TrustSettings &trust, const std::string &utc)
{
    const openssl::Borrowed signers(PKCS7_get0_signers(token, nullptr, 0));
    std::vector<openssl::Certificate> chain;
    if (sk_X509_num(signers.get()) == 1)
        chain = chainToAnchor(sk_X509_value(signers.get(), 0), token->d.sign->cert, trust.anchors,
            X509_PURPOSE_TIMESTAMP_SIGN);
    const bool isTrusted = !chain.empty()
        && std::ranges::all_of(
            chain, [&](const openssl::Certificate &one) { return isValidAt(one.get(), utc); });
    if (!isTrusted)
        return Message{
            DYNCAL_TEXT("core",
                "The time stamp (%1) is by an authority behind which none of the certificates of --trust stands, and does not count."),
            {utc}};
    std::optional<Message> weakness = weaknessOf(chain);
    if (!weakness)
        return std::nullopt;
    return Message{DYNCAL_TEXT("core", "The time stamp (%1) does not count."), {utc}, {*weakness}};
}

std::string signatureOf(const openssl::OpenedCms &opened)
{
    const ASN1_OCTET_STRING *value = CMS_SignerInfo_get0_signature(opened.signer);
    return {reinterpret_cast<const char *>(ASN1_STRING_get0_data(value)),
        static_cast<std::size_t>(ASN1_STRING_length(value))};
}

/// The token among the unsigned attributes, DER; empty where there is none.
std::string tokenOf(const openssl::OpenedCms &opened)
{
    const int place
        = CMS_unsigned_get_attr_by_NID(opened.signer, NID_id_smime_aa_timeStampToken, -1);
    const ASN1_TYPE *value = place < 0
        ? nullptr
        : X509_ATTRIBUTE_get0_type(CMS_unsigned_get_attr(opened.signer, place), 0);
    if (value == nullptr || value->type != V_ASN1_SEQUENCE)
        return {};
    return {reinterpret_cast<const char *>(ASN1_STRING_get0_data(value->value.sequence)),
        static_cast<std::size_t>(ASN1_STRING_length(value->value.sequence))};
}

} // namespace

std::string momentOfToken(std::string_view token, std::string_view signature)
{
    std::string moment = momentOf(openToken(token).get(), signature);
    ERR_clear_error();
    return moment;
}

void judgeStamp(const openssl::OpenedCms &opened, const TrustSettings &trust, SignatureCheck &check)
{
    const std::string der = tokenOf(opened);
    if (der.empty())
        return;
    const openssl::Pkcs7 token = openToken(der);
    const std::string moment = momentOf(token.get(), signatureOf(opened));
    if (moment.empty())
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "The time stamp is not over this signature, or was changed, and does not count."),
                {}});
    else if (std::optional<Message> fault = faultOfAuthority(token.get(), trust, moment))
        check.remarks.push_back(std::move(*fault));
    else
        check.stampedUtc = moment;
    ERR_clear_error();
}

} // namespace dyncal
