// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/capture/check_settings.h"
#include "core/capture/import_settings.h"

namespace dyncal {

/// The rates that a recording can have: less is no dynamic record, more no recorder has.
constexpr double kLowestRate_Hz = 0.1;
constexpr double kHighestRate_Hz = 1e12;

/// Puts the recipe's sample rate in the place of the file's. A rate that differs from the file's by
/// more than checks.rateMismatch_percent needs a reason, else CAP-003; with one it is a caution,
/// below that an info (CAP-025, once for the same rates). CAP-003 too where there is no rate at
/// all, or one that no recording can have.
Result<void> setSampleRate(Channel &channel, Index shot, const ImportSettings &settings,
    const CheckSettings &checks, Findings &findings);

/// Brings the channel's values into its SI unit with what the recipe says of the channel and, if it
/// is the DUT, of the DUT; fills short gaps of the DUT (CAP-022). Fails (Usage) on a sensitivity of
/// what is a pressure already, or of a unit that is not known.
Result<void> shapeChannel(
    Channel &channel, Index shot, const ImportSettings &settings, Findings &findings);

} // namespace dyncal
