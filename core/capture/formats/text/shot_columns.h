// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/import_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

// Text tables whose columns are shots of one sensor, not channels of one shot.

/// Whether each column is a shot: import.columns_are is "shots".
bool areColumnsShots(const ImportSettings &settings);

/// Which shot each of `columns` columns is, from 1 in the order of the columns; 0 = none: the
/// column of times, and those to which settings.columns gives another role.
std::vector<Index> shotsOfColumns(
    const ImportSettings &settings, Index columns, std::optional<Index> timeColumn);

/// Fails (Usage) if each column is a shot and the settings name one of them as the DUT.
Result<void> checkShotColumns(const std::string &path, const ImportSettings &settings);

} // namespace dyncal
