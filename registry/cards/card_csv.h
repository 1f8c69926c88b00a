// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "registry/cards/card.h"

#include <vector>

namespace dyncal {

/// Cards of one kind as CSV: a line of titles ("name", then every field that any of them has), a
/// line for each card, UTF-8, commas, CRLF not needed. What a spreadsheet would take for a formula
/// has an apostrophe before it, which comes off again.
std::string cardsCsv(const std::vector<Card> &cards);

/// Reads it back, also as a spreadsheet writes it (quotes, CRLF, semicolons, a byte order mark);
/// empty cells are left out. Fails (Usage), naming the line, where the column "name" or a name is
/// missing, a name is there twice or longer than 200 bytes, a line has other columns than the
/// first, or a quote is not closed.
Result<std::vector<Card>> parseCards(const std::string &csv, const std::string &kind);

} // namespace dyncal
