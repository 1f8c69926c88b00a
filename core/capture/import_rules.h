// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

namespace dyncal {

/// Applies the import section of a recipe to what a reader delivered: roles, unit, scale,
/// polarity, gauge or absolute, sample rate, levels, excluded shots. With one channel only and
/// no role given anywhere, that channel is the DUT. Channels named in the recipe win over roles
/// in the file. Fails (Usage) on a channel or shot number that does not exist, naming those that
/// do.
Result<CaptureSet> applyImportSettings(CaptureSet set, const ImportSettings &settings);

} // namespace dyncal
