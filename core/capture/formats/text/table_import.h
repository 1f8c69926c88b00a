// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_source.h"
#include "core/capture/formats/text/text_time.h"
#include "core/capture/formats/text/time_words.h"
#include "core/capture/import_settings.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// A text file, or its first whole lines.
struct TextPart
{
    const std::string &path; ///< for messages
    std::string_view text;
    bool whole = true;
    const TextSource *all = nullptr; ///< where more of the text is, if `text` is its beginning
};

/// A table as it was understood.
struct ImportedTable
{
    std::vector<ColumnTitle> titles; ///< one per column
    std::vector<std::vector<double>> columns; ///< equally long; NaN = invalid sample
    TextTime time;
    Index countedHeaderLines = 0; ///< lines of bare numbers that were header, too
    Findings findings; ///< of all of this, those of the time included
};

/// Numbers, titles and sampling of a table whose dialect is known. Errors and findings are those of
/// readDelimitedText.
Result<ImportedTable> importTable(const TextPart &part, const TextDialect &dialect,
    const ImportSettings &settings, const JobControl &control);

} // namespace dyncal
