// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/signal/level_statistics.h"

#include <Eigen/Core>

namespace dyncal {

/// The level from which a response is counted, from the samples before it.
struct BaselineLevel
{
    double level = 0.0; ///< the mean, or of a steady drift the value that its line has at the start
    double varianceFactor = 1.0; ///< of the level's variance by white noise, over the mean's
    LineFit line;
};

/// `quiet` is the baseline, its last sample `ahead` samples before the start. A drift is steady
/// where a line through the means of eight pieces has a slope of more than eight of its u, by the
/// scatter of the means (6 degrees of freedom): noise that is slow scatters them too. Its line is
/// followed to the start at most as far as the baseline is long, and not back from behind it. With
/// d samples from the middle to the start the factor is 1 + 12 d^2/n^2. Fewer than 128 samples have
/// their mean. All finite. docs/method/window.md.
BaselineLevel baselineLevel(const Eigen::Ref<const Eigen::VectorXd> &quiet, Index ahead);

} // namespace dyncal
