// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

#include <string>
#include <string_view>

namespace dyncal {

/// How sure it is that the file is a text with rows of numbers, 0..60.
int recogniseDelimitedText(const std::string &path, std::string_view head);

/// Reads a table of numbers as one shot, one channel per column, or as one shot per column of one
/// sensor (settings.columnsAre, shot_columns.h). Separator, decimal mark, header and time column
/// are detected unless the settings state them; `settings.columns` gives roles, and once it names a
/// column other than the time only named columns are read as channels. Every row must be
/// readable: an empty or "nan" cell is an invalid sample, anything else that is no number fails
/// with its line and column (CAP-018). Without a time column the sample rate stays 0. Fails:
/// CAP-001 no rows of numbers, CAP-003 time column against settings.sampleRate_Hz, CAP-016
/// irregular times, CAP-018 unreadable. Findings: CAP-018 (end of the file), CAP-019 (decimal
/// mark).
Result<CaptureSet> readDelimitedText(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal
