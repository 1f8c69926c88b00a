// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dyncal {

// Text that comes from files, names of files, recipes and arguments is foreign: it may hold
// anything. These make it fit to be shown; whatever outlet shows it, it comes through here.

enum class LineBreaks {
    Escape, ///< one line: a break is shown as \n
    Keep, ///< text of several lines
};

/// `bytes` as valid UTF-8 that does nothing but be read: bytes that are none become U+FFFD,
/// controls are shown (\x1b, \t, <U+009B>), and so is what cannot be seen or turns the order of
/// what stands beside it (<U+202E>, <U+200B>, <U+2028>). Other text is unchanged, and so is text
/// that came through here before.
std::string presentable(std::string_view bytes, LineBreaks breaks = LineBreaks::Escape);

/// Characters of one argument of a sentence; the longest path has 4096 bytes.
inline constexpr std::size_t kLongestInSentence = 600;

/// As presentable(), with "…" in place of its middle where it is longer than `most` characters.
std::string presentableInBrief(std::string_view bytes, std::size_t most = kLongestInSentence);

/// A cell of a table for spreadsheets: presentable, and with an apostrophe before what these would
/// take for a formula (= + - @, at the start or behind a separator of another language). Numbers,
/// with a unit or not, stay as they are.
std::string spreadsheetText(std::string_view bytes);

/// `cells` already as spreadsheetText() and joined by tabs are what spreadsheets paste; one that
/// begins with a quote is quoted, as they would read on for its end.
std::string pastedCell(std::string_view bytes);

/// JSON as it was written, with \uXXXX for what presentable() would show: reads back as the same.
std::string presentableJson(std::string_view json);

} // namespace dyncal
