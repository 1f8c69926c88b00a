// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Marks a sentence for translation: DYNCAL_TEXT("core", "Shot %1 has no step."). Core has no Qt;
/// lupdate is told that this macro means QT_TRANSLATE_NOOP, and ui/text translates the sentence
/// before the arguments are put in. The context is "core"; "RecipeLabel" for labels of recipe keys.
#define DYNCAL_TEXT(context, text) text

namespace dyncal {

/// One sentence for a person: English source text with places %1..%9 and the words that go there.
/// The text must be a literal (it is the translation key); every number is an argument.
struct Message
{
    const char *text = "";
    std::vector<std::string> arguments;
    /// Further sentences: the first ones stand in the places %M1..%M9 (message_places.h), the
    /// others each on a line of its own.
    std::vector<Message> below = {};

    bool operator==(const Message &other) const
    {
        return std::string_view(text) == other.text && arguments == other.arguments
            && below == other.below;
    }
};

/// The sentence in English, places filled in. Places without an argument stay as they are.
std::string english(const Message &message);

/// Puts `arguments` into the places %1..%9 of `text` in one pass (an argument that itself holds
/// "%1" is not expanded again). The text is ours, the arguments are foreign: they come out as
/// presentableInBrief() makes them, or in full with their line breaks.
enum class ArgumentText { Brief, Full };
std::string fillPlaces(std::string_view text, const std::vector<std::string> &arguments,
    ArgumentText shown = ArgumentText::Brief);

} // namespace dyncal
