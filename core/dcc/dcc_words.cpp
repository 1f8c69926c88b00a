// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_words.h"

#include <algorithm>

namespace dyncal {
namespace {

std::string orDash(std::string text)
{
    return inOneLine(text).empty() ? "\xE2\x80\x93" : text;
}

} // namespace

std::vector<XmlElement> DccWords::contents(const Message &message) const
{
    std::vector<XmlElement> contents;
    for (const std::string &language : languages)
        contents.push_back({"dcc:content", {{"lang", language}},
            orDash(translate ? translate(message, language) : english(message))});
    const bool isOne = std::string_view(message.text).starts_with('%')
        && std::ranges::all_of(
            contents, [&](const XmlElement &one) { return one.text == contents.front().text; });
    if (isOne) {
        contents.resize(1);
        contents.front().attributes.clear();
    }
    return contents;
}

XmlElement DccWords::element(const std::string &name, const std::vector<Message> &sentences) const
{
    XmlElement element{name};
    for (const Message &sentence : sentences)
        for (XmlElement &content : contents(sentence))
            element.add(std::move(content));
    return element;
}

} // namespace dyncal
