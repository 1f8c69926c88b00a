// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/text_dialect.h"

#include <string_view>

namespace dyncal {

/// What can be told of a last line that has no line end.
enum class RowEnd {
    Whole, ///< its last number has the digits that all numbers above have
    Unclear, ///< it may be whole
    Cut, ///< cells or digits are missing
};

/// Compares `line`, the unterminated end of `text`, with the rows directly above it.
RowEnd lastRowEnd(std::string_view text, std::string_view line, const TextDialect &dialect);

} // namespace dyncal
