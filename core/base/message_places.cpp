// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/message_places.h"

#include "core/base/foreign_text.h"

#include <algorithm>

namespace dyncal {
namespace {

/// A place "%1", "%L1", "%V1" or "%M1"; without length: none.
struct Place
{
    std::size_t number = 0; ///< from 0
    std::size_t length = 0;
    bool isSentence = false;
};

Place placeAt(std::string_view text, std::size_t at)
{
    if (text[at] != '%')
        return {};
    const std::size_t kind = at + 1;
    const bool hasKind
        = kind < text.size() && std::string_view("LVM").find(text[kind]) != std::string_view::npos;
    const std::size_t digit = hasKind ? kind + 1 : kind;
    if (digit >= text.size() || text[digit] < '1' || text[digit] > '9')
        return {};
    return {static_cast<std::size_t>(text[digit] - '1'), digit + 1 - at, text[kind] == 'M'};
}

} // namespace

std::string fillPlaces(std::string_view text, const std::vector<std::string> &arguments,
    ArgumentText shown, const std::vector<std::string> &within)
{
    std::string filled;
    filled.reserve(text.size() + 32);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const Place place = placeAt(text, i);
        const auto &from = place.isSentence ? within : arguments;
        if (place.length == 0 || place.number >= from.size()) {
            filled += text[i];
            continue;
        }
        const std::string &words = from[place.number];
        if (place.isSentence)
            filled += words;
        else
            filled += shown == ArgumentText::Brief ? presentableInBrief(words)
                                                   : presentable(words, LineBreaks::Keep);
        i += place.length - 1;
    }
    return filled;
}

std::size_t countWithin(const Message &message)
{
    const std::string_view text = message.text;
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (const Place place = placeAt(text, i); place.length > 0 && place.isSentence)
            count = std::max(count, place.number + 1);
    return std::min(count, message.below.size());
}

} // namespace dyncal
