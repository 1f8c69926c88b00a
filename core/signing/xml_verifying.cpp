// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_verifying.h"

#include "core/signing/signer_standing.h"
#include "core/signing/xml_document.h"
#include "core/signing/xml_form.h"
#include "core/signing/xml_scope.h"

#include <xmlsec/keys.h>
#include <xmlsec/openssl/evp.h>
#include <xmlsec/xmldsig.h>
#include <xmlsec/xmlsec.h>

namespace dyncal {
namespace {

using Context = std::unique_ptr<xmlSecDSigCtx, openssl::Freed<&xmlSecDSigCtxDestroy>>;

SignatureCheck changed(Message difference)
{
    return {.status = SignatureCheck::Status::Changed, .difference = std::move(difference)};
}

xmlSecKey *publicKeyOf(const X509 *certificate)
{
    openssl::PrivateKey key(X509_get_pubkey(const_cast<X509 *>(certificate)));
    xmlSecKeyData *data = key ? xmlSecOpenSSLEvpKeyAdopt(key.get()) : nullptr;
    if (data == nullptr)
        return nullptr;
    static_cast<void>(key.release()); // now of `data`
    xmlSecKey *made = xmlSecKeyCreate();
    if (made == nullptr || xmlSecKeySetValue(made, data) != 0) {
        xmlSecKeyDataDestroy(data);
        xmlSecKeyDestroy(made);
        return nullptr;
    }
    return made;
}

/// Whether what the one reference names has its digest.
bool isDigestRight(xmlSecDSigCtx &context)
{
    const auto *reference = static_cast<xmlSecDSigReferenceCtx *>(
        xmlSecPtrListGetItem(&context.signedInfoReferences, 0));
    return reference != nullptr && reference->status == xmlSecDSigStatusSucceeded;
}

std::optional<Message> faultOf(xmlNode *signature, const X509 *certificate)
{
    const xml::Quiet quiet;
    const Context context(xml::startXmlSec() ? xmlSecDSigCtxCreate(nullptr) : nullptr);
    if (context) {
        context->signKey = publicKeyOf(certificate);
        context->enabledReferenceUris = xmlSecTransformUriTypeEmpty;
    }
    const bool isDone = context && context->signKey != nullptr
        && xmlSecDSigCtxVerify(context.get(), signature) == 0;
    ERR_clear_error();
    if (isDone && context->status == xmlSecDSigStatusSucceeded)
        return std::nullopt;
    if (isDone && !isDigestRight(*context))
        return Message{DYNCAL_TEXT("core",
                           "What stands in the element %1 is not what was signed: it was changed."),
            {reinterpret_cast<const char *>(signature->parent->name)}};
    return Message{
        DYNCAL_TEXT("core",
            "The XML signature was not made by the key of the certificate in it: one of both was changed."),
        {}};
}

Message notRead(std::string_view xml)
{
    if (xml.size() <= kMostXmlBytes && !keepsXmlLimits(xml))
        return {
            DYNCAL_TEXT("core",
                "It is no XML document that is read: it may have at most %1 elements in %2 levels, and each with those around it at most %3 attributes and namespaces."),
            {std::to_string(kMostXmlElements), std::to_string(kDeepestXml),
                std::to_string(kMostXmlNames)}};
    return {
        DYNCAL_TEXT("core",
            "It is no XML document that is read: it must be sound, without document type and entities, of at most %1 bytes."),
        {std::to_string(kMostXmlBytes)}};
}

/// Comments are not signed (XML-DSig, 4.4.3.3), and could cut a number in two.
void judgeUnread(xml::Unread unread, SignatureCheck &check)
{
    if (unread == xml::Unread::InText)
        check = changed(
            {DYNCAL_TEXT("core",
                 "A comment or processing instruction stands in the text of an element, where the signature may not cover it and other programs may read another value; Dyncal writes none."),
                {}});
    else if (unread == xml::Unread::Beside)
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "The XML document has a comment or processing instruction, which Dyncal does not write and the signature may not cover: it may be anybody's."),
                {}});
}

} // namespace

SignatureCheck checkXmlSignature(std::string_view xml, const TrustSettings &trust)
{
    const xml::Document document = xml::parsed(xml);
    if (!document)
        return changed(notRead(xml));
    const xml::FoundXmlSignature found = xml::signatureIn(document.get());
    if (found.isNone)
        return {};
    if (found.certificates.empty())
        return changed(
            {DYNCAL_TEXT("core",
                 "The XML signature is damaged, or not of the one form that is accepted: over the whole document, once, as the last element of its root, with exclusive canonicalisation, SHA-256 and the signer's certificate."),
                {}});
    X509 *signer = found.certificates.front().get();
    if (std::optional<Message> fault = faultOf(found.element, signer))
        return changed(std::move(*fault));
    SignatureCheck check;
    judgeSigner(signer, openssl::borrowed(found.certificates).get(), trust, check);
    judgeUnread(xml::unreadIn(document.get()), check);
    return check;
}

} // namespace dyncal
