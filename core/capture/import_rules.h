// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/check_settings.h"
#include "core/capture/import_settings.h"

namespace dyncal {

/// Applies the import section of a recipe to what a reader delivered: roles, units, scale, gain,
/// sensitivity, polarity, gauge or absolute, sample rate, levels, excluded shots. With one channel
/// only and no role given anywhere, that channel is the DUT. Channels named in the recipe win over
/// roles in the file; settings for one channel, file or shot win over those for all. Pressures are
/// then in Pa and voltages in V, whatever the recorded unit. Fails (Usage) on a channel, file or
/// shot number that does not exist, naming those that do, and on a sensitivity for a channel that
/// is a pressure already; with CAP-003 (DataBlocked) on a missing sample rate and on one that
/// contradicts the file by more than checks.rateMismatch_percent without import.sample_rate_reason.
Result<CaptureSet> applyImportSettings(
    CaptureSet set, const ImportSettings &settings, const CheckSettings &checks = {});

} // namespace dyncal
