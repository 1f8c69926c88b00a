// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/shock/gas_model.h"
#include "core/shock/shock_relations.h"

namespace dyncal {

/// As shockStates() of shock_relations.h, also with cp(T): mass, momentum and energy across both
/// shocks are solved for the density ratios, exact to rounding. Fails as shockStates(), and
/// (DataBlocked, SHK-009) where a region leaves 200..1500 K.
Result<ShockStates> shockStatesOf(
    const GasModel &gas, double p1_Pa, double T1_K, double velocity_m_s);

/// Velocity of the shock behind which the pressure is p2: the inverse of shockStatesOf(), exact to
/// rounding. Fails as shockStatesOf(), and (DataBlocked, SHK-001) where p2 does not exceed p1.
Result<double> velocityOfShockedPressure_m_s(
    const GasModel &gas, double p1_Pa, double T1_K, double p2_Pa);

} // namespace dyncal
