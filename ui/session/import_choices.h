// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_settings.h"
#include "ui/session/import_view.h"

#include <optional>
#include <string>

namespace dyncal {

/// What an operator chooses in an import dialog, as changes of the settings of that file. `view` is
/// how the file reads under the settings so far.

/// Where the times of a text table come from: one of these, or TimeFirstColumn + the column.
enum TimeChoice { TimeAuto, TimeNone, TimeFirstColumn };

/// Whether the settings name columns, and no times among them: the rate is given then.
bool leavesTimesOut(const ImportSettings &settings);

void chooseTimes(ImportSettings &settings, const ImportView &view, int choice);

/// Whether each column of a text table is a shot of one sensor. What was said of the columns or
/// channels of the other kind is forgotten, the column of times not.
void chooseShotColumns(ImportSettings &settings, const ImportView &view, bool each);

/// There is one DUT only: another one loses its role. True if the file must be read again.
bool chooseRole(
    ImportSettings &settings, ImportView &view, const std::string &channel, ChannelRole role);

/// A dataset of an HDF5 file; without a role it is not read.
void chooseDatasetRole(ImportSettings &settings, const ImportView &view, const std::string &name,
    std::optional<ChannelRole> role);

/// Whether a rate is typed that differs from the file's: the rules of import ask why.
bool needsRateReason(const ImportSettings &settings, const ImportView &view);

} // namespace dyncal
