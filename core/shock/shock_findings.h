// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_velocity.h"
#include "core/shock/shock_work.h"

#include <optional>

namespace dyncal {

// What the operator must see of one shot; each may add a finding.
void judgeVelocity(ShockWork &work, double relativeFromDistance); ///< SHK-003
void judgeFit(ShockWork &work, const VelocityEstimate &estimate); ///< SHK-008, SHK-010
/// SHK-015; the first of `gasWays` made the states.
void judgeGas(ShockWork &work, const SectionState &state);
/// SHK-020: a typed p1 or T1 differs from the recorded one by more than 3.6 u of both, and by more
/// than 0.5 % or 1 K.
void judgeTypedState(ShockWork &work, const SectionState &state);
void judgeStates(ShockWork &work); ///< SHK-019: a shock that this tube cannot hold
/// SHK-019: no pressure of the driver's gas makes such a shock.
void judgeUnreachable(ShockWork &work, const Error &error);
void judgeDriverPressure(ShockWork &work, double computed_Pa); ///< SHK-006
void judgeTypedPressure(ShockWork &work, double p1_Pa); ///< SHK-011
void reportPlateau(ShockWork &work); ///< SHK-005
/// SHK-018: one typed number serves `shots` shots.
void judgeSharedNumbers(const ShockSettings &settings, Index shots, Findings &findings);
/// The one typed pressure that the state of every shot follows from; empty where it follows from a
/// velocity, or from the pressure that each shot has recorded.
std::optional<double> typedStatePressure_Pa(const ShockSettings &settings);

} // namespace dyncal
