// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// What XML 1.0 forbids in a document, and where.
struct XmlFault
{
    Index line = 0; ///< from 1
    std::string what; ///< in libxml2's words
};

/// The first rule of well-formed XML 1.0 that the document in UTF-8, whatever its declaration says,
/// breaks: characters that are none ("&#0;"), entities that nobody declares, attributes given
/// twice, and all that pugixml passes over. Empty where it keeps them all. Nothing is built or
/// fetched; time linear in the bytes. The document has no document type and is no deeper than
/// kDeepestXml.
std::optional<XmlFault> faultOfXml(std::string_view utf8);

} // namespace dyncal
