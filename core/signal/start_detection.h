// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/capture/check_settings.h"

#include <optional>

namespace dyncal {

inline constexpr double kStartSigmas = 5.0;
inline constexpr double kEventSigmas = CheckSettings{}.stepSigmas;

/// Where the response begins in one record.
struct DetectedStart
{
    Index sample = 0; ///< first sample of the response: the last quiet sample is before it
    double time_s = 0.0; ///< of that sample, on the record's own axis
    double threshold = 0.0; ///< physical units above the baseline
    double baseline = 0.0; ///< median level before
    double noiseSd = 0.0; ///< robust standard deviation before
    double stepToNoise = 0.0; ///< height of the event over noiseSd
    bool baselineAtRest = true; ///< false: the record moves before the event (CAP-020)
};

/// Finds the first lasting rise (or fall) of a record: the sharpest level change of the record is
/// located on block means, the noise is taken robustly from before it, and the start is walked back
/// from there to the first sample beyond `kStartSigmas` noise deviations of the baseline (the mean
/// of several samples is taken where single ones are too noisy), at least 0.5 % of the event's
/// height. Rules: docs/method/window.md. A lone spike before the event does not count. An event
/// needs more than `eventSigmas`: the largest excursion over the noise, else CAP-009 (DataBlocked);
/// so does a record that moves from its first samples on. Invalid samples are skipped. Needs at
/// least 64 samples. Works on counts block by block; never converts the whole record. `shot` is the
/// number that messages name.
Result<DetectedStart> detectStart(const Channel &channel, const JobControl &control = {},
    Index shot = 0, double eventSigmas = kEventSigmas);

/// First crossing of `level` (physical units) at or after sample `from`, interpolated linearly
/// between the two samples around it. Time on the record's own axis.
std::optional<double> crossingTime_s(const Channel &channel, double level, Index from);

} // namespace dyncal
