// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/front.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// Between which durations of the front a value is compared, and by what the difference is divided
/// to be its u: of a stated duration T - u(T) to T + u(T) and 2; else 0 to kUnstatedFront_s and
/// sqrt(5), as in frontLine().
struct FrontRange
{
    const char *quantity = ""; ///< "front_duration_s" or "front_unknown"
    double shorter_s = 0.0;
    double longer_s = 0.0;
    double divisor = 1.0;
};

FrontRange frontRange(const FrontDuration &front);

/// The model as it would be if the front had lasted `to_s` in place of `from_s`: what rings has
/// other amplitudes (frontFactor()). As withAmplitudes().
SensorModel withFront(const SensorModel &model, double from_s, double to_s);

/// The model at both ends of the range of its front.
struct FrontVariation
{
    FrontRange range;
    SensorModel shorter;
    SensorModel longer;
};

FrontVariation frontVariation(const SensorModel &model, const FrontDuration &front);

} // namespace dyncal
