// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/message.h"

#include "core/base/foreign_text.h"

namespace dyncal {

std::string fillPlaces(
    std::string_view text, const std::vector<std::string> &arguments, ArgumentText shown)
{
    const bool brief = shown == ArgumentText::Brief;
    std::string filled;
    filled.reserve(text.size() + 32);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isPlace
            = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9';
        const std::size_t number = isPlace ? static_cast<std::size_t>(text[i + 1] - '1') : 0;
        if (isPlace && number < arguments.size()) {
            filled += brief ? presentableInBrief(arguments[number])
                            : presentable(arguments[number], LineBreaks::Keep);
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

std::string english(const Message &message)
{
    std::string text = fillPlaces(message.text, message.arguments);
    for (const Message &sentence : message.below)
        text.append("\n").append(english(sentence));
    return text;
}

} // namespace dyncal
