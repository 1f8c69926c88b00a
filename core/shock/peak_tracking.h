// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"

#include <vector>

namespace dyncal {

/// Prominent peaks of the first shot's spectrum that every other shot shows too: at the frequency
/// of a gas mode there, at that of the sensor, or between. Each is tested against the sound speed
/// of region 5. `shock` needs states of at least two shots; otherwise nothing is followed.
std::vector<FollowedPeak> followPeaks(
    const SpectrumResult &spectrum, const WindowResult &window, const ShockConditionsSet &shock);

/// SPC-005: the peaks that move with the gas.
Findings judgePeaks(const std::vector<FollowedPeak> &peaks);

} // namespace dyncal
