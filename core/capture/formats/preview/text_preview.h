// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/capture/channel_glance.h"
#include "core/capture/import_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What the import dialog shows of a text file: how its beginning reads under given settings.
struct TextPreview
{
    std::vector<std::string> columnTitles; ///< one per column, UTF-8: "p", or "column 2"
    std::vector<std::string> units; ///< one per column, "" where the file states none
    std::vector<ChannelGlance> glances; ///< one per column, of the rows looked at; may be empty
    std::vector<std::vector<std::string>> rows; ///< up to 50 rows of data, cells as written
    Index headerLines = 0; ///< before the data; rows[0] is line headerLines + 1
    Index dataRows = 0; ///< of what was looked at
    Index unreadableCells = 0; ///< of these rows: no number (words, wrong mark), missing, too many
    char separator = ','; ///< ' ' stands for any run of blanks and tabs
    char decimal = '.';
    std::string encoding; ///< "UTF-8", "UTF-16" or "Windows-1252"
    bool decimalAmbiguous = false; ///< numbers can be read in two ways (CAP-019)
    std::optional<Index> timeColumn; ///< holds times or row numbers, no samples
    std::vector<Index> shots; ///< where each column is one: its number from 1, 0 = no shot
    double sampleRate_Hz = 0.0; ///< 0 = must be stated
    std::optional<Error> problem; ///< what would stop the import under these settings
    Message remark; ///< the question, to be translated; no text if all is certain
    std::string question; ///< English sentence: what must be asked; empty if all is certain
};

/// Reads at most the first MiB of a table of numbers. The question is the sentence with which the
/// import would stop, or of its first finding above info, or that the rate must be given. Fails as
/// readDelimitedText does where nothing can be shown: CAP-001 no rows of numbers, CAP-018 the file
/// cannot be read.
Result<TextPreview> previewText(const std::string &path, const ImportSettings &settings);

} // namespace dyncal
