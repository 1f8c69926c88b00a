// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/import_settings.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// How the rows of a text file are written. Views are into the text that was looked at.
struct TextDialect
{
    char separator = ','; ///< kBlankSeparator: any run of blanks and tabs
    char decimal = '.';
    std::vector<std::string_view> header; ///< the lines before the data
    Index columns = 0;
    std::string ambiguous; ///< a cell that can be read in two ways, or empty

    Index headerLines() const { return static_cast<Index>(header.size()); }
};

/// Finds separator, decimal mark and the first row of numbers from the first lines of a text; what
/// the settings state is taken as stated. Empty if there are no rows of numbers.
std::optional<TextDialect> dialectOf(std::string_view text, const ImportSettings &settings);

/// Name and unit of a column as far as the header says.
struct ColumnTitle
{
    std::string name;
    std::string unit;
};

/// One title per column: from the last header line that has as many cells (behind "#" or "%"), with
/// the unit in brackets, behind " / " or in a row of units below. Without such a line: "column 1".
/// Names are unique: a second "p" becomes "p, column 3".
/// Names that are more or fewer than the columns are not used, but for a first one that says time.
std::vector<ColumnTitle> columnTitles(const TextDialect &dialect);

/// How many cells the last header line has, if it looks like names but is not as long as the rows.
std::optional<Index> namesThatDoNotFit(const TextDialect &dialect);

} // namespace dyncal
