// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/capture/capture_set.h"
#include "core/capture/formats/preview/foreign_datasets.h"
#include "core/capture/formats/preview/text_preview.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One channel as an import dialog lists it.
struct ImportChannel
{
    std::string name; ///< by which the recipe gives it a role
    std::string unit; ///< as the file says
    ChannelRole fileRole = ChannelRole::Other; ///< as the file says
    ChannelRole role = ChannelRole::Other; ///< with the settings applied
    std::optional<Index> column; ///< of a text table
    Index samples = 0; ///< 0 = not counted
    ChannelGlance glance{}; ///< of the record, or of the rows of a text that were looked at
    ChannelRole proposed = ChannelRole::Other; ///< by the records alone; nothing takes it unasked
    Index shot = 0; ///< which shot a column is, from 1; 0 = a channel of all shots
    std::string title{}; ///< of the column that is a shot: all these have one name
    bool operator==(const ImportChannel &) const = default;
};

/// What an import dialog shows: how one file reads under given settings.
struct ImportView
{
    std::string format; ///< id of the reader; empty = none takes the file
    std::optional<TextPreview> text; ///< of a text table
    std::vector<ImportChannel> channels;
    std::vector<DatasetEntry> datasets; ///< of an HDF5 file of another program
    double sampleRate_Hz = 0.0; ///< as the file says; 0 = it does not
    std::optional<Error> problem; ///< what would stop the import
    /// Where header and column of times contradict each other (CAP-003): what each of them says.
    std::optional<double> headerRate_Hz, timesRate_Hz;

    /// Whether each column of a text table is a shot of one sensor.
    bool isShotPerColumn() const { return text && !text->shots.empty(); }

    /// Whether a proposal gives a DUT where there is none yet.
    bool hasProposal() const;

    /// Whether the file can be imported with these settings: it reads without an error, its numbers
    /// can be taken in one way only, the rate is known and one channel (or each column) is the DUT.
    bool isComplete(const ImportSettings &settings) const;
};

/// Reads under the settings of this file (settingsOfFile): of a text table only the beginning, of
/// other files no more than is needed to show what they hold.
ImportView lookAtFile(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// Gives the channels their roles under other settings, without a look at the file.
void applyRoles(ImportView &view, const ImportSettings &settings);

/// The first of `set`'s files that leaves open what only the operator knows, with the settings
/// applied: the sample rate, which channel is the DUT, the decimal mark. Empty if none does.
std::string fileWithQuestion(const CaptureSet &set, const ImportSettings &settings);

/// Whether the error is such a question.
bool isQuestion(const Error &error);

} // namespace dyncal
