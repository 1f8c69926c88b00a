// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/xml/xml_limits.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dyncal {

/// An element of an XML document, as a value.
struct ParsedElement
{
    std::string
        name; ///< without the prefix of its namespace, which every writer chooses; KnownSpace
    std::string text; ///< all of its own, as it stands; "" where it is of blanks alone
    Index line = 0; ///< of the file, from 1
    std::vector<std::pair<std::string, std::string>> attributes = {}; ///< names without prefix
    std::vector<ParsedElement> children = {};

    std::string trimmedText() const; ///< blanks at both ends left out
    std::string attribute(std::string_view named) const; ///< "" where there is none
    const ParsedElement *child(
        std::string_view named) const; ///< the first; null where there is none
    std::vector<const ParsedElement *> all(std::string_view named) const; ///< children, not below
    /// The first child of the first child ... ; null where one of them is missing.
    const ParsedElement *at(const std::vector<std::string_view> &path) const;
    /// Blanks at both ends left out; "" where it is missing.
    std::string textAt(const std::vector<std::string_view> &path) const;
};

/// Whether elements of the namespace with this address have their plain names; those of others are
/// named "{address}name". Of a prefix that nobody declares the address is "prefix:".
using KnownSpace = bool (*)(std::string_view address);

/// Reads a document in UTF-8, UTF-16 or, where it says so, Latin-1. Nothing is fetched and nothing
/// expanded: a document type, which alone can declare entities, is refused. Without `isKnown` every
/// namespace is known, and elements in none are known always. Fails (FileUnreadable) on that, on
/// malformed XML (faultOfXml()), and beyond the limits of xml_limits.h, in time and memory linear
/// in the bytes.
Result<ParsedElement> readXml(std::string_view bytes, KnownSpace isKnown = nullptr);

/// The words of a text between the blanks of XML.
std::vector<std::string> wordsIn(std::string_view text);

} // namespace dyncal
