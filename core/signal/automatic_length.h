// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/channel.h"

#include <Eigen/Core>

namespace dyncal {

inline constexpr Index kLeastWindow = 16; ///< samples
inline constexpr double kUsedShare = 0.9; ///< of the time to the departure, which is noticed late

/// Period, in blocks and rounded up, of the slowest ringing that stands out of these block means
/// and has four periods there, of more than four blocks; 0 where none does, or where a mean is not
/// finite.
Index slowestRinging_blocks(const Eigen::VectorXd &levels);

/// Samples after `start` until the level leaves its plateau for good, times kUsedShare; at most
/// `limit` samples. `baseline` and `noiseSd` are those of the record before the step.
Index automaticStepLength(
    const Channel &channel, Index start, Index limit, double baseline, double noiseSd);

/// Samples after `start` until the response has decayed to the noise; at most `limit` samples.
Index automaticDecayLength(
    const Channel &channel, Index start, Index limit, double baseline, double noiseSd);

} // namespace dyncal
