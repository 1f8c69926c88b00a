// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"
#include "core/signal/start_detection.h"

#include <optional>

namespace dyncal {

/// What a side-wall sensor's record shows of the passing shock.
struct SideArrival
{
    double time_s = 0.0; ///< crossing of 50 % of its own step p1 -> p2, record axis
    double u_time_s = 0.0; ///< of the crossing: noise over slope, sample spacing
    double rise_s = 0.0; ///< 10 % to 90 %
    double before = 0.0; ///< p1 level, in the channel's unit; `behind`: p2
    double behind = 0.0;
    double noiseSd = 0.0;
};

/// Level before from `start`, as detectStart() found it; level behind as the median of the second
/// and third quarter between the start and `reflectionFree_s` (a time until which the reflected
/// shock cannot be back, such as the arrival at the end wall). Where that is unknown or not after
/// the start, half a millisecond after the start is taken instead. Empty where no arrival is found.
std::optional<SideArrival> sideArrival(const Channel &channel, const DetectedStart &start,
    const std::optional<double> &reflectionFree_s);

/// Median of the finite physical values between two times of the record; empty if there is none.
std::optional<double> medianBetween(const Channel &channel, double begin_s, double end_s);

} // namespace dyncal
