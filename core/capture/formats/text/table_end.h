// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/formats/text/text_dialect.h"

#include <string>
#include <string_view>

namespace dyncal {

/// Whether a last line without a line end is complete.
enum class RowEnd {
    Whole, ///< its last number has all digits of those above, or quotes
    Unclear, ///< it may be whole
    Cut, ///< cells or digits are missing
};

/// Compares `line`, the unterminated end of `text`, with the rows directly above it.
/// `text` begins with the dialect's header, `columns` counts what a whole row has.
RowEnd lastRowEnd(std::string_view text, std::string_view line, const TextDialect &dialect);

/// CAP-018 for a last line that is cut (and left out) or may be.
Finding unfinishedLine(const std::string &path, Index line, RowEnd end);

} // namespace dyncal
