// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_signing.h"

#include "core/signing/raw_signature.h"
#include "core/signing/xml_document.h"
#include "core/signing/xml_signature_text.h"
#include "core/signing/xml_verifying.h"

#include <libxml/c14n.h>

namespace dyncal {
namespace {

/// SHA-256 of the document as exclusive canonicalisation without comments writes it; empty where
/// that fails. It is what the enveloped transform will leave of the signed document.
std::string digestOf(xmlDoc *document)
{
    const xml::Quiet quiet;
    xmlChar *canonical = nullptr;
    const int size
        = xmlC14NDocDumpMemory(document, nullptr, XML_C14N_EXCLUSIVE_1_0, nullptr, 0, &canonical);
    std::string digest(
        size > 0 ? static_cast<std::size_t>(EVP_MD_get_size(EVP_sha256())) : 0, '\0');
    if (size > 0)
        EVP_Digest(canonical, static_cast<std::size_t>(size),
            reinterpret_cast<unsigned char *>(digest.data()), nullptr, EVP_sha256(), nullptr);
    xmlFree(canonical);
    return digest;
}

/// The element Signature; empty where the key refuses. xmlsec takes no keys of OpenSSL's engines,
/// so that it only judges what is made here (adr/0031).
std::string signatureOver(const std::string &digest, const KeyMaterial &state)
{
    EVP_PKEY *key = state.key.get();
    const bool isRsa = EVP_PKEY_get_base_id(key) == EVP_PKEY_RSA;
    const std::string signedInfo = canonicalSignedInfo(digest, isRsa);
    const std::string made = openssl::signatureBy(key, signedInfo);
    const std::string signature = isRsa ? made : openssl::rawCurveSignature(made, key);
    ERR_clear_error();
    return signature.empty() ? std::string() : signatureElement(signedInfo, signature, state);
}

} // namespace

Result<std::string> signedXml(const std::string &xml, const SigningKey &key)
{
    const xml::Document document = xml::parsed(xml);
    const std::size_t end = document ? endOfRoot(xml, xmlDocGetRootElement(document.get())) : 0;
    const std::string digest = end == 0 ? std::string() : digestOf(document.get());
    if (digest.empty() || xml::unreadIn(document.get()) == xml::Unread::InText
        || !xml::elementsNamed(xmlDocGetRootElement(document.get()), "Signature").empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The XML document cannot be signed: it must be sound, without document type and entities, without comments in the text of an element, of at most %1 bytes and not signed yet."),
                {std::to_string(kMostXmlBytes)}});
    std::string made = xml;
    made.insert(end, signatureOver(digest, key.material()));
    // xmlsec reads it as others will; only the signer is not of interest here.
    const SignatureCheck check = checkXmlSignature(made, {});
    if (check.status != SignatureCheck::Status::Changed
        && check.status != SignatureCheck::Status::Unsigned)
        return made;
    return fail(ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "The key of %1 does not sign; where it is one of a token, look whether the token is still there and unlocked."),
            {key.signer()}});
}

std::string withoutXmlSignature(const std::string &xml)
{
    constexpr std::string_view kBegin = "<ds:Signature xmlns:ds=", kEnd = "</ds:Signature>";
    const std::size_t begin = xml.rfind(kBegin), end = xml.rfind(kEnd);
    if (begin == xml.npos || end == xml.npos || end < begin)
        return xml;
    return std::string(xml).erase(begin, end + kEnd.size() - begin);
}

} // namespace dyncal
