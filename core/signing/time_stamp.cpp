// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/time_stamp.h"

#include "core/base/foreign_text.h"
#include "core/signing/cms_opened.h"
#include "core/signing/time_stamp_check.h"

namespace dyncal {
namespace {

using Request = std::unique_ptr<TS_REQ, openssl::Freed<&TS_REQ_free>>;
using Reply = std::unique_ptr<TS_RESP, openssl::Freed<&TS_RESP_free>>;

constexpr std::size_t kNonceBytes = 8;

openssl::Bytes sha256Of(std::string_view bytes)
{
    openssl::Bytes digest(static_cast<std::size_t>(EVP_MD_get_size(EVP_sha256())));
    EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
    return digest;
}

/// A number that only this signature has; an authority that repeats it answers this request.
openssl::Bytes nonceOf(const openssl::Bytes &digest)
{
    openssl::Bytes bytes = sha256Of({reinterpret_cast<const char *>(digest.data()), digest.size()});
    bytes.resize(kNonceBytes);
    bytes.front() |= 1; // no leading zero
    bytes.front() &= 0x7F; // positive
    return bytes;
}

std::string requestOver(std::string_view signature)
{
    const openssl::Bytes digest = sha256Of(signature), nonce = nonceOf(digest);
    const Request request(TS_REQ_new());
    const std::unique_ptr<TS_MSG_IMPRINT, openssl::Freed<&TS_MSG_IMPRINT_free>> imprint(
        TS_MSG_IMPRINT_new());
    const std::unique_ptr<X509_ALGOR, openssl::Freed<&X509_ALGOR_free>> algorithm(X509_ALGOR_new());
    const std::unique_ptr<ASN1_INTEGER, openssl::Freed<&ASN1_INTEGER_free>> number(
        ASN1_INTEGER_new());
    X509_ALGOR_set0(algorithm.get(), OBJ_nid2obj(NID_sha256), V_ASN1_NULL, nullptr);
    ASN1_STRING_set(number.get(), nonce.data(), static_cast<int>(nonce.size()));
    TS_MSG_IMPRINT_set_algo(imprint.get(), algorithm.get());
    TS_MSG_IMPRINT_set_msg(
        imprint.get(), const_cast<unsigned char *>(digest.data()), static_cast<int>(digest.size()));
    TS_REQ_set_version(request.get(), 1);
    TS_REQ_set_msg_imprint(request.get(), imprint.get());
    TS_REQ_set_nonce(request.get(), number.get());
    TS_REQ_set_cert_req(request.get(), 1);
    return openssl::derOf(request.get(), &i2d_TS_REQ);
}

long statusOf(TS_RESP *reply)
{
    return ASN1_INTEGER_get(TS_STATUS_INFO_get0_status(TS_RESP_get_status_info(reply)));
}

bool isGranted(TS_RESP *reply)
{
    const long status = statusOf(reply);
    return status == TS_STATUS_GRANTED || status == TS_STATUS_GRANTED_WITH_MODS;
}

/// What the authority says of it; "-" where it says nothing.
std::string wordsOf(TS_RESP *reply)
{
    const STACK_OF(ASN1_UTF8STRING) *texts
        = TS_STATUS_INFO_get0_text(TS_RESP_get_status_info(reply));
    const ASN1_UTF8STRING *text
        = sk_ASN1_UTF8STRING_num(texts) > 0 ? sk_ASN1_UTF8STRING_value(texts, 0) : nullptr;
    const int size = text != nullptr ? ASN1_STRING_length(text) : 0;
    return size <= 0
        ? std::string("-")
        : presentableInBrief({reinterpret_cast<const char *>(ASN1_STRING_get0_data(text)),
            static_cast<std::size_t>(size)});
}

bool hasNonce(TS_RESP *reply, std::string_view signature)
{
    const openssl::Bytes nonce = nonceOf(sha256Of(signature));
    const ASN1_INTEGER *stated = TS_TST_INFO_get_nonce(TS_RESP_get_tst_info(reply));
    return stated != nullptr
        && std::string_view(reinterpret_cast<const char *>(ASN1_STRING_get0_data(stated)),
               static_cast<std::size_t>(ASN1_STRING_length(stated)))
        == std::string_view(reinterpret_cast<const char *>(nonce.data()), nonce.size());
}

Reply openedReply(std::string_view reply)
{
    const unsigned char *place = openssl::bytesOf(reply);
    return Reply(d2i_TS_RESP(nullptr, &place, static_cast<long>(reply.size())));
}

/// The token in a reply that grants it for this signature; empty otherwise.
std::string tokenIn(const Reply &opened, std::string_view signature)
{
    if (!opened || !isGranted(opened.get()) || TS_RESP_get_token(opened.get()) == nullptr
        || !hasNonce(opened.get(), signature))
        return {};
    std::string token = openssl::derOf(TS_RESP_get_token(opened.get()), &i2d_PKCS7);
    return momentOfToken(token, signature).empty() ? std::string() : token;
}

} // namespace

Result<std::string> withTimeStamp(const std::string &cms, const AskAuthority &ask)
{
    const Result<openssl::OpenedCms> opened = openssl::openCms(cms);
    if (!opened)
        return tl::unexpected<Error>(opened.error());
    const ASN1_OCTET_STRING *value = CMS_SignerInfo_get0_signature(opened->signer);
    const std::string_view signature(reinterpret_cast<const char *>(ASN1_STRING_get0_data(value)),
        static_cast<std::size_t>(ASN1_STRING_length(value)));
    const Result<std::string> reply = ask(requestOver(signature));
    if (!reply)
        return reply;
    const Reply answer = openedReply(*reply);
    const std::string token = tokenIn(answer, signature);
    ERR_clear_error();
    if (answer && !isGranted(answer.get()))
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The time-stamping authority refused to stamp this signature (PKIStatus %1, %2); ask those who run it, or take another by --tsa."),
                {std::to_string(statusOf(answer.get())), wordsOf(answer.get())}});
    if (token.empty())
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The time-stamping authority answered, but not with a time stamp over this signature; look whether the address (--tsa) is that of an RFC 3161 service."),
                {}});
    CMS_unsigned_add1_attr_by_NID(opened->signer, NID_id_smime_aa_timeStampToken, V_ASN1_SEQUENCE,
        token.data(), static_cast<int>(token.size()));
    return openssl::derOf(opened->cms.get(), &i2d_CMS_ContentInfo);
}

} // namespace dyncal
