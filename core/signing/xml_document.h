// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room that know libxml2.

#include <libxml/parser.h>
#include <libxml/tree.h>
#include <libxml/xmlerror.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal::xml {

inline constexpr const char *kSignatureSpace = "http://www.w3.org/2000/09/xmldsig#";
inline constexpr const char *kCanonical = "http://www.w3.org/2001/10/xml-exc-c14n#";
inline constexpr const char *kEnveloped = "http://www.w3.org/2000/09/xmldsig#enveloped-signature";
inline constexpr const char *kSha256 = "http://www.w3.org/2001/04/xmlenc#sha256";
inline constexpr const char *kRsa = "http://www.w3.org/2001/04/xmldsig-more#rsa-sha256";
inline constexpr const char *kEllipticCurve = "http://www.w3.org/2001/04/xmldsig-more#ecdsa-sha256";

struct FreedDocument
{
    void operator()(xmlDoc *document) const { xmlFreeDoc(document); }
};
using Document = std::unique_ptr<xmlDoc, FreedDocument>;

/// Parses without network, document type and entities, within the limits of xml_limits.h
/// (keepsXmlLimits); null for anything else.
Document parsed(std::string_view bytes);

/// Comments and processing instructions of a document, which its readers pass over.
enum class Unread {
    None,
    Beside, ///< there are some
    InText, ///< one is among the text of an element, which readers then take for two texts, or half
};
Unread unreadIn(const xmlDoc *document);

/// The elements among the children.
std::vector<xmlNode *> elementsIn(const xmlNode *parent);

/// Whether it is an element of that name of XML-DSig.
bool isOfSignature(const xmlNode *node, std::string_view name);

/// All elements of that local name, whatever their namespace, at any depth.
std::vector<xmlNode *> elementsNamed(xmlNode *root, std::string_view name);

/// As long as it lives nothing of libxml2 on this thread is printed.
class Quiet
{
public:
    Quiet();
    Quiet(const Quiet &) = delete;
    Quiet &operator=(const Quiet &) = delete;
    ~Quiet();

private:
    xmlStructuredErrorFunc m_before;
    void *m_contextBefore;
};

/// Starts xmlsec once in the life of the program; false where it cannot be used.
bool startXmlSec();

} // namespace dyncal::xml
