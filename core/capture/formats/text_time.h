// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/formats/text_dialect.h"
#include "core/capture/import_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Sampling of a table; rate 0 and start 0 without a column of times.
struct TextTime
{
    std::optional<Index> column;
    double sampleRate_Hz = 0.0;
    double first_s = 0.0;
};

/// Finds the column of times (named in the settings; by title or unit; or a first column that
/// increases uniformly, unless it just counts 1, 2, 3) and takes the rate from it. Once the
/// settings name columns, they must name the time too. Row 0 of `columns` is line headerLines + 1.
/// Fails with CAP-016 if the times are not uniform, CAP-003 if they and settings.sampleRate_Hz
/// differ by more than 0.1 %.
Result<TextTime> timeOfTable(const std::string &path, const ImportSettings &settings,
    const std::vector<ColumnTitle> &titles, const std::vector<std::vector<double>> &columns,
    Index headerLines);

} // namespace dyncal
