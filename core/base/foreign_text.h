// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dyncal {

// Text that comes from files, names of files, recipes and arguments is foreign: it may hold
// anything. These functions make it fit to be shown; every output of such text goes through them.

enum class LineBreaks {
    Escape, ///< one line: a break is shown as \n
    Keep, ///< text of several lines
};

/// `bytes` as valid UTF-8 without side effects: invalid bytes become U+FFFD; controls are written
/// out (\x1b, \t, <U+009B>), and so are characters that cannot be seen or change the direction of
/// the text (<U+202E>, <U+200B>, <U+2028>). Other text is unchanged; a second call changes nothing.
std::string presentable(std::string_view bytes, LineBreaks breaks = LineBreaks::Escape);

/// Characters of one argument of a sentence; the longest path has 4096 bytes.
inline constexpr std::size_t kLongestInSentence = 600;

/// As presentable(), with "…" in place of its middle where it is longer than `most` characters.
std::string presentableInBrief(std::string_view bytes, std::size_t most = kLongestInSentence);

/// A cell of a table for spreadsheets: presentable, and with an apostrophe before what a
/// spreadsheet would take for a formula (= + - @, at the start or after a separator of another
/// language). Numbers, with a unit or not, stay as they are.
std::string spreadsheetText(std::string_view bytes);

/// A cell for pasting, in a line of cells joined by tabs: as spreadsheetText(), and quoted if it
/// begins with a quote, because a spreadsheet would search for the closing one.
std::string pastedCell(std::string_view bytes);

/// JSON with \uXXXX for what presentable() would escape; it still reads back as the same values.
std::string presentableJson(std::string_view json);

} // namespace dyncal
