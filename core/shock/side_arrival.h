// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/capture/channel.h"
#include "core/signal/start_detection.h"

#include <optional>

namespace dyncal {

/// The reflected shock as it passes a side-wall sensor on its way back.
struct ReturnPassage
{
    double time_s = 0.0; ///< crossing of 50 % of its step p2 -> p5, record axis
    double u_time_s = 0.0;
    double level
        = kUnknown; ///< p5, in the channel's unit; NaN: its plateau is too short to be read
};

/// What a side-wall sensor's record shows of the passing shock.
struct SideArrival
{
    double time_s = 0.0; ///< crossing of 50 % of its own step p1 -> p2, record axis
    double u_time_s = 0.0; ///< of the crossing: noise over slope, sample spacing
    double rise_s = 0.0; ///< 10 % to 90 %
    double before = 0.0; ///< p1 level, in the channel's unit; `behind`: p2
    double behind = 0.0;
    double noiseSd = 0.0;
    std::optional<ReturnPassage> back = std::nullopt; ///< with a DUT in the end wall
};

/// Level before from `start`, as detectStart() found it; level behind as the median of the second
/// and third quarter between the start and `reflectionFree_s` (a time until which the reflected
/// shock cannot be back, such as the arrival at the end wall). Where that is unknown or not after
/// the start, half a millisecond after the start is taken instead. Empty where no arrival is found.
std::optional<SideArrival> sideArrival(const Channel &channel, const DetectedStart &start,
    const std::optional<double> &reflectionFree_s);

/// The reflected shock's passage, found in the record alone: what rises beyond p2 by half of the
/// incident step after the shock reached the end wall at `wall_s` (the reflected step is the larger
/// one). Without a level; empty where nothing does, or the noise hides it.
std::optional<ReturnPassage> returnPassage(
    const Channel &channel, const SideArrival &arrival, double wall_s);

/// The level p5 behind it: the median over a stretch behind the passage that is short against the
/// way from the wall, and ends before `end_s`. NaN where that has fewer than 20 samples.
double levelBehindReturn(
    const Channel &channel, const ReturnPassage &back, double wall_s, double end_s);

/// Median of the finite physical values between two times of the record; empty if there is none.
std::optional<double> medianBetween(const Channel &channel, double begin_s, double end_s);

} // namespace dyncal
