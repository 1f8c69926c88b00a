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

} // namespace dyncal
