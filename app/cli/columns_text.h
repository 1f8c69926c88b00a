// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace dyncal {

/// Rows of cells as lines of columns two blanks apart, all but the last cell of a row filled up to
/// the widest of its column; rows may differ in length. Widths are those of UTF-8 characters.
std::string columnsText(const std::vector<std::vector<std::string>> &rows);

} // namespace dyncal
