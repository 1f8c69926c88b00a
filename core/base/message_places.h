// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// fillPlaces(), and `within` into the places %M1..%M9: whole sentences of ours, which come out as
/// they are. A message has them at the head of `below`.
std::string fillPlaces(std::string_view text, const std::vector<std::string> &arguments,
    ArgumentText shown, const std::vector<std::string> &within);

/// How many of the sentences `below` stand within the message's own, in places %M1 to %M9; the
/// others follow on lines of their own.
std::size_t countWithin(const Message &message);

/// The message as text: `fill` puts the sentences within into it, `shown` makes text of each
/// sentence below, within or not.
template <typename Text, typename Shown, typename Fill>
Text withSentences(const Message &message, const Text &newLine, Shown shown, Fill fill)
{
    const std::size_t within = countWithin(message);
    std::vector<Text> sentences;
    sentences.reserve(message.below.size());
    for (const Message &sentence : message.below)
        sentences.push_back(shown(sentence));
    const auto firstBelow = sentences.begin() + static_cast<std::ptrdiff_t>(within);
    Text text = fill(std::vector<Text>(sentences.begin(), firstBelow));
    for (auto line = firstBelow; line != sentences.end(); ++line)
        text += newLine + *line;
    return text;
}

} // namespace dyncal
