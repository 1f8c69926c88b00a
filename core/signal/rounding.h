// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

namespace dyncal {

/// Step q to which the values in `range` were rounded, in physical units: one count, or, where the
/// source has floating point numbers, the step that all large values are multiples of (a text file
/// of few digits, counts that were scaled). Where there is none, the last bit of the largest value.
/// 0 for an empty range, and where the samples cannot be read.
double resolutionOf(const Channel &channel, const SampleRange &range);

/// Step that all values are multiples of, apart from a common offset and from rounding to double
/// precision; 0 if there is none, or fewer than eight different values. All finite.
double commonStep(Eigen::VectorXd values);

/// Standard deviation that a record of noise had before it was rounded to steps of `resolution`. 0
/// where the record takes at most two neighbouring values: how often it takes each says where the
/// level lies, not how large the noise is.
double noiseBeforeRounding(const Eigen::Ref<const Eigen::VectorXd> &noise, double resolution);

/// Mean error of rounding in the presence of normal noise, which no averaging removes: root mean
/// square over all positions of the level between two steps (docs/method/order.md).
///     v = sum over k of q^2/(2 pi^2 k^2) e^(-4 pi^2 k^2 sd^2/q^2)
/// q/sqrt(12) without noise, nothing to speak of from sd = q on.
double lastingRounding(double noiseSd, double resolution);

} // namespace dyncal
