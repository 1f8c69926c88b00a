// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_signature_text.h"

namespace dyncal {
namespace {

constexpr std::string_view kBegin = "<ds:Signature", kEnd = "</ds:Signature>";
const std::string kSpace = std::string(" xmlns:ds=\"") + xml::kSignatureSpace + '"';

std::string base64Of(std::string_view bytes)
{
    std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0'); // with a zero at the end
    EVP_EncodeBlock(reinterpret_cast<unsigned char *>(text.data()), openssl::bytesOf(bytes),
        static_cast<int>(bytes.size()));
    text.pop_back();
    return text;
}

std::string certificateElement(X509 *certificate)
{
    return "<ds:X509Certificate>" + base64Of(openssl::derOf(certificate, &i2d_X509))
        + "</ds:X509Certificate>";
}

/// With an end tag: canonical XML has no empty elements.
std::string method(const std::string &name, const char *algorithm)
{
    return "<ds:" + name + " Algorithm=\"" + algorithm + "\"></ds:" + name + ">";
}

std::string keyInfo(const KeyMaterial &state)
{
    std::string element = "<ds:KeyInfo><ds:X509Data>" + certificateElement(state.certificate.get());
    for (const openssl::Certificate &one : state.chain)
        element += certificateElement(one.get());
    return element + "</ds:X509Data></ds:KeyInfo>";
}

} // namespace

std::string canonicalSignedInfo(std::string_view digest, bool isRsa)
{
    return "<ds:SignedInfo" + kSpace + '>' + method("CanonicalizationMethod", xml::kCanonical)
        + method("SignatureMethod", isRsa ? xml::kRsa : xml::kEllipticCurve)
        + "<ds:Reference URI=\"\"><ds:Transforms>" + method("Transform", xml::kEnveloped)
        + method("Transform", xml::kCanonical) + "</ds:Transforms>"
        + method("DigestMethod", xml::kSha256) + "<ds:DigestValue>" + base64Of(digest)
        + "</ds:DigestValue></ds:Reference></ds:SignedInfo>";
}

std::string signatureElement(
    const std::string &signedInfo, std::string_view signature, const KeyMaterial &state)
{
    return std::string(kBegin) + kSpace + '>' + signedInfo + "<ds:SignatureValue>"
        + base64Of(signature) + "</ds:SignatureValue>" + keyInfo(state) + std::string(kEnd);
}

std::size_t endOfRoot(const std::string &xml, const xmlNode *root)
{
    std::string name = reinterpret_cast<const char *>(root->name);
    if (root->ns != nullptr && root->ns->prefix != nullptr)
        name = reinterpret_cast<const char *>(root->ns->prefix) + (':' + name);
    const std::size_t end = xml.rfind("</" + name);
    return end == xml.npos ? 0 : end;
}

} // namespace dyncal
