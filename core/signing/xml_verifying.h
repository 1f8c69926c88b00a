// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/signature_check.h"
#include "core/xml/xml_limits.h"

#include <string_view>

namespace dyncal {

/// Holds the signature of an XML document against it. Only the one form that signedXml() writes is
/// accepted, once in the document, as the last child of its root; anything else, as a reference to
/// a part, another transform or a second signature, is Changed; so is a comment in the text of an
/// element, and any other is remarked. A document without any is Unsigned. Nothing is fetched.
SignatureCheck checkXmlSignature(std::string_view xml, const TrustSettings &trust);

} // namespace dyncal
