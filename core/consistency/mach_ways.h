// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/gas_model.h"

#include <optional>

namespace dyncal {

/// The gas before the shock, for the two ways to its Mach number that need neither a clock nor a
/// calibration: ratios of what one sensor sees of the incident and of the reflected shock. Both
/// rise with M (thesis 3.1 to 3.9); empty where no M from 1.001 to 8 gives the ratio.
struct GasBefore
{
    GasModel gas;
    double p1_Pa = 0.0;
    double T1_K = 0.0;
};

/// M at the end wall from r = (p5 - p2)/(p2 - p1) at a side sensor, where the incident shock has
/// `localFactor` times its velocity at the wall. r is 1 for M -> 1. Below a factor of 1 r falls
/// first and then rises with M; the root on the rising part counts.
std::optional<double> machOfStepRatio(const GasBefore &before, double ratio, double localFactor);

/// M from W/W_R, incident over reflected velocity. 1 for M -> 1.
std::optional<double> machOfVelocityRatio(const GasBefore &before, double ratio);

} // namespace dyncal
