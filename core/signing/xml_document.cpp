// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_document.h"

#include "core/signing/xml_scope.h"
#include "core/xml/xml_limits.h"

#include <algorithm>

#include <xmlsec/crypto.h>
#include <xmlsec/errors.h>
#include <xmlsec/xmlsec.h>

namespace dyncal::xml {
namespace {

void beSilent(const char *, int, const char *, const char *, const char *, int, const char *) { }

void passOver(void *, xmlErrorPtr) { }

const char *text(const xmlChar *name)
{
    return reinterpret_cast<const char *>(name);
}

/// The next element of the tree in the order of the document, down first; null behind the last.
xmlNode *following(xmlNode *node, const xmlNode *root)
{
    if (node->type == XML_ELEMENT_NODE && node->children != nullptr)
        return node->children;
    while (node != root && node->next == nullptr)
        node = node->parent;
    return node == root ? nullptr : node->next;
}

/// Among the children of an element, or of the document.
Unread unreadAmong(const xmlNode *children)
{
    bool isThere = false, hasText = false;
    for (const xmlNode *one = children; one != nullptr; one = one->next) {
        const bool isText = one->type == XML_TEXT_NODE || one->type == XML_CDATA_SECTION_NODE;
        isThere = isThere || one->type == XML_COMMENT_NODE || one->type == XML_PI_NODE;
        hasText = hasText || (isText && xmlIsBlankNode(one) != 1);
    }
    return !isThere ? Unread::None : hasText ? Unread::InText : Unread::Beside;
}

} // namespace

Unread unreadIn(const xmlDoc *document)
{
    Unread found = unreadAmong(document->children);
    xmlNode *root = xmlDocGetRootElement(document);
    for (xmlNode *node = root; node != nullptr; node = following(node, root))
        if (node->type == XML_ELEMENT_NODE)
            found = std::max(found, unreadAmong(node->children));
    return found;
}

Document parsed(std::string_view bytes)
{
    // Zeros are of UTF-16 and would hide a document type.
    if (bytes.empty() || bytes.size() > kMostXmlBytes || bytes.find('\0') != bytes.npos
        || bytes.find("<!DOCTYPE") != bytes.npos || bytes.find("<!ENTITY") != bytes.npos
        || !keepsXmlLimits(bytes))
        return {};
    Document document(xmlReadMemory(bytes.data(), static_cast<int>(bytes.size()), nullptr, nullptr,
        XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING));
    const bool isFit = document && document->intSubset == nullptr && document->extSubset == nullptr
        && xmlDocGetRootElement(document.get()) != nullptr;
    return isFit ? std::move(document) : nullptr;
}

std::vector<xmlNode *> elementsIn(const xmlNode *parent)
{
    std::vector<xmlNode *> list;
    for (xmlNode *child = parent->children; child != nullptr; child = child->next)
        if (child->type == XML_ELEMENT_NODE)
            list.push_back(child);
    return list;
}

bool isOfSignature(const xmlNode *node, std::string_view name)
{
    return node != nullptr && node->type == XML_ELEMENT_NODE && text(node->name) == name
        && node->ns != nullptr && text(node->ns->href) == std::string_view(kSignatureSpace);
}

std::vector<xmlNode *> elementsNamed(xmlNode *root, std::string_view name)
{
    std::vector<xmlNode *> list;
    for (xmlNode *node = root; node != nullptr; node = following(node, root))
        if (node->type == XML_ELEMENT_NODE && text(node->name) == name)
            list.push_back(node);
    return list;
}

Quiet::Quiet()
    : m_before(xmlStructuredError)
    , m_contextBefore(xmlStructuredErrorContext)
{
    xmlSetStructuredErrorFunc(nullptr, &passOver);
}

Quiet::~Quiet()
{
    xmlSetStructuredErrorFunc(m_contextBefore, m_before);
}

bool startXmlSec()
{
    static const bool isStarted = [] {
        xmlInitParser();
        const bool isReady = xmlSecInit() == 0 && xmlSecCryptoInit() == 0;
        xmlSecErrorsSetCallback(&beSilent); // xmlSecInit() sets its own, which prints
        return isReady;
    }();
    return isStarted;
}

} // namespace dyncal::xml
