// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/time_words.h"

#include <optional>
#include <vector>

namespace dyncal {

/// One title per column: from the last header line that has as many cells (after "#" or "%"), with
/// the unit in brackets, after " / " or in a row of units below. Without such a line: "column 1".
/// Names are unique: a second "p" becomes "p, column 3". If the number of names differs from that
/// of the columns, they are not used, except for a first one that says time.
std::vector<ColumnTitle> columnTitles(const TextDialect &dialect);

/// How many cells the last header line has, if it looks like names but is not as long as the rows.
std::optional<Index> namesThatDoNotFit(const TextDialect &dialect);

} // namespace dyncal
