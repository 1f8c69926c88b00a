// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/check_settings.h"
#include "core/capture/import_settings.h"

namespace dyncal {

/// Range of credible sample rates: below it no record is dynamic, above it no recorder exists.
constexpr double kLowestRate_Hz = 0.1;
constexpr double kHighestRate_Hz = 1e12;

/// Replaces the file's sample rate by the recipe's. If they differ by more than
/// checks.rateMismatch_percent, a reason is needed, else it fails (CAP-003). With a reason it is a
/// caution, a smaller difference an info (CAP-025, once for the same rates). Fails (CAP-003) too
/// where there is no rate or no credible one.
Result<void> setSampleRate(Channel &channel, Index shot, const ImportSettings &settings,
    const CheckSettings &checks, Findings &findings);

/// Brings the channel's values into its SI unit with what the recipe says of the channel and, if it
/// is the DUT, of the DUT; without a unit, with the one that its name ends with (CAP-033); fills
/// short gaps of the DUT (CAP-022). Says where that contradicts the unit in the file (CAP-030) or
/// the sensor's card (CAP-032), once for all shots alike. Fails (Usage) on a sensitivity of what is
/// a pressure already, or of a unit that is not known.
Result<void> shapeChannel(Channel &channel, Index shot, const ImportSettings &settings,
    const Attributes &card, Findings &findings);

} // namespace dyncal
