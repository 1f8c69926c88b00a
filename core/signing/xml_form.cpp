// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_form.h"

#include <algorithm>
#include <initializer_list>

namespace dyncal::xml {
namespace {

using Nodes = std::vector<xmlNode *>;

/// Whether a node has these elements of XML-DSig as its children, in this order, and nothing else
/// but white space.
bool hasExactly(const xmlNode *parent, std::initializer_list<std::string_view> names)
{
    const Nodes children = elementsIn(parent);
    const bool hasOthers = [&] {
        for (const xmlNode *child = parent->children; child != nullptr; child = child->next)
            if (child->type != XML_ELEMENT_NODE && xmlIsBlankNode(child) != 1)
                return true;
        return false;
    }();
    return !hasOthers
        && std::ranges::equal(children, names,
            [](const xmlNode *node, std::string_view name) { return isOfSignature(node, name); });
}

/// The one attribute of a node that has that one and no other; "?" otherwise.
std::string onlyAttribute(xmlNode *node, const char *name)
{
    const xmlAttr *attribute = node->properties;
    if (attribute == nullptr || attribute->next != nullptr || attribute->ns != nullptr
        || reinterpret_cast<const char *>(attribute->name) != std::string_view(name))
        return "?";
    xmlChar *value = xmlNodeListGetString(node->doc, attribute->children, 1);
    std::string text = value != nullptr ? reinterpret_cast<char *>(value) : "";
    xmlFree(value);
    return text;
}

bool isMethod(xmlNode *node, std::initializer_list<const char *> algorithms)
{
    return elementsIn(node).empty()
        && std::ranges::find(algorithms, onlyAttribute(node, "Algorithm")) != algorithms.end();
}

bool isReference(xmlNode *node)
{
    if (!onlyAttribute(node, "URI").empty()
        || !hasExactly(node, {"Transforms", "DigestMethod", "DigestValue"}))
        return false;
    const Nodes parts = elementsIn(node);
    if (!hasExactly(parts[0], {"Transform", "Transform"}) || parts[0]->properties != nullptr)
        return false;
    const Nodes transforms = elementsIn(parts[0]);
    return isMethod(transforms[0], {kEnveloped}) && isMethod(transforms[1], {kCanonical})
        && isMethod(parts[1], {kSha256}) && elementsIn(parts[2]).empty();
}

bool isSignedInfo(xmlNode *node)
{
    if (node->properties != nullptr
        || !hasExactly(node, {"CanonicalizationMethod", "SignatureMethod", "Reference"}))
        return false;
    const Nodes parts = elementsIn(node);
    return isMethod(parts[0], {kCanonical}) && isMethod(parts[1], {kRsa, kEllipticCurve})
        && isReference(parts[2]);
}

std::string contentOf(xmlNode *node)
{
    xmlChar *content = xmlNodeGetContent(node);
    std::string text = content != nullptr ? reinterpret_cast<char *>(content) : "";
    xmlFree(content);
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
    return text;
}

/// A certificate in base64; null where it is none.
openssl::Certificate certificateIn(xmlNode *node)
{
    const std::string text = contentOf(node);
    openssl::Bytes der(text.size());
    const int size = text.size() > 65536
        ? -1
        : EVP_DecodeBlock(der.data(), openssl::bytesOf(text), static_cast<int>(text.size()));
    const unsigned char *place = der.data();
    openssl::Certificate certificate(size > 0 ? d2i_X509(nullptr, &place, size) : nullptr);
    ERR_clear_error();
    return certificate;
}

/// All certificates of KeyInfo/X509Data; empty where there is anything else.
std::vector<openssl::Certificate> certificatesOf(xmlNode *keyInfo)
{
    std::vector<openssl::Certificate> list;
    if (!hasExactly(keyInfo, {"X509Data"}))
        return list;
    for (xmlNode *one : elementsIn(elementsIn(keyInfo)[0])) {
        openssl::Certificate certificate
            = isOfSignature(one, "X509Certificate") ? certificateIn(one) : nullptr;
        if (!certificate)
            return {};
        list.push_back(std::move(certificate));
    }
    return list;
}

bool isLastChild(const xmlNode *node, const xmlNode *root)
{
    return node->parent == root && elementsIn(root).back() == node;
}

} // namespace

FoundXmlSignature signatureIn(xmlDoc *document)
{
    xmlNode *root = xmlDocGetRootElement(document);
    const Nodes signatures = elementsNamed(root, "Signature");
    FoundXmlSignature found{signatures.empty() && elementsNamed(root, "SignedInfo").empty()
        && elementsNamed(root, "SignatureValue").empty()};
    if (signatures.size() != 1 || !isOfSignature(signatures[0], "Signature")
        || !isLastChild(signatures[0], root)
        || !hasExactly(signatures[0], {"SignedInfo", "SignatureValue", "KeyInfo"}))
        return found;
    const Nodes parts = elementsIn(signatures[0]);
    if (!isSignedInfo(parts[0]) || !elementsIn(parts[1]).empty())
        return found;
    found.element = signatures[0];
    found.certificates = certificatesOf(parts[2]);
    return found;
}

} // namespace dyncal::xml
