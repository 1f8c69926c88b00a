// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_source.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// The numbers of a table and the findings about its end.
struct TableColumns
{
    std::vector<std::vector<double>> columns; ///< equally long; NaN = invalid sample
    Findings findings; ///< CAP-018: the last line is cut or may be
};

/// Reads the rows after the header of the text. Every row must be readable: an empty or "nan" cell
/// and each blank line within the data is an invalid sample, anything else that is no number fails
/// with line and column (CAP-018). Comment lines ("#", "%") may follow the data, not interrupt it.
/// A file that changes meanwhile fails, too, and one whose blank lines claim more memory than its
/// size times `maxExpansion` (ExpansionBudget).
Result<TableColumns> parseTable(const std::string &path, const TextSource &text,
    const TextDialect &dialect, const JobControl &control, double maxExpansion = kUsualExpansion);

} // namespace dyncal
