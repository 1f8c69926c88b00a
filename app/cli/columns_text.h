// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace dyncal {

/// The text with blanks behind it up to this width, in characters of UTF-8.
std::string filledTo(std::size_t width, const std::string &text);

/// Rows of cells as lines of columns two blanks apart, all but the last cell of a row filled up to
/// the widest of its column; rows may differ in length. Widths are those of UTF-8 characters.
std::string columnsText(const std::vector<std::vector<std::string>> &rows);

} // namespace dyncal
