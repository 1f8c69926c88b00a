// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/dcc/xml_element.h"

#include <functional>
#include <string>
#include <vector>

namespace dyncal {

/// The sentence in a language ("sv"), places filled in, as the certificate prints it.
using DccTranslation
    = std::function<std::string(const Message &message, const std::string &language)>;

/// The words of a DCC: every text in each of its languages, beside each other.
struct DccWords
{
    std::vector<std::string> languages{"en"}; ///< ISO 639-1, at least one
    DccTranslation translate = {}; ///< empty: English, whatever the language

    /// dcc:content for each language, with its lang; one without where all have the same, as of
    /// what was typed. No text is empty: a dash stands for none.
    std::vector<XmlElement> contents(const Message &message) const;
    /// An element of dcc:textType, or of dcc:richContentType, which takes several sentences.
    XmlElement element(const std::string &name, const std::vector<Message> &sentences) const;
};

} // namespace dyncal
