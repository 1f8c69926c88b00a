// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/message.h"

#include "core/base/message_places.h"

namespace dyncal {

std::string fillPlaces(
    std::string_view text, const std::vector<std::string> &arguments, ArgumentText shown)
{
    return fillPlaces(text, arguments, shown, {});
}

std::string english(const Message &message)
{
    return withSentences(
        message, std::string("\n"), english, [&](const std::vector<std::string> &within) {
            return fillPlaces(message.text, message.arguments, ArgumentText::Brief, within);
        });
}

} // namespace dyncal
