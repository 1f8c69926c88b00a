// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/shock/velocity_fit.h"

#include <vector>

namespace dyncal {

/// Time that a counter measured between two places.
struct CounterReading
{
    double far_m = 0.0; ///< distances to the end wall, far > near
    double near_m = 0.0;
    double time_s = 0.0;
    double u_distance_m = 0.0; ///< of far - near
    double u_time_s = 0.0;
    bool operator==(const CounterReading &) const = default;
};

/// The velocity from counters: the mean velocity of each interval at its middle, fitted by a
/// constant or a straight line; with Attenuation::Automatic its slope a W is observed once more, as
/// what `range_per_m` says of it. Fails (Usage) without a reading or on an impossible one.
Result<VelocityFit> fitCounters(const std::vector<CounterReading> &readings,
    Attenuation attenuation, const Interval &range_per_m = kUsualAttenuation_per_m);

/// As refittedVelocity_m_s(), for other readings.
double refittedCounterVelocity_m_s(
    const VelocityFit &fit, const std::vector<CounterReading> &readings, double attenuation_per_m);

} // namespace dyncal
