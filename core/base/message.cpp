// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/message.h"

#include "core/base/foreign_text.h"

namespace dyncal {
namespace {

/// Where the digit of the place stands that begins at `at`: "%1", "%L1", "%V1"; 0 if none does.
std::size_t placeDigit(std::string_view text, std::size_t at)
{
    if (text[at] != '%')
        return 0;
    const std::size_t kind = at + 1;
    const bool hasKind = kind < text.size() && (text[kind] == 'L' || text[kind] == 'V');
    const std::size_t digit = hasKind ? kind + 1 : kind;
    return digit < text.size() && text[digit] >= '1' && text[digit] <= '9' ? digit : 0;
}

} // namespace

std::string fillPlaces(
    std::string_view text, const std::vector<std::string> &arguments, ArgumentText shown)
{
    const bool brief = shown == ArgumentText::Brief;
    std::string filled;
    filled.reserve(text.size() + 32);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t digit = placeDigit(text, i);
        const std::size_t number = digit > 0 ? static_cast<std::size_t>(text[digit] - '1') : 0;
        if (digit > 0 && number < arguments.size()) {
            filled += brief ? presentableInBrief(arguments[number])
                            : presentable(arguments[number], LineBreaks::Keep);
            i = digit;
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
