// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/cms_signature.h"

#include "core/signing/cms_opened.h"
#include "core/signing/key_material.h"
#include "core/signing/raw_signature.h"
#include "core/signing/signer_fitness.h"
#include "core/signing/signer_standing.h"
#include "core/signing/time_stamp_check.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr unsigned kFlags = CMS_PARTIAL | CMS_DETACHED | CMS_BINARY | CMS_NOSMIMECAP | CMS_CADES;
constexpr unsigned char kSetTag = 0x31;
constexpr std::size_t kShortLength = 0x80, kByteLength = 0x100;

/// Tag and length before the bytes of a SET (X.690, 8.1.3).
std::string derSet(const std::string &content)
{
    std::string der(1, static_cast<char>(kSetTag));
    const std::size_t size = content.size();
    if (size >= kShortLength)
        der += static_cast<char>(size < kByteLength ? 0x81 : 0x82);
    if (size >= kByteLength)
        der += static_cast<char>(size / kByteLength);
    der += static_cast<char>(size % kByteLength);
    return der + content;
}

/// What is signed: the signed attributes as a SET OF in the order of DER (RFC 5652, 5.4).
std::string signedBytes(const CMS_SignerInfo *signer)
{
    std::vector<std::string> attributes;
    for (int i = 0; i < CMS_signed_get_attr_count(signer); ++i)
        attributes.push_back(openssl::derOf(CMS_signed_get_attr(signer, i), &i2d_X509_ATTRIBUTE));
    std::ranges::sort(attributes);
    std::string all;
    for (const std::string &one : attributes)
        all += one;
    return derSet(all);
}

/// OpenSSL 3.0 would put the time of signing among the attributes (CMS_SignerInfo_sign), which
/// PAdES forbids; so the signature is made here.
bool sign(CMS_SignerInfo *signer, EVP_PKEY *key)
{
    const std::string signature = openssl::signatureBy(key, signedBytes(signer));
    return !signature.empty()
        && ASN1_OCTET_STRING_set(CMS_SignerInfo_get0_signature(signer), openssl::bytesOf(signature),
               static_cast<int>(signature.size()))
        == 1;
}

bool addAttributes(CMS_SignerInfo *signer, const std::string &sha256)
{
    const openssl::Bytes digest = openssl::bytesOfHex(sha256);
    return CMS_signed_add1_attr_by_NID(signer, NID_pkcs9_messageDigest, V_ASN1_OCTET_STRING,
               digest.data(), static_cast<int>(digest.size()))
        == 1
        && CMS_signed_add1_attr_by_NID(
               signer, NID_pkcs9_contentType, V_ASN1_OBJECT, OBJ_nid2obj(NID_pkcs7_data), -1)
        == 1;
}

openssl::Cms builtCms(const std::string &sha256, const KeyMaterial &state)
{
    const openssl::Borrowed chain = openssl::borrowed(state.chain);
    openssl::Cms cms(CMS_sign(nullptr, nullptr, chain.get(), nullptr, kFlags));
    CMS_SignerInfo *signer = cms
        ? CMS_add1_signer(cms.get(), state.certificate.get(), state.key.get(), EVP_sha256(), kFlags)
        : nullptr;
    const bool isSigned
        = signer != nullptr && addAttributes(signer, sha256) && sign(signer, state.key.get());
    return isSigned ? std::move(cms) : nullptr;
}

/// Hash of the pieces together.
openssl::Bytes digestOf(const std::vector<std::string_view> &content, const EVP_MD *algorithm)
{
    const std::unique_ptr<EVP_MD_CTX, openssl::Freed<&EVP_MD_CTX_free>> context(EVP_MD_CTX_new());
    openssl::Bytes digest(EVP_MAX_MD_SIZE);
    unsigned size = 0;
    EVP_DigestInit_ex(context.get(), algorithm, nullptr);
    for (const std::string_view piece : content)
        EVP_DigestUpdate(context.get(), piece.data(), piece.size());
    EVP_DigestFinal_ex(context.get(), digest.data(), &size);
    digest.resize(size);
    return digest;
}

} // namespace

Result<std::string> cmsOfHash(const std::string &sha256, const SigningKey &key)
{
    const openssl::Cms cms = builtCms(sha256, key.material());
    ERR_clear_error();
    if (cms)
        return openssl::derOf(cms.get(), &i2d_CMS_ContentInfo);
    return fail(ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "The key of %1 does not sign; where it is one of a token, look whether the token is still there and unlocked."),
            {key.signer()}});
}

SignatureCheck checkCms(std::string_view der, const std::vector<std::string_view> &content,
    const std::string &statedUtc, const TrustSettings &trust)
{
    SignatureCheck check{.status = SignatureCheck::Status::Changed};
    const Result<openssl::OpenedCms> opened = openssl::openCms(der);
    if (!opened) {
        check.difference = opened.error().message;
        return check;
    }
    check.difference
        = openssl::faultOf(*opened, digestOf(content, openssl::digestAlgorithm(*opened)));
    if (check.difference)
        return check;
    check.signedUtc = openssl::signingTime(*opened);
    if (check.signedUtc.empty())
        check.signedUtc = statedUtc;
    judgeStamp(*opened, trust, check);
    judgeSigner(opened->certificate, opened->others.get(), trust, check);
    return check;
}

std::optional<Message> faultOfCms(std::string_view der, const std::string &sha256)
{
    const Result<openssl::OpenedCms> opened = openssl::openCms(der);
    return opened ? openssl::faultOf(*opened, openssl::bytesOfHex(sha256)) : opened.error().message;
}

Result<void> checkSignerOfCms(
    std::string_view der, const std::string &source, const std::string &utc)
{
    const Result<openssl::OpenedCms> opened = openssl::openCms(der);
    if (!opened)
        return tl::unexpected<Error>(opened.error());
    if (const Result<void> fit = checkFitToSign(opened->certificate, source); !fit)
        return fit;
    return checkSignerValidAt(opened->certificate, utc);
}

} // namespace dyncal
