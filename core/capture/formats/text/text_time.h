// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/time_words.h"
#include "core/capture/import_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Sampling of a table; rate 0 and start 0 where nothing certain states it.
struct TextTime
{
    std::optional<Index> column; ///< holds times or row numbers, no samples
    double sampleRate_Hz = 0.0;
    double first_s = 0.0;
    Findings findings; ///< CAP-003 and CAP-016: what was assumed, or why the rate is unknown
};

/// Finds the column of times (named in the settings; by title or unit; or a first column without
/// title that increases uniformly) and takes the rate from it, or else from the header.
///
/// A wrong rate makes every frequency wrong, so times are trusted only with a unit. Without one
/// they are compared with the stated rate (settings or header); without that, seconds are assumed
/// (with a finding) if the rate is then at least 1 MHz, or 100 Hz for a column titled as time.
/// Otherwise, and for a column that only counts 0, 1, 2, the rate stays 0. Once the settings name
/// columns, they must name the time too. Row 0 of `columns` is the first line after the header.
///
/// Fails: CAP-001 the first column holds frequencies, CAP-003 times, header and
/// settings.sampleRate_Hz differ by more than 0.1 % (not the last, if settings.sampleRateReason
/// says why: then the import rules replace the rate), or another column holds other times, CAP-016
/// times are not uniform or their unit is unknown.
Result<TextTime> timeOfTable(const std::string &path, const ImportSettings &settings,
    const TextDialect &dialect, const std::vector<ColumnTitle> &titles,
    const std::vector<std::vector<double>> &columns);

} // namespace dyncal
