// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dyncal {

/// An element of an XML document as a value: either text or children.
struct XmlElement
{
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes = {};
    std::string text = {};
    std::vector<XmlElement> children = {};

    XmlElement &add(XmlElement child); ///< the child, as it now is
};

/// The text without what XML 1.0 cannot hold: bytes that are no UTF-8, and controls, written out as
/// presentable() does; line breaks stay.
std::string xmlCharacters(std::string_view text);

/// The same in one line, its blanks single and none at its ends: what a DCC calls not empty. The
/// words that stand in place of nothing are the caller's.
std::string inOneLine(std::string_view text);

/// The document with its declaration, UTF-8, one element on a line. Same value, same bytes.
std::string xmlText(const XmlElement &root);

} // namespace dyncal
