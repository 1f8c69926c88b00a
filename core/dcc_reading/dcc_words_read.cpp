// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_words_read.h"

namespace dyncal {

std::string wordsOfText(const ParsedElement *element)
{
    if (!element)
        return {};
    for (const ParsedElement *content : element->all("content"))
        if (content->attribute("lang") == "en")
            return content->trimmedText();
    return element->textAt({"content"});
}

std::vector<std::string> wordsOfAttribute(const ParsedElement &element, std::string_view name)
{
    return wordsIn(element.attribute(name));
}

} // namespace dyncal
