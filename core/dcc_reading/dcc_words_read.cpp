// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_words_read.h"

#include <sstream>

namespace dyncal {

std::string wordsOfText(const ParsedElement *element)
{
    if (!element)
        return {};
    for (const ParsedElement *content : element->all("content"))
        if (content->attribute("lang") == "en")
            return content->text;
    return element->textAt({"content"});
}

std::vector<std::string> wordsOfAttribute(const ParsedElement &element, std::string_view name)
{
    std::vector<std::string> words;
    std::istringstream stream(element.attribute(name));
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

} // namespace dyncal
