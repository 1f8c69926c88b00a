// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/model_variation.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <vector>

namespace dyncal {

/// Standard uncertainty that the noise gives the settling time, in s. Ringing leaves the settled
/// range for the last time in one of its swings: where the noise may lift the next swing out of the
/// range, or draw the last one into it, the time jumps by half a wave, which no derivative shows.
/// Two things move it (docs/method/uncertainty.md): the size of the swings, whose relative u is
/// that of the swings before and after, and the time of their passages through 1. A larger size is
/// the same as a narrower range, so that the time at the range times e^(+-2 u) is where it may
/// reach; half of the farther reach counts as u. Where both ends lie in the swing in which it
/// settles nothing jumps, and u is `derivative_s`, what the variations make of the time itself.
/// `wider`: how much more than by the noise everything scatters (it is in `derivative_s`). Unknown
/// without variations or without a settling time.
double settlingSpread_s(const SensorModel &model, const std::vector<ModelVariation> &variations,
    ResponseTreatment treatment, double derivative_s, double wider);

} // namespace dyncal
